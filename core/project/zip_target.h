// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

struct zip_source;  // libzip's

namespace relievo {

/// Of the libzip that this process has loaded: "1.7.3".
std::string libzipVersion();

/// An open file into which libzip writes an archive. By itself libzip writes a second file beside
/// the one it is given, under a name that stays when the process is killed.
class ZipTarget {
 public:
  /// @param file  there already; errno says why it cannot be opened
  explicit ZipTarget(const std::filesystem::path& file);
  ~ZipTarget();
  ZipTarget(const ZipTarget&) = delete;
  ZipTarget& operator=(const ZipTarget&) = delete;

  /// For zip_open_from_source, which takes it over. It may not outlive this. Null: no memory, or
  /// the file could not be opened.
  zip_source* source();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
