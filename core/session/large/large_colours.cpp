// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/large_colours.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/threads.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kBlock = 16384;
constexpr std::uint64_t kStep = 1U << 20U;  // Points between two looks at the stop token.

bool isOfSixteenBits(ScalarType type) {
  return type == ScalarType::u8 || type == ScalarType::u16;
}

/// Whole numbers in the order of the floats.
std::uint32_t rankOf(float number) {
  const auto bits = std::bit_cast<std::uint32_t>(number);
  return (bits >> 31U) != 0 ? ~bits : bits | (1U << 31U);
}
float numberOf(std::uint32_t rank) {
  return std::bit_cast<float>((rank >> 31U) != 0 ? rank & ~(1U << 31U) : ~rank);
}

using Counts = std::vector<std::uint64_t>;

/// The entry that the `rank`-th of all lies in; `rank` becomes that within the entry.
std::uint32_t entryOf(const Counts& counts, std::uint64_t& rank) {
  std::uint32_t entry = 0;
  while (rank >= counts[entry]) rank -= counts[entry++];
  return entry;
}

}  // namespace

template <class Look>
void StreamedValues::lookAtAll(int threads, const Task& task, const Look& look) const {
  const std::uint64_t count = stream_->info().points;
  const int workers = threadCount(threads);
  for (std::uint64_t start = 0; start < count; start += kStep) {
    task.check();
    task.report("Looking at colours", static_cast<double>(start) / static_cast<double>(count));
    inParts(start, std::min(start + kStep, count), workers,
            [&](int part, std::uint64_t first, std::uint64_t end) {
              std::vector<FilePoint> block(std::min<std::uint64_t>(kBlock, end - first));
              std::vector<StoredValues> values(block.size());
              while (first < end) {
                const auto wanted = std::min<std::uint64_t>(block.size(), end - first);
                const std::size_t got =
                    stream_->read(first, std::span(block).first(wanted), values);
                if (got == 0) return;
                for (std::size_t i = 0; i < got; ++i) {
                  if (isFinite(block[i])) look(static_cast<std::size_t>(part), values[i]);
                }
                first += got;
              }
            });
    if (look.isDecided()) return;
  }
}

bool StreamedValues::isDecided(const Seen& seen) const {
  const std::optional<ScalarType> colour = stream_->colourType();
  const bool colours_known = !colour || (*colour == ScalarType::u8 && seen.colour.most() > 1) ||
                             (*colour == ScalarType::u16 && seen.colour.bits() == 16);
  const std::optional<ScalarType> intensity = stream_->intensityType();
  const bool intensities_known =
      !intensity ||
      (stream_->hasWordIntensities() ? seen.most_intensity > 0
                                     : isOfSixteenBits(*intensity) && seen.intensity.isWords() &&
                                           seen.intensity.hasIntensities());
  return colours_known && intensities_known;
}

StreamedValues::StreamedValues(const std::vector<std::filesystem::path>& files,
                               const ImportOptions& options, int threads, const Task& task)
    : stream_(std::make_shared<PointFiles>(files, options, task, StreamedParts::values)) {
  const bool colours = stream_->colourType().has_value();
  const bool intensities = stream_->intensityType().has_value();
  if (!colours && !intensities) return;
  struct Survey {
    const StreamedValues& values;
    std::vector<Seen>& parts;
    bool colours, intensities;

    void operator()(std::size_t part, const StoredValues& v) const {
      Seen& seen = parts[part];
      if (colours) seen.colour.look(v.colour);
      if (!intensities) return;
      seen.intensity.look(v.intensity);
      seen.most_intensity = std::max(seen.most_intensity, v.intensity);
    }
    Seen joined() const {
      Seen all;
      for (const Seen& part : parts) {
        all.colour.join(part.colour);
        all.intensity.join(part.intensity);
        all.most_intensity = std::max(all.most_intensity, part.most_intensity);
      }
      return all;
    }
    bool isDecided() const { return values.isDecided(joined()); }
  };
  std::vector<Seen> parts(static_cast<std::size_t>(threadCount(threads)));
  const Survey survey{*this, parts, colours, intensities};
  lookAtAll(threads, task, survey);
  const Seen seen = survey.joined();
  colour_ = seen.colour;
  intensity_ = seen.intensity;
  has_colours_ = colours && colour_.hasColours();
  if (colours && colour_.isBeyond()) warnings_.push_back(said<MessageId::colours_beyond_words>());
  if (!intensities) return;
  has_intensities_ =
      stream_->hasWordIntensities() ? seen.most_intensity > 0 : intensity_.hasIntensities();
  if (has_intensities_ && !stream_->hasWordIntensities() && !intensity_.isWords()) {
    findMiddle(threads, task);
  }
}

/// Exactly, in two looks at the file: by the upper half of the numbers, then by the lower.
void StreamedValues::findMiddle(int threads, const Task& task) {
  struct Counter {
    std::vector<std::array<Counts, 2>>& parts;
    std::optional<std::array<std::uint32_t, 2>> upper;  ///< Halves whose lower ones are counted.

    void operator()(std::size_t part, const StoredValues& v) const {
      if (!std::isfinite(v.intensity)) return;
      const std::uint32_t rank = rankOf(v.intensity);
      for (std::size_t k = 0; k < 2; ++k) {
        if (!upper) {
          ++parts[part][k][rank >> 16U];
          break;
        }
        if (rank >> 16U == (*upper)[k]) ++parts[part][k][rank & 0xFFFFU];
      }
    }
    bool isDecided() const { return false; }
  };
  const auto counted = [&](std::optional<std::array<std::uint32_t, 2>> upper) {
    std::vector<std::array<Counts, 2>> parts(
        static_cast<std::size_t>(threadCount(threads)),
        {Counts(std::size_t{1} << 16U), Counts(std::size_t{1} << 16U)});
    lookAtAll(threads, task, Counter{parts, upper});
    for (std::size_t part = 1; part < parts.size(); ++part) {
      for (std::size_t k = 0; k < 2; ++k) {
        std::transform(parts[0][k].begin(), parts[0][k].end(), parts[part][k].begin(),
                       parts[0][k].begin(), std::plus<>());
      }
    }
    return std::move(parts[0]);
  };
  auto [low_rank, high_rank] = intensity_.middleRanks();
  const Counts upper = counted(std::nullopt)[0];
  const std::array entries{entryOf(upper, low_rank), entryOf(upper, high_rank)};
  const std::array<Counts, 2> lower = counted(entries);
  const auto number = [&](std::size_t k, std::uint64_t rank) {
    return numberOf(entries[k] << 16U | entryOf(lower[k], rank));
  };
  intensity_.setMiddle(number(0, low_rank), number(1, high_rank));
}

std::optional<ColourFact> StreamedValues::colourFact() const {
  if (!has_colours_) return std::nullopt;
  return ColourFact{.source = stream_->colourSource(), .bits = colour_.bits(), .points = 0};
}

std::optional<IntensityRange> StreamedValues::intensityRange() const {
  if (!has_intensities_) return std::nullopt;
  return intensity_.range();
}

ValueSource StreamedValues::source(std::function<bool(const FilePoint&)> keeps) const {
  return {.count = stream_->info().points,
          .read = [stream = stream_, colour = colour_, intensity = intensity_,
                   has_colours = has_colours_, has_intensities = has_intensities_,
                   keeps = std::move(keeps)](std::uint64_t first, std::span<FilePoint> block,
                                             std::span<PointValue> values) {
            std::vector<StoredValues> stored(block.size());
            const std::size_t got = stream->read(first, block, stored);
            constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
            for (std::size_t i = 0; i < got; ++i) {
              if (keeps && isFinite(block[i]) && !keeps(block[i])) block[i] = {kNone, kNone, kNone};
              values[i] = {
                  .colour = has_colours ? colour(stored[i].colour) : Rgba{},
                  .intensity = has_intensities ? intensity(stored[i].intensity) : std::uint16_t{0}};
            }
            return got;
          }};
}

}  // namespace relievo
