// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "data/generate/sample.h"

/// A ruin site of 400 x 400 m in coordinates like those of a UTM zone (no real place): a walled
/// precinct with gates and stairs, a tiered temple, broken columns, a stepped tank, houses, and a
/// paved court whose joints are centimetres wide. Taken by an aerial scan from one side, by three
/// stations on the ground and by one close scan of the court. Metres, z up.
namespace relievo::samples {

inline constexpr double kRuinEastM = 656'800;     ///< Of the south-west corner.
inline constexpr double kRuinNorthM = 1'695'300;  ///< Of the south-west corner.
inline constexpr double kRuinSideM = 400;
inline constexpr double kRuinReferenceSpacingM = 0.25;

/// Standard deviations along z of the three kinds of scan.
inline constexpr double kRuinAerialNoiseM = 0.02;
inline constexpr double kRuinStationNoiseM = 0.004;
inline constexpr double kRuinCourtNoiseM = 0.001;

/// Points of the three kinds of scan; they stand in the cloud in this order.
inline constexpr std::size_t kRuinAerialPoints = 420'000;
inline constexpr std::size_t kRuinStationPoints = 300'000;
inline constexpr std::size_t kRuinCourtPoints = 240'000;

/// The part of the court that was scanned closely: metres from the south-west corner.
inline constexpr double kRuinCourtEastM = 246;
inline constexpr double kRuinCourtNorthM = 197;
inline constexpr double kRuinCourtSideM = 6;
inline constexpr double kRuinCourtReferenceSpacingM = 0.01;

/// True height at file coordinates; NaN off the site.
double ruinHeightM(double east_m, double north_m);

Cloud makeRuin();
Reference ruinReference();       ///< The whole site.
Reference ruinCourtReference();  ///< The closely scanned part of the court.

}  // namespace relievo::samples
