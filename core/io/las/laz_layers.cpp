// SPDX-License-Identifier: BSD-3-Clause
// Point formats 6 to 10: every field of a chunk in a stream of its own. What changes from point to
// point is learnt for each of four scanner channels.
#include <array>
#include <cstring>
#include <optional>
#include <span>

#include "core/io/formats/scalar.h"
#include "core/io/las/laz_chunk.h"
#include "core/io/las/laz_fields.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::size_t kChannels = 4;
constexpr std::size_t kPointBytes = 30;
constexpr std::uint16_t kOwnChannelVersion = 4;

/// Streams of a record's first 30 bytes, in the file's order.
enum Layer : std::size_t {
  kPlace,
  kHeight,
  kClass,
  kFlags,
  kIntensity,
  kAngle,
  kUser,
  kSource,
  kTime,
  kPointLayers
};

/// Bits of what changes with a point.
enum Changed : unsigned {
  kReturnBits = 3,
  kReturnsBit = 4,
  kAngleBit = 8,
  kTimeBit = 16,
  kSourceBit = 32,
  kChannelBit = 64
};

/// Which models a pair of return and number of returns shares.
unsigned returnGroup(unsigned n, unsigned r) {
  constexpr std::array<std::uint8_t, 16> kOfNone{0, 1, 2, 3, 4, 5, 3, 4, 4, 5, 5, 5, 5, 5, 5, 5};
  const unsigned a = std::min(n, r), b = std::max(n, r);
  if (a == 0) return kOfNone[b];
  if (a == 1) return b == 1 ? 0 : b == 2 ? 1 : 3;
  if (a == 2) return b == 2 ? 2 : b <= 10 ? 4 : 3;
  return a == b || (b == a + 1 && a >= 11) ? 5 : 4;
}

/// Fields of a point that its layers change.
struct Point14 {
  std::uint32_t x = 0, y = 0, z = 0;
  std::uint32_t r = 0, n = 0;  ///< Return and number of returns.
  std::uint32_t flags = 0;     ///< Class flags, scan direction, edge of flight line.
  std::uint32_t classification = 0, user = 0, angle = 0, source = 0;
  std::uint16_t intensity = 0;
  std::uint64_t time = 0;

  static Point14 of(const char* record) {
    const auto byte = [record](std::size_t at) -> std::uint32_t {
      return static_cast<unsigned char>(record[at]);
    };
    Point14 p;
    p.x = loadAs<std::uint32_t>(record, ByteOrder::little);
    p.y = loadAs<std::uint32_t>(record + 4, ByteOrder::little);
    p.z = loadAs<std::uint32_t>(record + 8, ByteOrder::little);
    p.intensity = loadAs<std::uint16_t>(record + 12, ByteOrder::little);
    p.r = byte(14) & 15U;
    p.n = byte(14) >> 4U;
    p.flags = (byte(15) & 15U) | (byte(15) >> 6U & 3U) << 4U;
    p.classification = byte(16);
    p.user = byte(17);
    p.angle = loadAs<std::uint16_t>(record + 18, ByteOrder::little);
    p.source = loadAs<std::uint16_t>(record + 20, ByteOrder::little);
    p.time = loadAs<std::uint64_t>(record + 22, ByteOrder::little);
    return p;
  }

  void store(char* record, std::size_t channel) const {
    storeLittle(record, x);
    storeLittle(record + 4, y);
    storeLittle(record + 8, z);
    storeLittle(record + 12, intensity);
    record[14] = static_cast<char>(r | n << 4U);
    record[15] = static_cast<char>((flags & 15U) | channel << 4U | flags >> 4U << 6U);
    record[16] = static_cast<char>(classification);
    record[17] = static_cast<char>(user);
    storeLittle(record + 18, static_cast<std::uint16_t>(angle));
    storeLittle(record + 20, static_cast<std::uint16_t>(source));
    storeLittle(record + 22, time);
  }
};

/// Models of one channel, from the last point of the channel before.
struct Channel {
  explicit Channel(const Point14& before)
      : last(before), time(LazTime::Unchanged::said_elsewhere, before.time) {
    heights.fill(before.z);
    greys.fill(before.intensity);
  }

  Point14 last;
  bool time_changed = false;
  LazBytes changed{8, 128}, next_channel{1, 3}, counts{16, 16}, returns{16, 16}, same_pulse{1, 13};
  IntegerModel x_steps{32, 2}, y_steps{32, 22}, height_steps{32, 20};
  std::array<RunningMedian, 12> x_medians, y_medians;
  std::array<std::uint32_t, 8> heights{};
  LazBytes classes{64}, flags{64, 64}, users{64};
  IntegerModel intensities{16, 4}, angles{16, 2}, sources{16, 1};
  std::array<std::uint16_t, 8> greys{};
  LazTime time;
};

using Layers = std::vector<std::optional<ArithmeticDecoder>>;

/// Return, number of returns, and bits of what changes; x and y.
unsigned decodeReturns(ArithmeticDecoder& decoder, Channel& channel, unsigned changed) {
  Point14& p = channel.last;
  if ((changed & kReturnsBit) != 0) p.n = channel.counts.decode(decoder, p.n);
  switch (changed & kReturnBits) {
    case 1:
      p.r = (p.r + 1) % 16;
      break;
    case 2:
      p.r = (p.r + 15) % 16;
      break;
    case 3:
      p.r = (changed & kTimeBit) != 0 ? channel.returns.decode(decoder, p.r)
                                      : (p.r + channel.same_pulse.decode(decoder, 0) + 2) % 16;
      break;
    default:
      break;
  }
  return (p.r == 1 ? 2U : 0U) + (p.r >= p.n ? 1U : 0U);
}

void decodePlace(Layers& layers, Channel& channel, std::size_t median) {
  Point14& p = channel.last;
  ArithmeticDecoder& decoder = *layers[kPlace];
  const unsigned single = p.n == 1 ? 1 : 0;
  const auto step = [&](IntegerModel& model, RunningMedian& of, unsigned context) {
    const std::uint32_t by = model.decode(decoder, static_cast<std::uint32_t>(of.value()), context);
    of.add(static_cast<std::int32_t>(by));
    return by;
  };
  p.x += step(channel.x_steps, channel.x_medians[median], single);
  const unsigned kx = channel.x_steps.lastBits();
  p.y += step(channel.y_steps, channel.y_medians[median], single + (kx < 20 ? kx & ~1U : 20));
  if (!layers[kHeight]) return;
  const unsigned k = (kx + channel.y_steps.lastBits()) / 2;
  std::uint32_t& height = channel.heights[std::min(p.n > p.r ? p.n - p.r : p.r - p.n, 7U)];
  height = channel.height_steps.decode(*layers[kHeight], height, single + (k < 18 ? k & ~1U : 18));
  p.z = height;
}

/// All that is not place and return. @param kind  2 for first returns, + 1 for last ones
void decodeAttributes(Layers& layers, Channel& channel, unsigned kind, unsigned changed) {
  Point14& p = channel.last;
  const unsigned timed = (changed & kTimeBit) != 0 ? 1 : 0;
  if (auto& layer = layers[kClass]) {
    p.classification =
        channel.classes.decode(*layer, 2 * (p.classification & 31U) + (kind == 3 ? 1 : 0));
  }
  if (auto& layer = layers[kFlags]) p.flags = channel.flags.decode(*layer, p.flags);
  if (auto& layer = layers[kIntensity]) {
    std::uint16_t& grey = channel.greys[2 * kind + timed];
    grey = static_cast<std::uint16_t>(channel.intensities.decode(*layer, grey, kind));
    p.intensity = grey;
  }
  if (auto& layer = layers[kAngle]; layer && (changed & kAngleBit) != 0) {
    p.angle = channel.angles.decode(*layer, p.angle, timed);
  }
  if (auto& layer = layers[kUser]) p.user = channel.users.decode(*layer, p.user / 4);
  if (auto& layer = layers[kSource]; layer && (changed & kSourceBit) != 0) {
    p.source = channel.sources.decode(*layer, p.source, 0);
  }
  if (auto& layer = layers[kTime]; layer && timed != 0) p.time = channel.time.decode(*layer);
  channel.time_changed = timed != 0;
}

/// What follows the first 30 bytes: colour, near infrared, waveforms, further bytes. Items of
/// version 3 go on from the values of the channel that they saw last (see Items::values).
class LayeredItem {
 public:
  LayeredItem(const LazItem& item, const char* first, std::size_t channel)
      : item_(item), seen_(channel) {
    channels_[channel].emplace(item);
    values_[channel].assign(first, first + item.bytes);
  }

  std::size_t layerCount() const { return layersOf(item_); }

  /// @param channel   of the point
  /// @param switched  the point before was of another channel
  void decode(std::span<std::optional<ArithmeticDecoder>> layers, std::size_t channel,
              bool switched, char* record) {
    if (item_.version < kOwnChannelVersion && !switched) channel = 0;
    std::vector<char>* values = &values_[seen_];
    if (channel != seen_) {
      const bool is_new = !channels_[channel];
      if (is_new) {
        channels_[channel].emplace(item_);
        values_[channel] = *values;
      }
      // Coders of version 3 forget to turn to the values of a channel that they know already.
      if (is_new || item_.version >= kOwnChannelVersion) values = &values_[channel];
      seen_ = channel;
    }
    channels_[channel]->decode(item_, layers, values->data());
    std::memcpy(record, values->data(), values->size());
  }

 private:
  struct Models {
    explicit Models(const LazItem& item)
        : bytes(item.kind == LazItemKind::bytes14 ? item.bytes : 0) {}

    void decode(const LazItem& item, std::span<std::optional<ArithmeticDecoder>> layers,
                char* values) {
      if (item.kind == LazItemKind::bytes14) {
        for (std::size_t i = 0; i < item.bytes; ++i) {
          if (!layers[i]) continue;
          values[i] = static_cast<char>(static_cast<unsigned char>(values[i]) +
                                        bytes.decode(*layers[i], i));
        }
        return;
      }
      if (item.kind == LazItemKind::waves14) {
        if (layers[0]) waves.decode(*layers[0], values);
        return;
      }
      if (layers[0]) {
        LazColour colour{};
        for (std::size_t i = 0; i < 3; ++i) {
          colour[i] = loadAs<std::uint16_t>(values + 2 * i, ByteOrder::little);
        }
        colour = colours.decode(*layers[0], colour);
        for (std::size_t i = 0; i < 3; ++i) storeLittle(values + 2 * i, colour[i]);
      }
      if (item.kind == LazItemKind::colour_infrared14 && layers[1]) {
        const auto last = loadAs<std::uint16_t>(values + 6, ByteOrder::little);
        storeLittle(values + 6, infrared.decode(*layers[1], last));
      }
    }

    LazColours colours;
    LazInfrared infrared;
    LazWaves waves;
    LazBytes bytes;
  };

  LazItem item_;
  std::size_t seen_;  ///< Channel of the values that come next.
  std::array<std::optional<Models>, kChannels> channels_;
  std::array<std::vector<char>, kChannels> values_;
};

/// Streams of a chunk, from the sizes before them. Empty: nothing changes, or it is not wanted.
class LayerReader {
 public:
  LayerReader(std::string_view sizes, std::string_view bytes) : sizes_(sizes), bytes_(bytes) {}

  std::optional<ArithmeticDecoder> next(bool wanted) {
    const auto size = loadAs<std::uint32_t>(sizes_.data(), ByteOrder::little);
    sizes_.remove_prefix(4);
    if (size > bytes_.size()) throw LazDamage(said<MessageId::laz_shorter_than_layers>());
    const std::string_view layer = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    if (size == 0 || !wanted) return std::nullopt;
    return ArithmeticDecoder(layer);
  }
  std::size_t left() const { return bytes_.size(); }

 private:
  std::string_view sizes_, bytes_;
};

bool isWanted(const LazItem& item, std::size_t layer, const LazWanted& wanted) {
  if (item.kind == LazItemKind::bytes14 || item.kind == LazItemKind::waves14) return wanted.others;
  return layer == 0 ? wanted.colours : wanted.others;
}

class LayersDecoder : public LazChunkDecoder {
 public:
  LayersDecoder(const LazLayout& layout, std::string_view bytes, std::uint64_t points,
                const LazWanted& wanted)
      : first_(bytes.substr(0, layout.record_bytes)),
        current_(static_cast<unsigned char>(first_[15]) >> 4U & 3U) {
    std::size_t at = 0;
    std::size_t layer_count = kPointLayers;
    for (const LazItem& item : layout.items) {
      if (at == 0) {
        requirePoint(item);
      } else {
        items_.push_back({LayeredItem(item, first_.data() + at, current_), at, layer_count});
        layer_count += items_.back().what.layerCount();
      }
      at += item.bytes;
    }
    bytes.remove_prefix(layout.record_bytes);
    if (bytes.size() < 4 + 4 * layer_count) throw LazDamage(said<MessageId::laz_ends_in_layers>());
    if (loadAs<std::uint32_t>(bytes.data(), ByteOrder::little) != points) {
      throw LazDamage(said<MessageId::laz_other_count>());
    }
    openLayers(layout,
               LayerReader(bytes.substr(4, 4 * layer_count), bytes.substr(4 + 4 * layer_count)),
               wanted);
    if (!layers_[kPlace] && points > 1) throw LazDamage(said<MessageId::laz_without_coordinates>());
    channels_[current_].emplace(Point14::of(first_.data()));
  }

  void decode(char* records, std::size_t count) override {
    if (count > 0 && at_first_) {
      at_first_ = false;
      std::memcpy(records, first_.data(), first_.size());
      records += first_.size();
      --count;
    }
    for (std::size_t i = 0; i < count; ++i, records += first_.size()) {
      decodePoint(records);
      if (i % kLazCheckEvery == 0) checkLayers();
    }
    checkLayers();
  }

  std::size_t unusedBytes() const override {
    std::size_t most = behind_;
    for (const auto& layer : layers_) {
      if (layer) most = std::max(most, layer->unusedBytes());
    }
    return most;
  }

  std::size_t missingBytes() const override {
    std::size_t most = 0;
    for (const auto& layer : layers_) {
      if (layer) most = std::max(most, layer->missingBytes());
    }
    return most;
  }

 private:
  struct Placed {
    LayeredItem what;
    std::size_t at;     ///< In the record.
    std::size_t layer;  ///< Its first.
  };

  static void requirePoint(const LazItem& item) {
    if (item.kind != LazItemKind::point14 || item.bytes != kPointBytes) {
      throw LazDamage(said<MessageId::laz_mixed_fields>());
    }
  }

  void openLayers(const LazLayout& layout, LayerReader reader, const LazWanted& wanted) {
    layers_.push_back(reader.next(true));
    layers_.push_back(reader.next(true));
    for (const bool is_wanted : {wanted.classes, wanted.flags, wanted.intensities}) {
      layers_.push_back(reader.next(is_wanted));
    }
    while (layers_.size() < kPointLayers) layers_.push_back(reader.next(wanted.others));
    for (std::size_t i = 0; i < items_.size(); ++i) {
      for (std::size_t layer = 0; layer < items_[i].what.layerCount(); ++layer) {
        layers_.push_back(reader.next(isWanted(layout.items[i + 1], layer, wanted)));
      }
    }
    behind_ = reader.left();
  }

  void decodePoint(char* record) {
    ArithmeticDecoder& place = *layers_[kPlace];
    const Channel& before = *channels_[current_];
    const Point14& last = before.last;
    const unsigned context =
        (last.r == 1 ? 1U : 0U) + (last.r >= last.n ? 2U : 0U) + (before.time_changed ? 4U : 0U);
    const unsigned changed = channels_[current_]->changed.decode(place, context);
    const bool switched = (changed & kChannelBit) != 0;
    if (switched) switchChannel(place);
    Channel& channel = *channels_[current_];
    const unsigned kind = decodeReturns(place, channel, changed);
    const unsigned group = returnGroup(channel.last.n, channel.last.r);
    decodePlace(layers_, channel, 2 * group + ((changed & kTimeBit) != 0 ? 1 : 0));
    decodeAttributes(layers_, channel, kind, changed);
    channel.last.store(record, current_);
    for (Placed& item : items_) {
      item.what.decode(std::span(layers_).subspan(item.layer, item.what.layerCount()), current_,
                       switched, record + item.at);
    }
  }

  void switchChannel(ArithmeticDecoder& place) {
    const std::size_t next =
        (current_ + channels_[current_]->next_channel.decode(place, 0) + 1) % kChannels;
    if (!channels_[next]) channels_[next].emplace(channels_[current_]->last);
    current_ = next;
  }

  void checkLayers() const {
    for (const auto& layer : layers_) {
      if (layer) requireEnough(*layer);
    }
  }

  std::string_view first_;
  std::size_t current_;  ///< Channel of the last point.
  std::array<std::optional<Channel>, kChannels> channels_;
  Layers layers_;
  std::vector<Placed> items_;
  std::size_t behind_ = 0;  ///< Bytes behind the last layer.
  bool at_first_ = true;
};

}  // namespace

std::size_t layersOf(const LazItem& item) {
  switch (item.kind) {
    case LazItemKind::point14:
      return kPointLayers;
    case LazItemKind::colour_infrared14:
      return 2;
    case LazItemKind::bytes14:
      return item.bytes;
    default:
      return 1;
  }
}

std::unique_ptr<LazChunkDecoder> openLazLayers(const LazLayout& layout, std::string_view bytes,
                                               std::uint64_t points, const LazWanted& wanted) {
  return std::make_unique<LayersDecoder>(layout, bytes, points, wanted);
}

}  // namespace relievo
