// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/measure.h"
#include "core/project/figure_request.h"
#include "core/project/named_region.h"
#include "core/project/undo_step.h"
#include "core/provenance/provenance.h"
#include "core/region/region.h"
#include "core/relief/look.h"
#include "core/replay/camera_path.h"
#include "core/session/surface.h"

namespace relievo {

/// The records are those of a provenance. No other schema was in a release.
inline constexpr int kProjectSchema = 2;

/// The whole state of the work as one plain value: which file, how its surface is made, what is
/// shown and measured. Written into project files and into every picture; a window changes nothing
/// else (docs/adr/0139).
struct Project {
  std::string file;                ///< As it is found from the project's or picture's folder.
  std::string sha256;              ///< Of the file, hexadecimal; empty: not known.
  std::uint64_t bytes = 0;         ///< Of the file; 0: not known.
  bool accept_incomplete = false;  ///< The complete records of a cut file were taken.
  ScanChoices scan;                ///< What of the file was read, and by whom.
  SurfaceOptions options;
  Region region;
  double gain = 1;
  ReliefLook look;
  StereoOptions stereo;
  /// What somebody chose, where the limit of comfort lets less through than that: then
  /// stereo.eye_angle_deg is what is drawn. Nothing: what is drawn was chosen.
  std::optional<double> chosen_eye_angle_deg;
  double azimuth_deg = 0, elevation_deg = 0;  ///< Turn of the camera; 0, 0 looks along -z.
  /// What carries this is a picture of exactly the region; nothing: a figure, or no picture.
  std::optional<PictureChoice> picture;
  FigureRequest figure;
  std::vector<NamedRegion> places;
  std::vector<Measurement> measurements;
  /// Logs of touches; found like `file`, each with its checksum.
  std::vector<InputFile> recordings;
  /// Figures and pictures that were made of it, found like `file`: offered for a package.
  std::vector<std::string> figures;
  std::vector<CameraPath> paths;     ///< The first is the window's.
  std::vector<std::string> history;  ///< Names of the steps that led here, oldest first.
  /// The last of these that can be undone without making the surface anew.
  std::vector<UndoStep> undo;
  std::string version;   ///< Of the program that wrote it.
  std::string made;      ///< See madeText; empty: not said.
  std::string saved_as;  ///< Of an automatic copy: the project file it goes on from, absolute.
  std::string others;    ///< JSON object of keys this version does not know.

  /// Field by field; numbers as they compare. Of the options all but the number of threads, which
  /// changes no result.
  friend bool operator==(const Project& a, const Project& b);
};

/// The part of the state that decides a picture of the region, and back.
ViewState viewOf(const Project& project);
void setView(Project& project, const ViewState& view);

/// Stereo as somebody chose it: without what a view makes of it for the heights that it shows.
StereoOptions chosenStereo(const Project& project);

/// What of a state cost somebody work; all else is empty. Where the window stands is not work: to
/// look about must not end in a question; recordings are files already.
/// @param settings  also how the surface is made and looked at: of a state that a project file
///                  holds
Project workIn(const Project& state, bool settings);

/// The state as files keep it: a view that was chosen automatically is written out, because a later
/// version may choose otherwise.
Project storedProject(Project project, const Surface& surface);

/// Where something made of this state comes from: its input as it is found from `folder`, every
/// choice, and what is shown.
/// @param made  madeText of the surface
Provenance provenanceOf(const Project& project, const Surface& surface,
                        const std::filesystem::path& folder, std::string made);
Provenance provenanceOf(const Project& project, const Surface& surface,
                        const std::filesystem::path& folder);

/// Readable JSON; the same project gives the same bytes. Keys this version does not know are kept.
std::string projectJson(const Project& project);
/// @throw FileError  not JSON, not a project, or of a newer schema; names `source`
Project projectFromJson(std::string_view json, const std::string& source);

/// The project with its files as they are found from the folder of `written`.
Project relativeTo(Project project, const std::filesystem::path& written);

/// Writes beside the target and renames. `project.file`, recordings and figures are stored relative
/// to the target's folder.
/// @throw WriteError
void writeProject(const std::filesystem::path& target, Project project);
/// `file` of the result, of its recordings and its figures are absolute, wherever the project has
/// been moved together with its input.
/// @throw FileError
Project readProject(const std::filesystem::path& source);

}  // namespace relievo
