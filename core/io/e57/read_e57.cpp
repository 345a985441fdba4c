// SPDX-License-Identifier: BSD-3-Clause
// E57: the points of all scans, moved to the file's common axes. Pictures are left aside.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/e57/e57_pages.h"
#include "core/io/e57/e57_scans.h"
#include "core/io/e57/e57_stream.h"
#include "core/io/file_check.h"
#include "core/io/formats/reader_steps.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kPointsPerReport = 1 << 14;

/// Range, azimuth and elevation, in metres and radians.
std::array<double, 3> cartesian(const std::array<double, 3>& s) {
  return {s[0] * std::cos(s[2]) * std::cos(s[1]), s[0] * std::cos(s[2]) * std::sin(s[1]),
          s[0] * std::sin(s[2])};
}

/// A scan whose packets were looked at, and which of its fields make a point.
struct SoundScan {
  E57Scan scan;
  E57Section section;
  bool is_cartesian = true;
  std::array<std::size_t, 3> axes{};
  std::optional<std::size_t> invalid;
  std::optional<std::array<std::size_t, 3>> colour;
  std::optional<std::size_t> colour_invalid, intensity, intensity_invalid;
};

/// What a channel's numbers run over: stated with the field, else beside it, else a byte. Limits of
/// 0 and 0 are none.
std::array<double, 2> colourLimits(const SoundScan& sound, std::size_t channel) {
  const auto usable = [](const std::optional<std::array<double, 2>>& limits) {
    return limits && (*limits)[1] > (*limits)[0];
  };
  const auto& stated = sound.scan.fields[(*sound.colour)[channel]].limits;
  if (usable(stated)) return *stated;
  const auto& beside = sound.scan.colour_limits[channel];
  return usable(beside) ? *beside : std::array<double, 2>{0, 255};
}

/// One point's colour as bytes, from numbers within limits.
class E57Colour {
 public:
  explicit E57Colour(const SoundScan& sound) {
    for (std::size_t k = 0; k < 3; ++k) limits_[k] = colourLimits(sound, k);
  }
  std::uint8_t byte(std::size_t channel, double value) const {
    const auto& [low, high] = limits_[channel];
    constexpr double kWords = 65535;
    if (low == 0 && high == kWords) {  // As of other formats: point_values.h.
      return static_cast<std::uint8_t>(static_cast<unsigned>(std::clamp(value, low, high)) >> 8U);
    }
    const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
    return std::isnan(share) ? std::uint8_t{0}
                             : static_cast<std::uint8_t>(std::lround(share * 255));
  }
  int bits() const {
    const double span = limits_[0][1] - limits_[0][0];
    return span > 255 ? 16 : span > 1 ? 8 : 32;
  }

 private:
  std::array<std::array<double, 2>, 3> limits_;
};

/// @throw E57Fault, Cancelled
SoundScan checkedScan(E57Scan scan, E57Pages& pages) {
  if (scan.fault) throw E57Fault(*scan.fault);
  SoundScan sound;
  sound.is_cartesian = scan.find("cartesianX").has_value();
  constexpr std::array<std::string_view, 3> kCartesian{"cartesianX", "cartesianY", "cartesianZ"};
  constexpr std::array<std::string_view, 3> kSpherical{"sphericalRange", "sphericalAzimuth",
                                                       "sphericalElevation"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view name = sound.is_cartesian ? kCartesian[axis] : kSpherical[axis];
    const auto found = scan.find(name);
    if (!found) throw E57Fault(said<MessageId::e57_without_field>(name));
    sound.axes[axis] = *found;
  }
  sound.invalid = scan.find(sound.is_cartesian ? "cartesianInvalidState" : "sphericalInvalidState");
  const auto red = scan.find("colorRed"), green = scan.find("colorGreen"),
             blue = scan.find("colorBlue");
  if (red && green && blue) sound.colour = std::array{*red, *green, *blue};
  sound.colour_invalid = scan.find("isColorInvalid");
  sound.intensity = scan.find("intensity");
  sound.intensity_invalid = scan.find("isIntensityInvalid");
  if (scan.records > 0) sound.section = openE57Section(scan, pages);
  sound.scan = std::move(scan);
  return sound;
}

/// "1 of 3 scans was left out: scan 2 "Tower" (a packet of its points makes no sense)."
class LeftOut {
 public:
  void add(std::size_t number, const std::string& name, const Message& fault) {
    constexpr std::size_t kNamed = 3;
    if (++count_ == 1) first_fault_ = fault;
    if (count_ > kNamed) return;
    const CountArgument shown(number);
    if (name.empty()) {
      list_.push_back(said<MessageId::e57_scan>(shown, WordsArgument::clause(fault)));
    } else {
      list_.push_back(said<MessageId::e57_named_scan>(shown, printable(name.substr(0, 60)),
                                                      WordsArgument::clause(fault)));
    }
  }
  std::size_t count() const noexcept { return count_; }
  /// Only where there is one.
  const Message& firstFault() const noexcept { return first_fault_; }
  Message sentence(std::size_t all) const {
    if (count_ > list_.size()) {
      return said<MessageId::e57_scans_and_others_left_out>(count_, all, list_);
    }
    return said<MessageId::e57_scans_left_out>(count_, all, list_);
  }

 private:
  std::size_t count_ = 0;
  std::vector<Message> list_;
  Message first_fault_;
};

class E57Reader {
 public:
  explicit E57Reader(const ReadJob& job)
      : job_(job), pages_(job), builder_(job.file, job.options) {}

  Scan read() {
    builder_.info().format = "E57";
    builder_.info().unit = LengthUnit::m;  // The standard allows no other.
    const std::vector<SoundScan> scans = soundScans();
    for (const SoundScan& sound : scans) {
      promised_ =
          sound.scan.records > ~promised_ ? ~std::uint64_t{0} : promised_ + sound.scan.records;
    }
    // Refused here, because points that are all the same need no bytes in the file.
    builder_.requireRoom(promised_);
    for (const SoundScan& sound : scans) readScan(sound);
    const std::uint64_t found = builder_.pointCount();
    if (found < promised_) {
      handleTruncation({RecordKind::points, promised_, found, found}, job_, builder_.info());
    }
    return builder_.finish();
  }

 private:
  /// Those that can be read; a warning names the others.
  std::vector<SoundScan> soundScans() {
    std::vector<E57Scan> all = listE57Scans(pages_.xml());
    std::vector<SoundScan> sound;
    LeftOut left_out;
    checkParts(job_, all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (!isWantedPart(job_, i)) continue;
      const std::string name = all[i].name;
      try {
        sound.push_back(checkedScan(std::move(all[i]), pages_));
      } catch (const E57Fault& fault) {
        left_out.add(i + 1, name, fault.why);
      }
    }
    if (sound.empty()) throw E57Fault(left_out.firstFault());
    if (left_out.count() > 0) {
      builder_.info().warnings.push_back(left_out.sentence(all.size()));
    }
    return sound;
  }

  /// A scan that ends early leaves the next ones as they are.
  void readScan(const SoundScan& sound) {
    const auto stream = [&](std::size_t field) {
      return E57Stream(pages_, sound.section, sound.scan.fields[field], field);
    };
    const auto streamIfAny = [&](std::optional<std::size_t> field) {
      std::optional<E57Stream> found;
      if (field) found.emplace(stream(*field));
      return found;
    };
    beginPart(sound);
    std::array streams{stream(sound.axes[0]), stream(sound.axes[1]), stream(sound.axes[2])};
    std::optional<E57Stream> state = streamIfAny(sound.invalid);
    std::optional<ColourStreams> colour;
    if (sound.colour) {
      const auto& [red, green, blue] = *sound.colour;
      colour.emplace(ColourStreams{{stream(red), stream(green), stream(blue)},
                                   streamIfAny(sound.colour_invalid),
                                   E57Colour(sound)});
      noteColours(*colour);
    }
    std::optional<E57Stream> intensity = streamIfAny(sound.intensity);
    std::optional<E57Stream> no_intensity = streamIfAny(sound.intensity_invalid);
    for (std::uint64_t i = 0; i < sound.scan.records; ++i) {
      if (i % kPointsPerReport == 0) report();
      std::array<double, 3> p{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto value = streams[axis].next();
        if (!value) return;
        p[axis] = *value;
      }
      if (state) {
        const auto value = state->next();
        if (!value) return;
        if (*value != 0) p = {kNoCoordinate, kNoCoordinate, kNoCoordinate};
      }
      p = sound.scan.pose(sound.is_cartesian ? p : cartesian(p));
      const bool kept = builder_.addPoint(p[0], p[1], p[2]);
      if (colour) readColour(*colour, kept);
      if (intensity) readIntensity(*intensity, no_intensity, kept);
    }
  }

  struct ColourStreams {
    std::array<E57Stream, 3> channels;
    std::optional<E57Stream> invalid;
    E57Colour colour;
  };

  void beginPart(const SoundScan& sound) {
    ScanPart part{.name = printable(sound.scan.name), .points = 0, .viewpoint = std::nullopt};
    const auto& t = sound.scan.pose.translation;
    if (sound.scan.has_pose) part.viewpoint = FilePoint{t[0], t[1], t[2]};
    builder_.beginPart(std::move(part));
  }

  void noteColours(const ColourStreams& colour) {
    auto& fact = builder_.info().colour;
    if (!fact) fact = ColourFact{.source = "colorRed colorGreen colorBlue", .bits = 8, .points = 0};
    fact->bits = std::max(fact->bits, colour.colour.bits());
  }

  /// A colour missing at the end is none: the point is there all the same.
  void readColour(ColourStreams& streams, bool kept) {
    std::array<std::uint8_t, 3> bytes{};
    bool valid = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = streams.channels[k].next();
      valid = valid && value.has_value();
      if (value) bytes[k] = streams.colour.byte(k, *value);
    }
    if (streams.invalid) valid = streams.invalid->next().value_or(1) == 0 && valid;
    if (!kept) return;
    if (valid) {
      builder_.addColour(bytes[0], bytes[1], bytes[2]);
    } else {
      builder_.addNoColour();
    }
  }

  void readIntensity(E57Stream& intensity, std::optional<E57Stream>& invalid, bool kept) {
    double value = intensity.next().value_or(kNoCoordinate);
    if (invalid && invalid->next().value_or(1) != 0) value = kNoCoordinate;
    if (kept) builder_.addWideIntensity(static_cast<float>(value));
  }

  void report() const {
    job_.task.check();
    job_.task.report("reading points",
                     static_cast<double>(builder_.pointCount()) / static_cast<double>(promised_));
  }

  const ReadJob& job_;
  E57Pages pages_;
  ScanBuilder builder_;
  std::uint64_t promised_ = 0;
};

}  // namespace

Scan readE57(const ReadJob& job) {
  try {
    return E57Reader(job).read();
  } catch (const E57Fault& fault) {
    throwReadError(job.file, fault.why, said<MessageId::advice_damaged_export>());
  }
}

}  // namespace relievo
