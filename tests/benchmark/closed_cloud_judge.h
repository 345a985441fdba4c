// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "core/session/surface.h"

namespace relievo::benchmark {

/// How a cloud is drawn from a surface.
struct Sampling {
  std::size_t points = 0;
  double noise = 0;       // Of the object's size.
  double unevenness = 1;  // Density at one end over that at the other, along the file's x.
  double strays = 0;      // Share of the points, anywhere in the box.
};

/// All of 20 000, 100 000 and 1 000 000 points with and without noise, unevenness and strays that
/// CLOSED_CLOUDS_LEAST and CLOSED_CLOUDS_MOST let through.
std::vector<Sampling> samplings();

/// The six sides, or the one that CLOSED_CLOUDS_VIEW names.
std::vector<const char*> views();

struct Found {
  double pits = 0, bumps = 0, lost = 0, beyond = 0, rms = 0, median = 0, measured = 0;
  // Against the object on 600 samples across, whatever the cloud's own grid.
  double fine_pits = 0, fine_lost = 0;
};

/// @param truth  heights of the object at the samples of the map, mm; NaN: nothing is there
Found compared(const Surface& surface, const std::vector<float>& truth);

/// Clouds of objects, one line each as it is judged. Bars: pits 0.1 %, lost cells 0.5 %, rms 0.6 of
/// the spacing away from silhouettes.
class Judgement {
 public:
  using CloudOf = std::function<Scan(const Sampling&)>;
  /// @param options  the surface was made with
  using Judge = std::function<Found(const Surface& surface, const SurfaceOptions& options)>;

  /// Every sampling of an object, seen from every side.
  void judge(const std::string& name, const CloudOf& cloud_of, const Judge& judge);

  /// Says how many missed a bar. @return  the program's exit status
  int end() const;

 private:
  int missed_ = 0, tried_ = 0;
};

}  // namespace relievo::benchmark
