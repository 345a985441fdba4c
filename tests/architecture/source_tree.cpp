// SPDX-License-Identifier: BSD-3-Clause
#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace relievo::architecture {
namespace {

namespace fs = std::filesystem;

bool isSkipped(const fs::path& folder) {
  const std::string name = folder.filename().string();
  if (name == ".ci") return false;
  return name.starts_with(".") || name == "build" || name == "samples";
}

template <std::size_t N>
bool endsWithAny(const std::string& path, const std::array<std::string_view, N>& ends) {
  return std::any_of(ends.begin(), ends.end(),
                     [&](std::string_view end) { return path.ends_with(end); });
}

}  // namespace

bool isCpp(const std::string& path) {
  return endsWithAny(path, std::array<std::string_view, 2>{".h", ".cpp"});
}

bool isText(const std::string& path) {
  constexpr std::array<std::string_view, 7> kEnds{".txt", ".cmake", ".md", ".json",
                                                  ".sh",  ".in",    ".qrc"};
  return isCpp(path) || endsWithAny(path, kEnds) || path == "run" || path == "test" ||
         path == ".ci/run";
}

std::map<std::string, std::string> readTree(bool (*wanted)(const std::string& path)) {
  const fs::path root = RELIEVO_SOURCE_DIR;
  std::map<std::string, std::string> files;
  for (auto it = fs::recursive_directory_iterator(root); it != fs::end(it); ++it) {
    if (it->is_directory()) {
      if (isSkipped(it->path())) it.disable_recursion_pending();
      continue;
    }
    const std::string path = fs::relative(it->path(), root).string();
    if (!it->is_regular_file() || !wanted(path)) continue;
    std::ifstream in(it->path(), std::ios::binary);
    files[path] = std::string(std::istreambuf_iterator<char>(in), {});
  }
  return files;
}

}  // namespace relievo::architecture
