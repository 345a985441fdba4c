// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/feelable.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/failure.h"
#include "core/region/window.h"
#include "core/relief/smooth.h"

namespace relievo {
namespace {

constexpr double kWidthPerSigma = 4;  // A Gaussian bump ends where it is below 14 % of its height.
constexpr double kSigmaOfLevel = 2;   // Samples; the next level has the next width.
// An isolated ridge of standard deviation s stands out most in the band of 0.42 s, where it is 1.45
// times what is just felt there if it is just felt itself (bands a factor 2 apart: within 6 %).
constexpr double kClearestSigma = 0.42;
constexpr double kClearestRatio = 1.45;
constexpr int kSideSamples = 100;     // Of a window that are looked at along each side.
constexpr double kSteep = 1.7320508;  // Tangent of 60 degrees.
constexpr double kMostOverlap = 0.25;

/// Relief of one width over the whole map: what stands out from its neighbourhood, so that a ridge
/// of that width has its own height.
struct Band {
  GridFrame frame;
  double width_mm = 0;
  std::vector<float> height_mm;
};

/// The cell of another grid over the same map nearest to a place.
Cell nearest(const GridFrame& frame, double x_mm, double y_mm) {
  const auto index = [&](double place, double first, int count) {
    return std::clamp(static_cast<int>(std::lround((place - first) / frame.spacing_mm)), 0,
                      count - 1);
  };
  return {index(x_mm, frame.first_x_mm, frame.size.cols),
          index(y_mm, frame.first_y_mm, frame.size.rows)};
}

/// The level as a map: what lies outside at its finest cells is outside.
DepthMap mapOfLevel(const DepthMap& map, const PyramidLevel& level) {
  DepthMap of{level.frame, {level.heights_mm.begin(), level.heights_mm.end()}, {}};
  of.origins.reserve(of.heights_mm.size());
  const GridFrame& f = level.frame;
  for (int row = 0; row < f.size.rows; ++row) {
    for (int col = 0; col < f.size.cols; ++col) {
      of.origins.push_back(map.origin(nearest(map.frame, f.first_x_mm + col * f.spacing_mm,
                                              f.first_y_mm + row * f.spacing_mm)));
    }
  }
  return of;
}

/// Is a sample so many others away from what is not known, along the axes?
class Inside {
 public:
  explicit Inside(const DepthMap& map) : map_(map) {}
  bool by(int samples, Cell at) const {
    const GridSize size = map_.frame.size;
    for (const Cell far : {Cell{at.col - samples, at.row}, Cell{at.col + samples, at.row},
                           Cell{at.col, at.row - samples}, Cell{at.col, at.row + samples}}) {
      if (!size.contains(far) || map_.origin(far) == CellStatus::outside) return false;
    }
    return true;
  }

 private:
  const DepthMap& map_;
};

/// A ridge of standard deviation s keeps s / sqrt(s^2 + t^2) of its height under a Gaussian of t.
Band bandOf(const DepthMap& level, double sigma_samples, const Task& task) {
  const double finer = sigma_samples / 2, coarser = sigma_samples * 2;
  const double kept = 1 / std::sqrt(1.25) - 1 / std::sqrt(5.0);
  const std::vector<float> with = smoothed(level, finer, task);
  const std::vector<float> without = smoothed(level, coarser, task);
  Band band{level.frame, kWidthPerSigma * sigma_samples * level.frame.spacing_mm, with};
  // Near a rim the neighbourhood has one side only, and a slope would look like relief.
  const Inside inside(level);
  const int reach = static_cast<int>(std::ceil(2 * coarser));
  const GridSize size = level.frame.size;
  for (int row = 0; row < size.rows; ++row) {
    for (int col = 0; col < size.cols; ++col) {
      const std::size_t i = size.index({col, row});
      band.height_mm[i] =
          inside.by(reach, {col, row}) ? static_cast<float>((with[i] - without[i]) / kept) : 0.0F;
    }
  }
  return band;
}

/// Finest first. The coarsest level has those that no other level follows, up to half its side.
std::vector<Band> bandsOf(const DepthMap& map, const Pyramid& pyramid, const Task& task) {
  std::vector<Band> bands;
  for (const PyramidLevel& level : pyramid.levels) {
    const DepthMap of = mapOfLevel(map, level);
    const int side = std::max(of.frame.size.cols, of.frame.size.rows);
    double sigma = kSigmaOfLevel;
    do {
      bands.push_back(bandOf(of, sigma, task));
      sigma *= pyramid.factor;
    } while (&level == &pyramid.levels.back() && kWidthPerSigma * sigma <= 0.5 * side);
  }
  return bands;
}

class Feeler {
 public:
  Feeler(const DepthMap& map, const Pyramid& pyramid, const FeelOptions& options, const Task& task)
      : map_(map), pyramid_(pyramid), options_(options), bands_(bandsOf(map, pyramid, task)) {}

  FeelableWindow judge(const Region& region) const {
    FeelableWindow window{.region = region};
    const double scale = handScale(region);
    std::vector<int> best(bands_.size(), 0);
    double sum = 0;
    for (int row = 0; row < kSideSamples; ++row) {
      for (int col = 0; col < kSideSamples; ++col) {
        const double x_mm = region.x_mm + (col + 0.5) / kSideSamples * region.side_mm;
        const double y_mm = region.y_mm + (row + 0.5) / kSideSamples * region.side_mm;
        if (!isMeasured(x_mm, y_mm)) continue;
        ++window.measured_share;
        if (isSteep(region.level, x_mm, y_mm)) {
          ++window.steep_share;
          continue;
        }
        const auto [ratio, band] = clearest(region, scale, x_mm, y_mm);
        sum += ratio / (1 + ratio);
        if (ratio < 1) continue;
        ++window.felt_share;
        ++best[band];
      }
    }
    constexpr double kAll = kSideSamples * kSideSamples;
    window.score = sum / kAll;
    window.measured_share /= kAll;
    window.steep_share /= kAll;
    window.felt_share /= kAll;
    const auto most = std::max_element(best.begin(), best.end());
    if (*most > 0) {
      window.width_mm =
          bands_[static_cast<std::size_t>(most - best.begin())].width_mm / kClearestSigma;
    }
    return window;
  }

 private:
  bool isMeasured(double x_mm, double y_mm) const {
    const bool on_map = x_mm >= map_.leftMm() && x_mm <= map_.leftMm() + map_.widthMm() &&
                        y_mm >= map_.bottomMm() && y_mm <= map_.bottomMm() + map_.heightExtentMm();
    return on_map && map_.origin(nearest(map_.frame, x_mm, y_mm)) == CellStatus::measured;
  }

  /// As handMapping(): smaller where the window is too high for the hand's space.
  double handScale(const Region& region) const {
    const PyramidLevel& level = levelOf(region.level);
    const GridFrame& f = level.frame;
    const Cell from = nearest(f, region.x_mm, region.y_mm);
    const Cell to = nearest(f, region.x_mm + region.side_mm, region.y_mm + region.side_mm);
    float low = level.heights_mm[f.size.index(from)], high = low;
    for (int row = from.row; row <= to.row; ++row) {
      const float* const first = &level.heights_mm[f.size.index({from.col, row})];
      const auto [least, most] = std::minmax_element(first, first + (to.col - from.col) + 1);
      low = std::min(low, *least);
      high = std::max(high, *most);
    }
    const double height = options_.gain * static_cast<double>(high - low);
    const double by_width = kHandWidthMm / region.side_mm;
    return height > 0 ? std::min(by_width, kHandHeightMm / height) : by_width;
  }

  const PyramidLevel& levelOf(Level level) const {
    return pyramid_.levels[static_cast<std::size_t>(level.value)];
  }

  bool isSteep(Level number, double x_mm, double y_mm) const {
    const PyramidLevel& level = levelOf(number);
    const GridFrame& f = level.frame;
    const Cell at = nearest(f, x_mm, y_mm);
    const int left = std::max(0, at.col - 1), right = std::min(f.size.cols - 1, at.col + 1);
    const int below = std::max(0, at.row - 1), above = std::min(f.size.rows - 1, at.row + 1);
    const auto height = [&](int col, int row) {
      return static_cast<double>(level.heights_mm[f.size.index({col, row})]);
    };
    const double dx = (height(right, at.row) - height(left, at.row)) / std::max(1, right - left);
    const double dy = (height(at.col, above) - height(at.col, below)) / std::max(1, above - below);
    return options_.gain * std::hypot(dx, dy) / f.spacing_mm > kSteep;
  }

  struct Clearest {
    double ratio = 0;  ///< How many times what is just felt.
    std::size_t band = 0;
  };
  Clearest clearest(const Region& region, double scale, double x_mm, double y_mm) const {
    Clearest found;
    const double finest_mm = levelOf(region.level).frame.spacing_mm;
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      const Band& band = bands_[b];
      // What is finer than the window's level is not in it; what is wider than it is its slope.
      if (band.frame.spacing_mm < 0.999 * finest_mm || band.width_mm > region.side_mm) continue;
      const float height = band.height_mm[band.frame.size.index(nearest(band.frame, x_mm, y_mm))];
      const double least =
          kClearestRatio * options_.grip_factor * justFeltMm(band.width_mm * scale);
      const double ratio = std::abs(static_cast<double>(height)) * options_.gain * scale / least;
      if (ratio > found.ratio) found = {ratio, b};
    }
    return found;
  }

  const DepthMap& map_;
  const Pyramid& pyramid_;
  const FeelOptions& options_;
  std::vector<Band> bands_;
};

/// Squares of 200 samples of a level, a quarter of their side apart, the last ones at the border.
std::vector<Region> candidates(const DetailLadder& ladder, Level level) {
  const Region whole = wholeRegion(ladder);
  const double side = ladder.sideMm(ladder.detailOf(level));
  if (level.value + 1 >= ladder.levels() || side >= whole.side_mm) return {};
  const auto places = [side](double from, double length) {
    if (side >= length) return std::vector<double>{from + 0.5 * (length - side)};
    const int steps = static_cast<int>(std::ceil(4 * (length - side) / side));
    std::vector<double> at{from};
    for (int i = 1; i <= steps; ++i) at.push_back(from + (length - side) * i / steps);
    return at;
  };
  std::vector<Region> regions;
  for (const double y : places(ladder.bottom_mm, ladder.height_mm)) {
    for (const double x : places(ladder.left_mm, ladder.width_mm)) {
      regions.push_back({x, y, side, level});
    }
  }
  return regions;
}

bool overlapTooMuch(const Region& a, const Region& b) {
  if (a.level != b.level) return false;
  const double wide = a.side_mm - std::abs(a.x_mm - b.x_mm);
  const double high = a.side_mm - std::abs(a.y_mm - b.y_mm);
  return wide > 0 && high > 0 && wide * high > kMostOverlap * a.side_mm * a.side_mm;
}

}  // namespace

double justFeltMm(double width_mm) {
  const auto law = [](double width) { return 8 * std::pow(width / 240, 1.3); };
  return width_mm < 1 ? law(1) * width_mm : law(width_mm);
}

std::vector<FeelableWindow> feelableWindows(const DepthMap& map, const Pyramid& pyramid,
                                            const FeelOptions& options, const Task& task) {
  const bool usable = std::isfinite(options.gain) && options.gain > 0 &&
                      std::isfinite(options.grip_factor) && options.grip_factor > 0 &&
                      options.most > 0;
  if (!usable) throw failure<MessageId::feel_options_not_positive>();
  const Feeler feeler(map, pyramid, options, task);
  const DetailLadder ladder = detailLadder(map, pyramid);
  std::vector<FeelableWindow> judged{feeler.judge(wholeRegion(ladder))};
  for (int level = ladder.levels() - 2; level >= 0; --level) {
    for (const Region& region : candidates(ladder, Level{level})) {
      task.check();
      judged.push_back(feeler.judge(region));
    }
  }
  std::stable_sort(judged.begin(), judged.end(),
                   [](const auto& a, const auto& b) { return a.score > b.score; });
  std::vector<FeelableWindow> best;
  for (const FeelableWindow& window : judged) {
    if (best.size() >= static_cast<std::size_t>(options.most) || !(window.felt_share > 0)) break;
    const bool known = std::any_of(best.begin(), best.end(), [&](const FeelableWindow& other) {
      return overlapTooMuch(window.region, other.region);
    });
    if (!known) best.push_back(window);
  }
  return best;
}

}  // namespace relievo
