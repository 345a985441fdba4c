// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/tiff_head.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <utility>

#include "core/base/error.h"
#include "core/base/failure.h"
#include "core/file/owned_fd.h"
#include "core/io/file_check.h"
#include "core/io/raster/xml_entities.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMostEntries = 4096;
constexpr int kMostDirectories = 1024;
constexpr std::uint64_t kMostTextBytes = 16U << 20U;
constexpr std::uint64_t kMostListBytes = 256U << 20U;  // Offsets of 30 million tiles.

// Tags of TIFF 6.0, and GDAL's own.
constexpr std::uint16_t kCols = 256, kRows = 257, kBits = 258, kCompression = 259,
                        kDescription = 270, kBands = 277, kPlanes = 284, kTileCols = 322,
                        kTileRows = 323, kTileOffsets = 324, kSampleFormat = 339,
                        kGdalMetadata = 42112;

/// Bytes of one value of a field's type; 0: none that is needed here.
std::uint64_t bytesOfType(std::uint16_t type) {
  constexpr std::array<std::uint64_t, 19> kBytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4,
                                                 8, 4, 8, 0, 0, 0, 8, 8, 8};
  return type < kBytes.size() ? kBytes[type] : 0;
}

struct Field {
  std::uint16_t tag = 0, type = 0;
  std::uint64_t count = 0, at = 0;  ///< Where the values are.
};

/// The bytes of a file in the order that it states.
class TiffBytes {
 public:
  TiffBytes(const std::filesystem::path& file, std::uint64_t size)
      : fd_(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)), size_(size) {}

  bool little_endian = true;

  bool has(std::uint64_t at, std::uint64_t bytes) const {
    return at <= size_ && bytes <= size_ - at;
  }
  /// @return  false beyond the end
  bool read(std::uint64_t at, void* out, std::uint64_t bytes) const {
    if (!has(at, bytes)) return false;
    auto* to = static_cast<char*>(out);
    while (bytes > 0) {
      const ssize_t got = ::pread(fd_.get(), to, bytes, static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      to += got;
      at += static_cast<std::uint64_t>(got);
      bytes -= static_cast<std::uint64_t>(got);
    }
    return true;
  }
  std::optional<std::uint64_t> number(std::uint64_t at, std::uint64_t bytes) const {
    std::array<std::uint8_t, 8> stored{};
    if (bytes > stored.size() || !read(at, stored.data(), bytes)) return std::nullopt;
    return numberOf(stored.data(), bytes);
  }
  std::uint64_t numberOf(const std::uint8_t* stored, std::uint64_t bytes) const {
    std::uint64_t value = 0;
    for (std::uint64_t i = 0; i < bytes; ++i) {
      value = value << 8U | stored[little_endian ? bytes - 1 - i : i];
    }
    return value;
  }

 private:
  OwnedFd fd_;
  std::uint64_t size_;
};

/// Where the first directory is, and in which of the two forms all of them are.
struct TiffStart {
  bool is_big = false;
  std::uint64_t directory = 0;
};

/// Nothing: no TIFF.
std::optional<TiffStart> startOf(TiffBytes& in) {
  std::array<char, 4> start{};
  if (!in.read(0, start.data(), start.size())) return std::nullopt;
  const std::string_view order(start.data(), 2);
  if (order != "II" && order != "MM") return std::nullopt;
  in.little_endian = order == "II";
  const auto magic = in.number(2, 2);
  if (!magic || (*magic != 42 && *magic != 43)) return std::nullopt;
  const bool big = magic == 43;
  if (big && in.number(4, 4) != (in.little_endian ? 8U : 0x80000U)) return std::nullopt;
  const auto directory = in.number(big ? 8 : 4, big ? 8 : 4);
  if (!directory) return std::nullopt;
  return TiffStart{.is_big = big, .directory = *directory};
}

struct Directory {
  std::vector<Field> fields;
  std::uint64_t next = 0;  ///< Where the next one is; 0: there is none.
};

/// Nothing: damaged.
std::optional<Directory> directoryAt(const TiffBytes& in, const TiffStart& start) {
  const std::uint64_t word = start.is_big ? 8 : 4;
  const std::uint64_t length = start.is_big ? 8 : 2;
  const std::uint64_t stride = 4 + 2 * word;
  const auto count = in.number(start.directory, length);
  if (!count || *count == 0 || *count > kMostEntries) return std::nullopt;
  Directory directory;
  for (std::uint64_t i = 0; i < *count; ++i) {
    const std::uint64_t at = start.directory + length + i * stride;
    const auto tag = in.number(at, 2);
    const auto type = in.number(at + 2, 2);
    const auto values = in.number(at + 4, word);
    if (!tag || !type || !values) return std::nullopt;
    Field field{.tag = static_cast<std::uint16_t>(*tag),
                .type = static_cast<std::uint16_t>(*type),
                .count = *values,
                .at = at + 4 + word};
    const std::uint64_t bytes = bytesOfType(field.type);
    // What does not fit into the entry is elsewhere.
    if (bytes > 0 && field.count > word / bytes) {
      const auto elsewhere = in.number(field.at, word);
      if (!elsewhere) return std::nullopt;
      field.at = *elsewhere;
    }
    directory.fields.push_back(field);
  }
  directory.next = in.number(start.directory + length + *count * stride, word).value_or(0);
  return directory;
}

std::optional<std::string> textOf(const TiffBytes& in, const Field& field) {
  // Whether the file has it is seen before there is room for it.
  if (bytesOfType(field.type) != 1 || field.count > kMostTextBytes ||
      !in.has(field.at, field.count)) {
    return std::nullopt;
  }
  std::string text(static_cast<std::size_t>(field.count), '\0');
  if (!in.read(field.at, text.data(), field.count)) return std::nullopt;
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

std::optional<std::vector<std::uint64_t>> listOf(const TiffBytes& in, const Field& field) {
  const std::uint64_t bytes = bytesOfType(field.type);
  if (bytes == 0 || field.count > kMostListBytes / bytes) return std::nullopt;
  if (!in.has(field.at, field.count * bytes)) return std::nullopt;
  std::vector<std::uint8_t> stored(static_cast<std::size_t>(field.count * bytes));
  if (!in.read(field.at, stored.data(), stored.size())) return std::nullopt;
  std::vector<std::uint64_t> list(static_cast<std::size_t>(field.count));
  for (std::size_t i = 0; i < list.size(); ++i) {
    list[i] = in.numberOf(stored.data() + i * bytes, bytes);
  }
  return list;
}

/// Entries of the whole raster: <Item name="NAME">TEXT</Item>. Those of a band have more
/// attributes.
void addItems(std::string_view xml, std::map<std::string, std::string>& facts) {
  constexpr std::string_view kItem = "<Item name=\"";
  for (std::size_t at = xml.find(kItem); at != std::string_view::npos; at = xml.find(kItem, at)) {
    at += kItem.size();
    const std::size_t name_end = xml.find('"', at);
    const std::size_t tag_end = xml.find('>', at);
    const std::size_t end = xml.find("</Item>", at);
    if (name_end == std::string_view::npos || tag_end == std::string_view::npos ||
        end == std::string_view::npos || tag_end > end) {
      return;
    }
    if (tag_end == name_end + 1) {
      // GDAL writes entities of the text, and then the whole as XML.
      facts[withoutEntities(xml.substr(at, name_end - at))] =
          withoutEntities(withoutEntities(xml.substr(tag_end + 1, end - tag_end - 1)));
    }
    at = end;
  }
}

/// @return  false if a value is missing or makes no sense
bool take(const TiffBytes& in, const Field& field, TiffHead& head) {
  if (field.tag == kDescription || field.tag == kGdalMetadata) {
    const auto text = textOf(in, field);
    if (!text) return false;
    if (field.tag == kGdalMetadata) {
      addItems(*text, head.facts);
    } else {
      head.facts["TIFFTAG_IMAGEDESCRIPTION"] = *text;
    }
    return true;
  }
  if (field.tag == kTileOffsets) {
    auto list = listOf(in, field);
    if (list) head.tile_offsets = std::move(*list);
    return list.has_value();
  }
  const std::array<std::pair<std::uint16_t, std::uint32_t*>, 7> numbers{
      {{kBits, &head.bits},
       {kCompression, &head.compression},
       {kBands, &head.bands},
       {kPlanes, &head.planes},
       {kTileCols, &head.tile_cols},
       {kTileRows, &head.tile_rows},
       {kSampleFormat, &head.sample_format}}};
  std::uint64_t* const size = field.tag == kCols   ? &head.cols
                              : field.tag == kRows ? &head.rows
                                                   : nullptr;
  const auto* const known = std::find_if(numbers.begin(), numbers.end(),
                                         [&](const auto& n) { return n.first == field.tag; });
  if (size == nullptr && known == numbers.end()) return true;
  const auto value = in.number(field.at, bytesOfType(field.type));
  if (!value || field.count == 0 || bytesOfType(field.type) == 0 || *value > 0x7fffffffU) {
    return false;
  }
  if (size != nullptr) {
    *size = *value;
  } else {
    *known->second = static_cast<std::uint32_t>(*value);
  }
  return true;
}

}  // namespace

std::optional<TiffHead> readTiffHead(const std::filesystem::path& file) {
  requireReadersAllowed("readTiffHead");
  TiffBytes in(file, checkedFileSize(file));
  const auto start = startOf(in);
  const auto first = start ? directoryAt(in, *start) : std::nullopt;
  if (!first) return std::nullopt;
  TiffHead head;
  head.little_endian = in.little_endian;
  for (const Field& field : first->fields) {
    if (!take(in, field, head)) return std::nullopt;
  }
  if (head.cols == 0 || head.rows == 0) return std::nullopt;
  return head;
}

std::optional<std::string> descriptionIn(const std::optional<TiffHead>& head,
                                         const std::filesystem::path& file) {
  if (!head) {
    throw failure<MessageId::file_is_no_tiff>(shownName(file));
  }
  const auto state = head->facts.find("TIFFTAG_IMAGEDESCRIPTION");
  if (state == head->facts.end()) return std::nullopt;
  return state->second;
}

std::uint64_t largestTiffMetadata(const std::filesystem::path& file) {
  requireReadersAllowed("largestTiffMetadata");
  TiffBytes in(file, checkedFileSize(file));
  auto start = startOf(in);
  std::uint64_t largest = 0;
  for (int i = 0; start && start->directory != 0 && i < kMostDirectories; ++i) {
    const auto directory = directoryAt(in, *start);
    if (!directory) break;  // Whoever reads it says what is wrong.
    for (const Field& field : directory->fields) {
      if (field.tag == kGdalMetadata) largest = std::max(largest, field.count);
    }
    start->directory = directory->next;
  }
  return largest;
}

}  // namespace relievo
