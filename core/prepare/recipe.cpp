// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/recipe.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/failure.h"

namespace relievo {
namespace {

constexpr double kRigid = 1e-9;  ///< How far from a rotation a matrix may be.
constexpr double kFarthest = 1e38;
constexpr double kMostDeviations = 1000;

/// Rows of unit length at right angles, right-handed, to 1e-9.
bool isRotation(const Rotation& r) {
  const auto row = [&r](std::size_t a, std::size_t b) {
    return r[3 * a] * r[3 * b] + r[3 * a + 1] * r[3 * b + 1] + r[3 * a + 2] * r[3 * b + 2];
  };
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      // Written so that NaN fails.
      if (!(std::abs(row(a, b) - (a == b ? 1 : 0)) <= kRigid)) return false;
    }
  }
  const double determinant = r[0] * (r[4] * r[8] - r[5] * r[7]) -
                             r[1] * (r[3] * r[8] - r[5] * r[6]) +
                             r[2] * (r[3] * r[7] - r[4] * r[6]);
  return determinant > 0;
}

class Checker {
 public:
  explicit Checker(Message step) : step_(std::move(step)) {}

  void operator()(const CropBox& s) const {
    point("min", s.min);
    point("max", s.max);
    if (!(s.min.x <= s.max.x) || !(s.min.y <= s.max.y) || !(s.min.z <= s.max.z)) {
      refuse<MessageId::step_box_reversed>();
    }
    rotation("axes", s.axes);
  }
  void operator()(const CropOutline& s) const {
    rotation("view", s.view);
    const std::size_t corners = s.outline.size();
    if (corners < 3 || corners > kMostOutlineCorners) {
      refuse<MessageId::step_outline_corners>(corners, kMostOutlineCorners);
    }
    for (const auto& corner : s.outline) {
      number("outline", corner[0], -kFarthest, kFarthest);
      number("outline", corner[1], -kFarthest, kFarthest);
    }
  }
  void operator()(const Classes&) const {}
  void operator()(const Returns&) const {}
  void operator()(const Intensities& s) const {
    number("low", s.low, -kFarthest, kFarthest);
    number("high", s.high, -kFarthest, kFarthest);
    if (s.low > s.high) refuse<MessageId::step_intensities_reversed>();
  }
  void operator()(const Duplicates&) const {}
  void operator()(const Outliers& s) const {
    number("neighbours", s.neighbours, 1, kMostNeighbours);
    number("deviations", s.deviations, 0, kMostDeviations);
  }
  void operator()(const Lonely& s) const {
    if (s.radius_mm) length("radius_mm", *s.radius_mm);
    number("spacings", s.spacings, 0, kFarthest);
    number("share", s.share, 0, 1);
    number("neighbours", s.neighbours, 1, kMostNeighbours);
  }
  void operator()(const Sparse& s) const {
    number("neighbours", s.neighbours, 1, kMostNeighbours);
    number("factor", s.factor, 1, kMostDeviations);
    number("off_surface", s.off_surface, 0, kMostDeviations);
  }
  void operator()(const Thin& s) const { length("spacing_mm", s.spacing_mm); }
  void operator()(const Base& s) const {
    if (s.distance_mm) length("distance_mm", *s.distance_mm);
  }
  void operator()(const Normals& s) const {
    number("neighbours", s.neighbours, 3, kMostNeighbours);
  }
  void operator()(const Align& s) const {
    if (s.reference >= kMostScans) refuse<MessageId::step_reference_beyond>();
    if (s.pairs.size() > kMostPairs) refuse<MessageId::step_many_pairs>(kMostPairs);
    for (const PickedPair& pair : s.pairs) {
      if (pair.scan >= kMostScans) refuse<MessageId::step_pair_beyond>();
      point("pairs", pair.point);
      point("pairs", pair.reference);
    }
    if (s.poses.size() > kMostScans) refuse<MessageId::step_many_poses>();
    for (const Pose& pose : s.poses) {
      if (!isRigid(pose)) refuse<MessageId::step_pose_not_rigid>();
    }
  }

 private:
  template <MessageId why, class... Given>
  [[noreturn]] void refuse(Given&&... given) const {
    throw failure<MessageId::step_refused>(step_, said<why>(std::forward<Given>(given)...));
  }
  void number(const char* key, double value, double low, double high) const {
    if (value >= low && value <= high) return;
    if (!std::isfinite(value)) {
      refuse<MessageId::step_value_not_finite>(key, shown(low), shown(high));
    }
    const NumberArgument is{.value = value, .digits = 6};
    refuse<MessageId::step_value_out_of_range>(key, is, shown(low), shown(high));
  }
  void length(const char* key, double value) const {
    if (value > 0 && value <= kFarthest) return;
    refuse<MessageId::step_length>(key);
  }
  void point(const char* key, const FilePoint& p) const {
    for (const double c : {p.x, p.y, p.z}) number(key, c, -kFarthest, kFarthest);
  }
  void rotation(const char* key, const Rotation& r) const {
    if (!isRotation(r)) refuse<MessageId::step_no_rotation>(key);
  }
  static std::string shown(double value) {
    if (std::abs(value) >= kFarthest) return value < 0 ? "-1e38" : "1e38";
    return std::to_string(static_cast<int>(value));
  }

  Message step_;
};

}  // namespace

std::string_view kindOf(const Step& step) noexcept {
  constexpr std::array<std::string_view, std::variant_size_v<Step>> kKinds{
      "crop_box", "crop_outline", "classes", "intensities", "duplicates", "outliers", "lonely",
      "sparse",   "thin",         "base",    "normals",     "align",      "returns"};
  return kKinds[step.index()];
}

std::vector<Step> cleaningSteps() {
  // Strays among strays first, then those near the surface, then those on its noise. Standard
  // deviations are no measure here: where there are no strays, mean + 3 leaves out 1 to 2 % of a
  // good scan.
  return {Lonely{.spacings = 6, .share = 0.9}, Sparse{.off_surface = 4}};
}

bool isRigid(const Pose& pose) noexcept {
  const auto& m = pose.m;
  const auto is_usable = [](double v) { return std::isfinite(v) && std::abs(v) <= kFarthest; };
  return std::all_of(m.begin(), m.end(), is_usable) && m[12] == 0 && m[13] == 0 && m[14] == 0 &&
         m[15] == 1 && isRotation({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]});
}

void check(const Recipe& recipe) {
  if (recipe.scans.size() > kMostScans) {
    throw failure<MessageId::recipe_many_scans>(recipe.scans.size(), kMostScans);
  }
  if (recipe.steps.size() > kMostSteps) {
    throw failure<MessageId::recipe_many_steps>(recipe.steps.size(), kMostSteps);
  }
  int joins = 0;
  for (std::size_t i = 0; i < recipe.steps.size(); ++i) {
    const Step& step = recipe.steps[i];
    std::visit(Checker(said<MessageId::step_of_recipe>(i + 1, kindOf(step))), step);
    if (std::holds_alternative<Align>(step)) ++joins;
  }
  if (joins > 1) throw failure<MessageId::recipe_aligns_twice>();
}

}  // namespace relievo
