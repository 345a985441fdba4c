// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/log/log_place.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "haptics/record/recording_error.h"

namespace relievo {
namespace {

constexpr int kMostLeftOver = 99;
constexpr int kNewMode = 0666;

/// A link is followed: what it names is replaced or made, not the link. One that leads in a circle
/// stays as it is, so that whoever opens it says why that cannot be done.
std::filesystem::path followed(const std::filesystem::path& file) {
  constexpr int kMostLinks = 40;  // As the system itself follows.
  std::error_code none;
  std::filesystem::path real = std::filesystem::canonical(file, none);
  if (!none) return real;
  real = file;
  for (int links = 0; links < kMostLinks; ++links) {
    const std::filesystem::path named = std::filesystem::read_symlink(real, none);
    if (none) return real;  // No link: the name that is free.
    real = real.parent_path() / named;
  }
  return file;
}

/// Takes the file, unless somebody else writes it. Locks of this kind are not those of the HDF5
/// library, so that other programs may read meanwhile. File systems without locks say nothing.
bool isTaken(int descriptor) {
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  return ::fcntl(descriptor, F_OFD_SETLK, &whole) != 0 && (errno == EAGAIN || errno == EACCES);
}

[[noreturn]] void refuseTaken(const std::filesystem::path& file) {
  throw failure<MessageId::recording_taken>(file);
}

void closeIfOpen(int& descriptor) noexcept {
  if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

}  // namespace

LogPlace::LogPlace(const std::filesystem::path& file) : target_(followed(file)), written_(target_) {
  struct stat facts {};
  if (::stat(target_.c_str(), &facts) != 0) {
    if (make(target_, kNewMode)) return;
    if (errno != EEXIST) throw recordingRefused(target_, errno);
    // Made by somebody else in this moment.
    if (::stat(target_.c_str(), &facts) != 0) throw recordingRefused(target_, errno);
  }
  if (!S_ISREG(facts.st_mode)) return;
  if (::access(target_.c_str(), W_OK) != 0) throw recordingRefused(target_, errno);
  held_target_ = ::open(target_.c_str(), O_RDWR | O_CLOEXEC);
  if (held_target_ >= 0 && isTaken(held_target_)) {
    closeIfOpen(held_target_);
    refuseTaken(target_);
  }
  makeBeside(static_cast<int>(facts.st_mode & 0777U));
}

LogPlace::~LogPlace() {
  release();
}

void LogPlace::release() noexcept {
  closeIfOpen(held_);
  closeIfOpen(held_target_);
}

/// @return  false: there is one already, or it cannot be made (errno)
bool LogPlace::make(const std::filesystem::path& file, int mode) {
  held_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  if (held_ < 0) return false;
  [[maybe_unused]] const bool taken = isTaken(held_);
  written_ = file;
  is_own_ = true;
  return true;
}

/// What an earlier log left there, killed, stays: it can be read.
void LogPlace::makeBeside(int mode) {
  for (int number = 1; number <= kMostLeftOver; ++number) {
    constexpr std::size_t kMostBytes = 255;  // Of a name.
    const std::string end = ".unfinished" + (number == 1 ? "" : "-" + std::to_string(number)) +
                            target_.extension().string();
    std::string stem = target_.stem().string();
    if (stem.size() + end.size() > kMostBytes)
      stem.resize(kMostBytes - std::min(end.size(), kMostBytes));
    const std::filesystem::path beside =
        std::filesystem::path(target_).replace_filename(stem + end);
    if (make(beside, mode)) return;
    if (errno != EEXIST) throw recordingRefused(beside, errno);
    int other = ::open(beside.c_str(), O_RDWR | O_CLOEXEC);
    const bool is_taken = other >= 0 && isTaken(other);
    closeIfOpen(other);
    if (is_taken) refuseTaken(target_);
  }
  throw recordingRefused(target_, EEXIST);
}

void LogPlace::keep() {
  if (!is_own_) return release();  // A device or a pipe.
  try {
    putInPlace(written_, target_);
  } catch (const CannotWrite& error) {
    throw failure<MessageId::recording_keeps_its_name>(target_, error.reason, written_);
  }
  written_ = target_;
  release();
}

void LogPlace::drop() noexcept {
  if (!std::exchange(is_own_, false)) return;
  ::unlink(written_.c_str());
}

}  // namespace relievo
