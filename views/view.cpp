// The list of all views.
#include "views/view.h"

#include <algorithm>

namespace gridscope {

static constexpr View kViews[] = {
#include "views/views.inc"
};

std::span<const View> allViews() { return kViews; }

const View* findView(std::string_view name) {
  const View* found = std::ranges::find(kViews, name, &View::name);
  return found == std::end(kViews) ? nullptr : found;
}

}  // namespace gridscope
