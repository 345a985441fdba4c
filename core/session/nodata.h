// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/message/message.h"

namespace relievo {

struct FileBounds;  // core/cloud/scan.h
struct Scan;        // core/cloud/scan.h
struct RasterMap;   // core/io/raster/raster.h

/// What somebody said of heights that stand for none and are not declared as such in the file;
/// while nothing is said, a suspect one is left out (docs/adr/0216).
struct NodataChoice {
  std::optional<double> value;  ///< This height is none, file unit; nothing: every height is one.
  friend bool operator==(const NodataChoice&, const NodataChoice&) = default;
};

/// A height that programs write where there is none, far from all other heights of the file.
struct SuspectHeight {
  double value = 0;         ///< File unit.
  std::uint64_t count = 0;  ///< Points or cells that have it.
  std::uint64_t all = 0;
  friend bool operator==(const SuspectHeight&, const SuspectHeight&) = default;
};

/// The lowest or highest height (file z) if it is one of -9999, -32768 and the like, or as good as
/// zero where others are not, several times, and the others lie close together beside the way to
/// it. Does not depend on the order of points or cells. [worker]
std::optional<SuspectHeight> suspectHeight(const Scan& scan);
std::optional<SuspectHeight> suspectHeight(const RasterMap& raster);

/// The same of heights that `each` hands over one by one, as often as it is asked.
using Heights = std::function<void(const std::function<void(double)>& take)>;
std::optional<SuspectHeight> suspectAmong(const Heights& each);
/// Whether a height is one that programs write for none; cheap, and says nothing of the others.
bool isUsualNodata(double value);

/// "1 204 of 40 000 heights are -9999, which often stands for a missing one; ..."
Message suspectWords(const SuspectHeight& suspect);
/// The same of a file that is only looked at.
Message suspectWordsOfFile(const SuspectHeight& suspect);
Message missingWords(std::uint64_t missing, double value);

/// The box of the heights that are not this one, file unit; nothing: there is none.
std::optional<FileBounds> boundsWithout(const RasterMap& raster, double value);

/// Marks the cells with this height as none. @return  how many  @throw FileError  none is left
std::uint64_t takeAsMissing(RasterMap& raster, double value);

/// "-9999", "1.17549435e-38"
std::string heightText(double value);

}  // namespace relievo
