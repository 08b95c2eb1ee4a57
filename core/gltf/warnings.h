// What the loader left out or replaced: one line per kind, with the first few examples and how many more there were.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace gridscope {

class GltfWarnings {
 public:
  void add(const std::string& kind, const std::string& example) {
    for (Entry& entry : entries_) {
      if (entry.kind == kind) return addTo(entry, example);
    }
    entries_.push_back({kind, {example}, 0});
  }

  std::vector<std::string> lines(const std::string& fileName) const {
    std::vector<std::string> lines;
    for (const Entry& entry : entries_) {
      std::string line = fileName + ": " + entry.kind + " (";
      for (const std::string& example : entry.examples) line += (&example == entry.examples.data() ? "" : ", ") + example;
      if (entry.moreCount > 0) line += " and " + std::to_string(entry.moreCount) + " more";
      lines.push_back(line + ")");
    }
    return lines;
  }

 private:
  struct Entry {
    std::string kind;
    std::vector<std::string> examples;
    uint64_t moreCount;
  };

  static void addTo(Entry& entry, const std::string& example) {
    if (std::ranges::find(entry.examples, example) != entry.examples.end()) return;
    if (entry.examples.size() < 4) {
      entry.examples.push_back(example);
    } else {
      ++entry.moreCount;
    }
  }

  std::vector<Entry> entries_;
};

}  // namespace gridscope
