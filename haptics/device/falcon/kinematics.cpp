// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/falcon/kinematics.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relievo::falcon {

namespace {
// Lengths in mm, in Stamper's letters.
constexpr double kA = 60;          // Thigh, from the motor's axis to the knee.
constexpr double kB = 102.5;       // Long side of the parallelogram.
constexpr double kC = 14.43;       // Shin's attachment to the platform, radially ...
constexpr double kF = -25;         // ... and tangentially.
constexpr double kDE = 2 * 11.25;  // End joints of the parallelogram, d + e.
constexpr double kR = 40;          // Motor's axis from the centre of the base, radially ...
constexpr double kS = -23.09;      // ... and tangentially.

constexpr double kRadian = std::numbers::pi / 180;
constexpr double kThetaAtZero = 35 * kRadian;
// 320 slots, four edges each; capstan of 14.25 mm on a sector of 110 mm.
constexpr double kRadPerCount = 2 * std::numbers::pi / (4 * 320) * 14.25 / 110;

struct Azimuth {
  double cosine, sine;
};
Azimuth azimuth(std::size_t arm) RELIEVO_REALTIME {
  // 105, -15 and -135 degrees.
  static constexpr double kSmall = 0.25881904510252076, kLarge = 0.9659258262890683;
  static constexpr std::array<Azimuth, kArms> kAzimuths{
      {{-kSmall, kLarge}, {kLarge, -kSmall}, {-std::numbers::sqrt2 / 2, -std::numbers::sqrt2 / 2}}};
  return kAzimuths[arm];
}

using Vec = std::array<double, 3>;
using Matrix = std::array<Vec, 3>;

double det(const Matrix& m) RELIEVO_REALTIME {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

double length(const Vec& row) RELIEVO_REALTIME {
  return std::sqrt(row[0] * row[0] + row[1] * row[1] + row[2] * row[2]);
}

/// Solves M x = b by Cramer's rule. Nothing: the rows span less than a thousandth of the volume
/// that rows of their length could.
std::optional<Vec> solve(const Matrix& m, const Vec& b) RELIEVO_REALTIME {
  const double determinant = det(m);
  const double largest = length(m[0]) * length(m[1]) * length(m[2]);
  constexpr double kLeastVolume = 1e-3;
  if (!(std::abs(determinant) > kLeastVolume * largest)) return std::nullopt;
  Vec x{};
  for (std::size_t column = 0; column < 3; ++column) {
    Matrix replaced = m;
    for (std::size_t row = 0; row < 3; ++row) replaced[row][column] = b[row];
    x[column] = det(replaced) / determinant;
  }
  return x;
}

/// One arm's closure g(p, theta) = k^2 + V^2 - b^2 = 0 and its derivatives.
struct Closure {
  double g = 0;         // mm^2
  Vec by_p{};           // mm
  double by_theta = 0;  // mm^2 / rad
};

Closure closure(std::size_t arm, BaseMm p, double theta) RELIEVO_REALTIME {
  const auto [cosine, sine] = azimuth(arm);
  // The arm's own axes: u outward, v around, w out of the device.
  const double u = p.x * cosine + p.y * sine - kR + kC - kA * std::cos(theta);
  const double v = -p.x * sine + p.y * cosine - kS + kF;
  const double w = p.z - kA * std::sin(theta);
  const double h = std::hypot(u, w);
  const double k = h - kDE;
  const double gu = 2 * k * u / h, gv = 2 * v, gw = 2 * k * w / h;
  return {k * k + v * v - kB * kB,
          {gu * cosine - gv * sine, gu * sine + gv * cosine, gw},
          2 * k * kA * (u * std::sin(theta) - w * std::cos(theta)) / h};
}
}  // namespace

Angles anglesFromEncoders(const std::array<std::int16_t, kArms>& encoders) RELIEVO_REALTIME {
  Angles angles{};
  for (std::size_t i = 0; i < kArms; ++i) angles[i] = kThetaAtZero + kRadPerCount * encoders[i];
  return angles;
}

std::array<double, kArms> encodersFromAngles(const Angles& angles) RELIEVO_REALTIME {
  std::array<double, kArms> encoders{};
  for (std::size_t i = 0; i < kArms; ++i) encoders[i] = (angles[i] - kThetaAtZero) / kRadPerCount;
  return encoders;
}

std::optional<BaseMm> gripFromAngles(const Angles& angles) RELIEVO_REALTIME {
  BaseMm p = kCentre;
  constexpr int kMostSteps = 12;
  constexpr double kSmallStepMm = 1e-9;
  for (int step = 0; step < kMostSteps; ++step) {
    Matrix gradient{};
    Vec minus_g{};
    for (std::size_t arm = 0; arm < kArms; ++arm) {
      const Closure c = closure(arm, p, angles[arm]);
      gradient[arm] = c.by_p;
      minus_g[arm] = -c.g;
    }
    const std::optional<Vec> move = solve(gradient, minus_g);
    if (!move) return std::nullopt;
    p = p + BaseMm{(*move)[0], (*move)[1], (*move)[2]};
    if (!isFinite(p)) return std::nullopt;
    if (length(*move) < kSmallStepMm) return p;
  }
  return std::nullopt;
}

std::optional<Angles> anglesFromGrip(BaseMm grip) RELIEVO_REALTIME {
  Angles angles{};
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    const auto [cosine, sine] = azimuth(arm);
    const double u = grip.x * cosine + grip.y * sine - kR;
    const double v = -grip.x * sine + grip.y * cosine - kS;
    const double w = grip.z;
    const double cos_theta3 = (v + kF) / kB;
    if (!(std::abs(cos_theta3) <= 1)) return std::nullopt;
    const double m = kDE + kB * std::sqrt(1 - cos_theta3 * cos_theta3);
    // Tangent half-angle form: D t^2 + B t + A = 0 with t = tan(theta / 2).
    const double common = w * w + u * u + kA * kA + kC * kC - m * m + 2 * kC * u;
    const double a = common - 2 * kA * u - 2 * kA * kC;
    const double b = -4 * kA * w;
    const double d = common + 2 * kA * u + 2 * kA * kC;
    const double root = b * b - 4 * a * d;
    if (!(root >= 0) || d == 0) return std::nullopt;
    angles[arm] = 2 * std::atan((-b - std::sqrt(root)) / (2 * d));
  }
  return angles;
}

std::optional<AngleJacobian> angleJacobian(BaseMm grip, const Angles& angles) RELIEVO_REALTIME {
  AngleJacobian jacobian{};
  for (std::size_t arm = 0; arm < kArms; ++arm) {
    const Closure c = closure(arm, grip, angles[arm]);
    // Implicit function: d theta / d p = -(dg/dp) / (dg/d theta).
    constexpr double kLeastLeverMm = 0.5;
    if (!(std::abs(c.by_theta) > kLeastLeverMm * length(c.by_p))) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) jacobian[arm][i] = -c.by_p[i] / c.by_theta;
  }
  return jacobian;
}

std::optional<Torques> torquesForForce(const AngleJacobian& jacobian,
                                       DeviceN force) RELIEVO_REALTIME {
  Matrix transposed{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) transposed[i][j] = jacobian[j][i];
  }
  return solve(transposed, {force.x, force.y, force.z});
}

std::array<std::int16_t, kArms> countsForTorques(const Torques& torques,
                                                 double counts_per_n_mm) RELIEVO_REALTIME {
  // A motor's positive direction lowers its angle.
  Vec counts{};
  double largest = 0;
  for (std::size_t i = 0; i < kArms; ++i) {
    counts[i] = -counts_per_n_mm * torques[i];
    if (!std::isfinite(counts[i])) return {};
    largest = std::max(largest, std::abs(counts[i]));
  }
  const double scale = largest > kMaxCounts ? kMaxCounts / largest : 1;
  std::array<std::int16_t, kArms> rounded{};
  for (std::size_t i = 0; i < kArms; ++i) {
    rounded[i] = static_cast<std::int16_t>(std::lround(scale * counts[i]));
  }
  return rounded;
}

}  // namespace relievo::falcon
