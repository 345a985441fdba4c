// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/text_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "core/base/error.h"
#include "core/file/atomic_file.h"
#include "core/file/owned_fd.h"
#include "core/io/file_check.h"

namespace relievo {
namespace {

bool writeAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

void writeTextFile(const OutputFile& file, std::string_view text) {
  AtomicFile replaced(file);
  {
    const OwnedFd out(
        ::open(replaced.path().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (out.get() < 0 || !writeAll(out.get(), text)) {
      throw WriteError("Cannot write " + file.path.string() + " (" + std::strerror(errno) +
                       "). What was there is as before. Choose another folder or free some space.");
    }
  }
  replaced.commit();
}

std::string readTextFile(const std::filesystem::path& file, std::size_t most_bytes) {
  const std::uint64_t bytes = checkedFileSize(file);
  if (bytes > most_bytes) {
    throw FileError("Cannot read " + shownName(file) + ": it has " + grouped(bytes) +
                    " bytes, more than the " + grouped(most_bytes) +
                    " that such a file may have. Nothing was loaded.");
  }
  return readHead(file, most_bytes);
}

}  // namespace relievo
