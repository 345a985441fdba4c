// SPDX-License-Identifier: BSD-3-Clause
#include "core/file/atomic_file.h"

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

#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/file/output_set.h"
#include "core/file/owned_fd.h"

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

/// ".NAME.relievo-123.tmp.tif" and, where that is taken, ".NAME.relievo-123.tmp2.tif". What belongs
/// to the program's own file, and no more bytes than a name may have: of a long name the first, and
/// a number in place of the others.
std::filesystem::path nameBeside(const std::filesystem::path& place, int number) {
  constexpr std::size_t kMostBytes = 255, kNumberDigits = 17;
  std::string extension = place.extension().string();
  if (extension.size() > kMostBytes / 4) extension.clear();
  const std::string end = std::string(kMark) + std::to_string(::getpid()) + std::string(kEnd) +
                          (number < 2 ? std::string() : std::to_string(number)) + extension;
  std::string stem = "." + place.stem().string();
  if (stem.size() + end.size() > kMostBytes) {
    const std::size_t hash = std::hash<std::string>{}(place.filename().string());
    stem.resize(kMostBytes - end.size() - kNumberDigits - 1);
    stem += "-" + std::to_string(hash >> 8U);
  }
  return place.parent_path() / (stem + end);
}

/// Every byte of a file, and mode and owner of what it replaces.
void toDisk(int descriptor, const std::filesystem::path& place) {
  if (descriptor < 0 || !takeOver(place, descriptor) || ::fsync(descriptor) != 0) {
    cannotWrite(place, std::strerror(errno));
  }
}

constexpr int kMostBeside = 99;  ///< Of one place and one process.

std::filesystem::path throughProc(int descriptor) {
  return "/proc/self/fd/" + std::to_string(descriptor);
}

/// A file without a name that can be opened again and given one later.
OwnedFd unnamedIn(const std::filesystem::path& folder) {
  OwnedFd file(::open(folder.empty() ? "." : folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666));
  struct stat own {
  }, found{};
  const bool reachable = file.get() >= 0 && ::fstat(file.get(), &own) == 0 &&
                         ::stat(throughProc(file.get()).c_str(), &found) == 0 &&
                         own.st_dev == found.st_dev && own.st_ino == found.st_ino;
  if (!reachable) file.reset();
  return file;
}

}  // namespace

void cannotWrite(const std::filesystem::path& file, const std::string& reason) {
  throw CannotWrite(file, reason);
}

CannotWrite::CannotWrite(const std::filesystem::path& file, const std::string& why)
    : WriteError(said<MessageId::cannot_write>(file, why)), reason(why) {}

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

struct AtomicFile::Impl {
  std::filesystem::path place;    ///< What is replaced, behind all links.
  std::filesystem::path written;  ///< What the writer opens.
  std::filesystem::path beside;   ///< Its name in the folder; empty: none (yet, or any more).
  OwnedFd file;                   ///< Holds the lock while it is written.
  int open_error = 0;             ///< Why there is no `file`.
  OutputSet* set = nullptr;
};

AtomicFile::AtomicFile(const OutputFile& file, TemporaryName name, LeftFiles left)
    : impl_(std::make_unique<Impl>()) {
  Impl& own = *impl_;
  own.set = file.set;
  own.place = requireReplaceable(file.path);
  if (left == LeftFiles::go) removeLeftFiles(folder());
  if (name == TemporaryName::none) own.file = unnamedIn(folder());
  if (own.file.get() >= 0) {
    own.written = throughProc(own.file.get());
  } else {
    for (int number = 1; number <= kMostBeside; ++number) {
      own.beside = nameBeside(own.place, number);
      own.file.reset(
          ::open(own.beside.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666));
      // Whoever opens it for writing says what is wrong, if this fails.
      if (own.file.get() >= 0 || errno != EEXIST) break;
    }
    own.written = own.beside;
  }
  if (own.file.get() >= 0) {
    ::flock(own.file.get(), LOCK_EX | LOCK_NB);
  } else {
    own.open_error = errno;
  }
}

AtomicFile::AtomicFile(AtomicFile&&) noexcept = default;

AtomicFile::~AtomicFile() {
  if (!impl_ || impl_->beside.empty()) return;
  std::error_code ignored;
  std::filesystem::remove(impl_->beside, ignored);
}

const std::filesystem::path& AtomicFile::path() const noexcept {
  return impl_->written;
}

std::filesystem::path AtomicFile::folder() const {
  return impl_->place.parent_path();
}

void AtomicFile::write(std::string_view bytes) {
  const Impl& own = *impl_;
  if (own.file.get() < 0) cannotWrite(own.place, std::strerror(own.open_error));
  while (!bytes.empty()) {
    const ssize_t count = ::write(own.file.get(), bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) cannotWrite(own.place, std::strerror(errno));
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void AtomicFile::commit() {
  if (impl_->set != nullptr) {
    impl_->set->add(std::move(*this));
    return;
  }
  bringToDisk();
  giveNameBeside();
  takePlace();
  bringNamesToDisk(folder());
}

/// Mode and owner of what it replaces, and every byte.
void AtomicFile::bringToDisk() {
  Impl& own = *impl_;
  // Some libraries replace the file that they are given the name of.
  if (!own.beside.empty()) {
    own.file.reset(::open(own.beside.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  }
  toDisk(own.file.get(), own.place);
}

/// The system gives an open file no name that is taken: it gets one beside its place first.
void AtomicFile::giveNameBeside() {
  Impl& own = *impl_;
  for (int number = 1; own.beside.empty(); ++number) {
    const std::filesystem::path name = nameBeside(own.place, number);
    if (::linkat(AT_FDCWD, own.written.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      own.beside = name;
    } else if (errno != EEXIST || number == kMostBeside) {
      cannotWrite(own.place, std::strerror(errno));
    }
  }
}

void AtomicFile::takePlace() {
  Impl& own = *impl_;
  if (::rename(own.beside.c_str(), own.place.c_str()) != 0) {
    cannotWrite(own.place, std::strerror(errno));
  }
  own.beside.clear();
}

void putInPlace(const std::filesystem::path& written, const std::filesystem::path& place) {
  const OwnedFd file(::open(written.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
  toDisk(file.get(), place);
  if (written != place && ::rename(written.c_str(), place.c_str()) != 0) {
    cannotWrite(place, std::strerror(errno));
  }
  bringNamesToDisk(place.parent_path());
}

}  // namespace relievo
