// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "core/cloud/scan.h"
#include "core/io/read_scan.h"

namespace relievo {

class ScanBuilder;

/// The materials of an OBJ file and the pictures they name. What an OBJ names is not trusted: only
/// files in its own folder or below are opened, whatever links say; what is refused becomes a
/// warning, and the mesh stays without that picture.
class ObjMaterials {
 public:
  ObjMaterials(const ReadJob& job, ScanBuilder& builder) : job_(job), builder_(builder) {}

  /// `mtllib NAME ...`
  void readLibraries(std::string_view names);
  /// Does any material name a picture, and can it be read here?
  bool hasPictures() const noexcept { return has_pictures_ && job_.load_texture != nullptr; }
  /// `usemtl NAME`: the texture's number, or kNoTexture. Loads it at its first use.
  std::uint16_t use(std::string_view name);

 private:
  struct Material {
    std::string picture;                   ///< As the file names it; empty: none.
    std::optional<std::uint16_t> texture;  ///< Once it was tried.
  };

  void readLibrary(const std::filesystem::path& file);
  std::uint16_t load(const std::string& picture);
  /// The file of that name. Nothing, and a warning, if it is not there or not to be opened.
  std::optional<std::filesystem::path> allowed(std::string_view name, std::uint64_t most_bytes);
  void warn(std::string_view name, Message reason);

  const ReadJob& job_;
  ScanBuilder& builder_;
  std::map<std::string, Material, std::less<>> materials_;
  std::map<std::string, std::uint16_t> loaded_;  ///< By the name of the picture.
  std::uint64_t texels_ = 0;
  std::size_t warnings_ = 0;
  bool has_pictures_ = false;
};

}  // namespace relievo
