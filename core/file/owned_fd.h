// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

namespace relievo {

/// A descriptor that closes itself.
class OwnedFd {
 public:
  explicit OwnedFd(int fd = -1) noexcept : fd_(fd) {}
  ~OwnedFd() { reset(); }
  OwnedFd(OwnedFd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  OwnedFd& operator=(OwnedFd&& other) noexcept {
    if (this != &other) reset(std::exchange(other.fd_, -1));
    return *this;
  }
  void reset(int fd = -1) noexcept;
  int get() const noexcept { return fd_; }

 private:
  int fd_;
};

}  // namespace relievo
