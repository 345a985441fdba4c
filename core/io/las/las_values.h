// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

#include "core/io/import.h"
#include "core/io/las/las_header.h"

namespace relievo {

class ScanBuilder;

/// Where the records of a point format keep what is read beside coordinates.
struct LasPlaces {
  std::optional<std::size_t> colour;  ///< Three 16-bit numbers.
  std::size_t classification = 15;
  std::uint8_t class_bits = 0x1F;    ///< Of the byte there.
  std::uint8_t withheld_bit = 0x80;  ///< Of byte kLasFlagsAt.
  unsigned return_bits = 3;          ///< Of byte kLasReturnsAt: of the number; that of all follows.
};
LasPlaces lasPlaces(int point_format) noexcept;

inline constexpr std::size_t kLasIntensityAt = 12;  ///< 16 bits.
inline constexpr std::size_t kLasReturnsAt = 14;
inline constexpr std::size_t kLasFlagsAt = 15;

/// Marked as not to be used?
inline bool isWithheld(const char* record, const LasPlaces& places) noexcept {
  return (static_cast<std::uint8_t>(record[kLasFlagsAt]) & places.withheld_bit) != 0;
}

/// As Scan::returns.
inline std::uint8_t returnsOf(const char* record, const LasPlaces& places) noexcept {
  const auto byte = static_cast<std::uint8_t>(record[kLasReturnsAt]);
  const unsigned mask = (1U << places.return_bits) - 1;
  return static_cast<std::uint8_t>((byte & mask) | (byte >> places.return_bits & mask) << 4U);
}

/// Several returns of one pulse? Files without any store 0 or 1 everywhere.
inline bool isOneOfSeveral(std::uint8_t packed) noexcept {
  return packed >> 4U > 1 || (packed & 15U) > 1;
}

/// What the records of one file hold, found before the first is read: whether colours have 8 or 16
/// bits can only be said over all of them, and files with room for values often hold none.
class LasSurvey {
 public:
  explicit LasSurvey(const LasHeader& header) : places_(lasPlaces(header.point_format)) {}

  /// @return  false once no further record can change anything
  bool look(const char* record) noexcept;

  bool hasColours() const noexcept { return most_colour_ > 0; }
  bool hasWords() const noexcept { return most_colour_ > 255; }  ///< 16 bits.
  bool hasIntensities() const noexcept { return intensities_; }
  bool hasClasses() const noexcept { return classes_; }
  bool hasReturns() const noexcept { return returns_; }

 private:
  LasPlaces places_;
  std::uint16_t most_colour_ = 0;
  bool intensities_ = false, classes_ = false, returns_ = false;
};

/// Turns records into points of `builder`, with what they hold beside coordinates.
class LasPointMaker {
 public:
  /// @param survey  what there is to take; nothing: records that are unpacked once only, of which
  ///                all is taken and what proves to be empty dropped at the end
  LasPointMaker(const LasHeader& header, const std::optional<LasSurvey>& survey,
                const ImportOptions& options, std::uint64_t count, ScanBuilder& builder);

  void add(const char* record);
  /// Counts and a warning for people, after the last record.
  void finish();

 private:
  const LasHeader& header_;
  LasPlaces places_;
  ScanBuilder& builder_;
  bool keep_withheld_ = false;
  bool colours_ = false, intensities_ = false, classes_ = false, returns_ = false;
  bool surveyed_ = false, any_intensity_ = false, any_class_ = false, any_returns_ = false;
  unsigned colour_shift_ = 0;
  std::uint64_t withheld_ = 0;
};

}  // namespace relievo
