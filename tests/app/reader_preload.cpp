// SPDX-License-Identifier: BSD-3-Clause
// Loaded before the program by one_way_in_test: tells how the program itself, not its import
// processes (which are not told of LD_PRELOAD), comes to the bytes of the inputs that
// RELIEVO_GUARDED names, separated by colons. Lines go to the file RELIEVO_GUARD_LOG:
//   library NAME FILE   a library opened it for reading
//   mapped FILE         it was mapped into memory
//   piece FILE          some of it was read, neither all of it in order (a checksum, a copy) ...
//   cells FILE          ... nor whole tiles of a map, at places where they may be
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

namespace {

/// A descriptor of an input.
struct Reading {
  bool is_input = false;
  std::string file;
  std::uint64_t size = 0, in_order = 0;
  bool tells_all = false;  ///< Nothing more is said of it.
};

std::mutex& lock() {
  static auto* const mutex = new std::mutex;  // Never destroyed: files are closed at the very end.
  return *mutex;
}

std::array<Reading, 1024>& readings() {
  static auto* const all = new std::array<Reading, 1024>;
  return *all;
}

/// The function behind ours of that name. Nothing is locked while the loader is asked, no guard of
/// a static variable either: a thread that loads a library holds the loader's lock, and what the
/// library does at its start may wait for ours.
/// @param known  where the answer is kept: one for each name
template <class Function>
Function next(std::atomic<void*>& known, const char* name) {
  void* function = known.load(std::memory_order_acquire);
  if (function == nullptr) {
    function = dlsym(RTLD_NEXT, name);
    known.store(function, std::memory_order_release);
  }
  return reinterpret_cast<Function>(function);
}

/// `real`, the function behind NAME, of the type that follows.
#define RELIEVO_REAL(NAME, ...)                \
  static constinit std::atomic<void*> known{}; \
  const auto real = next<__VA_ARGS__>(known, NAME)

std::string settingOf(const char* name) {
  const char* const text = std::getenv(name);
  return text == nullptr ? std::string() : std::string(text);
}

/// The guarded input that is this file; null: none.
const std::string* inputOf(const struct stat& facts) {
  struct Input {
    std::string name;
    dev_t device;
    ino_t number;
  };
  static const auto* const inputs = [] {
    auto* all = new std::vector<Input>;
    std::string names = settingOf("RELIEVO_GUARDED");
    for (std::size_t at = 0; at < names.size();) {
      const std::size_t end = std::min(names.find(':', at), names.size());
      const std::string name = names.substr(at, end - at);
      struct stat of_name {};
      if (::stat(name.c_str(), &of_name) == 0)
        all->push_back({name, of_name.st_dev, of_name.st_ino});
      at = end + 1;
    }
    return all;
  }();
  for (const Input& input : *inputs) {
    if (input.device == facts.st_dev && input.number == facts.st_ino) return &input.name;
  }
  return nullptr;
}

void tell(const std::string& line) {
  static const std::string* const log = new std::string(settingOf("RELIEVO_GUARD_LOG"));
  // Not by open and close, which would ask the loader here, under the lock of readings().
  const auto fd = static_cast<int>(::syscall(SYS_openat, AT_FDCWD, log->c_str(),
                                             O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600));
  if (fd < 0) return;
  [[maybe_unused]] const ssize_t written = ::write(fd, (line + "\n").data(), line.size() + 1);
  ::syscall(SYS_close, fd);
}

void opened(int fd, bool for_reading) {
  if (fd < 0 || fd >= static_cast<int>(readings().size()) || !for_reading) return;
  struct stat facts {};
  if (::fstat(fd, &facts) != 0 || !S_ISREG(facts.st_mode)) return;
  const std::string* const input = inputOf(facts);
  const std::scoped_lock held(lock());
  Reading& reading = readings()[static_cast<std::size_t>(fd)];
  reading = {};
  if (input == nullptr) return;
  reading.is_input = true;
  reading.file = *input;
  reading.size = static_cast<std::uint64_t>(facts.st_size);
}

/// What was read from `at` on; -1: from where the last read ended.
void got(int fd, ssize_t bytes, off_t at) {
  constexpr ssize_t kTile = 256 * 256;
  if (bytes <= 0 || fd < 0 || fd >= static_cast<int>(readings().size())) return;
  const std::scoped_lock held(lock());
  Reading& reading = readings()[static_cast<std::size_t>(fd)];
  if (!reading.is_input || reading.tells_all) return;
  if (at < 0) {
    reading.in_order += static_cast<std::uint64_t>(bytes);
    return;
  }
  reading.tells_all = true;
  tell((bytes == kTile || bytes == 4 * kTile ? "cells " : "piece ") + reading.file);
}

void closed(int fd) {
  if (fd < 0 || fd >= static_cast<int>(readings().size())) return;
  const std::scoped_lock held(lock());
  Reading& reading = readings()[static_cast<std::size_t>(fd)];
  if (reading.is_input && !reading.tells_all && reading.in_order != 0 &&
      reading.in_order != reading.size) {
    tell("piece " + reading.file);
  }
  reading = {};
}

bool reads(int flags) {
  return (flags & O_ACCMODE) != O_WRONLY && (flags & O_PATH) == 0;
}

void byLibrary(const char* library, const char* file) {
  struct stat facts {};
  if (file == nullptr || ::stat(file, &facts) != 0) return;
  if (inputOf(facts) != nullptr) tell(std::string("library ") + library + " " + file);
}

}  // namespace

extern "C" {

// NOLINTBEGIN: these are the C library's names and forms.
#define RELIEVO_OPEN(NAME)                                                                 \
  int NAME(const char* file, int flags, ...) {                                             \
    RELIEVO_REAL(#NAME, int (*)(const char*, int, ...));                                   \
    va_list more;                                                                          \
    va_start(more, flags);                                                                 \
    const mode_t mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0; \
    va_end(more);                                                                          \
    const int fd = real(file, flags, mode);                                                \
    opened(fd, reads(flags));                                                              \
    return fd;                                                                             \
  }
RELIEVO_OPEN(open)
RELIEVO_OPEN(open64)

#define RELIEVO_OPENAT(NAME)                                                               \
  int NAME(int folder, const char* file, int flags, ...) {                                 \
    RELIEVO_REAL(#NAME, int (*)(int, const char*, int, ...));                              \
    va_list more;                                                                          \
    va_start(more, flags);                                                                 \
    const mode_t mode = (flags & (O_CREAT | __O_TMPFILE)) != 0 ? va_arg(more, mode_t) : 0; \
    va_end(more);                                                                          \
    const int fd = real(folder, file, flags, mode);                                        \
    opened(fd, reads(flags));                                                              \
    return fd;                                                                             \
  }
RELIEVO_OPENAT(openat)
RELIEVO_OPENAT(openat64)

#define RELIEVO_FOPEN(NAME)                                       \
  FILE* NAME(const char* file, const char* how) {                 \
    RELIEVO_REAL(#NAME, FILE* (*)(const char*, const char*));     \
    FILE* const stream = real(file, how);                         \
    if (stream != nullptr) opened(fileno(stream), how[0] == 'r'); \
    return stream;                                                \
  }
RELIEVO_FOPEN(fopen)
RELIEVO_FOPEN(fopen64)

int fclose(FILE* stream) {
  RELIEVO_REAL("fclose", int (*)(FILE*));
  closed(fileno(stream));
  return real(stream);
}

int close(int fd) {
  RELIEVO_REAL("close", int (*)(int));
  closed(fd);
  return real(fd);
}

ssize_t read(int fd, void* to, size_t bytes) {
  RELIEVO_REAL("read", ssize_t(*)(int, void*, size_t));
  const ssize_t count = real(fd, to, bytes);
  got(fd, count, -1);
  return count;
}

size_t fread(void* to, size_t size, size_t count, FILE* stream) {
  RELIEVO_REAL("fread", size_t(*)(void*, size_t, size_t, FILE*));
  const size_t items = real(to, size, count, stream);
  got(fileno(stream), static_cast<ssize_t>(items * size), -1);
  return items;
}

#define RELIEVO_PREAD(NAME)                                      \
  ssize_t NAME(int fd, void* to, size_t bytes, off_t at) {       \
    RELIEVO_REAL(#NAME, ssize_t (*)(int, void*, size_t, off_t)); \
    const ssize_t count = real(fd, to, bytes, at);               \
    got(fd, count, at);                                          \
    return count;                                                \
  }
RELIEVO_PREAD(pread)
RELIEVO_PREAD(pread64)

#define RELIEVO_MMAP(NAME)                                                      \
  void* NAME(void* start, size_t bytes, int how, int flags, int fd, off_t at) { \
    RELIEVO_REAL(#NAME, void* (*)(void*, size_t, int, int, int, off_t));        \
    if (fd >= 0) {                                                              \
      struct stat facts {};                                                     \
      const bool is_file = ::fstat(fd, &facts) == 0 && S_ISREG(facts.st_mode);  \
      const std::string* const input = is_file ? inputOf(facts) : nullptr;      \
      if (input != nullptr) tell("mapped " + *input);                           \
    }                                                                           \
    return real(start, bytes, how, flags, fd, at);                              \
  }
RELIEVO_MMAP(mmap)
RELIEVO_MMAP(mmap64)

void* GDALOpenEx(const char* file, unsigned flags, const char* const* drivers,
                 const char* const* options, const char* const* siblings) {
  RELIEVO_REAL("GDALOpenEx", void* (*)(const char*, unsigned, const char* const*,
                                       const char* const*, const char* const*));
  byLibrary("GDALOpenEx", file);
  return real(file, flags, drivers, options, siblings);
}

void* zip_open(const char* file, int flags, int* error) {
  RELIEVO_REAL("zip_open", void* (*)(const char*, int, int*));
  byLibrary("zip_open", file);
  return real(file, flags, error);
}

std::int64_t H5Fopen(const char* file, unsigned flags, std::int64_t access) {
  RELIEVO_REAL("H5Fopen", std::int64_t(*)(const char*, unsigned, std::int64_t));
  byLibrary("H5Fopen", file);
  return real(file, flags, access);
}
// NOLINTEND
}
