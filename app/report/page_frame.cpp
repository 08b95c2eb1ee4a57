// See page_frame.h.
#include "app/report/page_frame.h"

#include <algorithm>

#include "app/report/findings.h"
#include "core/grid/cell_updates.h"
#include "core/pipeline/stability.h"
#include "core/trace/cell_rays.h"
#include "core/trace/invariants_frame.h"

namespace gridscope {

namespace {

// Views of the frame's products and of its truth; of builds that differ where they can, of an update where there is one before the frame.
bool isShown(const View& view, const Session& session, const Options& options) {
  const Pipeline& pipeline = session.pipeline();
  switch (view.need) {
    case ViewNeed::stability: return pipeline.settings().grid.insertion == kInsertionFirstCome && session.canRebuild();
    case ViewNeed::cellUpdates: return options.frame > 0 && pipeline.numbered().dynamicInstanceCount() > 0 && session.canRebuild();
    default: return true;
  }
}

std::vector<const View*> shownViews(const Session& session, const Options& options) {
  std::vector<const View*> views;
  for (const View& view : allViews())
    if (isShown(view, session, options)) views.push_back(&view);
  return views;
}

bool anyNeeds(const std::vector<const View*>& views, ViewNeed need) {
  return std::ranges::any_of(views, [need](const View* view) { return view->need == need; });
}

PagePicture paint(const View& view, Pipeline& pipeline, const SliceSettings& slice) {
  const FrameSettings& settings = pipeline.settings();
  const GridParameters& grid = pipeline.parameters().grid;
  const int layers = grid.cellCount[slice.axis];
  const ViewPictureSettings how{.legend = false,
                                .capacity = uint32_t(grid.capacity),
                                .frameWidth = settings.width,
                                .frameHeight = settings.height,
                                .sliceAxis = slice.axis,
                                .sliceIndex = slice.index < 0 ? layers / 2 : slice.index,
                                .sliceCount = layers};
  const Pipeline::ViewImage image = pipeline.view(view.name, slice, view.needsGrid);
  return {&view, makeViewPicture(view, image.elements, image.width, image.height, how)};
}

// The counting trace for the counters, then the fast one, whose time is said. Their hits are the same.
void runStages(Session& session, const Options& options, const std::vector<const View*>& views, PageFrame& frame) {
  Pipeline& pipeline = session.pipeline();
  session.build();
  std::optional<Grid> before;
  if (anyNeeds(views, ViewNeed::cellUpdates)) {
    session.update(options.frame - 1);
    before = pipeline.grid();
  }
  session.update(options.frame);
  if (before) pipeline.useCellUpdates(compareUpdate(*before, pipeline.grid()));
  session.makeRays(options.frame);
  pipeline.trace(true);
  frame.counters = pipeline.counters();
  pipeline.trace(false);
  frame.explained.foreignHits = session.useCapturedHits(options.frame);
  frame.rendered.frames.push_back(reportFrame(session, options.frame, true));
}

// Proofs of so many rays take a few seconds of two cores: a page has them without being asked.
constexpr uint64_t kMostProvenUnasked = 100000;

void explainFrame(Session& session, const Options& options, PageFrame& frame, Progress& progress) {
  Pipeline& pipeline = session.pipeline();
  ExplainReport& explained = frame.explained;
  explained.frame = tellFrame(pipeline);
  explained.grid = frame.rendered.frames.back().grid;
  explained.ledger = makeLedger(explained.frame);
  explained.worst = worstRays(explained.frame, options.worst);
  explained.width = pipeline.settings().width;
  explained.frameNumber = options.frame;
  explained.countsRefused = gridAbilities(frame.grid).countsRefusals;
  if (!options.verify && explained.frame.totals.differ() > kMostProvenUnasked) return;
  progress.step("prove every cause");
  explained.proofs = proveFrame(explained.frame);
}

void testFrame(Session& session, PageFrame& frame) {
  const FrameTruth& truth = frame.explained.frame;
  GridFacts facts{.grid = truth.grid, .scene = *truth.scene, .demand = &truth.demand, .builtBy = session.builtBy()};
  facts.tried = session.capture() ? truth.demand.total() : session.pipeline().referencesTried();
  frame.invariants = testGrid(facts);
  for (Invariant& invariant : testFrameHits(*truth.scene, truth.parameters, truth.rays, truth.hits))
    frame.invariants.push_back(std::move(invariant));
}

// What views read beside the products.
void useFindings(Session& session, const Options& options, const std::vector<const View*>& views, const ExplainReport& explained) {
  Pipeline& pipeline = session.pipeline();
  pipeline.useTruths(explained.frame.truths);
  std::vector<uint32_t> costs;
  for (const TriangleLoss& loss : explained.ledger.triangles) costs.push_back(loss.rays);
  pipeline.useTriangleCosts(costs);
  pipeline.useCellRays(countCellRays(explained.frame.traceInput(), explained.frame.rays));
  if (!anyNeeds(views, ViewNeed::stability)) return;

  // The frame's own grid and hits come back afterwards.
  const Stability stability = compareBuilds(pipeline, kComparedBuilds, [&] { session.rebuild(options.frame); });
  pipeline.useStability(stability.cells, stability.rays);
  pipeline.useGrid(explained.frame.grid.words);
  pipeline.useHits(explained.frame.hits);
}

}  // namespace

PageFrame makePageFrame(const Options& options, Session& session, Progress& progress) {
  Pipeline& pipeline = session.pipeline();
  PageFrame frame{.scene = session.scene().name,
                  .device = session.deviceName() + ", " + session.deviceReport().driver,
                  .names = session.names(),
                  .frameCount = session.frameCount(),
                  .settings = pipeline.settings(),
                  .grid = pipeline.parameters().grid};
  frame.warnings = session.scene().warnings;
  std::vector<std::string> arguments = options.arguments;
  arguments.insert(arguments.begin(), "gridscope");
  frame.command = shellText(arguments);

  const std::vector<const View*> views = shownViews(session, options);
  progress.step("trace");
  runStages(session, options, views, frame);
  progress.step("explain every ray");
  explainFrame(session, options, frame, progress);
  testFrame(session, frame);
  useFindings(session, options, views, frame.explained);
  for (const View* view : views) {
    progress.step("view " + std::string(view->name));
    frame.pictures.push_back(paint(*view, pipeline, options.slice));
  }
  frame.rendered.frames.back().times.views = pipeline.times().views;
  frame.statistics = reportTable(session, frame.rendered).rows();
  return frame;
}

}  // namespace gridscope
