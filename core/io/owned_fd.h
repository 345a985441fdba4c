// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace relievo {

/// A descriptor that closes itself.
class OwnedFd {
 public:
  explicit OwnedFd(int fd = -1) noexcept : fd_(fd) {}
  ~OwnedFd() { reset(); }
  OwnedFd(const OwnedFd&) = delete;
  OwnedFd& operator=(const OwnedFd&) = delete;
  void reset(int fd = -1) noexcept;
  int get() const noexcept { return fd_; }

 private:
  int fd_;
};

}  // namespace relievo
