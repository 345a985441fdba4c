// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/float_tiff.h"

#include <bit>
#include <cstdint>
#include <cstring>
#include <vector>

namespace relievo::samples {
namespace {

static_assert(std::endian::native == std::endian::little, "the TIFF is written as II");

enum FieldType : std::uint16_t { kAscii = 2, kShort = 3, kLong = 4, kDouble = 12 };

template <class T>
void put(std::string& bytes, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

struct Entry {
  std::uint16_t tag = 0;
  FieldType type = kShort;
  std::uint32_t count = 0;
  std::string value;  ///< As stored; more than 4 bytes go behind the directory.
};

Entry shorts(std::uint16_t tag, const std::vector<std::uint16_t>& values) {
  Entry e{tag, kShort, static_cast<std::uint32_t>(values.size()), {}};
  for (const std::uint16_t v : values) put(e.value, v);
  return e;
}
Entry number(std::uint16_t tag, std::uint32_t value) {
  Entry e{tag, kLong, 1, {}};
  put(e.value, value);
  return e;
}
Entry doubles(std::uint16_t tag, const std::vector<double>& values) {
  Entry e{tag, kDouble, static_cast<std::uint32_t>(values.size()), {}};
  for (const double v : values) put(e.value, v);
  return e;
}
Entry text(std::uint16_t tag, std::string value) {
  value.push_back('\0');
  return {tag, kAscii, static_cast<std::uint32_t>(value.size()), value};
}

constexpr std::size_t kHeaderBytes = 8;
constexpr std::size_t kEntryBytes = 12;

/// Header, directory and the long values; the pixels follow at `*pixels_at`.
std::string directory(const std::vector<Entry>& entries, std::size_t pixels_entry) {
  const std::size_t values_at = kHeaderBytes + 2 + entries.size() * kEntryBytes + 4;
  std::size_t end = values_at;
  for (const Entry& e : entries) {
    if (e.value.size() > 4) end += (e.value.size() + 7) / 8 * 8;
  }
  std::string bytes = "II";
  put<std::uint16_t>(bytes, 42);
  put<std::uint32_t>(bytes, kHeaderBytes);
  put(bytes, static_cast<std::uint16_t>(entries.size()));
  std::string values;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    Entry e = entries[i];
    if (i == pixels_entry) e = number(e.tag, static_cast<std::uint32_t>(end));
    put(bytes, e.tag);
    put(bytes, static_cast<std::uint16_t>(e.type));
    put(bytes, e.count);
    if (e.value.size() > 4) {
      put(bytes, static_cast<std::uint32_t>(values_at + values.size()));
      values += e.value;
      values.resize((values.size() + 7) / 8 * 8);
    } else {
      e.value.resize(4);
      bytes += e.value;
    }
  }
  put<std::uint32_t>(bytes, 0);  // no further image
  return bytes + values;
}

}  // namespace

std::string floatTiffBytes(const Reference& r, const std::string& unit) {
  const auto cols = static_cast<std::uint32_t>(r.cols);
  const auto rows = static_cast<std::uint32_t>(r.rows);
  const double left = r.first_x - 0.5 * r.spacing;
  const double top = r.y(r.rows - 1) + 0.5 * r.spacing;
  const std::vector<Entry> entries{
      number(256, cols),                          // ImageWidth
      number(257, rows),                          // ImageLength
      shorts(258, {32}),                          // BitsPerSample
      shorts(259, {1}),                           // Compression: none
      shorts(262, {1}),                           // PhotometricInterpretation: black is 0
      text(270, "true surface, unit " + unit),    // ImageDescription
      number(273, 0),                             // StripOffsets, set by directory()
      shorts(277, {1}),                           // SamplesPerPixel
      number(278, rows),                          // RowsPerStrip
      number(279, cols * rows * 4),               // StripByteCounts
      shorts(339, {3}),                           // SampleFormat: IEEE float
      doubles(33550, {r.spacing, r.spacing, 0}),  // ModelPixelScale
      doubles(33922, {0, 0, 0, left, top, 0}),    // ModelTiepoint: corner of the first pixel
      shorts(34735, {1, 1, 0, 2, 1024, 0, 1, 0,   // GeoKeyDirectory: user-defined model,
                     1025, 0, 1, 1}),             // pixels are areas
      text(42113, "nan"),                         // GDAL_NODATA
  };
  constexpr std::size_t kPixelsEntry = 6;
  std::string bytes = directory(entries, kPixelsEntry);
  for (std::uint32_t row = rows; row-- > 0;) {
    const float* line = r.z.data() + static_cast<std::size_t>(row) * cols;
    for (std::uint32_t col = 0; col < cols; ++col) put(bytes, line[col]);
  }
  return bytes;
}

}  // namespace relievo::samples
