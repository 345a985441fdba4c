// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/text_file.h"

#include "core/base/failure.h"
#include "core/io/file_check.h"

namespace relievo {

void writeTextFile(const OutputFile& file, std::string_view text) {
  try {
    AtomicFile written(file);
    written.write(text);
    written.commit();
  } catch (const CannotWrite& error) {
    throw failure<MessageId::text_not_written>(file.path, error.reason);
  }
}

std::string readTextFile(const std::filesystem::path& file, std::size_t most_bytes) {
  const std::uint64_t bytes = checkedFileSize(file);
  if (bytes > most_bytes) {
    throw failure<MessageId::file_too_long>(shownName(file), CountArgument::grouped(bytes),
                                            CountArgument::grouped(most_bytes));
  }
  return readHead(file, most_bytes);
}

}  // namespace relievo
