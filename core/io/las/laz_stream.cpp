// SPDX-License-Identifier: BSD-3-Clause
// Point formats 0 to 5: all fields of a chunk in one stream.
#include <array>
#include <cstring>

#include "core/io/formats/scalar.h"
#include "core/io/las/laz_chunk.h"
#include "core/io/las/laz_fields.h"
#include "core/io/las/laz_stream_item.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

/// By number of returns and return.
constexpr std::array<std::array<std::uint8_t, 8>, 8> kReturnMap{{{15, 14, 13, 12, 11, 10, 9, 8},
                                                                 {14, 0, 1, 3, 6, 10, 10, 9},
                                                                 {13, 1, 2, 4, 7, 11, 11, 10},
                                                                 {12, 3, 4, 5, 8, 12, 12, 11},
                                                                 {11, 6, 7, 8, 9, 13, 13, 12},
                                                                 {10, 10, 11, 12, 13, 14, 14, 13},
                                                                 {9, 10, 11, 12, 13, 14, 15, 14},
                                                                 {8, 9, 10, 11, 12, 13, 14, 15}}};

class Point10 : public StreamItem {
 public:
  explicit Point10(const char* first)
      : x_(loadAs<std::uint32_t>(first, ByteOrder::little)),
        y_(loadAs<std::uint32_t>(first + 4, ByteOrder::little)),
        z_(loadAs<std::uint32_t>(first + 8, ByteOrder::little)),
        returns_(byteOf(first[14])),
        class_(byteOf(first[15])),
        angle_(byteOf(first[16])),
        user_(byteOf(first[17])),
        source_(loadAs<std::uint16_t>(first + 18, ByteOrder::little)) {}

  void decode(ArithmeticDecoder& decoder, char* item) override {
    const unsigned changed = decoder.symbol(changed_);
    if ((changed & 32U) != 0) returns_ = returns_models_.decode(decoder, returns_);
    const unsigned r = returns_ & 7U, n = returns_ >> 3U & 7U;
    const unsigned m = kReturnMap[n][r];
    if ((changed & 16U) != 0) {
      grey_[m] = static_cast<std::uint16_t>(greys_.decode(decoder, grey_[m], std::min(m, 3U)));
    }
    if ((changed & 8U) != 0) class_ = classes_.decode(decoder, class_);
    if ((changed & 4U) != 0) {
      angle_ = (angle_ + angles_.decode(decoder, returns_ >> 6U & 1U)) & 0xFFU;
    }
    if ((changed & 2U) != 0) user_ = users_.decode(decoder, user_);
    if ((changed & 1U) != 0) source_ = sources_.decode(decoder, source_, 0);
    decodePlace(decoder, m, n > r ? n - r : r - n, n == 1 ? 1 : 0);
    storeLittle(item, x_);
    storeLittle(item + 4, y_);
    storeLittle(item + 8, z_);
    storeLittle(item + 12, grey_[m]);
    item[14] = static_cast<char>(returns_);
    item[15] = static_cast<char>(class_);
    item[16] = static_cast<char>(angle_);
    item[17] = static_cast<char>(user_);
    storeLittle(item + 18, static_cast<std::uint16_t>(source_));
  }

 private:
  static std::uint32_t byteOf(char c) { return static_cast<unsigned char>(c); }

  void decodePlace(ArithmeticDecoder& decoder, unsigned m, unsigned l, unsigned single) {
    const auto step = [&](IntegerModel& model, RunningMedian& median, unsigned context) {
      const std::uint32_t by =
          model.decode(decoder, static_cast<std::uint32_t>(median.value()), context);
      median.add(static_cast<std::int32_t>(by));
      return by;
    };
    x_ += step(x_steps_, x_medians_[m], single);
    const unsigned kx = x_steps_.lastBits();
    y_ += step(y_steps_, y_medians_[m], single + (kx < 20 ? kx & ~1U : 20));
    const unsigned k = (kx + y_steps_.lastBits()) / 2;
    z_ = heights_.decode(decoder, height_[l], single + (k < 18 ? k & ~1U : 18));
    height_[l] = z_;
  }

  std::uint32_t x_, y_, z_;
  std::uint32_t returns_, class_, angle_, user_, source_;
  std::array<std::uint16_t, 16> grey_{};
  std::array<std::uint32_t, 8> height_{};
  std::array<RunningMedian, 16> x_medians_, y_medians_;
  SymbolModel changed_{64};
  LazBytes returns_models_{256}, classes_{256}, angles_{2}, users_{256};
  IntegerModel greys_{16, 4}, sources_{16, 1}, x_steps_{32, 2}, y_steps_{32, 22}, heights_{32, 20};
};

class Time10 : public StreamItem {
 public:
  explicit Time10(const char* first)
      : time_(LazTime::Unchanged::said_here, loadAs<std::uint64_t>(first, ByteOrder::little)) {}
  void decode(ArithmeticDecoder& decoder, char* item) override {
    storeLittle(item, time_.decode(decoder));
  }

 private:
  LazTime time_;
};

class Colour10 : public StreamItem {
 public:
  explicit Colour10(const char* first) {
    for (std::size_t i = 0; i < 3; ++i) {
      last_[i] = loadAs<std::uint16_t>(first + 2 * i, ByteOrder::little);
    }
  }
  void decode(ArithmeticDecoder& decoder, char* item) override {
    last_ = colours_.decode(decoder, last_);
    for (std::size_t i = 0; i < 3; ++i) storeLittle(item + 2 * i, last_[i]);
  }

 private:
  LazColour last_{};
  LazColours colours_;
};

class Bytes10 : public StreamItem {
 public:
  Bytes10(const char* first, std::size_t count) : last_(first, first + count), models_(count) {}
  void decode(ArithmeticDecoder& decoder, char* item) override {
    for (std::size_t i = 0; i < last_.size(); ++i) {
      last_[i] =
          static_cast<char>(static_cast<unsigned char>(last_[i]) + models_.decode(decoder, i));
    }
    std::memcpy(item, last_.data(), last_.size());
  }

 private:
  std::vector<char> last_;
  LazBytes models_;
};

class Waves10 : public StreamItem {
 public:
  explicit Waves10(const char* first) : last_(first, first + LazWaves::kBytes) {}
  void decode(ArithmeticDecoder& decoder, char* item) override {
    waves_.decode(decoder, last_.data());
    std::memcpy(item, last_.data(), last_.size());
  }

 private:
  std::vector<char> last_;
  LazWaves waves_;
};

std::unique_ptr<StreamItem> itemOf(const LazItem& item, const char* first) {
  if (item.kind == LazItemKind::waves10) return std::make_unique<Waves10>(first);
  if (item.version == 1) return firstVersionItem(item, first);
  switch (item.kind) {
    case LazItemKind::point10:
      return std::make_unique<Point10>(first);
    case LazItemKind::time:
      return std::make_unique<Time10>(first);
    case LazItemKind::colour10:
      return std::make_unique<Colour10>(first);
    case LazItemKind::bytes:
      return std::make_unique<Bytes10>(first, item.bytes);
    default:
      throw LazDamage(said<MessageId::laz_mixed_fields>());
  }
}

class StreamDecoder : public LazChunkDecoder {
 public:
  StreamDecoder(const LazLayout& layout, std::string_view bytes)
      : first_(bytes.substr(0, layout.record_bytes)), decoder_(bytes.substr(layout.record_bytes)) {
    std::size_t at = 0;
    for (const LazItem& item : layout.items) {
      items_.push_back({itemOf(item, first_.data() + at), at});
      at += item.bytes;
    }
  }

  void decode(char* records, std::size_t count) override {
    if (count > 0 && at_first_) {
      at_first_ = false;
      std::memcpy(records, first_.data(), first_.size());
      records += first_.size();
      --count;
    }
    for (std::size_t i = 0; i < count; ++i, records += first_.size()) {
      for (const Placed& item : items_) item.what->decode(decoder_, records + item.at);
      if (i % kLazCheckEvery == 0) requireEnough(decoder_);
    }
    requireEnough(decoder_);
  }

  std::size_t unusedBytes() const override { return decoder_.unusedBytes(); }
  std::size_t missingBytes() const override { return decoder_.missingBytes(); }

 private:
  struct Placed {
    std::unique_ptr<StreamItem> what;
    std::size_t at;  ///< In the record.
  };
  std::string_view first_;
  ArithmeticDecoder decoder_;
  std::vector<Placed> items_;
  bool at_first_ = true;
};

}  // namespace

void requireEnough(const ArithmeticDecoder& decoder) {
  if (decoder.missingBytes() > kLazSlack) throw LazDamage(said<MessageId::laz_ends_before_last>());
}

std::unique_ptr<LazChunkDecoder> openLazStream(const LazLayout& layout, std::string_view bytes) {
  return std::make_unique<StreamDecoder>(layout, bytes);
}

std::unique_ptr<LazChunkDecoder> openLazChunk(const LazLayout& layout, std::string_view bytes,
                                              std::uint64_t points, const LazWanted& wanted) {
  if (bytes.size() < layout.record_bytes) throw LazDamage(said<MessageId::laz_ends_before_first>());
  return layout.layered ? openLazLayers(layout, bytes, points, wanted)
                        : openLazStream(layout, bytes);
}

}  // namespace relievo
