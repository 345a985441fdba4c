// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/file_check.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/base/failure.h"
#include "core/io/formats/lines.h"

namespace relievo {
namespace {

/// Owns a descriptor opened for reading.
class ReadOnlyFile {
 public:
  explicit ReadOnlyFile(const std::filesystem::path& file)
      : fd_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    if (fd_ < 0) throw refusal(shownName(file), errno);
  }
  ~ReadOnlyFile() { ::close(fd_); }
  ReadOnlyFile(const ReadOnlyFile&) = delete;
  ReadOnlyFile& operator=(const ReadOnlyFile&) = delete;
  int fd() const noexcept { return fd_; }

 private:
  static FileError refusal(const std::string& name, int error) {
    switch (error) {
      case ENOENT:
      case ENOTDIR:
        return failure<MessageId::file_missing>(name);
      case EACCES:
      case EPERM:
        return failure<MessageId::file_forbidden>(name);
      case ELOOP:
        return failure<MessageId::file_links_in_circle>(name);
      default:
        return failure<MessageId::file_not_opened>(name, std::strerror(error));
    }
  }

  int fd_;
};

std::uint64_t sizeOf(const ReadOnlyFile& open_file, const std::filesystem::path& file) {
  struct stat facts {};
  if (::fstat(open_file.fd(), &facts) != 0) {
    throw failure<MessageId::file_not_read>(shownName(file), std::strerror(errno));
  }
  if (S_ISDIR(facts.st_mode)) {
    throw failure<MessageId::file_is_a_folder>(shownName(file));
  }
  if (!S_ISREG(facts.st_mode)) {
    throw failure<MessageId::file_is_a_pipe>(shownName(file));
  }
  if (facts.st_size <= 0) {
    throw failure<MessageId::file_is_empty>(shownName(file));
  }
  return static_cast<std::uint64_t>(facts.st_size);
}

/// Bytes of the UTF-8 character at the front of `text`, 0 if there is none (RFC 3629, section 4).
std::size_t characterBytes(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t count = first < 0xC2   ? 0
                            : first < 0xE0 ? 2
                            : first < 0xF0 ? 3
                            : first < 0xF5 ? 4
                                           : 0;
  if (count == 0 || text.size() < count) return 0;
  for (std::size_t i = 1; i < count; ++i) {
    if ((byte(i) & 0xC0U) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second >= 0xA0;
  const bool too_large = first == 0xF4 && second >= 0x90;
  return overlong || surrogate || too_large ? 0 : count;
}

/// C0 and C1 control characters, and delete.
bool isControl(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return first < 32 || first == 127;
  return first == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const std::size_t bytes = characterBytes(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(bytes, 1));
    if (bytes == 0 || isControl(character)) {
      shown += '?';
    } else {
      shown += character;
    }
    text.remove_prefix(character.size());
  }
  return shown;
}

std::string shownStart(std::string_view line) {
  return printable(trimmed(line).substr(0, 60));
}

std::string shownName(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return printable(name.empty() ? file.string() : name);
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
      throw failure<MessageId::file_not_read>(shownName(file), std::strerror(errno));
    }
    if (got == 0) break;
    done += static_cast<std::size_t>(got);
  }
  head.resize(done);
  return head;
}

}  // namespace relievo
