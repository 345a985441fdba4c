// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/replaced_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "core/base/error.h"
#include "core/base/replaceable.h"

namespace relievo {
namespace {

constexpr std::string_view kMark = ".relievo-";
constexpr std::string_view kEnd = ".tmp";

/// ".NAME.relievo-123.tmp.tif": the number of the process that writes it; nothing for other names.
std::optional<pid_t> writerOf(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (!name.starts_with('.') || mark == std::string_view::npos) return std::nullopt;
  const std::string_view rest = name.substr(mark + kMark.size());
  pid_t writer = 0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), writer);
  const std::string_view after(end, static_cast<std::size_t>(rest.data() + rest.size() - end));
  if (error != std::errc{} || writer <= 0 || !after.starts_with(kEnd)) return std::nullopt;
  return writer;
}

/// A process that lives may be seen from here or, in another container, only by its lock.
bool isLeft(const std::filesystem::path& file, pid_t writer) {
  if (writer == ::getpid() || ::kill(writer, 0) == 0 || errno != ESRCH) return false;
  const OwnedFd fd(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC));
  return fd.get() >= 0 && ::flock(fd.get(), LOCK_EX | LOCK_NB) == 0;
}

/// What belongs to the program's own file, and no more bytes than a name may have: of a long name
/// the first, and a number in place of the others.
std::string temporaryName(const std::filesystem::path& file) {
  constexpr std::size_t kMostBytes = 255, kNumberDigits = 17;
  std::string extension = file.extension().string();
  if (extension.size() > kMostBytes / 4) extension.clear();
  const std::string end =
      std::string(kMark) + std::to_string(::getpid()) + std::string(kEnd) + extension;
  std::string stem = "." + file.stem().string();
  if (stem.size() + end.size() > kMostBytes) {
    const std::string number =
        "-" + std::to_string(std::hash<std::string>{}(file.filename().string()) >> 8U);
    stem.resize(kMostBytes - end.size() - kNumberDigits - 1);
    stem += number;
  }
  return stem + end;
}

/// Mode and owner of what is replaced. @return false: errno says why not
bool takeOver(const std::filesystem::path& replaced, int descriptor) {
  struct stat before {
  }, now{};
  if (::stat(replaced.c_str(), &before) != 0) return errno == ENOENT;
  if (::fstat(descriptor, &now) != 0) return false;
  const bool same_owner = before.st_uid == now.st_uid && before.st_gid == now.st_gid;
  if (!same_owner && ::fchown(descriptor, before.st_uid, before.st_gid) != 0) return false;
  return ::fchmod(descriptor, before.st_mode & 07777U) == 0;
}

}  // namespace

void cannotWrite(const std::filesystem::path& file, const std::string& reason) {
  throw WriteError("Cannot write " + file.string() + ": " + reason +
                   ". Check the folder, its permissions and the free space.");
}

void removeLeftFiles(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, error);
  for (; !error && entries != std::filesystem::directory_iterator(); entries.increment(error)) {
    const std::filesystem::path& file = entries->path();
    const auto writer = writerOf(file.filename().string());
    std::error_code ignored;
    if (!writer || !std::filesystem::is_regular_file(entries->symlink_status(ignored))) continue;
    if (isLeft(file, *writer)) std::filesystem::remove(file, ignored);
  }
}

ReplacedFile::ReplacedFile(const std::filesystem::path& final_name)
    : final_(requireReplaceable(final_name)),
      temporary_(final_.parent_path() / temporaryName(final_)) {
  removeLeftFiles(final_.parent_path());
  // Whoever opens it for writing says what is wrong, if this fails.
  lock_.reset(::open(temporary_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
  if (lock_.get() >= 0) ::flock(lock_.get(), LOCK_EX | LOCK_NB);
}

ReplacedFile::~ReplacedFile() {
  std::error_code ignored;
  if (!kept_) std::filesystem::remove(temporary_, ignored);
}

void ReplacedFile::keep() {
  const OwnedFd written(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  if (written.get() < 0 || !takeOver(final_, written.get()) || ::fsync(written.get()) != 0 ||
      ::rename(temporary_.c_str(), final_.c_str()) != 0) {
    cannotWrite(final_, std::strerror(errno));
  }
  kept_ = true;
  // The name is on the disk, too. Some network file systems have no such call for folders.
  const std::filesystem::path folder = final_.parent_path();
  const OwnedFd names(
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (names.get() >= 0) ::fsync(names.get());
}

}  // namespace relievo
