// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/plugin_image.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "core/base/failure.h"
#include "core/hash/sha256.h"

namespace relievo::foreign {

namespace fs = std::filesystem;

namespace {
constexpr off_t kMostBytes = off_t{256} << 20U;

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw failure<MessageId::device_plugin_unreadable>(file, why);
}

/// Without waiting for the other end of a pipe.
OwnedFd opened(const fs::path& file) {
  return OwnedFd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
}

/// Whoever owns the root of all files: in a container it may have another number than 0.
uid_t administrator() {
  struct stat root {};
  return ::stat("/", &root) == 0 ? root.st_uid : 0;
}

bool isOurs(const struct stat& facts) {
  return facts.st_uid == ::geteuid() || facts.st_uid == 0 || facts.st_uid == administrator();
}

bool othersWrite(const struct stat& facts) {
  return (facts.st_mode & (S_IWGRP | S_IWOTH)) != 0;
}

/// In a folder like /tmp others write, but only its owner replaces a file.
bool isSafeFolder(const fs::path& folder) {
  struct stat facts {};
  if (::stat(folder.c_str(), &facts) != 0 || !isOurs(facts)) return false;
  return !othersWrite(facts) || (facts.st_mode & S_ISVTX) != 0;
}

/// @return false: the copy is not whole
bool writeAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Into the image, and into its checksum.
void copy(int from, PluginImage& image) {
  Sha256 sum;
  std::array<char, 65536> bytes{};
  off_t size = 0;
  while (true) {
    const ssize_t got = ::read(from, bytes.data(), bytes.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse(image.file, std::strerror(errno));
    if (got == 0) break;
    size += got;
    if (size > kMostBytes) refuse(image.file, "it is larger than 256 MB");
    const std::string_view part(bytes.data(), static_cast<std::size_t>(got));
    sum.add(part);
    if (!writeAll(image.bytes.get(), part)) refuse(image.file, std::strerror(errno));
  }
  image.sha256 = sum.finish();
}
}  // namespace

fs::path openToOthers(int fd) {
  std::error_code error;
  const fs::path real = fs::read_symlink("/proc/self/fd/" + std::to_string(fd), error);
  struct stat facts {};
  if (error || ::fstat(fd, &facts) != 0 || !isOurs(facts) || othersWrite(facts)) return real;
  for (fs::path folder = real.parent_path();; folder = folder.parent_path()) {
    if (!isSafeFolder(folder)) return folder;
    if (folder == folder.parent_path()) return {};
  }
}

fs::path openToOthers(const fs::path& file) {
  const OwnedFd fd = opened(file);
  return fd.get() < 0 ? file : openToOthers(fd.get());
}

PluginImage readPlugin(const fs::path& file) {
  const OwnedFd from = opened(file);
  struct stat facts {};
  if (from.get() < 0 || ::fstat(from.get(), &facts) != 0 || !S_ISREG(facts.st_mode)) {
    refuse(file, "it is no file, or may not be read");
  }
  PluginImage image{.file = file,
                    .bytes = OwnedFd(::memfd_create("plug-in", MFD_CLOEXEC | MFD_ALLOW_SEALING)),
                    .sha256 = {},
                    .open_to_others = openToOthers(from.get())};
  if (image.bytes.get() < 0) refuse(file, std::strerror(errno));
  copy(from.get(), image);
  constexpr int kSeals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL;
  if (::fcntl(image.bytes.get(), F_ADD_SEALS, kSeals) != 0) refuse(file, std::strerror(errno));
  return image;
}

}  // namespace relievo::foreign
