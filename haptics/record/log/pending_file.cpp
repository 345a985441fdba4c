// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/log/pending_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "haptics/record/recording_error.h"

namespace relievo {

PendingFile::PendingFile(const std::filesystem::path& file)
    : descriptor_(::open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ >= 0) return;
  throw recordingRefused(file, errno);
}

PendingFile::~PendingFile() {
  [[maybe_unused]] const int too_late = close();
}

bool PendingFile::readDisk(std::uint64_t from, std::span<char> to) const {
  while (!to.empty()) {
    const ssize_t count = ::pread(descriptor_, to.data(), to.size(), static_cast<off_t>(from));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    if (count == 0) break;
    from += static_cast<std::uint64_t>(count);
    to = to.subspan(static_cast<std::size_t>(count));
  }
  std::fill(to.begin(), to.end(), '\0');
  return true;
}

int PendingFile::writeDisk(std::uint64_t at, std::span<const char> from) {
  while (!from.empty()) {
    const ssize_t count = ::pwrite(descriptor_, from.data(), from.size(), static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return count < 0 ? errno : ENOSPC;
    at += static_cast<std::uint64_t>(count);
    from = from.subspan(static_cast<std::size_t>(count));
  }
  return 0;
}

bool PendingFile::read(std::uint64_t from, std::span<char> to) const {
  while (!to.empty()) {
    const std::uint64_t offset = from % kPageBytes;
    const auto bytes =
        static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), kPageBytes - offset));
    const auto page = changed_.find(from / kPageBytes);
    if (page != changed_.end()) {
      std::memcpy(to.data(), page->second.data() + offset, bytes);
    } else if (!readDisk(from, to.first(bytes))) {
      return false;
    }
    from += bytes;
    to = to.subspan(bytes);
  }
  return true;
}

bool PendingFile::write(std::uint64_t at, std::span<const char> from) {
  while (!from.empty()) {
    const std::uint64_t number = at / kPageBytes, offset = at % kPageBytes;
    const auto bytes =
        static_cast<std::size_t>(std::min<std::uint64_t>(from.size(), kPageBytes - offset));
    const auto [page, is_new] = changed_.try_emplace(number);
    if (is_new && bytes < kPageBytes && !readDisk(number * kPageBytes, page->second)) {
      changed_.erase(page);
      return false;
    }
    std::memcpy(page->second.data() + offset, from.data(), bytes);
    at += bytes;
    from = from.subspan(bytes);
    size_ = std::max(size_, at);
  }
  return true;
}

int PendingFile::takeRoom() {
  if (size_ <= size_on_disk_) return 0;
  int error = EINTR;
  while (error == EINTR) {
    error = ::posix_fallocate(descriptor_, static_cast<off_t>(size_on_disk_),
                              static_cast<off_t>(size_ - size_on_disk_));
  }
  return error;
}

void PendingFile::drop() noexcept {
  changed_.clear();
  size_ = size_on_disk_;
  if (descriptor_ < 0) return;
  // Cutting a file takes no room; should it fail, the zeros after the end are in nobody's way.
  [[maybe_unused]] const int cut = ::ftruncate(descriptor_, static_cast<off_t>(size_on_disk_));
}

int PendingFile::commit() {
  int error = takeRoom();
  // From the end to the head, so that nothing that is there is touched before the new is safe.
  for (auto page = changed_.rbegin(); error == 0 && page != changed_.rend(); ++page) {
    const std::uint64_t begin = page->first * kPageBytes;
    if (begin >= size_) continue;
    const std::span<const char> bytes(page->second);
    error = writeDisk(begin, bytes.first(std::min(kPageBytes, size_ - begin)));
    whole_ = error == 0 || begin >= size_on_disk_;
  }
  if (error == 0 && ::ftruncate(descriptor_, static_cast<off_t>(size_)) != 0) error = errno;
  if (error == 0) size_on_disk_ = size_;
  drop();
  return error;
}

int PendingFile::close() noexcept {
  if (descriptor_ < 0) return 0;
  drop();
  return ::close(std::exchange(descriptor_, -1)) == 0 ? 0 : errno;
}

}  // namespace relievo
