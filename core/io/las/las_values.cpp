// SPDX-License-Identifier: BSD-3-Clause
// Point data records: LAS specification 1.4 R15, section 2.6; 8-bit colours are to be stored times
// 256 there, and of real files a third does not.
#include "core/io/las/las_values.h"

#include <algorithm>

#include "core/io/file_check.h"
#include "core/io/formats/scalar.h"
#include "core/io/scan_builder.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr int kFirstExtended = 6;  ///< Formats from it on have a byte for the class alone.

std::uint16_t wordAt(const char* at) {
  return loadAs<std::uint16_t>(at, ByteOrder::little);
}

}  // namespace

LasPlaces lasPlaces(int point_format) noexcept {
  constexpr std::array<std::size_t, 11> kColour{0, 0, 20, 28, 0, 28, 0, 30, 30, 0, 30};
  LasPlaces places;
  const std::size_t colour = kColour[static_cast<std::size_t>(point_format)];
  if (colour != 0) places.colour = colour;
  if (point_format >= kFirstExtended) {
    places.classification = 16;
    places.class_bits = 0xFF;
    places.withheld_bit = 0x04;
    places.return_bits = 4;
  }
  return places;
}

bool LasSurvey::look(const char* record) noexcept {
  intensities_ = intensities_ || wordAt(record + kLasIntensityAt) != 0;
  classes_ = classes_ ||
             (static_cast<std::uint8_t>(record[places_.classification]) & places_.class_bits) != 0;
  returns_ = returns_ || isOneOfSeveral(returnsOf(record, places_));
  if (places_.colour) {
    const char* const at = record + *places_.colour;
    most_colour_ = std::max({most_colour_, wordAt(at), wordAt(at + 2), wordAt(at + 4)});
  }
  return !(intensities_ && classes_ && returns_ && (!places_.colour || hasWords()));
}

LasPointMaker::LasPointMaker(const LasHeader& header, const std::optional<LasSurvey>& survey,
                             const ImportOptions& options, std::uint64_t count,
                             ScanBuilder& builder)
    : header_(header),
      places_(lasPlaces(header.point_format)),
      builder_(builder),
      keep_withheld_(options.scan.keep_withheld),
      colours_(survey ? survey->hasColours() : places_.colour.has_value()),
      intensities_(!survey || survey->hasIntensities()),
      classes_(!survey || survey->hasClasses()),
      returns_(!survey || survey->hasReturns()),
      surveyed_(survey.has_value()),
      colour_shift_(survey && survey->hasWords() ? 8 : 0) {
  builder.expectPoints(count);
  if (colours_) {
    builder.expectColours(count, surveyed_);
    builder.info().colour =
        ColourFact{.source = "red green blue", .bits = colour_shift_ != 0 ? 16 : 8, .points = 0};
  }
  if (intensities_) {
    builder.expectIntensities(count, true);
    builder.info().intensity = IntensityRange{0, 65535};
  }
  if (classes_) builder.expectClasses(count);
  if (returns_) builder.expectReturns(count);
}

void LasPointMaker::add(const char* record) {
  if (isWithheld(record, places_)) {
    ++withheld_;
    if (!keep_withheld_) return builder_.addLeftOutPoint();
  }
  const auto coordinate = [&](std::size_t axis) {
    const auto stored = loadAs<std::int32_t>(record + 4 * axis, ByteOrder::little);
    return static_cast<double>(stored) * header_.scale[axis] + header_.offset[axis];
  };
  if (!builder_.addPoint(coordinate(0), coordinate(1), coordinate(2))) return;
  if (colours_) {
    const char* const at = record + *places_.colour;
    const auto channel = [&](std::size_t k) { return wordAt(at + 2 * k); };
    const auto byte = [&](std::size_t k) {
      return static_cast<std::uint8_t>(channel(k) >> colour_shift_);
    };
    if (surveyed_) {
      builder_.addColour(byte(0), byte(1), byte(2));
    } else {
      builder_.addWideColour({static_cast<float>(channel(0)), static_cast<float>(channel(1)),
                              static_cast<float>(channel(2))});
    }
  }
  if (intensities_) {
    const std::uint16_t intensity = wordAt(record + kLasIntensityAt);
    any_intensity_ = any_intensity_ || intensity != 0;
    builder_.addIntensity(intensity);
  }
  if (classes_) {
    const auto number = static_cast<std::uint8_t>(
        static_cast<std::uint8_t>(record[places_.classification]) & places_.class_bits);
    any_class_ = any_class_ || number != 0;
    builder_.addClass(number);
  }
  if (returns_) {
    const std::uint8_t packed = returnsOf(record, places_);
    any_returns_ = any_returns_ || isOneOfSeveral(packed);
    builder_.addReturn(packed);
  }
}

void LasPointMaker::finish() {
  if (!any_intensity_) builder_.dropIntensities();
  if (!any_class_) builder_.dropClasses();
  if (!any_returns_) builder_.dropReturns();
  ScanInfo& info = builder_.info();
  info.withheld = withheld_;
  if (withheld_ == 0) return;
  const CountArgument count = CountArgument::grouped(withheld_);
  info.warnings.push_back(keep_withheld_ ? said<MessageId::withheld_taken>(count)
                                         : said<MessageId::withheld_left_out>(count));
}

}  // namespace relievo
