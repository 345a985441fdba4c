// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/ascii_grid.h"

#include <cctype>
#include <fstream>
#include <string>
#include <vector>

#include "core/io/file_check.h"
#include "core/io/format.h"
#include "core/io/formats/lines.h"
#include "core/io/read_scan.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

/// Words of the lines before the first cell: a keyword and its number each.
std::uint64_t headerWords(const std::string& head) {
  Lines lines(head);
  std::uint64_t words = 0;
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view word = takeWord(rest);
    if (word.empty()) continue;
    const bool keyword = std::isalpha(static_cast<unsigned char>(word.front())) != 0;
    if (!keyword || parseNumber(word)) break;  // "nan" is a cell.
    for (++words; !takeWord(rest).empty();) ++words;
  }
  return words;
}

bool isSpace(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

void checkAsciiGridCells(const std::filesystem::path& file, std::uint64_t promised) {
  constexpr std::size_t kChunk = 1 << 16;
  std::ifstream stream(file, std::ios::binary);
  std::vector<char> chunk(kChunk);
  std::uint64_t words = 0;
  bool in_word = false;
  while (stream.read(chunk.data(), kChunk), stream.gcount() > 0) {
    for (std::streamsize i = 0; i < stream.gcount(); ++i) {
      const bool space = isSpace(chunk[static_cast<std::size_t>(i)]);
      if (!space && !in_word) ++words;
      in_word = !space;
    }
  }
  const std::uint64_t before = headerWords(readHead(file, kSniffedBytes));
  const std::uint64_t found = words > before ? words - before : 0;
  if (found >= promised) return;
  throwReadError(file,
                 said<MessageId::refused_grid_cells>(CountArgument::grouped(promised),
                                                     CountArgument::grouped(found)),
                 said<MessageId::advice_copy_or_export>());
}

}  // namespace relievo
