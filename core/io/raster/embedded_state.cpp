// SPDX-License-Identifier: BSD-3-Clause
// The process's own side of embeddedState; that of its caller is in import.cpp.
#include "core/io/raster/embedded_state.h"

#include <png.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>

#include "core/base/failure.h"
#include "core/io/export/write_cloud.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/ply_header.h"
#include "core/io/raster/png_version.h"
#include "core/io/raster/tiff_head.h"
#include "core/io/raster/xml_entities.h"
#include "core/io/worker/reader_guard.h"

namespace relievo {
namespace {

constexpr std::size_t kMostStateBytes = 16U << 20U;
constexpr int kMostCommentLines = 1000;  // Of a CSV file, before its columns.

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void beQuiet(png_structp, png_const_charp) {}

// libpng leaves by longjmp: nothing with a destructor is made in this function.
bool readPngEntry(std::FILE* file, std::string& state) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, beQuiet);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info || setjmp(png_jmpbuf(png))) {
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_init_io(png, file);
  png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
  png_set_chunk_malloc_max(png, kMostStateBytes);
  png_read_info(png, info);
  png_textp entries = nullptr;
  int count = 0;
  png_get_text(png, info, &entries, &count);
  for (int i = 0; i < count; ++i) {
    if (kStateKey == entries[i].key && entries[i].text != nullptr) state = entries[i].text;
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}

std::optional<std::string> pngState(const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, CloseFile> in(std::fopen(file.c_str(), "rb"));
  std::string state;
  if (!in || !readPngEntry(in.get(), state)) {
    throw failure<MessageId::picture_damaged>(shownName(file));
  }
  if (state.empty()) return std::nullopt;
  return state;
}

/// A map's description is its state; a picture's has it after the caption.
std::optional<std::string> tiffState(const std::filesystem::path& file) {
  auto words = descriptionIn(readTiffHead(file), file);
  if (!words || words->starts_with('{')) return words;
  const std::string line = "\n" + std::string(kStateKey) + "\n";
  const std::size_t at = words->find(line);
  if (at == std::string::npos) return std::nullopt;  // Another program's description.
  return words->substr(at + line.size());
}

std::optional<std::string> commentState(const std::filesystem::path& file) {
  const std::string start = "# " + std::string(kStateKey) + " ";
  std::ifstream in(file, std::ios::binary);
  std::string line;
  for (int i = 0; i < kMostCommentLines && in.peek() == '#'; ++i) {
    line.clear();
    for (int c = in.get(); c != '\n' && c != EOF && line.size() < kMostStateBytes; c = in.get()) {
      line += static_cast<char>(c);
    }
    if (line.starts_with(start)) return line.substr(start.size());
  }
  return std::nullopt;
}

/// Of a cloud: the pieces that its header's comments hold.
std::optional<std::string> cloudState(const std::filesystem::path& file) {
  const std::string head = readHead(file, kMaxHeaderBytes);
  std::string state;
  Lines lines(head);
  while (lines.next() && trimmed(lines.line()) != "end_header") {
    if (lines.line().starts_with(kCloudStateWords)) {
      state += lines.line().substr(kCloudStateWords.size());
    }
  }
  if (state.empty()) return std::nullopt;
  return state;
}

/// Reads on to the end of `mark`. @return what stood before it; nothing: it does not come, or only
/// after more than `most` bytes
std::optional<std::string> textUpTo(std::istream& in, std::string_view mark, std::size_t most) {
  std::string text;
  for (int c = in.get(); c != EOF && text.size() < most; c = in.get()) {
    text += static_cast<char>(c);
    if (text.ends_with(mark)) return text.substr(0, text.size() - mark.size());
  }
  return std::nullopt;
}

/// As textUpTo, but keeps nothing of what comes before the mark.
bool skipTo(std::istream& in, std::string_view mark) {
  constexpr std::size_t kBlock = 1U << 20U;
  std::string block;
  while (in) {
    const std::size_t kept = std::min(block.size(), mark.size() - 1);
    block.erase(0, block.size() - kept);
    const auto begin = static_cast<std::streamoff>(in.tellg()) - static_cast<std::streamoff>(kept);
    block.resize(kept + kBlock);
    in.read(block.data() + kept, static_cast<std::streamsize>(kBlock));
    block.resize(kept + static_cast<std::size_t>(in.gcount()));
    const std::size_t at = block.find(mark);
    if (at == std::string::npos) continue;
    in.clear();
    in.seekg(begin + static_cast<std::streamoff>(at + mark.size()));
    return true;
  }
  return false;
}

/// Of an SVG, or of the XMP packet of a PDF, which is neither packed nor encrypted.
std::optional<std::string> markupState(const std::filesystem::path& file) {
  const std::string key(kStateKey);
  std::ifstream in(file, std::ios::binary);
  if (!skipTo(in, "<" + key) || !textUpTo(in, ">", kMostStateBytes)) return std::nullopt;
  const auto text = textUpTo(in, "</" + key, kMostStateBytes);
  if (!text) {
    throw failure<MessageId::embedded_state_cut>(shownName(file));
  }
  return withoutEntities(*text);
}

}  // namespace

std::optional<std::string> embeddedStateHere(const std::filesystem::path& file) {
  requireReadersAllowed("embeddedStateHere");
  const std::string head = readHead(file, 8);
  if (head == "\x89PNG\r\n\x1a\n") return pngState(file);
  if (head.starts_with(std::string_view("II*\0", 4)) || head.starts_with("II+") ||
      head.starts_with(std::string_view("MM\0", 3))) {
    return tiffState(file);
  }
  if (head.starts_with("ply\n")) return cloudState(file);
  if (head.starts_with('#')) return commentState(file);
  if (head.starts_with("%PDF-") || head.starts_with("<?xml") || head.starts_with("<svg")) {
    return markupState(file);
  }
  return std::nullopt;
}

std::string pngVersion() {
  return png_get_libpng_ver(nullptr);
}

}  // namespace relievo
