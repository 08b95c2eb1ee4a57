// Everything that a report's page says about one frame, collected before a line of it is written.
#pragma once

#include <string>
#include <vector>

#include "app/report/explain_report.h"
#include "app/report/report.h"
#include "app/session/session.h"
#include "views/picture.h"

namespace gridscope {

// A view's picture, without the strip below it: the page says itself how to read it.
struct PagePicture {
  const View* view;
  ViewPicture shown;
};

struct PageFrame {
  std::string scene;   // its name
  std::string device;  // that ran build, update and trace; and its driver
  CaptureNames names;
  uint32_t frameCount = 1;  // of the captured sequence that it is one of
  FrameSettings settings;
  GridParameters grid{};
  RenderReport rendered;                             // one frame
  std::vector<std::vector<std::string>> statistics;  // rows of a name and a text
  ExplainReport explained;
  std::vector<RayCounters> counters;  // one a ray
  std::vector<Invariant> invariants;  // of the grid and the hits
  std::vector<std::string> warnings;  // of the scene
  std::vector<PagePicture> pictures;  // in the order of all views
  std::string command;                // that makes the page again
};

// Steps that the progress of a page counts, the views' apart.
inline constexpr uint64_t kPageSteps = 7;

// Runs the stages, finds the truth and paints the views.
PageFrame makePageFrame(const Options& options, Session& session, Progress& progress);

}  // namespace gridscope
