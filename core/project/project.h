// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/measure.h"
#include "core/project/figure_request.h"
#include "core/provenance/sha256.h"
#include "core/region/region.h"
#include "core/relief/look.h"
#include "core/replay/camera_path.h"
#include "core/session/surface.h"

namespace relievo {

inline constexpr int kProjectSchema = 1;

struct NamedRegion {
  std::string name;
  Region region;
  double gain = 1;
  friend bool operator==(const NamedRegion&, const NamedRegion&) = default;
};

/// Everything that brings a state back: which file, how its surface is made, what is shown and
/// measured. Written into project files and into every figure.
struct Project {
  std::string file;    ///< As it is found from the project's or picture's folder.
  std::string sha256;  ///< Of the file, hexadecimal; empty: not known.
  SurfaceOptions options;
  Region region;
  double gain = 1;
  ReliefLook look;
  StereoOptions stereo;
  FigureRequest figure;
  std::vector<NamedRegion> places;
  std::vector<Measurement> measurements;
  /// Logs of touches; found like `file`, each with its checksum.
  std::vector<InputFile> recordings;
  std::vector<CameraPath> paths;     ///< The first is the window's.
  std::vector<std::string> history;  ///< Names of the steps that led here, oldest first.
  std::string version;               ///< Of the program that wrote it.
  std::string others;                ///< JSON object of keys this version does not know.
};

/// Readable JSON; the same project gives the same bytes. Keys this version does not know are kept.
std::string projectJson(const Project& project);
/// @throw FileError  not JSON, not a project, or of a newer schema; names `source`
Project projectFromJson(std::string_view json, const std::string& source);

/// Writes beside the target and renames. `project.file` and the recordings are stored relative to
/// the target's folder.
/// @throw WriteError
void writeProject(const std::filesystem::path& target, Project project);
/// `file` of the result and of its recordings is absolute, wherever the project has been moved
/// together with its input.
/// @throw FileError
Project readProject(const std::filesystem::path& source);

}  // namespace relievo
