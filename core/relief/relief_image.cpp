// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/relief_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "core/base/bands.h"
#include "core/base/failure.h"
#include "core/relief/horizon.h"
#include "core/relief/neighbourhood.h"
#include "core/relief/smooth.h"

namespace relievo {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr double kDegree = std::numbers::pi / 180;
constexpr double kFirstRadiusSamples = 10;
constexpr double kMostRadiusSamples = 400;
constexpr double kLeastLevelShade = 0.25;  // Level ground under a lamp near the horizon.
constexpr Rgb8 kStone{204, 200, 193};      // Where a scan has no colour of its own.

struct Gradient {
  double dx = 0, dy = 0;  ///< Height per length, without unit.
};

/// Central differences; at the rim of object and grid one-sided.
class Slopes {
 public:
  explicit Slopes(const DepthMap& map) : map_(map), size_(map.frame.size) {}

  bool inside(int col, int row) const {
    return size_.contains({col, row}) && map_.origin({col, row}) != CellStatus::outside;
  }
  Gradient at(int col, int row) const { return {along(col, row, 1, 0), along(col, row, 0, 1)}; }

 private:
  double along(int col, int row, int dc, int dr) const {
    const bool before = inside(col - dc, row - dr);
    const bool after = inside(col + dc, row + dr);
    if (!before && !after) return 0;
    const auto height = [&](int steps) {
      return static_cast<double>(map_.heightMm({col + steps * dc, row + steps * dr}));
    };
    const double rise = height(after ? 1 : 0) - height(before ? -1 : 0);
    return rise / (map_.frame.spacing_mm * ((after ? 1 : 0) + (before ? 1 : 0)));
  }

  const DepthMap& map_;
  GridSize size_;
};

/// Cosine of the angle between the surface and a light, not below 0 (Horn 1981, eq. 12).
double shade(const Gradient& g, double azimuth_deg, double elevation_deg) {
  const double a = azimuth_deg * kDegree;
  const double e = elevation_deg * kDegree;
  const double along = -g.dx * std::sin(a) * std::cos(e) - g.dy * std::cos(a) * std::cos(e);
  return std::max(0.0, (along + std::sin(e)) / std::sqrt(1 + g.dx * g.dx + g.dy * g.dy));
}

/// Lights from 225, 270, 315 and 360 degrees, each weighted by sin^2(aspect - azimuth): slopes that
/// a light meets along their contour lines show best (Mark 1992). Level ground has no aspect; all
/// four count alike.
double multiShade(const Gradient& g, double elevation_deg) {
  constexpr std::array<double, 4> kAzimuths{225, 270, 315, 360};
  const double steepness = std::hypot(g.dx, g.dy);
  double sum = 0;
  double weights = 0;
  for (const double azimuth : kAzimuths) {
    double weight = 1;
    if (steepness > 1e-12) {
      // Aspect: where the slope faces, clockwise from up.
      const double aspect = std::atan2(-g.dx, -g.dy);
      const double s = std::sin(aspect - azimuth * kDegree);
      weight = s * s;
    }
    sum += weight * shade(g, azimuth, elevation_deg);
    weights += weight;
  }
  return sum / weights;
}

template <class ValueOf>
std::vector<float> forEachInside(const DepthMap& map, const Task& task, const ValueOf& value_of) {
  const GridSize size = map.frame.size;
  std::vector<float> values(size.count(), kNan);
  parallelFor(size.rows, threadsFor(size.count(), 0), [&](int first, int end) {
    for (int row = first; row < end; ++row) {
      task.check();
      for (int col = 0; col < size.cols; ++col) {
        const std::size_t i = size.index({col, row});
        if (map.origins[i] == CellStatus::outside) continue;
        values[i] = static_cast<float>(value_of(col, row));
      }
    }
  });
  return values;
}

/// The middle 98 % of the values: a few outliers must not grey out a picture.
std::array<double, 2> rangeOf(const std::vector<float>& values) {
  std::vector<float> sorted;
  const std::size_t stride = std::max<std::size_t>(1, values.size() / 200000);
  for (std::size_t i = 0; i < values.size(); i += stride) {
    if (std::isfinite(values[i])) sorted.push_back(values[i]);
  }
  if (sorted.empty()) return {0, 1};
  const auto quantile = [&](double q) {
    const auto at =
        sorted.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return static_cast<double>(*at);
  };
  const double low = quantile(0.01);
  const double high = quantile(0.99);
  return {low, high > low ? high : low + 1};
}

double radiusSamples(const DepthMap& map, const ReliefLook& look) {
  if (look.radius_mm == 0) return kFirstRadiusSamples;
  return std::clamp(look.radius_mm / map.frame.spacing_mm, 1.0, kMostRadiusSamples);
}

std::vector<float> compute(const DepthMap& map, const ReliefLook& look, const Task& task) {
  const Slopes slopes(map);
  switch (look.kind) {
    case ReliefKind::lit:
    case ReliefKind::height:
      return forEachInside(map, task, [&](int c, int r) {
        return static_cast<double>(map.heightMm({.col = c, .row = r}));
      });
    case ReliefKind::hillshade:
      return forEachInside(map, task, [&](int c, int r) {
        return shade(slopes.at(c, r), look.light.azimuth_deg, look.light.elevation_deg);
      });
    case ReliefKind::multi_hillshade:
      return forEachInside(map, task, [&](int c, int r) {
        return multiShade(slopes.at(c, r), look.light.elevation_deg);
      });
    case ReliefKind::slope:
      return forEachInside(map, task, [&](int c, int r) {
        const Gradient g = slopes.at(c, r);
        return std::atan(std::hypot(g.dx, g.dy)) / kDegree;
      });
    case ReliefKind::local_relief: {
      // A radius of two standard deviations holds what the eye takes for the neighbourhood.
      const std::vector<float> smooth = smoothed(map, 0.5 * radiusSamples(map, look), task);
      return forEachInside(map, task, [&](int c, int r) {
        const std::size_t i = map.frame.size.index({.col = c, .row = r});
        return static_cast<double>(map.heights_mm[i]) - static_cast<double>(smooth[i]);
      });
    }
    case ReliefKind::multi_scale:
      return largestDeviations(map, radiusSamples(map, look), task);
    case ReliefKind::curvature: {
      const BallShares balls(map, radiusSamples(map, look));
      return forEachInside(map, task, [&](int c, int r) { return balls.bulge({c, r}); });
    }
    case ReliefKind::occlusion:
    case ReliefKind::sky_view: {
      const HorizonSearch search(map, radiusSamples(map, look));
      return forEachInside(map, task, [&](int c, int r) { return search.skyView({c, r}); });
    }
    case ReliefKind::openness: {
      const HorizonSearch search(map, radiusSamples(map, look));
      return forEachInside(map, task, [&](int c, int r) { return search.openness({c, r}); });
    }
    case ReliefKind::natural:
    case ReliefKind::intensity: {
      // Of level ground 1: there the scan's own colours stay as they are.
      const double level = std::max(std::sin(look.light.elevation_deg * kDegree), kLeastLevelShade);
      return forEachInside(map, task, [&](int c, int r) {
        return shade(slopes.at(c, r), look.light.azimuth_deg, look.light.elevation_deg) / level;
      });
    }
  }
  return {};
}

}  // namespace

bool hasRadius(ReliefKind kind) {
  return kind == ReliefKind::local_relief || kind == ReliefKind::sky_view ||
         kind == ReliefKind::openness || kind == ReliefKind::multi_scale ||
         kind == ReliefKind::curvature || kind == ReliefKind::occlusion;
}

double radiusMm(const ReliefLook& look, double spacing_mm) {
  return look.radius_mm > 0 ? look.radius_mm : kFirstRadiusSamples * spacing_mm;
}

bool isLit(ReliefKind kind) {
  return kind == ReliefKind::lit || kind == ReliefKind::height || kind == ReliefKind::occlusion;
}

bool showsOwnColours(ReliefKind kind) {
  return kind == ReliefKind::natural || kind == ReliefKind::intensity;
}

bool hasLegend(ReliefKind kind) {
  return kind != ReliefKind::lit && kind != ReliefKind::hillshade &&
         kind != ReliefKind::multi_hillshade && kind != ReliefKind::occlusion &&
         !showsOwnColours(kind);
}

bool hasKeyLight(const ReliefLook& look) {
  return isLit(look.kind) || look.kind == ReliefKind::hillshade ||
         (showsOwnColours(look.kind) && look.shading > 0);
}

ColourMap coloursOf(const ReliefLook& look) {
  return hasLegend(look.kind) ? look.colours : ColourMap::grey;
}

void checkShading(const ReliefLook& look) {
  if (look.shading >= 0 && look.shading <= 1) return;
  throw failure<MessageId::shading_out_of_range>();
}

std::pair<double, double> roundEnds(double low, double high) {
  const double most = (high - low) / 10;
  const double decade = std::pow(10, std::floor(std::log10(most)));
  double step = decade;
  for (const double factor : {2.0, 5.0}) {
    if (factor * decade <= most) step = factor * decade;
  }
  return {step * std::floor(low / step + 1e-9), step * std::ceil(high / step - 1e-9)};
}

void checkRange(const ReliefLook& look) {
  if (!look.range || (*look.range)[1] > (*look.range)[0]) return;
  throw failure<MessageId::colour_range_reversed>();
}

ReliefValues reliefValues(const DepthMap& map, const ReliefLook& look, const Task& task) {
  const bool light = std::isfinite(look.light.azimuth_deg) && look.light.elevation_deg >= 0 &&
                     look.light.elevation_deg <= 90;
  if (!light) throw failure<MessageId::light_without_direction>();
  if (!(look.radius_mm >= 0) || !std::isfinite(look.radius_mm)) {
    throw failure<MessageId::relief_radius_negative>();
  }
  checkRange(look);
  checkShading(look);
  ReliefValues made;
  made.values = compute(map, look, task);
  struct Kind {
    std::string_view title, unit;
  };
  constexpr std::array<Kind, 13> kKinds{{{"height", "mm"},
                                         {"height", "mm"},
                                         {"hillshade", ""},
                                         {"hillshade, four lights", ""},
                                         {"slope", "\u00b0"},
                                         {"local relief", "mm"},
                                         {"sky-view factor", ""},
                                         {"openness", "\u00b0"},
                                         {"multi-scale deviation", ""},
                                         {"multi-scale curvature", ""},
                                         {"ambient occlusion", ""},
                                         {"natural colours", ""},
                                         {"intensity", ""}}};
  const Kind& kind = kKinds[static_cast<std::size_t>(look.kind)];
  made.title = kind.title;
  made.unit = kind.unit;
  std::array<double, 2> range{0, 1};
  if (look.kind == ReliefKind::lit || hasLegend(look.kind)) {
    range = look.range.value_or(rangeOf(made.values));
  }
  made.low = range[0];
  made.high = range[1];
  return made;
}

namespace {

/// The scan's own colours under the key light, as far as the look wants it.
std::vector<std::uint8_t> shadedColours(const ReliefValues& values, const ReliefLook& look,
                                        const GridColours& own) {
  const std::size_t count = values.values.size();
  const bool natural = look.kind == ReliefKind::natural;
  if ((natural ? own.colours.size() : own.intensities.size()) != count) {
    if (natural) throw failure<MessageId::no_own_colours>();
    throw failure<MessageId::no_own_intensities>();
  }
  const auto shading = static_cast<float>(look.shading);
  std::vector<std::uint8_t> colours;
  colours.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    Rgb8 colour = kStone;
    if (natural) {
      const Rgba& c = own.colours[i];
      if (c[3] != 0) colour = {c[0], c[1], c[2]};
    } else if (own.intensities[i][1] != 0) {
      colour.fill(own.intensities[i][0]);
    }
    const float shade = values.values[i];
    const float factor = std::isfinite(shade) ? 1 - shading + shading * shade : 1;
    for (const std::uint8_t channel : colour) {
      const float lit = std::min(factor * static_cast<float>(channel) + 0.5F, 255.0F);
      colours.push_back(static_cast<std::uint8_t>(lit));
    }
  }
  return colours;
}

/// Stone that lamps will light, as dark as little of the sky is seen.
std::vector<std::uint8_t> occludedStone(const ReliefValues& values) {
  std::vector<std::uint8_t> colours;
  colours.reserve(3 * values.values.size());
  for (const float sky : values.values) {
    for (const std::uint8_t channel : kStone) {
      const float seen = std::isfinite(sky) ? sky * static_cast<float>(channel) : channel;
      colours.push_back(static_cast<std::uint8_t>(seen + 0.5F));
    }
  }
  return colours;
}

}  // namespace

std::vector<std::uint8_t> reliefColours(const ReliefValues& values, const ReliefLook& look,
                                        const GridColours& own) {
  if (look.kind == ReliefKind::lit) return {};
  if (look.kind == ReliefKind::occlusion) return occludedStone(values);
  if (showsOwnColours(look.kind)) return shadedColours(values, look, own);
  constexpr int kSteps = 1024;
  std::array<Rgb8, kSteps> table{};
  for (int i = 0; i < kSteps; ++i) {
    table[static_cast<std::size_t>(i)] = colourOf(coloursOf(look), i / (kSteps - 1.0));
  }
  std::vector<std::uint8_t> colours;
  colours.reserve(3 * values.values.size());
  const double per_value = (kSteps - 1) / (values.high - values.low);
  for (const float value : values.values) {
    Rgb8 colour{128, 128, 128};
    if (std::isfinite(value)) {
      const double t = (static_cast<double>(value) - values.low) * per_value;
      colour = table[static_cast<std::size_t>(std::clamp(t + 0.5, 0.0, kSteps - 1.0))];
    }
    colours.insert(colours.end(), colour.begin(), colour.end());
  }
  return colours;
}

}  // namespace relievo
