// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

namespace relievo {

/// A file's bytes in memory, read-only, for as long as this lives.
/// If another program cuts the file meanwhile, touching the lost part raises SIGBUS; only the
/// import worker maps scans.
class MappedFile {
 public:
  /// @throw FileError  as checkedFileSize
  explicit MappedFile(const std::filesystem::path& file);
  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  std::string_view bytes() const noexcept { return bytes_; }

 private:
  std::string_view bytes_;
};

}  // namespace relievo
