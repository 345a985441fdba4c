// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/dhd/models.h"

#include <algorithm>
#include <cmath>

namespace relievo::dhd {

namespace {
constexpr double kMostForceN = 6;
constexpr Three kOmegaBox{50, 40, 35}, kDeltaBox{100, 80, 70}, kLambdaBox{75, 60, 55};

constexpr std::array<Model, 14> kModels{{
    {33, kMostForceN, 2.5, kOmegaBox},    // omega.3
    {34, kMostForceN, 2.5, kOmegaBox},    // omega.6, right
    {36, kMostForceN, 2.5, kOmegaBox},    // omega.6, left
    {35, kMostForceN, 2.5, kOmegaBox},    // omega.7, right
    {37, kMostForceN, 2.5, kOmegaBox},    // omega.7, left
    {63, kMostForceN, 2.5, kDeltaBox},    // delta.3
    {206, kMostForceN, 2.0, kOmegaBox},   // sigma.3
    {104, kMostForceN, 2.0, kOmegaBox},   // sigma.7, right
    {105, kMostForceN, 2.0, kOmegaBox},   // sigma.7, left
    {203, kMostForceN, 4.0, kLambdaBox},  // lambda.3
    {131, kMostForceN, 4.0, kLambdaBox},  // lambda.6, right
    {132, kMostForceN, 4.0, kLambdaBox},  // lambda.6, left
    {108, kMostForceN, 4.0, kLambdaBox},  // lambda.7, right
    {109, kMostForceN, 4.0, kLambdaBox},  // lambda.7, left
}};
constexpr int kFalcon = 60;
constexpr std::array<int, 3> kControllers{81, 82, 91};
}  // namespace

const Model* modelOf(int type) noexcept {
  const auto* const found = std::find_if(kModels.begin(), kModels.end(),
                                         [type](const Model& m) { return m.type == type; });
  return found == kModels.end() ? nullptr : found;
}

const char* whyNot(int type) noexcept {
  if (type == kFalcon) return "it is a Novint Falcon; choose it as falcon";
  const bool bare = std::find(kControllers.begin(), kControllers.end(), type) != kControllers.end();
  return bare ? "it is a controller, and which arm hangs on it is not known"
              : "its type is not known";
}

Three placeMm(const Three& place_m) RELIEVO_REALTIME {
  constexpr double kMmPerM = 1000;
  return {kMmPerM * place_m[1], kMmPerM * place_m[2], kMmPerM * place_m[0]};
}

Three withinSight(const Three& place_mm, const Three& half_extent_mm) RELIEVO_REALTIME {
  constexpr double kBelieved = 1.95, kNoArmMm = 400;
  Three seen = place_mm;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double most_mm = kBelieved * half_extent_mm[i];
    if (std::abs(seen[i]) < kNoArmMm) seen[i] = std::clamp(seen[i], -most_mm, most_mm);
  }
  return seen;
}

Three forceForLibrary(const Three& force_n) RELIEVO_REALTIME {
  return {force_n[2], force_n[0], force_n[1]};
}

std::uint32_t buttonsOf(unsigned int mask) RELIEVO_REALTIME {
  constexpr std::array<unsigned int, 4> kPlaces{2, 0, 3, 1};
  std::uint32_t buttons = 0;
  for (unsigned int i = 0; i < kPlaces.size(); ++i) buttons |= (mask >> i & 1U) << kPlaces[i];
  return buttons;
}

}  // namespace relievo::dhd
