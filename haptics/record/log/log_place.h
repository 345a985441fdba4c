// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace relievo {

/// Where a log is written until it is whole (docs/adr/0134-logs-replace-when-whole.md): under its
/// own name if that is free, else beside what stands there, as NAME.unfinished.csv. Held against
/// other writers as long as this lives. [one thread at a time]
class LogPlace {
 public:
  /// Makes the file, empty, where there is none. Devices and pipes are written as they are.
  /// @throw WriteError (E401)  it cannot be made, or is being written by somebody else
  explicit LogPlace(const std::filesystem::path& file);
  ~LogPlace();
  LogPlace(const LogPlace&) = delete;
  LogPlace& operator=(const LogPlace&) = delete;

  const std::filesystem::path& target() const noexcept { return target_; }
  const std::filesystem::path& writtenTo() const noexcept { return written_; }

  /// The log is whole: it is brought to the disk and gets its name, in place of what stood there.
  /// @throw WriteError (E401)  it could not; it stays where it was written
  void keep();
  /// The log stays as it is, where it is.
  void release() noexcept;
  /// The log is of no use: what was made is removed.
  void drop() noexcept;

 private:
  bool make(const std::filesystem::path& file, int mode);
  void makeBeside(int mode);

  std::filesystem::path target_, written_;
  int held_ = -1;         ///< Of the file that is written.
  int held_target_ = -1;  ///< Of what stands under the target's name.
  bool is_own_ = false;   ///< Made here, so that it may be removed.
};

}  // namespace relievo
