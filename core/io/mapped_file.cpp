// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/mapped_file.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"

namespace relievo {

MappedFile::MappedFile(const std::filesystem::path& file) {
  const auto size = static_cast<std::size_t>(checkedFileSize(file));
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  void* const start = fd < 0 ? MAP_FAILED : ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, fd, 0);
  const int error = errno;
  if (fd >= 0) ::close(fd);
  if (start == MAP_FAILED) {
    throw failure<MessageId::file_not_read>(shownName(file), std::strerror(error));
  }
  bytes_ = {static_cast<const char*>(start), size};
}

MappedFile::~MappedFile() {
  // munmap wants a pointer to non-const; nothing is written.
  ::munmap(const_cast<char*>(bytes_.data()), bytes_.size());
}

}  // namespace relievo
