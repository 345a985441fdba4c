// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/cli/state.h"
#include "core/base/replaceable.h"

namespace relievo::batch {

/// What a command reads and what it writes, as far as its words tell: known before any work.
struct VerbFiles {
  /// A map as it was given, and the option that it was given by.
  struct NamedMap {
    std::string option;
    std::filesystem::path file;
  };

  std::vector<FileRead> inputs;
  std::vector<std::filesystem::path> outputs;
  std::vector<NamedMap> maps;

  /// With what belongs to it: origins and levels of a map, a raster's georeference.
  void reads(const std::filesystem::path& scan);
  void reads(const std::filesystem::path& file, const std::string& what);
  /// A picture or project whose state comes back, and the files that the state names.
  /// @param given  the scan, if no state is given or it is not where the state says; else empty
  /// @throw FileError  the state is unreadable, or (E501) the scan is nowhere
  void readsStateOf(const HostFileArguments& host_file, const std::string& given);
  /// Likewise of a log that says how its map was made. @throw FileError
  void readsStateOf(const std::filesystem::path& log, const std::string& given);

  /// Empty and "-" are no file.
  void writes(const std::filesystem::path& file);
  /// A depth map, whose origins and colours lie beside it.
  void writesMap(const std::filesystem::path& map);
  /// Maps are GeoTIFFs, whatever they are called: a name that says something else is refused.
  void namesMap(const std::string& option, const std::filesystem::path& map);
  /// What lies beside a map whose scan had colours or intensities; writesMap names it, too.
  void writesColoursOf(const std::filesystem::path& map);
  /// One map per level of a pyramid.
  void writesLevels(const std::filesystem::path& finest);
};

struct TouchArguments;
/// Of the verbs that touch.
VerbFiles filesOf(const TouchArguments& arguments);

/// @throw ArgumentError  an output is an input, or another output, or a map's name ends otherwise
///     than .tif or .tiff
void check(const VerbFiles& files);

}  // namespace relievo::batch
