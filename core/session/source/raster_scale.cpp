// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/source/raster_scale.h"

#include <algorithm>
#include <cmath>

#include "core/base/failure.h"
#include "core/io/raster/raster.h"

namespace relievo {
namespace {

constexpr double kGuessedRise = 0.1;  // Of the longer side.

bool isSaid(UnitSource source) {
  return source == UnitSource::given || source == UnitSource::file;
}

/// 0.00153 becomes 0.001: the one digit that is left is below, so that nothing rises too high.
double downToOneDigit(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  return std::max(1.0, std::floor(value / power)) * power;
}

NumberArgument millimetres(double value) {
  return {.value = value,
          .digits = 4,
          .form = NumberArgument::Form::significant,
          .unit = MessageUnit::millimetre};
}

}  // namespace

bool ScaleInUse::isOpen() const {
  return !is_placed && !(isSaid(pixel_source) && isSaid(height_source));
}

ScaleInUse scaleInUse(const RasterHead& raster, LengthUnit unit, UnitSource unit_source,
                      const RasterScale& said, double low, double high) {
  if ((said.pixel_mm && !(*said.pixel_mm > 0)) || (said.height_mm && *said.height_mm == 0)) {
    throw failure<MessageId::raster_scale_is_none>();
  }
  const double mm = mmPer(unit);
  ScaleInUse scale{.pixel_mm = said.pixel_mm.value_or(raster.pixel * mm),
                   .height_mm = said.height_mm.value_or(mm),
                   .pixel_source = said.pixel_mm ? UnitSource::given : unit_source,
                   .height_source = said.height_mm ? UnitSource::given : unit_source,
                   .zero = said.zero,
                   .is_placed = raster.is_placed};
  const double longer_mm = scale.pixel_mm * (std::max(raster.size.cols, raster.size.rows) - 1);
  const double rise_mm = (high - low) * mm;
  if (!raster.is_placed && !isSaid(scale.height_source) && rise_mm > longer_mm) {
    scale.height_mm = downToOneDigit(kGuessedRise * longer_mm / (high - low));
    scale.height_source = UnitSource::guessed;
  }
  return scale;
}

std::optional<Message> scaleWords(const ScaleInUse& scale) {
  if (!scale.isOpen()) return std::nullopt;
  const NumberArgument pixel = millimetres(scale.pixel_mm);
  const NumberArgument height = millimetres(scale.height_mm);
  return scale.height_source == UnitSource::guessed
             ? said<MessageId::raster_size_guessed>(pixel, height)
             : said<MessageId::raster_size_assumed>(pixel, height);
}

}  // namespace relievo
