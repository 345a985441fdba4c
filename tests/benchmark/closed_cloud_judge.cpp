// SPDX-License-Identifier: BSD-3-Clause
#include "tests/benchmark/closed_cloud_judge.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "core/depth/rules/rasterize.h"

namespace relievo::benchmark {
namespace {

std::size_t number(const char* variable, std::size_t otherwise) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::strtoul(text, nullptr, 10) : otherwise;
}

bool isWithinBars(const Found& found) {
  return found.pits <= 0.1 && found.lost <= 0.5 && found.fine_pits <= 0.1 &&
         found.fine_lost <= 0.5 && found.rms <= 0.6;
}

void print(const std::string& name, const Sampling& how, const char* view, const Surface& surface,
           const Found& found, double seconds) {
  std::printf(
      "%c %-20.20s %7zu noise %.3f uneven %2.0f strays %.2f %-6s %4dx%-4d pits %6.3f bumps "
      "%6.3f lost %6.3f fine pits %6.3f lost %6.3f beyond %5.2f rms %.3f median %.3f "
      "measured %3.0f %% hidden %2.0f %% %.2f s  "
      "%s\n",
      isWithinBars(found) ? ' ' : '!', name.c_str(), how.points, how.noise, how.unevenness,
      how.strays, view, surface.map.frame.size.cols, surface.map.frame.size.rows, found.pits,
      found.bumps, found.lost, found.fine_pits, found.fine_lost, found.beyond, found.rms,
      found.median, found.measured, 100 * surface.losses->hidden_share, seconds,
      surface.rule.c_str());
  std::fflush(stdout);
}

}  // namespace

std::vector<Sampling> samplings() {
  const std::size_t least = number("CLOSED_CLOUDS_LEAST", 0);
  const std::size_t most = number("CLOSED_CLOUDS_MOST", 1'000'000);
  std::vector<Sampling> all;
  for (const std::size_t points : {20'000UL, 100'000UL, 1'000'000UL}) {
    if (points < least || points > most) continue;
    for (const double noise : {0.0, 0.001}) {
      for (const double unevenness : {1.0, 10.0}) {
        for (const double strays : {0.0, 0.01}) {
          all.push_back(
              {.points = points, .noise = noise, .unevenness = unevenness, .strays = strays});
        }
      }
    }
  }
  return all;
}

std::vector<const char*> views() {
  const char* const only = std::getenv("CLOSED_CLOUDS_VIEW");
  std::vector<const char*> list;
  for (const char* view : {"front", "back", "left", "right", "top", "bottom"}) {
    if (only == nullptr || std::string(only) == view) list.push_back(view);
  }
  return list;
}

Found compared(const Surface& surface, const std::vector<float>& truth) {
  const GridFrame& frame = surface.map.frame;
  const double size = frame.spacing_mm * std::max(frame.size.cols, frame.size.rows);
  Found found;
  double cells = 0;
  double squares = 0;
  double measured = 0;
  std::vector<double> errors;
  for (int row = 0; row < frame.size.rows; ++row) {
    for (int col = 0; col < frame.size.cols; ++col) {
      const std::size_t i = frame.size.index({.col = col, .row = row});
      const CellStatus origin = surface.map.origins[i];
      const bool is_there = origin != CellStatus::outside && origin != CellStatus::base_plane;
      found.beyond += is_there && std::isnan(truth[i]) ? 1 : 0;
      float low = 1e30F;
      float high = -1e30F;
      bool inside = true;
      for (int r = row - 2; r <= row + 2; ++r) {
        for (int c = col - 2; c <= col + 2; ++c) {
          const Cell near{.col = c, .row = r};
          const float z = frame.size.contains(near) ? truth[frame.size.index(near)] : NAN;
          inside = inside && z == z;
          low = std::min(low, z);
          high = std::max(high, z);
        }
      }
      if (!inside) continue;
      ++cells;
      measured += origin == CellStatus::measured || origin == CellStatus::steep ? 1 : 0;
      found.lost += is_there ? 0 : 1;
      if (!is_there) continue;
      const double height = surface.map.heights_mm[i];
      if (height < low - 0.03 * size) {
        found.pits += 1;
        if (std::getenv("CLOSED_CLOUDS_PITS") != nullptr) {
          std::printf("  pit at %d %d: %.2f, mesh %.2f (%.2f to %.2f), origin %d\n", col, row,
                      height, static_cast<double>(truth[i]), static_cast<double>(low),
                      static_cast<double>(high), static_cast<int>(origin));
        }
        continue;
      }
      if (height > high + 0.03 * size) {
        found.bumps += 1;
        continue;
      }
      if (high - low > 8 * frame.spacing_mm) continue;
      const double error = height - static_cast<double>(truth[i]);
      squares += error * error;
      errors.push_back(std::abs(error));
    }
  }
  if (cells == 0 || errors.empty()) return found;
  found.pits *= 100 / cells;
  found.lost *= 100 / cells;
  found.bumps *= 100 / cells;
  found.beyond *= 100 / cells;
  found.measured = 100 * measured / cells;
  found.rms = std::sqrt(squares / static_cast<double>(errors.size())) / frame.spacing_mm;
  std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                   errors.end());
  found.median = errors[errors.size() / 2] / frame.spacing_mm;
  return found;
}

void Judgement::judge(const std::string& name, const CloudOf& cloud_of, const Judge& judge) {
  for (const Sampling& how : samplings()) {
    const Scan cloud = cloud_of(how);
    for (const char* view : views()) {
      SurfaceOptions options;
      options.unit = LengthUnit::mm;
      options.view = ViewChoice{.name = view, .rotation = {}};
      const auto start = std::chrono::steady_clock::now();
      const Surface surface = makeSurface(cloud, options, rasterize);
      const double seconds =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      const Found found = judge(surface, options);
      ++tried_;
      missed_ += isWithinBars(found) ? 0 : 1;
      print(name, how, view, surface, found, seconds);
    }
  }
}

int Judgement::end() const {
  std::printf("%d of %d clouds miss a bar\n", missed_, tried_);
  return missed_ == 0 ? 0 : 1;
}

}  // namespace relievo::benchmark
