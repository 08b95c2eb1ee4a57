// How to read a view's picture, as HTML: sharp at every width, in the page's light and dark.
#pragma once

#include <string>

#include "views/picture.h"
#include "views/view.h"

namespace gridscope {

// A bar of colours with its numbers, and what marks mean; empty for a view that has neither. Of `shown` all but the pixels is used.
std::string legendHtml(const View& view, const ViewPicture& shown);

}  // namespace gridscope
