// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/prepare/prepare.h"
#include "ui/prepare/prepare_state.h"
#include "ui/vtk/cloud/cloud_scene.h"

namespace relievo {

/// A scan that was read, and what of it is drawn.
struct ReadScan {
  std::shared_ptr<const Scan> scan;
  std::vector<std::uint32_t> shown;  ///< Numbers of the points that are drawn, rising.
  std::vector<Point3f> normals;      ///< Of these.
  double spacing = 0;                ///< Of these, file units.
  std::string sha256;                ///< Of the file as it was read, hexadecimal.
};

/// @param most  points to draw [worker] @throw as importScan
std::shared_ptr<const ReadScan> readScan(const PrepareInput& input, std::size_t most,
                                         const Task& task);
/// The same of a scan that is in memory. [worker] @throw Cancelled
std::shared_ptr<const ReadScan> shownOf(std::shared_ptr<const Scan> scan, const std::string& sha256,
                                        std::size_t most, const Task& task);

/// What a recipe gave, with what it was made of.
struct PrepareResult {
  PrepareChoices choices;
  Recipe recipe;                                       ///< Of `choices`.
  std::vector<std::size_t> used;                       ///< Inputs, in the recipe's order.
  std::vector<std::shared_ptr<const ReadScan>> scans;  ///< As `used`.
  Prepared prepared;
};

enum class CloudStage { before, both, after };
enum class CloudColour { own, scan, distance };

/// What of a result is drawn.
struct CloudWish {
  CloudStage stage = CloudStage::both;
  CloudColour colour = CloudColour::own;
};

/// Points where a result laid them, or as stored before it. Those that went are red among the
/// others. Of CloudColour::distance: how far from the surface of the other scans, from blue at 0 to
/// red at three spacings; grey where no other scan is. [worker] @throw Cancelled
CloudPoints cloudOf(const PrepareResult& result, const CloudWish& wish, const Task& task);
/// One scan as it is stored, in its own colours. [any thread]
CloudPoints cloudOf(const ReadScan& scan);

/// "scan 1" to "scan n" in CloudColour::scan. sRGB.
std::array<std::uint8_t, 3> colourOfScan(std::size_t number);

/// Writes the prepared cloud, byte for byte as `relievo prepare` writes it. The files of the inputs
/// are read once more for their checksums: one that has changed since it was read is refused.
/// [worker] @throw WriteError, FileError, Cancelled
void writePrepared(const PrepareResult& result, const std::filesystem::path& file,
                   const Task& task);

/// Writes the recipe that does the same again, with the poses that were found. [worker]
/// @throw WriteError, FileError, Cancelled
void writeRecipe(const PrepareResult& result, const std::filesystem::path& file, const Task& task);

}  // namespace relievo
