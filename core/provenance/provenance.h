// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/vec3.h"
#include "core/io/import.h"
#include "core/provenance/sha256.h"
#include "core/region/region.h"
#include "core/relief/look.h"
#include "core/relief/stereo.h"
#include "core/session/surface.h"

namespace relievo {

/// Which part of a surface is seen, and how: what a named view keeps and what can be pasted as
/// text.
struct ViewState {
  Region region = {};
  double gain = 1;  ///< On heights; 1 is true to scale.
  ReliefLook look = {};
  StereoOptions stereo = {};
  double azimuth_deg = 0, elevation_deg = 0;  ///< Turn of the camera; 0, 0 looks along -z.
  friend bool operator==(const ViewState&, const ViewState&) = default;
};

/// The hand as a picture shows it.
struct DrawnHand {
  ViewMm proxy, hip;
  DeviceN force;
  double force_limit_n = 0;
  bool touching = false, forces_on = false;
  double ball_radius_mm = 1;
  friend bool operator==(const DrawnHand&, const DrawnHand&) = default;
};

/// How a view becomes a picture of exactly the region.
struct PictureChoice {
  int width_px = 0, height_px = 0;
  bool scale_bar = false;
  /// What of the window it shows: `detail`; others only the window can draw again.
  std::string source = "detail";
  std::string background = {};                   ///< "#rrggbb"; empty: the usual dark grey.
  std::vector<std::vector<ViewMm>> lines = {};   ///< Measurements, as drawn.
  std::optional<DrawnHand> hand = std::nullopt;  ///< Nothing: no hand was on the surface.
  /// One of the two pictures that the view's stereo would mix, by its eye separation.
  FigureEye eye = FigureEye::both;
  friend bool operator==(const PictureChoice&, const PictureChoice&) = default;
};

/// Where a result came from: which bytes, which program, every choice in between. It travels inside
/// every picture, map and log; what is made again from it has the same pixels or samples. No
/// dates: the same input and choices give the same bytes.
struct Provenance {
  std::string version, commit;  ///< Of the program that made the result.
  InputFile input;
  /// The files that `input` stands for, in the order in which their points are counted, if it is
  /// several (inputOf).
  std::vector<InputFile> files;
  SurfaceOptions options;          ///< What was chosen for people is written out.
  bool accept_incomplete = false;  ///< The complete records of a cut file were taken.
  ScanChoices scan;                ///< What of the file was read, and by whom.
  std::optional<ViewState> view;
  std::optional<PictureChoice> picture;
  std::optional<ReliefLook> values;  ///< A map of this relief image's values, not of heights.
  /// JSON objects, kept as they are; empty: none. `touch` is the stroke and the law of the force,
  /// `made` what the surface came out as, `figure` a page around the picture.
  std::string touch, made, figure;
};

/// What a surface came out as, for a reader of the file: one JSON object.
std::string madeText(const Surface& surface);

/// `version`, `commit`, `options` and `made` of a surface that is in memory.
/// @param made  its madeText
Provenance provenanceOf(const Surface& surface, const SurfaceOptions& options, std::string made);
Provenance provenanceOf(const Surface& surface, const SurfaceOptions& options);

/// The same of a map made by tiles.
struct LargeMap;  // core/session/large/large_map.h
Provenance provenanceOf(const LargeMap& map, const SurfaceOptions& options);

/// The options with what was chosen automatically written out: unit, view, sample distance.
SurfaceOptions resolved(const SurfaceOptions& options, const Surface& surface);

/// One JSON object, numbers in round-trip form; the same record gives the same text.
/// @param indent  blanks per level; -1 writes one line
std::string toJson(const Provenance& provenance, int indent = 2);
/// @throw FileError  no such object, of a newer schema, or with a value that makes no sense; the
///                   sentence names `source`
Provenance provenanceFromJson(std::string_view json, const std::string& source);

/// A view as text that people can read, paste and send.
std::string toText(const ViewState& view);
/// @throw ArgumentError  not a view, or a value that makes no sense
ViewState viewFromText(std::string_view text);

}  // namespace relievo
