// Pieces of HTML for pages. Whatever is text goes through markupText() here, so that no name of a scene can become markup.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gridscope {

// A cell of a table: a text, or a bar of a share 0..1 of the column's width.
struct PageCell {
  PageCell(std::string shownText) : text(std::move(shownText)) {}
  PageCell(const char* shownText) : text(shownText) {}
  static PageCell bar(double share, std::string colour = "") {
    PageCell cell("");
    cell.isBar = true;
    cell.share = share;
    cell.colour = std::move(colour);
    return cell;
  }
  static PageCell named(std::string text, std::string colour) {
    PageCell cell(std::move(text));
    cell.colour = std::move(colour);
    return cell;
  }

  // A pixel "X,Y" of the frame: a click shows it in the pictures.
  static PageCell pixel(std::string place) {
    PageCell cell(std::move(place));
    cell.isPixel = true;
    return cell;
  }

  std::string text;
  bool isBar = false;
  bool isPixel = false;
  double share = 0.0;
  std::string colour;  // in CSS, of the bar or of a swatch before the text; empty: the page's own, or none
};

// With a caption a table can be sorted by its columns; marked rows, the sums, then stay below.
class PageTable {
 public:
  // Columns: a letter each, l left, n left in one line, r right (numbers), b a bar.
  PageTable(std::string caption, std::string columns, std::vector<std::string> names);
  void add(std::vector<PageCell> cells, bool marked = false);
  bool empty() const { return rows_ == 0; }

  // `whenEmpty`: said in place of a table without rows.
  std::string html(std::string_view whenEmpty = "") const;

 private:
  std::string caption_;
  std::string columns_;
  std::string head_;
  std::string body_;
  size_t rows_ = 0;
};

std::string paragraph(std::string_view text);
std::string codeBlock(std::string_view text);

// "data:image/png;base64,...".
std::string pngDataUri(std::span<const std::byte> png);

// A palette's colour in CSS, with the page's custom property where it has one.
std::string cssColour(uint32_t colour);

}  // namespace gridscope
