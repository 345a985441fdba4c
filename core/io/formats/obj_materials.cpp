// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/formats/obj_materials.h"

#include <algorithm>
#include <array>
#include <system_error>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/text_file.h"
#include "core/io/scan_builder.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMostLibraryBytes = 16 << 20;
constexpr std::uint64_t kMostPictureBytes = 512 << 20;
constexpr std::uint64_t kMostTexels = (1ULL << 30) / sizeof(Rgba);  ///< Of all pictures together.
constexpr std::size_t kMostMaterials = 10'000;
constexpr std::size_t kMostWarnings = 3;

/// The file name behind the options of `map_Kd`; it may hold blanks.
std::string_view withoutOptions(std::string_view rest) {
  struct Option {
    std::string_view name;
    int words;
  };
  constexpr std::array<Option, 12> kOptions{{{"-blendu", 1},
                                             {"-blendv", 1},
                                             {"-bm", 1},
                                             {"-boost", 1},
                                             {"-cc", 1},
                                             {"-clamp", 1},
                                             {"-imfchan", 1},
                                             {"-mm", 2},
                                             {"-texres", 1},
                                             {"-o", 3},
                                             {"-s", 3},
                                             {"-t", 3}}};
  for (;;) {
    rest = trimmed(rest);
    const std::string_view word = firstWord(rest);
    const auto* const option = std::find_if(
        kOptions.begin(), kOptions.end(), [&](const Option& known) { return known.name == word; });
    if (option == kOptions.end()) return rest;
    takeWord(rest);
    for (int i = 0; i < option->words; ++i) {
      // Places may be one to three numbers.
      if (option->words == 3 && !parseNumber(firstWord(rest))) break;
      takeWord(rest);
    }
  }
}

bool staysBelow(const std::filesystem::path& file, const std::filesystem::path& folder) {
  const auto [rest, at] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return rest == folder.end() && at != file.end();
}

}  // namespace

void ObjMaterials::warn(std::string_view name, Message reason) {
  if (++warnings_ > kMostWarnings) return;
  builder_.info().warnings.push_back(
      said<MessageId::loaded_without_picture>(printable(name.substr(0, 80)), std::move(reason)));
}

std::optional<std::filesystem::path> ObjMaterials::allowed(std::string_view name,
                                                           std::uint64_t most_bytes) {
  std::string text(name);
  std::replace(text.begin(), text.end(), '\\', '/');
  const std::filesystem::path stated(text);
  const bool leaves = stated.is_absolute() || text.find('\0') != std::string::npos ||
                      std::find(stated.begin(), stated.end(), "..") != stated.end();
  if (leaves || text.empty()) {
    warn(name, said<MessageId::picture_outside_folder>());
    return std::nullopt;
  }
  std::error_code error;
  const auto folder = std::filesystem::canonical(job_.file, error).parent_path();
  const auto file = std::filesystem::canonical(folder / stated, error);
  if (error) {
    warn(name, said<MessageId::picture_not_there>());
    return std::nullopt;
  }
  if (!staysBelow(file, folder)) {
    warn(name, said<MessageId::picture_outside_folder>());
    return std::nullopt;
  }
  if (!std::filesystem::is_regular_file(file, error) ||
      std::filesystem::file_size(file, error) > most_bytes || error) {
    warn(name, said<MessageId::picture_no_file>());
    return std::nullopt;
  }
  return file;
}

void ObjMaterials::readLibraries(std::string_view names) {
  names = trimmed(names);
  // One name with blanks, or several without.
  std::error_code error;
  const auto whole = std::filesystem::path(job_.file).parent_path() / std::string(names);
  if (std::filesystem::exists(whole, error)) return readLibrary(std::string(names));
  for (std::string_view name = takeWord(names); !name.empty(); name = takeWord(names)) {
    readLibrary(std::string(name));
  }
}

void ObjMaterials::readLibrary(const std::filesystem::path& name) {
  const auto file = allowed(name.string(), kMostLibraryBytes);
  if (!file) return;
  std::string text;
  try {
    text = readTextFile(*file, kMostLibraryBytes);
  } catch (const FileError&) {
    return warn(name.string(), said<MessageId::materials_unreadable>());
  }
  Lines lines(text);
  Material* material = nullptr;
  while (lines.next()) {
    std::string_view rest = lines.line();
    const std::string_view word = takeWord(rest);
    if (word == "newmtl" && materials_.size() < kMostMaterials) {
      material = &materials_[std::string(trimmed(rest))];
    } else if (word == "map_Kd" && material != nullptr) {
      material->picture = withoutOptions(rest);
      has_pictures_ = has_pictures_ || !material->picture.empty();
    }
  }
}

std::uint16_t ObjMaterials::use(std::string_view name) {
  const auto found = materials_.find(trimmed(name));
  if (found == materials_.end() || found->second.picture.empty() || !hasPictures()) {
    return kNoTexture;
  }
  Material& material = found->second;
  if (!material.texture) {
    const auto before = loaded_.find(material.picture);
    material.texture = before != loaded_.end() ? before->second : load(material.picture);
    loaded_[material.picture] = *material.texture;
  }
  return *material.texture;
}

std::uint16_t ObjMaterials::load(const std::string& picture) {
  constexpr std::size_t kMostTextures = 4096;
  const auto file = allowed(picture, kMostPictureBytes);
  if (!file) return kNoTexture;
  if (loaded_.size() >= kMostTextures) {
    warn(picture, said<MessageId::picture_too_many>());
    return kNoTexture;
  }
  job_.task.check();
  job_.task.report("reading pictures", 0);
  std::optional<Message> reason;
  auto texture = job_.load_texture(*file, kMostTexels - texels_, reason);
  if (!texture) {
    warn(picture, *std::move(reason));
    return kNoTexture;
  }
  texels_ += texture->texels.size();
  return builder_.addTexture(std::move(*texture));
}

}  // namespace relievo
