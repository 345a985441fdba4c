// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>

namespace relievo {

/// A file whose changes stay in memory until there is room for all of them. What is on the disk is
/// at any time what the last commit() left there. [one thread at a time]
class PendingFile {
 public:
  /// Makes the file, empty. @throw WriteError (E401)  it cannot be made
  explicit PendingFile(const std::filesystem::path& file);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  std::uint64_t size() const noexcept { return size_; }  ///< In bytes, with the changes.
  void resize(std::uint64_t bytes) noexcept { size_ = bytes; }
  /// Zeros beyond the end. @return false: the disk cannot be read
  bool read(std::uint64_t from, std::span<char> to) const;
  /// @return false: what it changes in part cannot be read. @throw std::bad_alloc
  bool write(std::uint64_t at, std::span<const char> from);

  /// Takes the room that the changes need, all of it or none. @return 0 or an errno
  [[nodiscard]] int takeRoom();
  /// Gives back what takeRoom() took and forgets the changes.
  void drop() noexcept;
  /// Room first, then the changes. @return 0; or an errno, with everything on the disk as it was
  /// unless whole() says otherwise
  [[nodiscard]] int commit();
  /// No: the disk failed in the middle of a commit that it had the room for.
  bool whole() const noexcept { return whole_; }
  /// Some file systems report a full disk only here. @return 0 or an errno
  [[nodiscard]] int close() noexcept;

 private:
  static constexpr std::uint64_t kPageBytes = 4096;
  using Page = std::array<char, kPageBytes>;

  bool readDisk(std::uint64_t from, std::span<char> to) const;
  int writeDisk(std::uint64_t at, std::span<const char> from);

  int descriptor_ = -1;
  std::uint64_t size_ = 0;
  std::uint64_t size_on_disk_ = 0;  ///< Without room that was taken.
  std::map<std::uint64_t, Page> changed_;
  bool whole_ = true;
};

}  // namespace relievo
