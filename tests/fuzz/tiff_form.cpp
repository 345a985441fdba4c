// SPDX-License-Identifier: BSD-3-Clause
// TIFF 6.0, sections 2 and "Image file directory"; GeoTIFF 1.1 and GDAL for the numbers of tags.
#include "tests/fuzz/tiff_form.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "core/io/formats/scalar.h"
#include "tests/core/io/sample_files.h"

namespace relievo::fuzz {
namespace {

using test::bytesOf;
using namespace std::string_literals;

constexpr std::size_t kEntry = 12;  ///< Tag, type, count, value or its place.
constexpr std::array<std::size_t, 14> kTypeBytes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4};
constexpr std::uint16_t kAscii = 2, kShort = 3, kDouble = 12;

std::uint32_t u32At(const std::string& file, std::size_t at) {
  return loadAs<std::uint32_t>(file.data() + at, ByteOrder::little);
}
std::uint16_t u16At(const std::string& file, std::size_t at) {
  return loadAs<std::uint16_t>(file.data() + at, ByteOrder::little);
}

/// Where the first directory's entries are.
struct Directory {
  std::size_t at = 0, count = 0;
  std::size_t entry(std::size_t i) const { return at + 2 + i * kEntry; }
  std::size_t end() const { return entry(count); }
};

std::optional<Directory> directoryOf(const std::string& file) {
  if (file.size() < 8 || !file.starts_with("II*\0"s)) return std::nullopt;
  Directory directory{.at = u32At(file, 4)};
  if (directory.at > file.size() - 2) return std::nullopt;
  directory.count = u16At(file, directory.at);
  if (directory.count == 0 || directory.end() > file.size()) return std::nullopt;
  return directory;
}

struct Contents {
  std::size_t at = 0, bytes = 0;
};

/// Of an entry, wherever they lie in the file.
std::optional<Contents> contentsOf(const std::string& file, std::size_t entry) {
  const std::uint16_t type = u16At(file, entry + 2);
  if (type >= kTypeBytes.size()) return std::nullopt;
  const std::uint64_t bytes = std::uint64_t{u32At(file, entry + 4)} * kTypeBytes[type];
  const std::size_t at = bytes <= 4 ? entry + 8 : u32At(file, entry + 8);
  if (at > file.size() || bytes > file.size() - at) return std::nullopt;
  return Contents{at, static_cast<std::size_t>(bytes)};
}

void setContents(std::string& file, std::size_t entry, const std::string& bytes) {
  const std::size_t each = std::max<std::size_t>(1, kTypeBytes[u16At(file, entry + 2)]);
  file.replace(entry + 4, 4, bytesOf(static_cast<std::uint32_t>(bytes.size() / each)));
  if (bytes.size() <= 4) {
    file.replace(entry + 8, bytes.size(), bytes);
    return;
  }
  file.replace(entry + 8, 4, bytesOf(static_cast<std::uint32_t>(file.size())));
  file += bytes;
}

/// One number among `bytes`, each `width` wide.
void changeBinaryNumber(std::string& bytes, std::size_t width, Chance& chance) {
  if (width == 0 || bytes.size() < width) return;
  const std::size_t at = chance.below(bytes.size() / width) * width;
  if (width == 8) {
    constexpr std::array<double, 8> kOdd{
        0, -1, 1e-9, 1e300, std::numeric_limits<double>::infinity(), -0.5, 0.3048, 1};
    const auto old = loadAs<double>(bytes.data() + at, ByteOrder::little);
    const double number = chance.oneIn(2) ? -old : kOdd[chance.below(kOdd.size())];
    bytes.replace(at, width, bytesOf(number));
    return;
  }
  bytes.replace(at, width, bytesOf(chance.number()).substr(0, width));
}

bool changeContents(std::string& file, std::size_t entry, Chance& chance) {
  const auto contents = contentsOf(file, entry);
  if (!contents) return false;
  std::string bytes = file.substr(contents->at, contents->bytes);
  const std::uint16_t type = u16At(file, entry + 2);
  if (type == kAscii) {
    if (chance.oneIn(2) || !changeNumber(bytes, chance)) mutateBytes(bytes, 32);
    setContents(file, entry, bytes);
    return true;
  }
  changeBinaryNumber(bytes, kTypeBytes[type], chance);
  file.replace(contents->at, bytes.size(), bytes);
  return true;
}

struct KnownTag {
  std::uint16_t tag, type;
  std::string contents;
};

std::string doubles(std::initializer_list<double> numbers) {
  std::string bytes;
  for (const double number : numbers) bytes += bytesOf(number);
  return bytes;
}

std::string shorts(std::initializer_list<std::uint16_t> numbers) {
  std::string bytes;
  for (const std::uint16_t number : numbers) bytes += bytesOf(number);
  return bytes;
}

/// Tags that the reader asks for, each in a form that GDAL takes.
KnownTag knownTag(Chance& chance) {
  constexpr std::uint16_t kPixelScale = 33550, kTiePoints = 33922, kTransformation = 34264;
  constexpr std::uint16_t kGeoKeys = 34735, kMetadata = 42112, kNoData = 42113;
  constexpr std::uint16_t kPhotometric = 262, kSampleFormat = 339;
  constexpr std::array<std::string_view, 6> kUnits{"m", "mm", "ft", "us-ft", "fathom", ""};
  switch (chance.below(9)) {
    case 0:
      return {kPixelScale, kDouble, doubles({2, 2, 0})};
    case 1:
      return {kTiePoints, kDouble, doubles({0, 0, 0, 100, 200, 0})};
    case 2:
      return {kTransformation, kDouble,
              doubles({2, 0, 0, 100, 0, -2, 0, 200, 0, 0, 0, 0, 0, 0, 0, 1})};
    case 3:  // A projected system in metres; heights in one of eight units.
      return {
          kGeoKeys, kShort,
          shorts(
              {1,    1, 0, 5,    1024, 0, 1, 1,
               1025, 0, 1, 1,    3072, 0, 1, 32633,
               3076, 0, 1, 9001, 4099, 0, 1, static_cast<std::uint16_t>(9001 + chance.below(8))})};
    case 4:
      return {kGeoKeys, kShort, shorts({1, 1, 0, 2, 1024, 0, 1, 2, 2048, 0, 1, 4326})};
    case 5:
      return {kMetadata, kAscii,
              "<GDALMetadata>\n<Item name=\"OFFSET\" sample=\"0\" role=\"offset\">1</Item>\n"
              "<Item name=\"SCALE\" sample=\"0\" role=\"scale\">2</Item>\n"
              "<Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">" +
                  std::string(kUnits[chance.below(kUnits.size())]) + "</Item>\n</GDALMetadata>\0"s};
    case 6:
      return {kNoData, kAscii, std::to_string(chance.below(10)) + "\0"s};
    case 7:
      return {kPhotometric, kShort, shorts({static_cast<std::uint16_t>(chance.below(9))})};
    default:
      return {kSampleFormat, kShort, shorts({static_cast<std::uint16_t>(chance.below(7))})};
  }
}

std::string entryOf(const KnownTag& tag) {
  return bytesOf(tag.tag) + bytesOf(tag.type) + std::string(8, '\0');
}

/// A copy of the directory at the end of the file, with or without one entry more: entries are in
/// the order of their tags.
void rewriteDirectory(std::string& file, const Directory& directory, Chance& chance) {
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < directory.count; ++i) {
    entries.push_back(file.substr(directory.entry(i), kEntry));
  }
  const bool less = chance.oneIn(4);
  const KnownTag known = knownTag(chance);
  const auto tag_of = [](const std::string& entry) { return u16At(entry, 0); };
  if (less) {
    entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(chance.below(entries.size())));
  } else {
    std::erase_if(entries, [&](const std::string& entry) { return tag_of(entry) == known.tag; });
    const auto place = std::find_if(entries.begin(), entries.end(), [&](const std::string& entry) {
      return tag_of(entry) > known.tag;
    });
    entries.insert(place, entryOf(known));
  }
  const std::size_t at = file.size();
  file.replace(4, 4, bytesOf(static_cast<std::uint32_t>(at)));
  file += bytesOf(static_cast<std::uint16_t>(entries.size()));
  for (const std::string& entry : entries) file += entry;
  file += std::string(4, '\0');  // No directory follows.
  if (less) return;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::size_t entry = at + 2 + i * kEntry;
    if (tag_of(entries[i]) == known.tag) setContents(file, entry, known.contents);
  }
}

}  // namespace

bool mutateTiff(std::string& file, Chance& chance) {
  const auto directory = directoryOf(file);
  if (!directory) return false;
  const std::size_t entry = directory->entry(chance.below(directory->count));
  switch (chance.below(8)) {
    case 0:
    case 1:
      rewriteDirectory(file, *directory, chance);
      return true;
    case 2:
      file.replace(entry + 2, 2, bytesOf(static_cast<std::uint16_t>(1 + chance.below(13))));
      return true;
    case 3:
      file.replace(entry + 4, 4, bytesOf(static_cast<std::uint32_t>(chance.number())));
      return true;
    default:
      return changeContents(file, entry, chance);
  }
}

}  // namespace relievo::fuzz
