// SPDX-License-Identifier: BSD-3-Clause
#include "core/tiles/spill_file.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/failure.h"
#include "core/file/unnamed_file.h"

namespace relievo {

void SpillFile::fail(int error) const {
  throw failure<MessageId::spill_not_kept>(folder_, std::strerror(error));
}

void SpillFile::open() {
  if (file_.get() >= 0) return;
  file_ = unnamedFile(folder_);
  if (file_.get() < 0) fail(errno);
}

std::uint64_t SpillFile::append(std::span<const std::byte> bytes) {
  const std::uint64_t at = size_;
  write(at, bytes);
  return at;
}

void SpillFile::write(std::uint64_t at, std::span<const std::byte> bytes) {
  open();
  size_ = std::max(size_, at + bytes.size());
  while (!bytes.empty()) {
    const ssize_t done = ::pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) fail(done < 0 ? errno : ENOSPC);
    at += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

void SpillFile::read(std::uint64_t at, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t done = ::pread(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) fail(done < 0 ? errno : EIO);
    at += static_cast<std::uint64_t>(done);
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
}

}  // namespace relievo
