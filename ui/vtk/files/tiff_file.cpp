// SPDX-License-Identifier: BSD-3-Clause
#include <tiffio.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "ui/vtk/files/picture_file.h"

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

void writeRows(const OutputFile& place, const TiffShape& shape, const std::uint8_t* bytes,
               const PictureText& text) {
  const fs::path& file = place.path;
  AtomicFile replaced(place);
  TIFFSetErrorHandler(beQuiet);
  TIFFSetWarningHandler(beQuiet);
  bool good = shape.width > 0 && shape.height > 0;
  errno = 0;
  if (good) {
    const TiffFile tiff(TIFFOpen(replaced.path().c_str(), "w"));
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
  if (!good) {
    if (errno == 0) throw failure<MessageId::picture_not_written>(file);
    throw failure<MessageId::picture_not_written_for>(file, std::strerror(errno));
  }
  replaced.commit();
}

}  // namespace

void writeTiff(const OutputFile& file, const RgbaImage& image, double dpi,
               const PictureText& text) {
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

void writeTiff(const OutputFile& file, const GreyPicture& image, double dpi,
               const PictureText& text) {
  writeRows(file,
            {.width = image.width, .height = image.height, .channels = 1, .bits = 16, .dpi = dpi},
            reinterpret_cast<const std::uint8_t*>(image.values.data()), text);
}

}  // namespace relievo
