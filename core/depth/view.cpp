// SPDX-License-Identifier: BSD-3-Clause
#include "core/depth/view.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "core/base/bands.h"
#include "core/base/failure.h"
#include "core/base/wide_vectors.h"
#include "core/depth/layers/automatic_view.h"
#include "core/depth/layers/principal_axes.h"

namespace relievo {
namespace {

// conventions: file axes that become view x, y, z.
const std::array<std::pair<std::string_view, Rotation>, 6> kStandardViews{{
    {"top", {1, 0, 0, 0, 1, 0, 0, 0, 1}},
    {"front", {1, 0, 0, 0, 0, 1, 0, -1, 0}},
    {"right", {0, 1, 0, 0, 0, 1, 1, 0, 0}},
    {"back", {-1, 0, 0, 0, 0, 1, 0, 1, 0}},
    {"left", {0, -1, 0, 0, 0, 1, -1, 0, 0}},
    {"bottom", {1, 0, 0, 0, -1, 0, 0, 0, -1}},
}};

ViewMm rotate(const Rotation& r, const FilePoint& p) noexcept {
  return {r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
          r[6] * p.x + r[7] * p.y + r[8] * p.z};
}

FilePoint localPoint(const Scan& scan, std::size_t i) noexcept {
  const auto& p = scan.points[i];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

constexpr double kTrimmedShare = 0.02;  // Outliers and stray points do not tilt the plane.
constexpr double kCertain = 1.02;       // Spreads closer than this could change places.

Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Axis scaled(const Axis& a, double factor) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
Axis unit(const Axis& a) {
  return scaled(a, 1 / std::hypot(a[0], a[1], a[2]));
}

/// Rows: right, the direction that completes them, toward the viewer.
Rotation rotationOf(const Axis& right, const Axis& toward) {
  const Axis up = cross(toward, right);
  return {right[0], right[1], right[2], up[0], up[1], up[2], toward[0], toward[1], toward[2]};
}

/// The picture stands upright: the file's axis that leans least toward the viewer's line of sight
/// is up, z before y before x, as it would be in the standard view nearest to this one.
Rotation upright(const Axis& toward) {
  std::string_view nearest = "top";
  double most = -2;
  for (const auto& [name, rotation] : kStandardViews) {
    const double along =
        rotation[6] * toward[0] + rotation[7] * toward[1] + rotation[8] * toward[2];
    if (along > most + 1e-9) {
      most = along;
      nearest = name;
    }
  }
  const Rotation standard = *standardRotation(nearest);
  const Axis up{standard[3], standard[4], standard[5]};
  return rotationOf(unit(cross(up, toward)), toward);
}

/// Of the two sides of a plane the one that shows more; above, if they show the same.
Axis showingSide(const Scan& scan, const Axis& normal, const Task& task) {
  const auto score = [&](const Axis& toward) {
    task.check();
    return shownFrom(scan, upright(toward)) * (toward[2] > 0 ? 1.15 : 1);
  };
  const Axis back = scaled(normal, -1);
  return score(back) > score(normal) ? back : normal;
}

NamedRotation bestFit(const Scan& scan, const Task& task) {
  const PrincipalAxes found = principalAxes(scan, kTrimmedShare, task);
  NamedRotation view{.name = "fit", .rotation = upright(showingSide(scan, found.axes[2], task))};
  if (found.spreads[1] < kCertain * found.spreads[2]) {
    view.note = said<MessageId::view_fit_uncertain>();
  }
  return view;
}

NamedRotation principalView(const Scan& scan, const Task& task) {
  const PrincipalAxes found = principalAxes(scan, 0, task);
  const Axis toward = showingSide(scan, found.axes[2], task);
  // The long axis to the right, and rather as the file has it than upside down.
  const Rotation standing = upright(toward);
  const double along = standing[0] * found.axes[0][0] + standing[1] * found.axes[0][1] +
                       standing[2] * found.axes[0][2];
  NamedRotation view{.name = "axes",
                     .rotation = rotationOf(scaled(found.axes[0], along < 0 ? -1 : 1), toward)};
  if (found.spreads[0] < kCertain * found.spreads[1] ||
      found.spreads[1] < kCertain * found.spreads[2]) {
    view.note = said<MessageId::view_axes_uncertain>();
  }
  return view;
}

NamedRotation untouched(const Scan& scan, const ViewChoice& choice, const Task& task) {
  if (choice.name == "auto") return automaticRotation(scan, task);
  if (choice.name == kEarlierAutomatic) return automaticFace(scan, task);
  if (choice.name == "fit") return bestFit(scan, task);
  if (choice.name == "axes") return principalView(scan, task);
  if (choice.name == "free") {
    if (!choice.rotation) throw failure<MessageId::free_view_without_rotation>();
    return {.name = "free", .rotation = *choice.rotation};
  }
  if (const auto rotation = namedRotation(choice.name)) {
    return {.name = choice.name, .rotation = *rotation};
  }
  throw failure<MessageId::no_such_view>(choice.name);
}

}  // namespace

std::optional<Rotation> standardRotation(std::string_view name) {
  for (const auto& [known, rotation] : kStandardViews) {
    if (known == name) return rotation;
  }
  return std::nullopt;
}

namespace {

// A view turned about the line of sight. {a, b}: view x and y become a x + b y and -b x + a y.
struct Turn {
  std::string_view words;
  double a, b;
};
constexpr std::array<Turn, 4> kTurns{{{"", 1, 0},
                                      {", turned to the left", 0, -1},
                                      {", turned to the right", 0, 1},
                                      {", upside down", -1, 0}}};

Rotation turnedBy(const Rotation& r, const Turn& turn) {
  Rotation result = r;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = turn.a * r[k] + turn.b * r[3 + k] + 0.0;  // No negative zeros.
    result[3 + k] = -turn.b * r[k] + turn.a * r[3 + k] + 0.0;
  }
  return result;
}

}  // namespace

std::optional<Rotation> namedRotation(std::string_view name) {
  for (const auto& [view, rotation] : kStandardViews) {
    if (!name.starts_with(view)) continue;
    for (const Turn& turn : kTurns) {
      if (name.substr(view.size()) == turn.words) return turnedBy(rotation, turn);
    }
  }
  return std::nullopt;
}

std::string nameOf(const Rotation& wanted) {
  for (const auto& [view, rotation] : kStandardViews) {
    for (const Turn& turn : kTurns) {
      if (turnedBy(rotation, turn) == wanted) return std::string(view).append(turn.words);
    }
  }
  return "free";
}

Rotation turned(const Rotation& rotation, const std::array<double, 3>& turn_deg) {
  Rotation result = rotation;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (turn_deg[axis] == 0) continue;  // No rounding where nothing turns.
    const double angle = turn_deg[axis] * std::numbers::pi / 180;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const std::size_t first = 3 * ((axis + 1) % 3);
    const std::size_t second = 3 * ((axis + 2) % 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const double a = result[first + k];
      const double b = result[second + k];
      result[first + k] = c * a - s * b;
      result[second + k] = s * a + c * b;
    }
  }
  return result;
}

namespace {
/// Six digits, as "%g", in every locale.
std::string shortText(double number) {
  constexpr int kDigits = 6;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number,
                                 std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}
}  // namespace

NamedRotation chosenRotation(const Scan& scan, const ViewChoice& choice, const Task& task) {
  const auto& turn = choice.turn_deg;
  if (!std::all_of(turn.begin(), turn.end(), [](double deg) { return std::isfinite(deg); })) {
    throw failure<MessageId::view_turn_not_finite>();
  }
  NamedRotation view = untouched(scan, choice, task);
  if (turn == std::array<double, 3>{}) return view;
  view.rotation = turned(view.rotation, turn);
  view.name += " + " + shortText(turn[0]) + ", " + shortText(turn[1]) + ", " + shortText(turn[2]) +
               " degrees";
  return view;
}

namespace {

constexpr std::size_t kLanes = 8;

/// The box of every eighth point, each of eight times.
struct BoxLanes {
  std::array<std::array<double, kLanes>, 3> min, max;
};

RELIEVO_WIDE_VECTORS
void widen(const std::array<float, 3>* points, std::size_t count, const Rotation& rotation,
           BoxLanes& result) {
  const Rotation r = rotation;
  BoxLanes box = result;
  for (std::size_t i = 0; i + kLanes <= count; i += kLanes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t n = 0; n < kLanes; ++n) {
        const double at = r[3 * axis] * static_cast<double>(points[i + n][0]) +
                          r[3 * axis + 1] * static_cast<double>(points[i + n][1]) +
                          r[3 * axis + 2] * static_cast<double>(points[i + n][2]);
        box.min[axis][n] = at < box.min[axis][n] ? at : box.min[axis][n];
        box.max[axis][n] = at > box.max[axis][n] ? at : box.max[axis][n];
      }
    }
  }
  result = box;
}

}  // namespace

RotatedBounds rotatedBounds(const Scan& scan, const Rotation& rotation, double mm_per_unit) {
  constexpr double kHuge = std::numeric_limits<double>::infinity();
  RotatedBounds box{.min = {kHuge, kHuge, kHuge}, .max = {-kHuge, -kHuge, -kHuge}};
  const auto add = [&box](const ViewMm& low, const ViewMm& high) {
    box.min = {std::min(box.min.x, low.x), std::min(box.min.y, low.y), std::min(box.min.z, low.z)};
    box.max = {std::max(box.max.x, high.x), std::max(box.max.y, high.y),
               std::max(box.max.z, high.z)};
  };
  const std::size_t blocks = scan.points.size() / kLanes;
  const int threads = threadsFor(scan.points.size(), 0);
  std::vector<BoxLanes> lanes(static_cast<std::size_t>(threads));
  parallelFor(threads, threads, [&](int first, int) {
    const auto part = static_cast<std::size_t>(first);
    for (auto& axis : lanes[part].min) axis.fill(kHuge);
    for (auto& axis : lanes[part].max) axis.fill(-kHuge);
    const std::size_t begin = kLanes * (blocks * part / lanes.size());
    const std::size_t end = kLanes * (blocks * (part + 1) / lanes.size());
    widen(scan.points.data() + begin, end - begin, rotation, lanes[part]);
  });
  for (const BoxLanes& some : lanes) {
    for (std::size_t n = 0; n < kLanes; ++n) {
      // Apart: a part without points has its least above its largest.
      add({some.min[0][n], some.min[1][n], some.min[2][n]},
          {some.max[0][n], some.max[1][n], some.max[2][n]});
    }
  }
  for (std::size_t i = kLanes * blocks; i < scan.points.size(); ++i) {
    const ViewMm p = rotate(rotation, localPoint(scan, i));
    add(p, p);
  }
  const ViewMm shift = rotate(rotation, scan.origin);
  box.min = mm_per_unit * (box.min + shift);
  box.max = mm_per_unit * (box.max + shift);
  return box;
}

}  // namespace relievo
