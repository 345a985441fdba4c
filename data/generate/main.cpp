// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "data/generate/float_tiff.h"
#include "data/generate/ply_bytes.h"
#include "data/generate/relief_f.h"

namespace {

namespace fs = std::filesystem;
using namespace relievo::samples;

void writeReliefF(const fs::path& folder) {
  const Cloud cloud = makeReliefF();
  writeFile(folder / "relief_f.ply", plyBytes(cloud));
  writeFile(folder / "relief_f_truncated.ply", truncatedPlyBytes(cloud));
  writeFile(folder / "relief_f_reference.tif", floatTiffBytes(reliefFReference(), cloud.unit));
}

}  // namespace

/// relievo-generate-samples FOLDER: writes every sample there. Same bytes on every run.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "Usage: relievo-generate-samples FOLDER\n";
    return 1;
  }
  try {
    const fs::path folder = argv[1];
    fs::create_directories(folder);
    writeReliefF(folder);
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 3;
  }
  return 0;
}
