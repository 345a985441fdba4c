// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/task.h"

namespace relievo {

/// SHA-256 (FIPS 180-4) of bytes that come in pieces.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;

  void add(std::span<const std::byte> bytes);
  void add(std::string_view bytes);
  /// 64 hexadecimal digits, lower case. To be called once, after the last piece.
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

std::string sha256OfText(std::string_view bytes);

/// A file's checksum, read in pieces; reports its progress. [worker]
/// @throw FileError  missing, not a regular file, or unreadable  @throw Cancelled
std::string sha256OfFile(const std::filesystem::path& file, const Task& task = {});

/// How `file` is found from `folder`, "/" between names; links are followed. Its absolute path
/// where there is no relative one.
std::string relativePath(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Which file something was made from.
struct InputFile {
  std::string file;         ///< As it is found from the folder of what was made; "/" between names.
  std::string sha256;       ///< 64 hexadecimal digits; empty: not known.
  std::uint64_t bytes = 0;  ///< Its size.
  friend bool operator==(const InputFile&, const InputFile&) = default;
};

/// @param from  folder that `file` of the result is relative to; empty: the name alone
/// @throw FileError, Cancelled
InputFile inputFile(const std::filesystem::path& file, const std::filesystem::path& from,
                    const Task& task = {});

}  // namespace relievo
