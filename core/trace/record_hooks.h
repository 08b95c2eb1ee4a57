// The hooks of shaders/shared/trace/traverse.h that write down what happens: included right before it, in a class with a member `record` of type
// RayRecord. No include guard: traverse.h forgets them.
#define ON_SEGMENT(segment, start, cell, outcome) record.steps.push_back({segment, start, cell, outcome, {}})
#define ON_TEST(place, reference, test, alphaByte) \
  record.steps.back().tests.push_back({uint(place), reference, test.verdict, test.t, alphaByte})
#define ON_CELL(storedCount, isSaturated, travelled) \
  record.steps.back().stored = storedCount, record.steps.back().saturated = isSaturated, record.steps.back().travel = travelled
