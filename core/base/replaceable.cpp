// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/replaceable.h"

#include <system_error>

#include "core/base/error.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

bool areOneFile(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code missing;  // Then the names tell, below the folders that are there.
  if (fs::equivalent(a, b, missing)) return true;
  const fs::path place = fs::weakly_canonical(a, missing);
  return !missing && place == fs::weakly_canonical(b, missing) && !missing;
}

}  // namespace

void requireReplaceable(const std::filesystem::path& file) {
  std::error_code unknown;  // What cannot be asked cannot be opened either, which says why.
  const std::filesystem::file_status status = std::filesystem::status(file, unknown);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status)) return;
  throw WriteError("Cannot write " + file.string() +
                   ": what has this name is no regular file. It was left as it is. Choose another "
                   "name.");
}

void requireNotAnInput(const fs::path& out, const std::vector<FileRead>& inputs) {
  for (const FileRead& input : inputs) {
    if (!areOneFile(out, input.file)) continue;
    throw ArgumentError("The output '" + out.string() + "' is " + input.what +
                        ". Nothing was written. Choose another name.");
  }
}

void requireDifferentFiles(const std::vector<fs::path>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!areOneFile(outputs[k], outputs[i])) continue;
      throw ArgumentError("Two of the outputs would be '" + outputs[i].string() +
                          "'. Nothing was written. Give one of them another name.");
    }
  }
}

}  // namespace relievo
