// Files that are written whole or not at all: to a temporary file in the same folder, flushed, renamed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace gridscope {

// A link is followed. When it throws Error (disk full, no permission; the message says why, not which file), the old file is as it was.
void writeWholeFile(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace gridscope
