// SPDX-License-Identifier: BSD-3-Clause
// Packs LAS records as LAZ does, chunk by chunk. For tests only: no file of others is used.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tests/core/io/laz_coder.h"
#include "tests/core/io/laz_first_coder.h"
#include "tests/core/io/sample_files.h"

namespace relievo::test {

/// How records are packed.
struct Packing {
  int format = 0;               ///< 0 to 10.
  std::size_t extra_bytes = 0;  ///< Behind each record's own.
  int version = 3;              ///< Of layered items: 3 or 4; of others: 1, else 2.

  bool layered() const { return format >= 6; }
  bool timed() const { return format == 1 || (format >= 3 && format <= 5); }
  bool infrared() const { return format == 8 || format == 10; }
  bool coloured() const {
    return format == 2 || format == 3 || format == 5 || format == 7 || infrared();
  }
  bool waved() const { return format == 4 || format == 5 || format >= 9; }
  /// Bytes of colour and near infrared.
  std::size_t colourBytes() const { return (coloured() ? 6U : 0U) + (infrared() ? 2U : 0U); }
  /// Bytes before the colour, before the waveform, and before further bytes.
  std::size_t colourAt() const { return layered() ? 30 : timed() ? 28 : 20; }
  std::size_t wavesAt() const { return colourAt() + colourBytes(); }
  std::size_t extraAt() const { return wavesAt() + (waved() ? 29U : 0U); }
};

/// Streams by name: one for all fields, or one each.
using Coders = std::vector<ArithmeticCoder>;

/// Place of a point: both ways to pack it do this alike.
struct PlaceCoder {
  explicit PlaceCoder(std::size_t medians) : x_medians(medians), y_medians(medians) {}

  void code(ArithmeticCoder& place, ArithmeticCoder& height, const char* old, const char* now,
            std::size_t median, std::size_t l, bool single) {
    const auto step = [&](IntegerCoder& of, CoderMedian& m, int at, std::size_t context) {
      const std::uint32_t by =
          numberOf<std::uint32_t>(now + at) - numberOf<std::uint32_t>(old + at);
      of.code(place, m.value(), by, context);
      m.add(by);
    };
    const std::size_t one = single ? 1 : 0;
    step(dx, x_medians[median], 0, one);
    const unsigned kx = dx.k();
    step(dy, y_medians[median], 4, one + (kx < 20 ? kx / 2 * 2 : 20));
    const unsigned k = (kx + dy.k()) / 2;
    const auto z_now = numberOf<std::uint32_t>(now + 8);
    z.code(height, heights[l], z_now, one + (k < 18 ? k / 2 * 2 : 18));
    heights[l] = z_now;
  }

  IntegerCoder dx{32, 2}, dy{32, 22}, z{32, 20};
  std::vector<CoderMedian> x_medians, y_medians;
  std::array<std::uint32_t, 8> heights{};
};

class Point10Coder {
 public:
  explicit Point10Coder(const char* first) : old_(first, 20) {}

  void code(ArithmeticCoder& coder, const char* now) {
    static constexpr const char* kMap =
        "FEDCBA98"
        "E0136AA9"
        "D1247BBA"
        "C3458CCB"
        "B6789DDC"
        "AABCDEED"
        "9ABCDEFE"
        "89ABCDEF";
    const std::uint32_t r = byteAt(now + 14) & 7U, n = byteAt(now + 14) >> 3U & 7U;
    const char digit = kMap[8 * n + r];
    const auto m = static_cast<std::size_t>(digit >= 'A' ? digit - 'A' + 10 : digit - '0');
    const auto grey = numberOf<std::uint16_t>(now + 12);
    const char* const old = old_.data();
    const auto source = numberOf<std::uint16_t>(now + 18);
    const bool new_source = source != numberOf<std::uint16_t>(old + 18);
    coder.symbol(changed_, (old[14] != now[14] ? 32U : 0U) + (grey_[m] != grey ? 16U : 0U) +
                               (old[15] != now[15] ? 8U : 0U) + (old[16] != now[16] ? 4U : 0U) +
                               (old[17] != now[17] ? 2U : 0U) + (new_source ? 1U : 0U));
    if (old[14] != now[14]) coder.symbol(bits_[byteAt(old + 14)], byteAt(now + 14));
    if (grey_[m] != grey) greys_.code(coder, grey_[m], grey, std::min<std::size_t>(m, 3));
    grey_[m] = grey;
    if (old[15] != now[15]) coder.symbol(classes_[byteAt(old + 15)], byteAt(now + 15));
    if (old[16] != now[16]) {
      coder.symbol(angles_[byteAt(now + 14) >> 6U & 1U],
                   (byteAt(now + 16) - byteAt(old + 16)) & 255U);
    }
    if (old[17] != now[17]) coder.symbol(users_[byteAt(old + 17)], byteAt(now + 17));
    if (new_source) sources_.code(coder, numberOf<std::uint16_t>(old + 18), source, 0);
    place_.code(coder, coder, old, now, m, n > r ? n - r : r - n, n == 1);
    old_.assign(now, 20);
  }

 private:
  std::string old_;
  std::array<std::uint16_t, 16> grey_{};
  CoderModel changed_{64};
  std::vector<CoderModel> bits_{256}, classes_{256}, angles_{2}, users_{256};
  IntegerCoder greys_{16, 4}, sources_{16, 1};
  PlaceCoder place_{16};
};

inline ColourCoder::Bytes colourBytes(const char* at) {
  ColourCoder::Bytes bytes{};
  for (std::size_t i = 0; i < 6; ++i) bytes[i] = static_cast<int>(byteAt(at + i));
  return bytes;
}

/// Descriptor, place, size, and four further numbers of a full waveform.
class WavesCoder {
 public:
  void code(ArithmeticCoder& coder, const char* old, const char* now) {
    coder.symbol(descriptor_, byteAt(now));
    const auto place = numberOf<std::uint64_t>(now + 1);
    const auto by = static_cast<std::int64_t>(place - numberOf<std::uint64_t>(old + 1));
    const std::size_t step = by == 0                                  ? 0
                             : by == numberOf<std::uint32_t>(old + 9) ? 1
                             : by == static_cast<std::int32_t>(by)    ? 2
                                                                      : 3;
    coder.symbol(steps_[step_], step);
    step_ = step;
    if (step == 2) {
      distances_.code(coder, distance_, static_cast<std::uint32_t>(by), 0);
      distance_ = static_cast<std::uint32_t>(by);
    } else if (step == 3) {
      coder.raw(static_cast<std::uint32_t>(place), 32);
      coder.raw(static_cast<std::uint32_t>(place >> 32U), 32);
    }
    const auto number = [&](IntegerCoder& of, std::size_t at, std::size_t context) {
      of.code(coder, numberOf<std::uint32_t>(old + at), numberOf<std::uint32_t>(now + at), context);
    };
    number(sizes_, 9, 0);
    number(returns_, 13, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) number(directions_, 17 + 4 * axis, axis);
  }

 private:
  CoderModel descriptor_{256};
  std::vector<CoderModel> steps_ = std::vector<CoderModel>(4, CoderModel(4));
  IntegerCoder distances_{32, 1}, sizes_{32, 1}, returns_{32, 1}, directions_{32, 3};
  std::size_t step_ = 0;
  std::uint32_t distance_ = 0;
};

/// Formats 0 to 5: the first record, then one stream.
inline std::string encodeStream(const std::vector<std::string>& records, const Packing& how) {
  const bool is_first_version = how.version == 1;
  const std::size_t colour_at = how.colourAt(), extra_at = how.extraAt();
  const char* old = records[0].data();
  ArithmeticCoder coder;
  Point10Coder point(old);
  TimeCoder time(1, how.timed() ? numberOf<std::uint64_t>(old + 20) : 0);
  ColourCoder colour;
  std::vector<CoderModel> extra(how.extra_bytes);
  FirstPointCoder first_point;
  FirstTimeCoder first_time;
  FirstColourCoder first_colour;
  IntegerCoder first_extra(8, how.extra_bytes);
  WavesCoder waves;
  for (std::size_t i = 1; i < records.size(); ++i) {
    const char* const now = records[i].data();
    is_first_version ? first_point.code(coder, old, now) : point.code(coder, now);
    if (how.timed()) {
      const auto at = numberOf<std::uint64_t>(now + 20);
      is_first_version ? first_time.code(coder, numberOf<std::uint64_t>(old + 20), at)
                       : time.code(coder, at);
    }
    if (how.coloured() && is_first_version) {
      first_colour.code(coder, old + colour_at, now + colour_at);
    } else if (how.coloured()) {
      colour.code(coder, colourBytes(old + colour_at), colourBytes(now + colour_at));
    }
    if (how.waved()) waves.code(coder, old + how.wavesAt(), now + how.wavesAt());
    for (std::size_t e = 0; e < how.extra_bytes; ++e) {
      const std::uint32_t before = byteAt(old + extra_at + e), byte = byteAt(now + extra_at + e);
      is_first_version ? first_extra.code(coder, before, byte, e)
                       : coder.symbol(extra[e], (byte - before) & 255U);
    }
    old = now;
  }
  return records[0] + coder.finishAlways();
}

/// Models of one scanner channel.
struct ChannelCoder {
  explicit ChannelCoder(const std::string& before)
      : old(before), time(0, numberOf<std::uint64_t>(before.data() + 22)) {
    place.heights.fill(numberOf<std::uint32_t>(before.data() + 8));
    greys.fill(numberOf<std::uint16_t>(before.data() + 12));
  }
  std::string old;
  bool timed = false;
  std::vector<CoderModel> changed = std::vector<CoderModel>(8, CoderModel(128));
  CoderModel next{3}, same{13};
  std::vector<CoderModel> counts = std::vector<CoderModel>(16, CoderModel(16));
  std::vector<CoderModel> returns = std::vector<CoderModel>(16, CoderModel(16));
  PlaceCoder place{12};
  std::vector<CoderModel> classes{64}, users{64};
  std::vector<CoderModel> flags = std::vector<CoderModel>(64, CoderModel(64));
  IntegerCoder intensities{16, 4}, angles{16, 2}, sources{16, 1};
  std::array<std::uint16_t, 8> greys{};
  TimeCoder time;
};

inline std::uint32_t flagsOf(const char* record) {
  return (byteAt(record + 15) & 15U) | byteAt(record + 15) >> 6U << 4U;
}

class Point14Coder {
 public:
  explicit Point14Coder(const std::string& first) : current_(channelOf(first.data())) {
    channels_[current_].emplace(first.substr(0, 30));
  }
  static std::size_t channelOf(const char* record) { return byteAt(record + 15) >> 4U & 3U; }
  std::size_t current() const { return current_; }
  bool switched() const { return switched_; }

  void code(Coders& c, const char* now) {
    ChannelCoder& before = *channels_[current_];
    const std::uint32_t br = byteAt(before.old.data() + 14) & 15U;
    const std::uint32_t bn = byteAt(before.old.data() + 14) >> 4U;
    CoderModel& changes =
        before.changed[(br == 1 ? 1U : 0U) + (br >= bn ? 2U : 0U) + (before.timed ? 4U : 0U)];
    const std::size_t channel = channelOf(now);
    switched_ = channel != current_;
    if (!channels_[channel]) channels_[channel].emplace(before.old);
    ChannelCoder& to = *channels_[channel];
    const char* const old = to.old.data();
    const std::uint32_t r = byteAt(now + 14) & 15U, n = byteAt(now + 14) >> 4U;
    const std::uint32_t old_r = byteAt(old + 14) & 15U, old_n = byteAt(old + 14) >> 4U;
    const bool timed = std::memcmp(old + 22, now + 22, 8) != 0;
    const bool angled = std::memcmp(old + 18, now + 18, 2) != 0;
    const bool sourced = std::memcmp(old + 20, now + 20, 2) != 0;
    const std::uint32_t turn = r == old_r               ? 0
                               : r == (old_r + 1) % 16  ? 1
                               : r == (old_r + 15) % 16 ? 2
                                                        : 3;
    c[0].symbol(changes, turn + (n != old_n ? 4U : 0U) + (angled ? 8U : 0U) + (timed ? 16U : 0U) +
                             (sourced ? 32U : 0U) + (switched_ ? 64U : 0U));
    if (switched_) c[0].symbol(before.next, (channel + 3 - current_) % 4);
    current_ = channel;
    if (n != old_n) c[0].symbol(to.counts[old_n], n);
    if (turn == 3) {
      timed ? c[0].symbol(to.returns[old_r], r) : c[0].symbol(to.same, (r + 14 - old_r) % 16);
    }
    codeFields(c, to, now, r, n, timed);
    if (angled) {
      to.angles.code(c[5], numberOf<std::uint16_t>(old + 18), numberOf<std::uint16_t>(now + 18),
                     timed ? 1 : 0);
    }
    if (sourced) {
      to.sources.code(c[7], numberOf<std::uint16_t>(old + 20), numberOf<std::uint16_t>(now + 20),
                      0);
    }
    if (timed) to.time.code(c[8], numberOf<std::uint64_t>(now + 22));
    to.timed = timed;
    to.old.assign(now, 30);
  }

 private:
  static std::size_t group(std::uint32_t n, std::uint32_t r) {
    const std::uint32_t a = std::min(n, r), b = std::max(n, r);
    constexpr std::string_view kNone = "0123453445555555";
    if (a == 0) return static_cast<std::size_t>(kNone[b] - '0');
    if (a == 1) return b < 3 ? b - 1 : 3;
    if (a == 2) return b == 2 ? 2 : b < 11 ? 4 : 3;
    return a == b || (b - a == 1 && a > 10) ? 5 : 4;
  }

  static void codeFields(Coders& c, ChannelCoder& to, const char* now, std::uint32_t r,
                         std::uint32_t n, bool timed) {
    const char* const old = to.old.data();
    const std::size_t kind = (r == 1 ? 2U : 0U) + (r >= n ? 1U : 0U);
    to.place.code(c[0], c[1], old, now, 2 * group(n, r) + (timed ? 1 : 0),
                  std::min<std::size_t>(n > r ? n - r : r - n, 7), n == 1);
    c[2].symbol(to.classes[2 * (byteAt(old + 16) & 31U) + (kind == 3 ? 1 : 0)], byteAt(now + 16));
    c[3].symbol(to.flags[flagsOf(old)], flagsOf(now));
    std::uint16_t& grey = to.greys[2 * kind + (timed ? 1 : 0)];
    to.intensities.code(c[4], grey, numberOf<std::uint16_t>(now + 12), kind);
    grey = numberOf<std::uint16_t>(now + 12);
    c[6].symbol(to.users[byteAt(old + 17) / 4], byteAt(now + 17));
  }

  std::size_t current_;
  bool switched_ = false;
  std::array<std::optional<ChannelCoder>, 4> channels_;
};

/// Colour, near infrared and further bytes of layered records.
class LayeredCoder {
 public:
  LayeredCoder(const Packing& how, const std::string& first, std::size_t channel)
      : how_(how), seen_(channel) {
    channels_[channel].emplace(how, first.substr(30));
  }

  void code(Coders& c, const char* now, std::size_t channel, bool switched) {
    if (how_.version == 3 && !switched) channel = 0;
    std::string* old = &channels_[seen_]->old;
    if (channel != seen_) {
      const bool is_new = !channels_[channel].has_value();
      if (is_new) channels_[channel].emplace(how_, *old);
      if (is_new || how_.version == 4) old = &channels_[channel]->old;
    }
    seen_ = channel;
    Models& models = *channels_[channel];
    std::size_t layer = 9, at = 0;
    if (how_.coloured()) {
      models.colour.code(c[layer++], colourBytes(old->data()), colourBytes(now + 30));
      at = 6;
    }
    if (how_.infrared()) {
      const std::uint32_t low = byteAt(now + 36), high = byteAt(now + 37);
      const std::uint32_t old_low = byteAt(old->data() + 6), old_high = byteAt(old->data() + 7);
      c[layer].symbol(models.infrared, (low != old_low ? 1U : 0U) + (high != old_high ? 2U : 0U));
      if (low != old_low) c[layer].symbol(models.infrared_bytes[0], (low - old_low) & 255U);
      if (high != old_high) c[layer].symbol(models.infrared_bytes[1], (high - old_high) & 255U);
      ++layer;
      at = 8;
    }
    if (how_.waved()) {
      models.waves.code(c[layer++], old->data() + at, now + 30 + at);
      at += 29;
    }
    for (std::size_t e = 0; e < how_.extra_bytes; ++e, ++at) {
      c[layer++].symbol(models.extra[e], (byteAt(now + 30 + at) - byteAt(old->data() + at)) & 255U);
    }
    old->assign(now + 30, at);
  }

 private:
  struct Models {
    Models(const Packing& how, std::string values)
        : old(std::move(values)), extra(how.extra_bytes) {}
    std::string old;
    ColourCoder colour;
    CoderModel infrared{4};
    std::array<CoderModel, 2> infrared_bytes;
    WavesCoder waves;
    std::vector<CoderModel> extra;
  };
  Packing how_;
  std::size_t seen_;
  std::array<std::optional<Models>, 4> channels_;
};

/// Formats 6 to 10: the first record, numbers of points and bytes, and a stream for each field.
/// Fields that never change have none.
inline std::string encodeLayers(const std::vector<std::string>& records, const Packing& how) {
  // Which bytes of a record each layer stands for; place and flags are always there.
  std::vector<std::array<std::size_t, 2>> fields{{0, 0},  {8, 4},  {16, 1}, {15, 1}, {12, 2},
                                                 {18, 2}, {17, 1}, {20, 2}, {22, 8}};
  if (how.coloured()) fields.push_back({30, 6});
  if (how.infrared()) fields.push_back({36, 2});
  if (how.waved()) fields.push_back({how.wavesAt(), 29});
  for (std::size_t e = 0; e < how.extra_bytes; ++e) fields.push_back({how.extraAt() + e, 1});
  Coders coders(fields.size());
  Point14Coder point(records[0]);
  LayeredCoder more(how, records[0], point.current());
  for (std::size_t i = 1; i < records.size(); ++i) {
    point.code(coders, records[i].data());
    more.code(coders, records[i].data(), point.current(), point.switched());
  }
  std::string sizes, bodies;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto [at, count] = fields[i];
    const bool unchanged =
        i > 0 && std::all_of(records.begin(), records.end(),
                             [&, at = at, count = count](const auto& record) {
                               return record.compare(at, count, records[0], at, count) == 0;
                             });
    const std::string body = unchanged ? ""
                             : i == 0  ? coders[i].finishAlways()
                                       : coders[i].finish();
    sizes += bytesOf(static_cast<std::uint32_t>(body.size()));
    bodies += body;
  }
  return records[0] + bytesOf(static_cast<std::uint32_t>(records.size())) + sizes + bodies;
}

inline std::string encodeChunk(const std::vector<std::string>& records, const Packing& how) {
  return how.layered() ? encodeLayers(records, how) : encodeStream(records, how);
}

}  // namespace relievo::test
