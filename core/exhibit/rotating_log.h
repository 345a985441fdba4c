// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

namespace relievo {

/// Lines of a file that never grows without end: when it is full it becomes NAME.1, that one
/// NAME.2, and so on; the oldest goes. One program writes to it. [one thread]
class RotatingLog {
 public:
  struct Limits {
    std::size_t bytes = 256 * 1024;  ///< Of a file, about.
    int kept = 4;                    ///< Older files beside the newest; 1 to 9.
  };

  explicit RotatingLog(std::filesystem::path file) : RotatingLog(std::move(file), Limits{}) {}
  RotatingLog(std::filesystem::path file, Limits limits);

  /// One line: the time, which is given ("2026-11-24T09:30:00Z"), and the words, ends of lines in
  /// them as %0A. A log that cannot be written must not end what it tells of: nothing is thrown.
  /// @return false: it was not written
  bool write(const std::string& time, const std::string& words);

  const std::filesystem::path& file() const noexcept { return file_; }

 private:
  void rotate() const;

  std::filesystem::path file_;
  Limits limits_;
};

/// "2026-11-24T09:30:00Z", of the computer's clock. [any thread]
std::string utcNow();
/// "2026-11-24", where the computer is.
std::string localDay();

}  // namespace relievo
