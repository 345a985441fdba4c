// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/transform.h"
#include "core/base/unit.h"
#include "core/depth/view.h"

namespace relievo {

/// Where a scan goes in the frame of the reference scan: both in file coordinates, rotation and
/// translation only.
using Pose = Transform<FilePoint, FilePoint>;

inline constexpr Rotation kFileAxes{1, 0, 0, 0, 1, 0, 0, 0, 1};

// Every step sees what the steps before it left, where they put it. Lengths in mm are turned into
// the scan's unit; coordinates are the file's own, of the reference scan after Align.

/// Keeps what lies in a box (edges included), or outside of it.
struct CropBox {
  FilePoint min, max;         ///< Along `axes`, file units.
  Rotation axes = kFileAxes;  ///< Rows: the box's axes in file axes.
  bool keep_inside = true;
  friend bool operator==(const CropBox&, const CropBox&) = default;
};

/// Keeps what is seen within an outline, or outside of it, however deep it lies. Where the outline
/// crosses itself the even-odd rule says what is inside.
struct CropOutline {
  Rotation view = kFileAxes;                        ///< Rows: x and y of the view in file axes.
  std::vector<std::array<double, 2>> outline = {};  ///< Corners as the view shows them, file units.
  bool keep_inside = true;
  friend bool operator==(const CropOutline&, const CropOutline&) = default;
};

/// Keeps points by their LAS class.
struct Classes {
  std::vector<std::uint8_t> keep = {};  ///< Empty: all.
  bool keep_noise = false;              ///< Else 7 and 18 go, unless `keep` names them.
  friend bool operator==(const Classes&, const Classes&) = default;
};

/// Of the places where a pulse of a laser scanner came back: in woods the first is on the trees,
/// the last mostly on the ground. A pulse that came back once is first, last and single.
enum class ReturnChoice { first, last, single };
inline constexpr std::array<std::string_view, 3> kReturnNames{"first", "last", "single"};

/// Keeps points by their number among the returns of a pulse (LAS).
struct Returns {
  ReturnChoice keep = ReturnChoice::last;
  friend bool operator==(const Returns&, const Returns&) = default;
};

/// Keeps points whose stored intensity is from `low` to `high`, both included.
struct Intensities {
  double low = 0, high = 0;
  friend bool operator==(const Intensities&, const Intensities&) = default;
};

/// Of points with equal coordinates the first stays.
struct Duplicates {
  friend bool operator==(const Duplicates&, const Duplicates&) = default;
};

/// Points go whose mean distance to their `neighbours` nearest is more than `deviations` standard
/// deviations above the mean of all these means: pcl::StatisticalOutlierRemoval.
struct Outliers {
  int neighbours = 8;
  double deviations = 2;
  friend bool operator==(const Outliers&, const Outliers&) = default;
};

/// Points go that have fewer than `neighbours` others within the radius:
/// pcl::RadiusOutlierRemoval.
struct Lonely {
  std::optional<double> radius_mm = std::nullopt;  ///< Nothing: in spacings of the scan.
  double spacings = 4;                             ///< If there is no radius.
  /// The spacing is the distance within which this share of the places has its nearest other.
  double share = 0.5;
  int neighbours = 3;
  friend bool operator==(const Lonely&, const Lonely&) = default;
};

/// Points go whose mean distance to their `neighbours` nearest is more than `factor` times that of
/// the densest of these: what is thin beside what is dense. Unlike Outliers it leaves alone what is
/// thin all around, at the far end of a scan; unlike Outliers it misses strays among strays.
/// Then, if it is asked for, points go that lie off the plane of their neighbours.
struct Sparse {
  int neighbours = 8;
  double factor = 2.6;
  /// So many times as far from the plane as most of the neighbours from theirs; 0: nobody asks. At
  /// most 0.18 % of the points go so, those farthest off.
  double off_surface = 0;
  friend bool operator==(const Sparse&, const Sparse&) = default;
};

/// One point stays in every cube of this side: the one nearest the cube's middle.
struct Thin {
  double spacing_mm = 0;
  friend bool operator==(const Thin&, const Thin&) = default;
};

/// The plane that holds most points: what lies on it goes, or the scan is laid flat, so that the
/// plane's normal is +z and most of the rest lies above.
struct Base {
  bool lay = false;  ///< Else crop.
  std::optional<double> distance_mm =
      std::nullopt;  ///< Nearer is on it; nothing: twice the scan's spacing.
  std::uint32_t seed = 1;
  friend bool operator==(const Base&, const Base&) = default;
};

/// A normal for every point from the plane of its nearest neighbours.
struct Normals {
  int neighbours = 12;
  friend bool operator==(const Normals&, const Normals&) = default;
};

enum class AlignMethod { stored, points, automatic };
inline constexpr std::array<std::string_view, 3> kAlignMethodNames{"stored", "points", "auto"};

/// The same place on a scan and on the reference, each in its own file coordinates.
struct PickedPair {
  std::uint32_t scan = 0;  ///< From 0.
  FilePoint point, reference;
  friend bool operator==(const PickedPair&, const PickedPair&) = default;
};

/// From here on all scans are one. Steps before it see every scan alone, and so do all steps of a
/// recipe without it.
struct Align {
  AlignMethod method = AlignMethod::stored;
  std::uint32_t reference = 0;         ///< The scan that stays where it is, from 0.
  std::vector<PickedPair> pairs = {};  ///< Of `points`.
  std::uint32_t seed = 1;
  std::vector<Pose> poses = {};  ///< One for each scan: found before, used and not searched again.
  friend bool operator==(const Align&, const Align&) = default;
};

using Step = std::variant<CropBox, CropOutline, Classes, Intensities, Duplicates, Outliers, Lonely,
                          Sparse, Thin, Base, Normals, Align, Returns>;

/// The steps that leave stray points out of most scans; tests/benchmark/prepare_benchmark holds
/// them against planted strays.
std::vector<Step> cleaningSteps();

/// "crop_box", "outliers", ...: the word of a step in recipes and reports.
std::string_view kindOf(const Step& step) noexcept;

/// One of the files that are prepared.
struct ScanSource {
  std::string file;         ///< As it is found from the recipe's folder; "/" between names.
  std::string sha256 = {};  ///< 64 hexadecimal digits; empty: not known.
  std::optional<LengthUnit> unit = std::nullopt;  ///< Given; nothing: as the file says.
  std::vector<int> parts = {};                    ///< E57, PTX: as ScanChoices::parts.
  bool keep_withheld = false;                     ///< LAS: as ScanChoices::keep_withheld.
  friend bool operator==(const ScanSource&, const ScanSource&) = default;
};

/// What is done to scans before a map is made of them. Plain value: the same recipe and files give
/// the same points.
struct Recipe {
  std::vector<ScanSource> scans = {};
  std::vector<Step> steps = {};
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

inline constexpr std::size_t kMostSteps = 100;
inline constexpr std::size_t kMostScans = 255;  ///< Scan::parts counts in bytes.
inline constexpr std::size_t kMostOutlineCorners = 4096;
inline constexpr std::size_t kMostPairs = 1000;
inline constexpr int kMostNeighbours = 1000;

/// Every number finite and within its range, every list within its limit, rotations rotations.
/// @throw ArgumentError  naming the step, the value and what it may be
void check(const Recipe& recipe);

/// A rotation (determinant +1, to 1e-9) and a translation, all finite.
bool isRigid(const Pose& pose) noexcept;

/// One JSON object, numbers in round-trip form; the same recipe gives the same text.
/// @param indent  blanks per level; -1 writes one line
std::string toJson(const Recipe& recipe, int indent = 2);
/// The parameters of one step, with its kind.
std::string toJson(const Step& step);

/// @throw FileError  not a recipe, of a newer schema, a key that no step knows, or a value that
///                   `check` refuses; the sentence names `source`
Recipe recipeFromJson(std::string_view json, const std::string& source);

}  // namespace relievo
