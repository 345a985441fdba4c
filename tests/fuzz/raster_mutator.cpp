// SPDX-License-Identifier: BSD-3-Clause
// Mutations of rasters that keep their form, because GDAL's branches are not seen: what it refuses
// teaches the fuzzer nothing, however near it was.
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "core/io/formats/scalar.h"
#include "tests/core/io/sample_files.h"
#include "tests/fuzz/mutation.h"
#include "tests/fuzz/tiff_form.h"

namespace relievo::fuzz {
namespace {

using test::bytesOf;

constexpr std::string_view kPngHead = "\x89PNG\r\n\x1A\n";

/// CRC-32 of ISO 3309 and PNG, bit by bit.
std::uint32_t pngSum(std::string_view bytes) {
  std::uint32_t crc = ~0U;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int i = 0; i < 8; ++i) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
  }
  return ~crc;
}

/// One chunk's contents; its length and checksum follow.
bool mutatePng(std::string& file, Chance& chance) {
  constexpr std::size_t kAround = 12;  // Length, name and checksum.
  std::vector<std::size_t> chunks;
  for (std::size_t at = kPngHead.size(); at + kAround <= file.size();) {
    const auto length = loadAs<std::uint32_t>(file.data() + at, ByteOrder::big);
    if (length > file.size() - at - kAround) break;
    chunks.push_back(at);
    at += length + kAround;
  }
  if (chunks.empty()) return false;
  const std::size_t at = chunks[chance.below(chunks.size())];
  const auto length = loadAs<std::uint32_t>(file.data() + at, ByteOrder::big);
  std::string contents = file.substr(at + 8, length);
  const std::string name = file.substr(at + 4, 4);
  mutateBytes(contents, name == "IHDR" ? 0 : 16);
  if (name == "IHDR") contents.resize(length, '\0');
  file.replace(at, length + kAround,
               bytesOf(static_cast<std::uint32_t>(contents.size()), true) + name + contents +
                   bytesOf(pngSum(name + contents), true));
  return true;
}

/// A grid of another size, with as many cells as it says.
std::string otherGrid(const std::string& file, Chance& chance) {
  const std::size_t cols = 1 + chance.below(9);
  const std::size_t rows = 1 + chance.below(9);
  std::string grid = "ncols " + std::to_string(cols) + "\nnrows " + std::to_string(rows) + "\n";
  // The other words of the header stay.
  for (std::size_t at = 0; at < file.size();) {
    const std::size_t end = std::min(file.find('\n', at), file.size() - 1);
    const std::string line = file.substr(at, end - at + 1);
    at = end + 1;
    const auto first = static_cast<unsigned char>(line[0]);
    if (std::isalpha(first) != 0 && std::tolower(first) != 'n') grid += line;
  }
  for (std::size_t i = 0; i < cols * rows; ++i) {
    grid += std::to_string(chance.below(20)) + (i % cols == cols - 1 ? "\n" : " ");
  }
  return grid;
}

bool mutateGrid(std::string& file, Chance& chance) {
  if (chance.oneIn(6)) {
    file = otherGrid(file, chance);
    return true;
  }
  return changeNumber(file, chance);
}

bool mutateForm(std::string& file, Chance& chance) {
  if (file.starts_with(kPngHead)) return mutatePng(file, chance);
  return mutateTiff(file, chance) || mutateGrid(file, chance);
}

}  // namespace
}  // namespace relievo::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  using namespace relievo::fuzz;
  Chance chance(seed);
  std::string file(reinterpret_cast<const char*>(data), size);
  if (chance.oneIn(3) || !mutateForm(file, chance)) return LLVMFuzzerMutate(data, size, max_size);
  return handBack(file, data, size, max_size);
}
