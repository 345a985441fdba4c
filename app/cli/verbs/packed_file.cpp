// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/verbs/packed_file.h"

#include <algorithm>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/provenance/name_text.h"
#include "core/provenance/sha256.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

/// A regular file that is below the folder when links are followed.
bool isBelow(const fs::path& file, const fs::path& folder) {
  std::error_code missing;
  const fs::path real = fs::canonical(file, missing), home = fs::canonical(folder, missing);
  if (missing || !fs::is_regular_file(real, missing)) return false;
  return std::mismatch(home.begin(), home.end(), real.begin(), real.end()).first == home.end();
}

}  // namespace

fs::path packedFile(const fs::path& package_folder, const fs::path& recording,
                    const fs::path& named, const std::string& sha256, const Task& task) {
  const fs::path beside = recording.parent_path();
  const fs::path name = textOfName(named.filename().string());  // As it was packed.
  const auto is_it = [&](const fs::path& file) {
    return isBelow(file, package_folder) && (sha256.empty() || sha256OfFile(file, task) == sha256);
  };
  for (const fs::path& place : {beside / name, package_folder / "input" / name}) {
    if (is_it(place)) return place;
  }
  for (int i = 2;; ++i) {
    fs::path numbered = beside / (std::to_string(i) + "-" + name.string());
    if (is_it(numbered)) return numbered;
    if (!isBelow(numbered, package_folder)) break;
  }
  throw failure<MessageId::package_lacks_file>(shownName(recording), shownName(named));
}

}  // namespace relievo::batch
