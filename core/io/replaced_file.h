// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace relievo {

/// "Cannot write FILE: <reason>." with what to look at. @throw WriteError
[[noreturn]] void cannotWrite(const std::filesystem::path& file, const std::string& reason);

/// A file under a temporary name beside its final one; removed unless `keep` was called. So a
/// failure leaves nothing half done, and what was there before.
class ReplacedFile {
 public:
  /// @throw WriteError  what is there must not be replaced
  explicit ReplacedFile(std::filesystem::path final_name);
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  const std::filesystem::path& path() const noexcept { return temporary_; }
  void keep();  ///< @throw WriteError

 private:
  std::filesystem::path final_, temporary_;
  bool kept_ = false;
};

}  // namespace relievo
