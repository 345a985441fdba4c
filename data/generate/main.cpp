// SPDX-License-Identifier: BSD-3-Clause
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "data/generate/coin.h"
#include "data/generate/float_tiff.h"
#include "data/generate/panel.h"
#include "data/generate/ply_bytes.h"
#include "data/generate/relief_f.h"
#include "data/generate/ruin.h"

namespace {

namespace fs = std::filesystem;
using namespace relievo::samples;

void writeReliefF(const fs::path& folder) {
  const Cloud cloud = makeReliefF();
  writeFile(folder / "relief_f.ply", plyBytes(cloud));
  writeFile(folder / "relief_f_truncated.ply", truncatedPlyBytes(cloud));
  writeFile(folder / "relief_f_reference.tif", floatTiffBytes(reliefFReference(), cloud.unit));
}

/// NAME.ply and NAME_reference.tif.
void writeSample(const fs::path& folder, const std::string& name, const Cloud& cloud,
                 const Reference& reference) {
  writeFile(folder / (name + ".ply"), plyBytes(cloud));
  writeFile(folder / (name + "_reference.tif"), floatTiffBytes(reference, cloud.unit));
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
    writeSample(folder, "coin", makeCoin(), coinReference());
    writeSample(folder, "panel", makePanel(), panelReference());
    const Cloud ruin = makeRuin();
    writeSample(folder, "ruin", ruin, ruinReference());
    writeFile(folder / "ruin_court_reference.tif", floatTiffBytes(ruinCourtReference(), ruin.unit));
  } catch (const std::exception& e) {
    std::cerr << e.what() << '\n';
    return 3;
  }
  return 0;
}
