// See page_frame.h.
#include "app/page_frame.h"


namespace gridscope {

namespace {

// Views of the frame's products and of its truth.
bool isShown(const View& view) {
  return view.need == ViewNeed::nothing || view.need == ViewNeed::truth || view.need == ViewNeed::triangleCosts;
}

Picture rowsOf(const Picture& picture, uint32_t begin, uint32_t end) {
  const size_t rowBytes = size_t{4} * picture.width;
  return {picture.width, end - begin, {picture.rgba.begin() + ptrdiff_t(rowBytes * begin), picture.rgba.begin() + ptrdiff_t(rowBytes * end)}};
}

PagePicture paint(const View& view, Pipeline& pipeline, const SliceSettings& slice) {
  const FrameSettings& settings = pipeline.settings();
  const GridParameters& grid = pipeline.parameters().grid;
  const int layers = grid.cellCount[slice.axis];
  ViewPictureSettings how{.capacity = uint32_t(grid.capacity), .frameWidth = settings.width, .frameHeight = settings.height, .sliceAxis = slice.axis,
                          .sliceIndex = slice.index < 0 ? layers / 2 : slice.index, .sliceCount = layers};
  const Pipeline::ViewImage image = pipeline.view(view.name, slice, view.needsGrid);
  const Picture whole = makeViewPicture(view, image.elements, image.width, image.height, how).picture;
  how.legend = false;
  const uint32_t height = makeViewPicture(view, image.elements, image.width, image.height, how).picture.height;
  return {&view, rowsOf(whole, 0, height), rowsOf(whole, height, whole.height)};
}

// The counting trace for the counters, then the fast one, whose time is said. Their hits are the same.
void runStages(Session& session, PageFrame& frame, Progress& progress) {
  progress.step("trace");
  Pipeline& pipeline = session.pipeline();
  session.build();
  session.update(0);
  session.makeRays(0);
  pipeline.trace(true);
  frame.counters = pipeline.counters();
  pipeline.trace(false);
  frame.rendered.frames.push_back(reportFrame(session, 0, true));
}

void explainFrame(Session& session, PageFrame& frame, Progress& progress) {
  progress.step("explain every ray");
  Pipeline& pipeline = session.pipeline();
  ExplainReport& explained = frame.explained;
  explained.frame = tellFrame(pipeline);
  explained.grid = frame.rendered.frames.back().grid;
  explained.tried = frame.rendered.frames.back().tried;
  explained.ledger = makeLedger(explained.frame);
  constexpr size_t kWorstRays = 20;
  explained.worst = worstRays(explained.frame, kWorstRays);
  explained.width = pipeline.settings().width;
  frame.brokenInvariants = checkInvariants(explained.frame.grid, pipeline.numbered(), session.capture() ? nullptr : &explained.tried);
}

// What the views of the truth read.
void useTruth(Pipeline& pipeline, const ExplainReport& explained) {
  pipeline.useTruths(explained.frame.truths);
  std::vector<uint32_t> costs;
  for (const TriangleLoss& loss : explained.ledger.triangles) costs.push_back(loss.rays);
  pipeline.useTriangleCosts(costs);
}

}  // namespace

PageFrame makePageFrame(const Options& options, Session& session, Progress& progress) {
  Pipeline& pipeline = session.pipeline();
  PageFrame frame{.scene = session.scene().name, .device = session.deviceName() + ", " + session.deviceReport().driver, .names = session.names(),
                  .settings = pipeline.settings(), .grid = pipeline.parameters().grid};
  frame.warnings = session.scene().warnings;
  std::vector<std::string> arguments = options.arguments;
  arguments.insert(arguments.begin(), "gridscope");
  frame.command = shellText(arguments);

  runStages(session, frame, progress);
  explainFrame(session, frame, progress);
  useTruth(pipeline, frame.explained);
  for (const View& view : allViews()) {
    if (!isShown(view)) continue;
    progress.step("view " + std::string(view.name));
    frame.pictures.push_back(paint(view, pipeline, options.slice));
  }
  frame.rendered.frames.back().times.views = pipeline.times().views;
  frame.statistics = reportTable(session, frame.rendered).rows();
  return frame;
}

}  // namespace gridscope
