// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

namespace relievo::fuzz {

/// One input after the other as a file, for readers that take names. In memory, not on the disk.
class InputFile {
 public:
  explicit InputFile(const std::string& suffix)
      : path_("/dev/shm/relievo_fuzz_" + std::to_string(::getpid()) + suffix) {}
  ~InputFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }

  void write(std::string_view bytes) const {
    const int fd = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    if (fd < 0 || ::write(fd, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
      std::abort();
    }
    ::close(fd);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace relievo::fuzz
