// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>
#include <tiffio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/base/error.h"
#include "ui/vtk/picture_file.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

// The caller says what went wrong; libtiff would also print it.
void beQuiet(const char*, const char*, va_list) {}

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};
using TiffFile = std::unique_ptr<TIFF, CloseTiff>;

constexpr const char* kStateLine = "\nrelievo:state\n";

std::string entry(const PictureText& text, const std::string& key) {
  for (const auto& [name, value] : text) {
    if (name == key) return value;
  }
  return {};
}

struct TiffShape {
  int width = 0, height = 0, channels = 1, bits = 8;
  double dpi = 300;
};

void describe(TIFF* tiff, const TiffShape& shape, const PictureText& text) {
  TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(shape.width));
  TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(shape.height));
  TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, static_cast<std::uint16_t>(shape.bits));
  TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, static_cast<std::uint16_t>(shape.channels));
  TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
               shape.channels == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB);
  TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
  TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
  TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, TIFFDefaultStripSize(tiff, 0));
  TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
  TIFFSetField(tiff, TIFFTAG_XRESOLUTION, shape.dpi);
  TIFFSetField(tiff, TIFFTAG_YRESOLUTION, shape.dpi);
  if (shape.channels == 4) {
    const std::uint16_t alpha = EXTRASAMPLE_UNASSALPHA;
    TIFFSetField(tiff, TIFFTAG_EXTRASAMPLES, 1, &alpha);
  }
  const std::string state = entry(text, kStateEntry);
  std::string words = entry(text, "Description");
  if (!state.empty()) words += kStateLine + state;
  if (!words.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, words.c_str());
  const std::string software = entry(text, "Software");
  if (!software.empty()) TIFFSetField(tiff, TIFFTAG_SOFTWARE, software.c_str());
}

void writeRows(const fs::path& file, const TiffShape& shape, const std::uint8_t* bytes,
               const PictureText& text) {
  TIFFSetErrorHandler(beQuiet);
  TIFFSetWarningHandler(beQuiet);
  fs::path part = file;
  part += ".part" + std::to_string(getpid());
  bool good = shape.width > 0 && shape.height > 0;
  if (good) {
    const TiffFile tiff(TIFFOpen(part.c_str(), "w"));
    good = tiff != nullptr;
    if (good) describe(tiff.get(), shape, text);
    const std::size_t row_bytes = static_cast<std::size_t>(shape.width) *
                                  static_cast<std::size_t>(shape.channels * shape.bits / 8);
    std::vector<std::uint8_t> row(row_bytes);  // The predictor works in place.
    for (int i = 0; good && i < shape.height; ++i) {
      std::copy_n(bytes + static_cast<std::size_t>(i) * row_bytes, row_bytes, row.begin());
      good = TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(i), 0) == 1;
    }
    good = good && TIFFFlush(tiff.get()) == 1;
  }
  std::error_code error;
  if (good) {
    fs::rename(part, file, error);
    if (!error) return;
  }
  fs::remove(part, error);
  throw WriteError("Cannot write the picture '" + file.string() +
                   "'. Choose another folder or free some space.");
}

std::optional<std::string> tiffState(const fs::path& file) {
  TIFFSetErrorHandler(beQuiet);
  TIFFSetWarningHandler(beQuiet);
  const TiffFile tiff(TIFFOpen(file.c_str(), "r"));
  if (!tiff) throw FileError("The picture '" + file.string() + "' cannot be read.");
  char* words = nullptr;
  if (TIFFGetField(tiff.get(), TIFFTAG_IMAGEDESCRIPTION, &words) != 1 || words == nullptr) {
    return std::nullopt;
  }
  const std::string text(words);
  const std::size_t at = text.find(kStateLine);
  if (at == std::string::npos) return std::nullopt;
  return text.substr(at + std::strlen(kStateLine));
}

[[noreturn]] void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void beQuietPng(png_structp, png_const_charp) {}

// libpng leaves by longjmp: nothing with a destructor lives in this function. The text is copied
// into `out`, which the caller owns. @return 0 broken, 1 no such entry, 2 found
int readState(std::FILE* file, char* out, std::size_t room) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, beQuietPng);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_read_struct(&png, &info, nullptr);
    return 0;
  }
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_chunk_malloc_max(png, room);
  png_init_io(png, file);
  png_read_info(png, info);
  png_textp entries = nullptr;
  int count = 0;
  int found = 1;
  png_get_text(png, info, &entries, &count);
  for (int i = 0; i < count; ++i) {
    if (std::strcmp(entries[i].key, kStateEntry) != 0) continue;
    if (std::strlen(entries[i].text) + 1 > room) break;
    std::strcpy(out, entries[i].text);
    found = 2;
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return found;
}

std::optional<std::string> pngState(const fs::path& file) {
  constexpr std::size_t kMostText = 8U << 20U;
  std::vector<char> text(kMostText);
  std::FILE* const in = std::fopen(file.c_str(), "rb");
  const int found = in != nullptr ? readState(in, text.data(), text.size()) : 0;
  if (in != nullptr) std::fclose(in);
  if (found == 0) throw FileError("The picture '" + file.string() + "' cannot be read.");
  if (found == 1) return std::nullopt;
  return std::string(text.data());
}

}  // namespace

void writeTiff(const fs::path& file, const RgbaImage& image, double dpi, const PictureText& text) {
  const std::vector<std::uint8_t> bytes = storedBytes(image);
  const bool opaque = 4 * bytes.size() == 3 * image.rgba.size();
  writeRows(file,
            {.width = image.width,
             .height = image.height,
             .channels = opaque ? 3 : 4,
             .bits = 8,
             .dpi = dpi},
            bytes.data(), text);
}

void writeTiff(const fs::path& file, const GreyPicture& image, double dpi,
               const PictureText& text) {
  writeRows(file,
            {.width = image.width, .height = image.height, .channels = 1, .bits = 16, .dpi = dpi},
            reinterpret_cast<const std::uint8_t*>(image.values.data()), text);
}

std::optional<std::string> pictureState(const fs::path& file) {
  std::FILE* const in = std::fopen(file.c_str(), "rb");
  std::array<unsigned char, 8> head{};
  const bool read = in != nullptr && std::fread(head.data(), 1, head.size(), in) == head.size();
  if (in != nullptr) std::fclose(in);
  if (!read) throw FileError("The picture '" + file.string() + "' cannot be read.");
  if (png_sig_cmp(head.data(), 0, head.size()) == 0) return pngState(file);
  const bool tiff = (head[0] == 'I' && head[1] == 'I') || (head[0] == 'M' && head[1] == 'M');
  if (tiff) return tiffState(file);
  throw FileError("'" + file.string() + "' is neither a PNG nor a TIFF picture.");
}

}  // namespace relievo
