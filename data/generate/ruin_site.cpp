// SPDX-License-Identifier: BSD-3-Clause
#include "data/generate/ruin_site.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "data/generate/shapes.h"

namespace relievo::samples {
namespace {

struct Block {
  double east = 0, north = 0;  ///< Of the middle.
  double half_east = 0, half_north = 0;
};

/// How deep inside the block, metres; negative outside: distance to the nearest side.
double depthInside(const Block& b, double east, double north) {
  return std::min(b.half_east - std::abs(east - b.east), b.half_north - std::abs(north - b.north));
}

/// A fixed number in [0, 1) for a lattice place.
double hashed(std::int64_t i, std::int64_t j, std::uint64_t salt) {
  std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15ULL +
                    static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4fULL + salt;
  for (int round = 0; round < 2; ++round) {
    h ^= h >> 31U;
    h *= 0xbf58476d1ce4e5b9ULL;
  }
  return static_cast<double>((h ^ (h >> 29U)) >> 11U) * 0x1p-53;
}

/// Smooth random hills of about the given size, in [0, 1].
double roughness(double east, double north, double size, std::uint64_t salt) {
  const double u = east / size;
  const double v = north / size;
  const auto i = static_cast<std::int64_t>(std::floor(u));
  const auto j = static_cast<std::int64_t>(std::floor(v));
  const double s = smoothStep(0, 1, u - std::floor(u));
  const double t = smoothStep(0, 1, v - std::floor(v));
  const double south = std::lerp(hashed(i, j, salt), hashed(i + 1, j, salt), s);
  const double north_side = std::lerp(hashed(i, j + 1, salt), hashed(i + 1, j + 1, salt), s);
  return std::lerp(south, north_side, t);
}

double terrain(double east, double north) {
  return 6 + 3 * std::sin(east / 90 + 0.5) + 2 * std::cos(north / 70) +
         0.8 * std::sin((east + north) / 31) + 1.2 * roughness(east, north, 24, 1) +
         0.25 * roughness(east, north, 3, 2) + 0.05 * roughness(east, north, 0.5, 3);
}

constexpr Block kPrecinct{200, 200, 105, 75};
constexpr double kPrecinctM = 11.5;  ///< Level of the precinct's floor.
constexpr Block kTank{150, 160, 14, 14};
constexpr Block kHall{183, 205, 15, 9};
constexpr Block kCourt{255, 200, 25, 14};
constexpr double kGateHalfM = 4;

/// Stones in running bond: joints 25 mm wide and 20 mm deep, each stone a little off level.
double paving(double east, double north) {
  constexpr double kLongM = 0.9;
  constexpr double kShortM = 0.6;
  constexpr double kJointM = 0.025;
  constexpr double kJointDeepM = 0.02;
  const double row = std::floor(north / kShortM);
  const double shift = std::remainder(row, 2.0) == 0 ? 0 : 0.5 * kLongM;
  const double col = std::floor((east + shift) / kLongM);
  const double u = east + shift - col * kLongM;
  const double v = north - row * kShortM;
  const double to_joint = std::min({u, kLongM - u, v, kShortM - v}) - 0.5 * kJointM;
  const auto i = static_cast<std::int64_t>(col);
  const auto j = static_cast<std::int64_t>(row);
  const double settled = 0.012 * (hashed(i, j, 11) - 0.5) +
                         0.01 * (hashed(i, j, 12) - 0.5) * (u / kLongM - 0.5) +
                         0.01 * (hashed(i, j, 13) - 0.5) * (v / kShortM - 0.5);
  return settled - kJointDeepM * (1 - smoothStep(-0.004, 0.004, to_joint));
}

double floorOfPrecinct(double east, double north) {
  if (depthInside(kCourt, east, north) > 0) return kPrecinctM + paving(east, north);
  return kPrecinctM + 0.15 * roughness(east, north, 5, 4) + 0.03 * roughness(east, north, 0.6, 5);
}

/// Steps that lead down into the tank, 0.35 m each.
double tank(double east, double north) {
  constexpr double kTreadM = 0.9;
  constexpr double kRiserM = 0.35;
  constexpr double kSteps = 10;
  const double in = depthInside(kTank, east, north);
  if (in <= 0) return 0;
  return -kRiserM * std::min(kSteps, std::floor(in / kTreadM) + 1);
}

/// Stairs up to the precinct before its east and west gates.
double stairs(double east, double north) {
  constexpr double kTreadM = 0.4;
  constexpr double kRiserM = 0.18;
  const double before = std::abs(east - kPrecinct.east) - kPrecinct.half_east;
  if (before <= 0 || std::abs(north - kPrecinct.north) > kGateHalfM) return -1;
  return kPrecinctM - kRiserM * std::ceil(before / kTreadM);
}

/// What is left of a wall of full height `high` along the block's outline.
double wallRemains(const Block& b, double thick, double high, double east, double north,
                   std::uint64_t salt) {
  const double in = depthInside(b, east, north);
  if (in < 0 || in > thick) return 0;
  const double left = 0.25 + 0.75 * roughness(east, north, 9, salt);
  const double crumbled = 0.25 * roughness(east, north, 0.8, salt + 1);
  const double course = 0.3;  // broken along the courses of the masonry
  return course * std::floor(std::max(0.0, high * left - crumbled) / course);
}

double precinctWall(double east, double north) {
  const bool gate = std::abs(north - kPrecinct.north) < kGateHalfM;
  return gate ? 0 : wallRemains(kPrecinct, 1.6, 4.5, east, north, 20);
}

double temple(double east, double north) {
  constexpr std::array<Block, 3> kTiers{
      {{215, 205, 17, 13}, {215, 205, 14, 10}, {215, 205, 11, 7.5}}};
  constexpr double kTierM = 1.1;
  double high = 0;
  for (const Block& tier : kTiers) {
    if (depthInside(tier, east, north) > 0) high += kTierM;
  }
  const Block sanctum{217, 205, 6.5, 5};
  const bool door = east < sanctum.east && std::abs(north - sanctum.north) < 1.1;
  return high + (door ? 0 : wallRemains(sanctum, 1.2, 6, east, north, 30));
}

/// Two rows of columns, broken at different heights.
double columns(double east, double north) {
  if (depthInside(kHall, east, north) < 0) return 0;
  constexpr double kPitchM = 3.6;
  constexpr double kRadiusM = 0.45;
  const double i = std::round((east - kHall.east) / kPitchM);
  const double j = std::round((north - kHall.north) / kPitchM);
  const double off = std::hypot(east - kHall.east - i * kPitchM, north - kHall.north - j * kPitchM);
  const double left = hashed(static_cast<std::int64_t>(i), static_cast<std::int64_t>(j), 40);
  if (off < kRadiusM) return 0.5 + (left < 0.2 ? 0 : 3.2 * left);
  return off < 0.75 ? 0.4 : 0.2;  // base, floor of the hall
}

/// Foundations of houses west of the precinct.
double houses(double east, double north) {
  constexpr double kPitchEastM = 11;
  constexpr double kPitchNorthM = 14;
  if (east < 30 || east > 85 || north < 110 || north > 290) return 0;
  const double i = std::floor((east - 30) / kPitchEastM);
  const double j = std::floor((north - 110) / kPitchNorthM);
  const auto salt = static_cast<std::int64_t>(j);
  if (hashed(static_cast<std::int64_t>(i), salt, 50) < 0.25) return 0;
  const Block house{30 + (i + 0.5) * kPitchEastM, 110 + (j + 0.5) * kPitchNorthM, 4.2, 5.4};
  const double inner_wall = std::abs(north - house.north) < 0.3 && std::abs(east - house.east) > 0.6
                                ? 0.9 * roughness(east, north, 4, 52)
                                : 0;
  const double walls = wallRemains(house, 0.6, 1.6, east, north, 51);
  return depthInside(house, east, north) > 0 ? std::max(walls, inner_wall) : 0;
}

/// Blocks that have fallen from the walls.
double fallenBlocks(double east, double north) {
  constexpr double kPitchM = 6;
  const double i = std::floor(east / kPitchM);
  const double j = std::floor(north / kPitchM);
  const auto a = static_cast<std::int64_t>(i);
  const auto b = static_cast<std::int64_t>(j);
  if (hashed(a, b, 60) < 0.8) return 0;
  const double turn = 3 * hashed(a, b, 61);
  const double u = east - (i + 0.3 + 0.4 * hashed(a, b, 62)) * kPitchM;
  const double v = north - (j + 0.3 + 0.4 * hashed(a, b, 63)) * kPitchM;
  const double along = std::abs(u * std::cos(turn) + v * std::sin(turn));
  const double across = std::abs(v * std::cos(turn) - u * std::sin(turn));
  return along < 0.6 && across < 0.35 ? 0.3 + 0.3 * hashed(a, b, 64) : 0;
}

}  // namespace

double siteHeightM(double east, double north) {
  const double ground = terrain(east, north);
  if (depthInside(kPrecinct, east, north) <= 0) {
    return std::max(ground + houses(east, north), stairs(east, north)) + fallenBlocks(east, north);
  }
  const double built =
      std::max({precinctWall(east, north), temple(east, north), columns(east, north)});
  const bool clear = depthInside(kCourt, east, north) > 0 || depthInside(kTank, east, north) > 0;
  const double loose = built > 0 || clear ? 0 : fallenBlocks(east, north);
  return floorOfPrecinct(east, north) + tank(east, north) + built + loose;
}

bool siteUnseen(double east, double north) {
  const Block water{kTank.east, kTank.north, 5, 5};
  if (depthInside(water, east, north) > 0) return true;
  const double thicket = std::hypot(east - 330, 1.4 * (north - 95));
  return thicket < 9 + 6 * roughness(east, north, 5, 70);
}

}  // namespace relievo::samples
