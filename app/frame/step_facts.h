// Everything there is to say of one step of a recorded ray: where it lies, why its cell was or was not read, every test with numbers worked out
// again, what the cell refused and who of those would have hit, the gate, the best hit, and why the ray went on or stopped.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/frame/snapshot.h"
#include "app/frame/step_words.h"

namespace gridscope {

// One test. t and barycentrics (of corners b and c) are those of the triangle's plane, also where the ray passes beside the triangle.
struct TestFacts {
  TestRecord test{};
  TriangleName name{};
  vec2 weights{0.0f};
  bool isNew = false;  // not tested at the step before
  bool best = false;   // the best hit when the step was done
};

// A reference that the step's cell refused, tested as if it had been there.
struct RefusedFacts {
  TestRecord test{};  // slot: its place in the list
  TriangleName name{};
  vec2 weights{0.0f};
  bool wouldHit = false;  // within this step's window, alpha keying included
};

struct BestHit {
  float t = 0.0f;
  uint32_t reference = kNoReference;
  uint32_t step = 0;  // that found it
};

// Values that differ from the step before.
struct StepChanges {
  bool cell = false, stored = false, refused = false, gate = false, best = false;
};

struct StepFacts {
  uint32_t index = 0;  // in the record
  StepOutcome kind = StepOutcome::empty;
  vec3 start{0.0f}, end{0.0f};       // world
  float startT = 0.0f, endT = 0.0f;  // along the ray, world units
  vec2 window{0.0f};                 // hits counted from the first to the second t; the second is kFar for dda
  ivec3 cell{0};
  bool inGrid = true;
  uint32_t stored = 0, refused = 0;  // of the cell; refused is 1 where a grid only flags full cells
  bool saturated = false;
  float travel = 0.0f, gate = 0.0f;  // distance from the launch plane, and what it must exceed; cell edges
  bool gateOpen = false;             // travel is above the gate, and gap-filling is on
  std::optional<BestHit> best;       // so far
  std::vector<TestFacts> tests;      // in slot order
  std::vector<RefusedFacts> refusedTests;
  bool refusedKnown = false;  // the demand is there
  StepChanges changes;
  std::string read;  // why its cell was or was not read, one sentence
  std::string went;  // why the ray went on or stopped, one sentence
};

// `step`: an index into the record's steps. The frame must hold grid, triangles and scene.
StepFacts stepFacts(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step);

// Distance from the launch plane where a step starts, cell edges: what the gate compares.
float stepTravel(const FrameSnapshot& frame, const RecordedRay& ray, uint32_t step);

// The step in one or two sentences, with links.
Sentence explainStep(const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts);

// The two sentences of the facts (step_sentences.cpp).
std::string whyRead(const RecordedRay& ray, const StepFacts& facts);
std::string whyWent(const FrameSnapshot& frame, const RecordedRay& ray, const StepFacts& facts);

// How the ray ended: "voxel hit at t 4.303".
std::string hitWords(const Hit& hit);

// The person's name of a mesh; "mesh 3" where it has none.
std::string meshName(const SceneFacts& scene, uint32_t mesh);
std::string instanceName(const SceneFacts& scene, uint32_t sceneInstance);

}  // namespace gridscope
