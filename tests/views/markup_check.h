// A small checker of HTML and SVG as this program writes them: tags nest, attributes are quoted, no stray < or &.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace gridscope {

class MarkupChecker {
 public:
  explicit MarkupChecker(std::string_view text) : text_(text) {}

  // The first fault, in words; empty: none.
  std::string check() {
    while (at_ < text_.size() && fault_.empty()) {
      if (text_[at_] == '<')
        tag();
      else if (text_[at_] == '&')
        entity();
      else
        ++at_;
    }
    if (fault_.empty() && !open_.empty()) fail("never closed: " + open_.back());
    return fault_;
  }

 private:
  void fail(const std::string& what) {
    if (fault_.empty()) fault_ = what + " near: " + std::string(text_.substr(at_ > 40 ? at_ - 40 : 0, 120));
  }

  void entity() {
    const size_t end = text_.find(';', at_);
    if (end == std::string_view::npos || end - at_ > 8) return fail("a stray &");
    at_ = end + 1;
  }

  std::string name() {
    const size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(uint8_t(text_[at_])) || text_[at_] == '-')) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  void tag() {
    ++at_;
    if (text_.substr(at_).starts_with("!doctype html>")) return void(at_ = text_.find('>', at_) + 1);
    const bool closing = at_ < text_.size() && text_[at_] == '/';
    if (closing) ++at_;
    const std::string element = name();
    if (element.empty()) return fail("a stray <");
    if (closing) return close(element);
    const bool selfClosing = attributes();
    if (!fault_.empty() || selfClosing) return;
    open_.push_back(element);
    if (element == "script" || element == "style") {
      at_ = text_.find("</" + element + ">", at_);
      if (at_ == std::string_view::npos) at_ = text_.size();
    }
  }

  void close(const std::string& element) {
    if (open_.empty() || open_.back() != element) return fail("closes what is not open: " + element);
    open_.pop_back();
    if (at_ >= text_.size() || text_[at_] != '>') return fail("an end tag without end");
    ++at_;
  }

  // Up to the end of a start tag; true when it closes itself.
  bool attributes() {
    std::vector<std::string> seen;
    for (;;) {
      while (at_ < text_.size() && std::isspace(uint8_t(text_[at_]))) ++at_;
      if (text_.substr(at_).starts_with("/>")) return at_ += 2, true;
      if (at_ < text_.size() && text_[at_] == '>') return ++at_, false;
      const std::string attribute = name();
      if (attribute.empty() || !text_.substr(at_).starts_with("=\"")) return fail("an attribute without a quoted value"), false;
      if (std::ranges::find(seen, attribute) != seen.end()) return fail("an attribute twice: " + attribute), false;
      seen.push_back(attribute);
      const size_t end = text_.find('"', at_ + 2);
      if (end == std::string_view::npos) return fail("a value without end"), false;
      if (text_.substr(at_ + 2, end - at_ - 2).find('<') != std::string_view::npos) return fail("a < in a value"), false;
      at_ = end + 1;
    }
  }

  std::string_view text_;
  size_t at_ = 0;
  std::vector<std::string> open_;
  std::string fault_;
};

inline std::string markupFault(std::string_view text) { return MarkupChecker(text).check(); }

}  // namespace gridscope
