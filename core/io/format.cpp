// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <optional>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

using namespace std::string_view_literals;

struct FormatFact {
  FileFormat format;
  bool readable_as_scan;
  std::string_view name;
  std::string_view endings;  ///< Of the files that are offered to be opened.
};

/// Every format this program has heard of. A reader that is added turns its line to true. Pictures
/// of every kind end in .png, so that none is offered for its ending.
constexpr auto kFormats = std::to_array<FormatFact>({
    {FileFormat::ply, true, "a PLY file", "ply"},
    {FileFormat::pcd, true, "a PCD file", "pcd"},
    {FileFormat::obj, true, "an OBJ file", "obj"},
    {FileFormat::stl, true, "an STL file", "stl"},
    {FileFormat::three_ds, true, "a 3DS file", "3ds"},
    {FileFormat::las, true, "a LAS file", "las"},
    {FileFormat::laz, true, "a compressed LAS file (LAZ or COPC)", "laz"},
    {FileFormat::e57, true, "an E57 file", "e57"},
    {FileFormat::ptx, true, "a PTX file", "ptx"},
    {FileFormat::text, true, "a text file", "xyz asc pts csv txt"},
    {FileFormat::tiff, false, "a TIFF raster", "tif tiff"},
    {FileFormat::png, false, "a PNG raster", ""},
    {FileFormat::ascii_grid, false, "an ESRI ASCII grid", "asc"},
    {FileFormat::other_raster, false, "a raster of another kind", ""},
    {FileFormat::other, false, "no scan that this program knows", ""},
});

struct Magic {
  std::string_view bytes;
  FileFormat format;
  std::string_view name;  ///< Empty: that of the format.
};

constexpr auto kMagics = std::to_array<Magic>({
    {"II*\0"sv, FileFormat::tiff, {}},
    {"MM\0*"sv, FileFormat::tiff, {}},
    {"II+\0"sv, FileFormat::tiff, {}},
    {"MM\0+"sv, FileFormat::tiff, {}},
    {"LASF"sv, FileFormat::las, {}},
    {"ASTM-E57"sv, FileFormat::e57, {}},
    {"DSAA"sv, FileFormat::other_raster, "a Surfer grid"},
    {"DSBB"sv, FileFormat::other_raster, "a Surfer grid"},
    {"DSRB"sv, FileFormat::other_raster, "a Surfer grid"},
    {"EHFA_HEADER_TAG"sv, FileFormat::other_raster, "an ERDAS Imagine raster"},
    {"\x89PNG"sv, FileFormat::png, {}},
    {"\xFF\xD8\xFF"sv, FileFormat::other, "a JPEG picture"},
    {"GIF8"sv, FileFormat::other, "a GIF picture"},
    {"BM"sv, FileFormat::other, "a BMP picture"},
    {"version https://git-lfs"sv, FileFormat::other,
     "a Git LFS pointer, not the scan itself; fetch it with git lfs pull"},
    {"<!DOCTYPE"sv, FileFormat::other, "a web page; the download probably failed"},
    {"<!doctype"sv, FileFormat::other, "a web page; the download probably failed"},
    {"<html"sv, FileFormat::other, "a web page; the download probably failed"},
    {"<HTML"sv, FileFormat::other, "a web page; the download probably failed"},
    {"<"sv, FileFormat::other, "an XML file"},
    {"%PDF"sv, FileFormat::other, "a PDF document"},
    {"PK\x03\x04"sv, FileFormat::other, "a ZIP archive; unpack it first"},
    {"\x1F\x8B"sv, FileFormat::other, "a gzip archive; unpack it first"},
    {"7z\xBC\xAF"sv, FileFormat::other, "a 7z archive; unpack it first"},
    {"\x89HDF"sv, FileFormat::other, "an HDF5 file"},
    {"relievo HDF5"sv, FileFormat::other, "a recording of a touch"},
    {"\x7F"
     "ELF"sv,
     FileFormat::other, "a program"},
    {"glTF"sv, FileFormat::other, "a glTF file"},
    {"Kaydara FBX"sv, FileFormat::other, "an FBX file"},
    {"\xFF\xFE"sv, FileFormat::other, "UTF-16 text; save it as UTF-8"},
    {"\xFE\xFF"sv, FileFormat::other, "UTF-16 text; save it as UTF-8"},
    {"{"sv, FileFormat::other, "a JSON file"},
});

/// What files of some formats end in, each once.
template <class Wanted>
std::vector<std::string_view> endingsOf(const Wanted& wanted) {
  std::vector<std::string_view> endings;
  for (const FormatFact& fact : kFormats) {
    if (!wanted(fact)) continue;
    std::string_view rest = fact.endings;
    while (!rest.empty()) {
      const std::string_view ending = takeWord(rest);
      if (std::find(endings.begin(), endings.end(), ending) == endings.end()) {
        endings.push_back(ending);
      }
    }
  }
  return endings;
}

std::string nameOf(FileFormat format) {
  for (const FormatFact& fact : kFormats) {
    if (fact.format == format) return std::string(fact.name);
  }
  return {};
}

FoundFormat found(FileFormat format) {
  return {format, nameOf(format)};
}

std::string lowerExtension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

std::uint32_t littleEndian32(std::string_view head, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(head[at + i]);
  return value;
}

bool isPlainText(std::string_view head) {
  return std::none_of(head.begin(), head.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return (u < 32 && c != '\t' && c != '\n' && c != '\r' && c != '\f') || u == 127;
  });
}

bool isWholeNumber(std::string_view line) {
  return !line.empty() && std::all_of(line.begin(), line.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
  });
}

/// PTX starts with its columns and rows on a line each; PTS has one such line only.
bool looksLikePtx(std::string_view head) {
  Lines lines(head);
  return lines.next() && isWholeNumber(trimmed(lines.line())) && lines.next() &&
         isWholeNumber(trimmed(lines.line()));
}

bool looksLikePcd(std::string_view head) {
  Lines lines(head);
  for (int i = 0; i < 100 && lines.next(); ++i) {
    const std::string_view word = firstWord(lines.line());
    if (word.empty()) continue;
    if (word.starts_with('#')) {
      if (lines.line().find(".PCD") != std::string_view::npos) return true;
      continue;
    }
    if (word == "VERSION" || word == "FIELDS" || word == "COLUMNS") return true;
    return false;
  }
  return false;
}

bool looksLikeObj(std::string_view head) {
  constexpr std::array kKeywords{"v"sv, "vt"sv,     "vn"sv,     "vp"sv, "f"sv, "o"sv,
                                 "g"sv, "mtllib"sv, "usemtl"sv, "s"sv,  "l"sv, "p"sv};
  Lines lines(head);
  while (lines.next()) {
    const std::string_view word = firstWord(lines.line());
    if (word.empty() || word.starts_with('#')) continue;
    return std::find(kKeywords.begin(), kKeywords.end(), word) != kKeywords.end();
  }
  return false;
}

/// Starts with one of the header's words, in capitals or not, and its number.
bool looksLikeAsciiGrid(std::string_view head) {
  constexpr std::array kWords{"ncols"sv,     "nrows"sv,     "xllcorner"sv, "yllcorner"sv,
                              "xllcenter"sv, "yllcenter"sv, "cellsize"sv};
  Lines lines(head);
  if (!lines.next()) return false;
  std::string_view rest = lines.line();
  std::string word(takeWord(rest));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end() &&
         parseNumber(takeWord(rest)).has_value();
}

bool looksLikeStl(std::string_view head, std::uint64_t size, const std::string& extension) {
  if (size >= 84 && head.size() >= 84 && 84 + 50ULL * littleEndian32(head, 80) == size) return true;
  if (head.starts_with("solid") &&
      (extension == ".stl" || head.find("facet") != std::string_view::npos)) {
    return true;
  }
  return extension == ".stl";
}

bool looksLike3ds(std::string_view head, std::uint64_t size, const std::string& extension) {
  if (head.size() < 6 || !head.starts_with("MM")) return false;
  return littleEndian32(head, 2) == size || extension == ".3ds";
}

std::optional<FoundFormat> findMagic(std::string_view head) {
  for (const Magic& magic : kMagics) {
    if (!head.starts_with(magic.bytes)) continue;
    if (magic.bytes == "BM" && isPlainText(head)) continue;
    if (magic.format == FileFormat::las && head.size() > 104 &&
        (static_cast<unsigned char>(head[104]) & 0xC0U) != 0) {
      return found(FileFormat::laz);
    }
    return magic.name.empty() ? found(magic.format)
                              : FoundFormat{magic.format, std::string(magic.name)};
  }
  return std::nullopt;
}

}  // namespace

FoundFormat findFormat(std::string_view head, const std::filesystem::path& file,
                       std::uint64_t file_size) {
  requireReadersAllowed("findFormat");
  const std::string extension = lowerExtension(file);
  if (head.starts_with("ply\n") || head.starts_with("ply\r") || head == "ply") {
    return found(FileFormat::ply);
  }
  if (head.size() >= 84 && 84 + 50ULL * littleEndian32(head, 80) == file_size) {
    return found(FileFormat::stl);
  }
  if (looksLike3ds(head, file_size, extension)) return found(FileFormat::three_ds);
  if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
  if (const auto magic = findMagic(head)) return *magic;
  if (looksLikeAsciiGrid(head)) return found(FileFormat::ascii_grid);
  if (looksLikePcd(head)) return found(FileFormat::pcd);
  const bool plain_text = isPlainText(head);
  if (looksLikeStl(head, file_size, extension)) return found(FileFormat::stl);
  if (extension == ".ply") return found(FileFormat::ply);
  if (extension == ".pcd") return found(FileFormat::pcd);
  if (plain_text && (looksLikeObj(head) || extension == ".obj")) return found(FileFormat::obj);
  if (plain_text && looksLikePtx(head)) return found(FileFormat::ptx);
  if (plain_text) return found(FileFormat::text);
  if (extension == ".las" || extension == ".laz" || extension == ".e57" || extension == ".3ds") {
    return {FileFormat::other, "damaged: it does not start as a file of this kind must"};
  }
  return {FileFormat::other, "neither text nor a format that this program knows"};
}

std::vector<std::string_view> offeredEndings() {
  return endingsOf([](const FormatFact&) { return true; });
}

std::string scanFormatList(std::string_view separator) {
  std::string list;
  for (std::string_view ending :
       endingsOf([](const FormatFact& f) { return f.readable_as_scan; })) {
    if (!list.empty()) list += separator;
    for (char c : ending) list += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return list;
}

bool isReadableRaster(FileFormat format) noexcept {
  return format == FileFormat::tiff || format == FileFormat::png ||
         format == FileFormat::ascii_grid;
}

RasterKind rasterKindOf(FileFormat format) noexcept {
  if (format == FileFormat::png) return {"PNG", "PNG"};
  if (format == FileFormat::ascii_grid) return {"AAIGrid", "ESRI ASCII grid"};
  return {"GTiff", "GeoTIFF"};
}

void checkReadableAsScan(const FoundFormat& found_format, const std::filesystem::path& file) {
  for (const FormatFact& fact : kFormats) {
    if (fact.format == found_format.format && fact.readable_as_scan) return;
  }
  if (isReadableRaster(found_format.format)) {
    throw failure<MessageId::file_is_a_raster>(shownName(file), found_format.name);
  }
  throw failure<MessageId::file_of_another_format>(shownName(file), found_format.name,
                                                   scanFormatList());
}

}  // namespace relievo
