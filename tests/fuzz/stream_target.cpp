// SPDX-License-Identifier: BSD-3-Clause
// Points in blocks under libFuzzer: the same points as the whole, whatever the blocks.
#include <vector>

#include "core/base/error.h"
#include "core/io/point_reader.h"
#include "tests/fuzz/input_file.h"
#include "tests/fuzz/invariants.h"

namespace {

bool same(const relievo::FilePoint& a, const relievo::FilePoint& b) {
  return a == b || (std::isnan(a.x) && std::isnan(b.x));
}

void readInBlocks(const std::filesystem::path& file, bool accept_incomplete) {
  using namespace relievo;
  ImportOptions options;
  options.accept_incomplete = accept_incomplete;
  const PointReader stream(file, options);
  std::vector<FilePoint> whole(static_cast<std::size_t>(stream.info().points));
  fuzz::require(stream.read(0, whole) == whole.size(), "every point is there");
  std::vector<FilePoint> block(7);
  for (std::size_t first = 0; first < whole.size(); first += block.size()) {
    const std::size_t got = stream.read(first, block);
    fuzz::require(got == std::min(block.size(), whole.size() - first), "blocks are full");
    for (std::size_t i = 0; i < got; ++i) {
      fuzz::require(same(block[i], whole[first + i]), "blocks do not change points");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const relievo::fuzz::InputFile kInput(".bin");
  kInput.write({reinterpret_cast<const char*>(data), size});
  try {
    readInBlocks(kInput.path(), size % 2 == 1);
  } catch (const relievo::FileError& error) {
    relievo::fuzz::checkMessage(error.what());
  }
  return 0;
}
