// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <utility>

#include "core/file/owned_fd.h"

namespace relievo {

/// What does not fit into memory: one file without a name, which vanishes with this object, and
/// with the process however it ends. Made at the first write.
class SpillFile {
 public:
  /// @param folder  on the disk to use; must exist
  explicit SpillFile(std::filesystem::path folder) : folder_(std::move(folder)) {}
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;

  /// @return  where the bytes begin. @throw WriteError  no room, no permission
  std::uint64_t append(std::span<const std::byte> bytes);
  /// @throw WriteError
  void write(std::uint64_t at, std::span<const std::byte> bytes);
  /// Bytes written before. [any thread] @throw WriteError  the disk failed
  void read(std::uint64_t at, std::span<std::byte> bytes) const;

  std::uint64_t size() const noexcept { return size_; }

 private:
  void open();
  [[noreturn]] void fail(int error) const;

  std::filesystem::path folder_;
  OwnedFd file_;
  std::uint64_t size_ = 0;
};

}  // namespace relievo
