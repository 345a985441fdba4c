// SPDX-License-Identifier: BSD-3-Clause
#include <png.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "ui/vtk/files/picture_file.h"
#include "ui/vtk/offscreen.h"

namespace relievo {
namespace {

struct PngText {
  std::vector<png_text> entries;
  explicit PngText(const std::vector<std::pair<std::string, std::string>>& text) {
    for (const auto& [key, value] : text) {
      if (key.empty() || key.size() > 79) {
        throw failure<MessageId::png_entry_name>(key);
      }
      png_text entry{};
      // Plain ASCII as tEXt, which every reader knows; anything else, and every entry of ours, as
      // UTF-8 in iTXt.
      const bool ours = key.rfind("relievo:", 0) == 0;
      const bool ascii = !ours && std::all_of(value.begin(), value.end(), [](char c) {
        return static_cast<unsigned char>(c) < 0x80;
      });
      entry.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
      entry.key = const_cast<char*>(key.c_str());
      entry.text = const_cast<char*>(value.c_str());
      if (ascii) {
        entry.text_length = value.size();
      } else {
        entry.itxt_length = value.size();
      }
      entries.push_back(entry);
    }
  }
};

// The caller says what went wrong; libpng would also print it.
[[noreturn]] void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void beQuiet(png_structp, png_const_charp) {}

struct PngShape {
  int width = 0, height = 0, colour_type = PNG_COLOR_TYPE_RGB;
  double dpi = 0;  ///< 0: not said.
};

// libpng leaves by longjmp: nothing with a destructor lives in this function.
bool encode(std::FILE* file, const PngShape& shape, const png_byte* const* rows, PngText& text) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, beQuiet);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_init_io(png, file);
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_IHDR(png, info, static_cast<png_uint_32>(shape.width),
               static_cast<png_uint_32>(shape.height), 8, shape.colour_type, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (shape.dpi > 0) {
    const auto per_metre = static_cast<png_uint_32>(std::lround(shape.dpi / 0.0254));
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (!text.entries.empty()) {
    png_set_text(png, info, text.entries.data(), static_cast<int>(text.entries.size()));
  }
  png_write_info(png, info);
  png_write_image(png, const_cast<png_bytepp>(rows));
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

// Written beside the target and renamed, so that a failure leaves nothing half done.
void writeRows(const OutputFile& place, const PngShape& shape,
               const std::vector<std::uint8_t>& bytes, const PictureText& text) {
  const std::filesystem::path& file = place.path;
  const std::size_t channels = shape.colour_type == PNG_COLOR_TYPE_RGB ? 3 : 4;
  const std::size_t row_bytes = channels * static_cast<std::size_t>(std::max(shape.width, 0));
  if (shape.width <= 0 || shape.height <= 0 ||
      bytes.size() != row_bytes * static_cast<std::size_t>(shape.height)) {
    throw failure<MessageId::no_picture_to_write>(file);
  }
  PngText entries(text);
  std::vector<const png_byte*> rows;
  rows.reserve(static_cast<std::size_t>(shape.height));
  for (int row = 0; row < shape.height; ++row) {
    rows.push_back(bytes.data() + row_bytes * static_cast<std::size_t>(row));
  }
  AtomicFile replaced(place);
  std::FILE* const out = std::fopen(replaced.path().c_str(), "wb");
  const bool opened = out != nullptr;
  const bool encoded = opened && encode(out, shape, rows.data(), entries);
  const bool closed = opened && std::fclose(out) == 0;
  if (!encoded || !closed) {
    throw failure<MessageId::picture_not_written_for>(file, std::strerror(errno));
  }
  replaced.commit();
}

}  // namespace

void writePng(const OutputFile& file, const RgbImage& image, const PictureText& text) {
  writeRows(file, {.width = image.width, .height = image.height}, image.rgb, text);
}

std::optional<PictureFormat> pictureFormatOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".png") return PictureFormat::png;
  if (ending == ".tif" || ending == ".tiff") return PictureFormat::tiff;
  return std::nullopt;
}

void writePng(const OutputFile& file, const RgbaImage& image, double dpi, const PictureText& text) {
  const std::vector<std::uint8_t> bytes = storedBytes(image);
  const bool opaque = 4 * bytes.size() == 3 * image.rgba.size();
  writeRows(file,
            {.width = image.width,
             .height = image.height,
             .colour_type = opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA,
             .dpi = dpi},
            bytes, text);
}

}  // namespace relievo
