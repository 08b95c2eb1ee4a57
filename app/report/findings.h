// What some views need beside a frame's products (View::need): made for the views that were asked for, and given to the pipeline.
#pragma once

#include <set>

#include "app/session/session.h"

namespace gridscope {

// Builds that the view `stability` compares where --stability does not say.
inline constexpr uint32_t kComparedBuilds = 8;

class Findings {
 public:
  // Both must outlive this.
  Findings(Session& session, const Options& options);

  void beforeUpdate();              // keeps the grid for what tells updates
  void afterTrace(uint32_t frame);  // may build and trace again

 private:
  bool needs(ViewNeed need) const { return needs_.contains(need); }
  void compareBuildsOf(uint32_t frame);
  void tellTruths();

  Session& session_;
  const Options& options_;
  std::set<ViewNeed> needs_;
  Grid before_;
};

}  // namespace gridscope
