// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace relievo::test {

/// A folder of its own, removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "relievo_io_XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) std::abort();
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }

  std::filesystem::path write(const std::string& name, std::string_view content) const {
    std::filesystem::path file = path_ / name;
    std::ofstream(file, std::ios::binary)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
    return file;
  }

 private:
  std::filesystem::path path_;
};

/// A path in a folder that only this process has, and that goes with it: a test runs beside itself
/// where it is also run under a sanitizer.
inline std::filesystem::path ownPath(const std::string& name) {
  static const TemporaryFolder folder;
  return folder.path() / name;
}

/// Shared scans, or an empty path.
inline std::filesystem::path sharedData() {
  const char* stated = std::getenv("RELIEVO_SHARED_DATA");
  const std::filesystem::path folder =
      stated != nullptr ? std::filesystem::path(stated)
                        : std::filesystem::path(RELIEVO_SOURCE_DIR) / ".." / "shared" / "data";
  std::error_code missing;
  return std::filesystem::is_directory(folder, missing) ? folder : std::filesystem::path{};
}

}  // namespace relievo::test
