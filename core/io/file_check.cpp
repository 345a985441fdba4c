// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/file_check.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/error.h"

namespace relievo {
namespace {

/// Owns a descriptor opened for reading.
class ReadOnlyFile {
 public:
  explicit ReadOnlyFile(const std::filesystem::path& file)
      : fd_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    if (fd_ < 0) throw FileError(reason(file, errno));
  }
  ~ReadOnlyFile() { ::close(fd_); }
  ReadOnlyFile(const ReadOnlyFile&) = delete;
  ReadOnlyFile& operator=(const ReadOnlyFile&) = delete;
  int fd() const noexcept { return fd_; }

 private:
  static std::string reason(const std::filesystem::path& file, int error) {
    const std::string name = shownName(file);
    switch (error) {
      case ENOENT:
      case ENOTDIR:
        return "Cannot read " + name + ": there is no such file. Check the name and the folder.";
      case EACCES:
      case EPERM:
        return "Cannot read " + name +
               ": this account may not read it. Change its permissions, or copy it.";
      case ELOOP:
        return "Cannot read " + name + ": its links lead in a circle. Choose the file itself.";
      default:
        return "Cannot read " + name + ": " + std::strerror(error) + ". Choose another file.";
    }
  }

  int fd_;
};

std::uint64_t sizeOf(const ReadOnlyFile& open_file, const std::filesystem::path& file) {
  struct stat facts {};
  if (::fstat(open_file.fd(), &facts) != 0) {
    throw FileError("Cannot read " + shownName(file) + ": " + std::strerror(errno) + ".");
  }
  if (S_ISDIR(facts.st_mode)) {
    throw FileError("Cannot read " + shownName(file) +
                    ": it is a folder. Choose one of the files in it.");
  }
  if (!S_ISREG(facts.st_mode)) {
    throw FileError("Cannot read " + shownName(file) +
                    ": it is a pipe or device, not a file. Save the scan to a file first.");
  }
  if (facts.st_size <= 0) {
    throw FileError("Cannot read " + shownName(file) +
                    ": it is empty (0 bytes). Copy or export it again.");
  }
  return static_cast<std::uint64_t>(facts.st_size);
}

}  // namespace

std::string shownName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.empty() ? file.string() : name;
}

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, 1, ' ');
  return digits;
}

std::uint64_t checkedFileSize(const std::filesystem::path& file) {
  const ReadOnlyFile open_file(file);
  return sizeOf(open_file, file);
}

std::string readHead(const std::filesystem::path& file, std::size_t limit) {
  const ReadOnlyFile open_file(file);
  const std::uint64_t size = sizeOf(open_file, file);
  std::string head(static_cast<std::size_t>(std::min<std::uint64_t>(size, limit)), '\0');
  std::size_t done = 0;
  while (done < head.size()) {
    const ssize_t got = ::read(open_file.fd(), head.data() + done, head.size() - done);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) {
      throw FileError("Cannot read " + shownName(file) + ": " + std::strerror(errno) + ".");
    }
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  head.resize(done);
  return head;
}

}  // namespace relievo
