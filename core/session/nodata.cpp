// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/nodata.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/failure.h"
#include "core/cloud/scan.h"
#include "core/io/file_check.h"
#include "core/io/raster/raster.h"
#include "core/session/strays.h"

namespace relievo {
namespace {

// What programs for terrain and rasters write by default where there is no height.
constexpr std::array kUsual{-9999.0,  -99999.0,      -999999.0, -9999999.0, -999.0,  -32768.0,
                            -32767.0, -3.4e38,       -1e38,     -1e37,      -1e30,   -1e20,
                            -1e10,    -2147483648.0, 9999.0,    99999.0,    32767.0, 3.4e38,
                            1e38,     1e37,          1e30,      1e20,       1e10,    2147483647.0};
constexpr double kAsGoodAsZero = 1e-30;   // 1.17549435e-38, the smallest float, and the like.
constexpr double kAway = 3;               // Times the spread of the other heights.
constexpr std::uint64_t kLeastCount = 2;  // Once is a measurement.

}  // namespace

bool isUsualNodata(double value) {
  if (value != 0 && std::abs(value) < kAsGoodAsZero) return true;
  // -3.4e38 is written as -3.4028235e38, -3.40282e38 and so on.
  return std::any_of(kUsual.begin(), kUsual.end(), [value](double usual) {
    return isHeight(value, usual, 0) ||
           (std::abs(usual) > 1e38 && std::abs(value / usual - 1) < 1e-2);
  });
}

namespace {

struct Spread {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double z) {
    low = std::min(low, z);
    high = std::max(high, z);
  }
};

/// @param each  calls `take` with every height
std::optional<SuspectHeight> suspectIn(const Heights& each, double origin_z) {
  Spread all;
  each([&all](double z) { all.add(z); });
  for (const double value : {all.low, all.high}) {
    if (!isUsualNodata(value)) continue;
    Spread others;
    SuspectHeight suspect{.value = value};
    each([&](double z) {
      ++suspect.all;
      if (isHeight(z, value, origin_z)) {
        ++suspect.count;
      } else {
        others.add(z);
      }
    });
    if (suspect.count < kLeastCount || !(others.low <= others.high)) continue;
    const double gap = value < others.low ? others.low - value : value - others.high;
    if (gap > kAway * (others.high - others.low)) return suspect;
  }
  return std::nullopt;
}

}  // namespace

std::optional<SuspectHeight> suspectAmong(const Heights& each) {
  return suspectIn(each, 0);
}

std::optional<SuspectHeight> suspectHeight(const Scan& scan) {
  // The box tells of nearly every file at once that there is nothing to look for.
  if (!scan.info.bounds ||
      (!isUsualNodata(scan.info.bounds->min.z) && !isUsualNodata(scan.info.bounds->max.z))) {
    return std::nullopt;
  }
  return suspectIn(
      [&scan](const std::function<void(double)>& take) {
        for (std::size_t i = 0; i < scan.points.size(); ++i) {
          take(scan.origin.z + static_cast<double>(scan.points[i][2]));
        }
      },
      scan.origin.z);
}

std::optional<SuspectHeight> suspectHeight(const RasterMap& raster) {
  if (raster.is_own_map || !raster.info.bounds ||
      (!isUsualNodata(raster.info.bounds->min.z) && !isUsualNodata(raster.info.bounds->max.z))) {
    return std::nullopt;
  }
  return suspectIn(
      [&raster](const std::function<void(double)>& take) {
        for (std::size_t i = 0; i < raster.values.size(); ++i) {
          if (raster.valid[i]) take(static_cast<double>(raster.values[i]));
        }
      },
      0);
}

std::string heightText(double value) {
  std::array<char, 32> text{};
  // Heights of files are floats: -3.4028235e38 rather than its 39 digits.
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), static_cast<float>(value));
  return error == std::errc{} ? std::string(text.data(), end) : std::to_string(value);
}

Message suspectWords(const SuspectHeight& suspect) {
  return said<MessageId::suspect_heights_left_out>(CountArgument::grouped(suspect.count),
                                                   CountArgument::grouped(suspect.all),
                                                   heightText(suspect.value));
}

Message suspectWordsOfFile(const SuspectHeight& suspect) {
  return said<MessageId::suspect_heights_in_file>(CountArgument::grouped(suspect.count),
                                                  CountArgument::grouped(suspect.all),
                                                  heightText(suspect.value));
}

Message missingWords(std::uint64_t missing, double value) {
  return said<MessageId::heights_taken_as_missing>(CountArgument::grouped(missing),
                                                   heightText(value));
}

std::optional<FileBounds> boundsWithout(const RasterMap& raster, double value) {
  std::optional<FileBounds> box;
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    const auto height = static_cast<double>(raster.values[i]);
    if (!raster.valid[i] || isHeight(height, value, 0)) continue;
    if (!box) {
      box = raster.info.bounds.value_or(FileBounds{});
      box->min.z = box->max.z = height;
    }
    box->min.z = std::min(box->min.z, height);
    box->max.z = std::max(box->max.z, height);
  }
  return box;
}

std::uint64_t takeAsMissing(RasterMap& raster, double value) {
  std::uint64_t missing = 0;
  std::uint64_t left = 0;
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    if (!raster.valid[i]) continue;
    if (isHeight(static_cast<double>(raster.values[i]), value, 0)) {
      raster.valid[i] = false;
      ++missing;
    } else {
      ++left;
    }
  }
  if (missing > 0 && left == 0) {
    throw failure<MessageId::every_height_is_none>(shownName(raster.info.file));
  }
  return missing;
}

}  // namespace relievo
