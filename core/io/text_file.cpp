// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/text_file.h"

#include "core/base/error.h"
#include "core/io/file_check.h"

namespace relievo {

void writeTextFile(const OutputFile& file, std::string_view text) {
  try {
    AtomicFile written(file);
    written.write(text);
    written.commit();
  } catch (const CannotWrite& error) {
    throw WriteError("Cannot write " + file.path.string() + " (" + error.reason +
                     "). What was there is as before. Choose another folder or free some space.");
  }
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
