// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "core/io/las/laz_arithmetic.h"

namespace relievo {

/// A group of fields that is packed together, as the file names it (16 bits).
enum class LazItemKind : std::uint16_t {
  bytes = 0,
  point10 = 6,
  time = 7,
  colour10 = 8,
  waves10 = 9,
  point14 = 10,
  colour14 = 11,
  colour_infrared14 = 12,
  waves14 = 13,
  bytes14 = 14
};

struct LazItem {
  LazItemKind kind = LazItemKind::bytes;
  std::size_t bytes = 0;
  std::uint16_t version = 0;
};

/// How the records of a file are packed.
struct LazLayout {
  std::vector<LazItem> items;
  std::size_t record_bytes = 0;  ///< Of all items.
  bool layered = false;          ///< Point formats 6 to 10.
};

/// Layers that are unpacked. The first point's value stands in all records for what is left out.
/// Only layered records can leave anything out.
struct LazWanted {
  bool classes = true, flags = true, intensities = true, colours = true;
  bool others =
      true;  ///< Scan angle, user data, source, time, near infrared, waveforms, extra bytes.
};

inline constexpr LazWanted kLazCoordinates{false, false, false, false, false};

/// Unpacks one chunk, point after point. One thread at a time.
class LazChunkDecoder {
 public:
  virtual ~LazChunkDecoder() = default;

  /// Writes the next `count` LAS records, one after the other. [any thread]
  /// @throw LazDamage  the bytes end too early, or hold what cannot be
  virtual void decode(char* records, std::size_t count) = 0;

  /// Most bytes that a part of the chunk holds beyond what was used; 0 to 4 is right once all
  /// points are unpacked.
  virtual std::size_t unusedBytes() const = 0;

  /// Bytes that were asked for beyond the end. Points that came before the first are right.
  virtual std::size_t missingBytes() const = 0;
};

/// @param bytes   of the chunk; they must outlive the decoder
/// @param points  that the chunk must hold
/// @throw LazDamage
std::unique_ptr<LazChunkDecoder> openLazChunk(const LazLayout& layout, std::string_view bytes,
                                              std::uint64_t points, const LazWanted& wanted = {});

/// Layers of an item of point formats 6 to 10, each with its number of bytes in the chunk.
std::size_t layersOf(const LazItem& item);

// The two ways; openLazChunk chooses.
std::unique_ptr<LazChunkDecoder> openLazStream(const LazLayout& layout, std::string_view bytes);
std::unique_ptr<LazChunkDecoder> openLazLayers(const LazLayout& layout, std::string_view bytes,
                                               std::uint64_t points, const LazWanted& wanted);

/// Bytes beyond the end of a stream that coders may count on.
inline constexpr std::size_t kLazSlack = 4;
/// Points, before bytes that are missing are noticed.
inline constexpr std::size_t kLazCheckEvery = 256;

/// @throw LazDamage  more bytes were asked for than there are
void requireEnough(const ArithmeticDecoder& decoder);

/// A little-endian number into a record.
template <class T>
void storeLittle(char* at, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) {
    at[i] = static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFFU);
  }
}

}  // namespace relievo
