// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/scan_builder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace relievo {
namespace {

using Points = std::vector<std::array<float, 3>>;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// More than are looked at before an origin is chosen. @param from  where they lie
Points randomPoints(float from, float spread) {
  std::mt19937 random(198);
  std::uniform_real_distribution<float> at(-spread, spread);
  Points points(150'001);
  for (auto& p : points) p = {from + at(random), -from + at(random), at(random)};
  return points;
}

std::vector<std::pair<std::string, Points>> clouds() {
  Points spoilt = randomPoints(0, 5);
  spoilt[3][1] = kNaN;
  spoilt[100'000][2] = std::numeric_limits<float>::infinity();
  spoilt[100'001][0] = -1.5e38F;
  spoilt[120'000][0] = 1e38F;
  Points zeros = randomPoints(0, 5);
  for (auto& p : zeros) p[0] = std::abs(p[0]) + 1;
  for (auto& p : zeros) p[1] = -std::abs(p[1]) - 1;
  zeros[90'007] = {-0.0F, -0.0F, 1};  // Looked at together with the next, in another lane.
  zeros[90'008] = {0.0F, 0.0F, 1};
  zeros[140'000] = {0.0F, -0.0F, 1};
  Points plane = randomPoints(0, 5);
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i][2] = i % 2 == 0 ? 0.0F : -0.0F;
  return {{"near", randomPoints(0, 5)},
          {"far", randomPoints(4.1e6F, 50)},
          {"some are no points", std::move(spoilt)},
          {"ends at zeros of both signs", std::move(zeros)},
          {"in a plane", std::move(plane)}};
}

void addOneByOne(const Points& points, ScanBuilder& builder) {
  for (const auto& p : points) {
    builder.addPoint(static_cast<double>(p[0]), static_cast<double>(p[1]),
                     static_cast<double>(p[2]));
  }
}

void addTogether(const Points& points, ScanBuilder& builder) {
  // At an address that is no float's.
  std::vector<char> bytes(points.size() * sizeof(points[0]) + 1);
  std::memcpy(bytes.data() + 1, points.data(), bytes.size() - 1);
  builder.addPoints(bytes.data() + 1, points.size());
}

/// With the signs of zeros.
std::array<std::uint64_t, 6> bitsOf(const FileBounds& b) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  return {bits(b.min.x), bits(b.min.y), bits(b.min.z), bits(b.max.x), bits(b.max.y), bits(b.max.z)};
}

bool haveSameBits(const Points& a, const Points& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

TEST(ScanBuilder, PointsAddedTogetherAreThoseAddedOneByOne) {
  for (const auto& [name, points] : clouds()) {
    for (const std::uint64_t every : {1, 3}) {
      ImportOptions options;
      options.scan.every = every;
      ScanBuilder one("one.ply", options);
      addOneByOne(points, one);
      const Scan wanted = one.finish();
      ScanBuilder together("one.ply", options);
      addTogether(points, together);
      const Scan found = together.finish();
      EXPECT_TRUE(haveSameBits(found.points, wanted.points)) << name;
      EXPECT_EQ(found.origin, wanted.origin) << name;
      EXPECT_EQ(found.info.points, wanted.info.points) << name;
      EXPECT_EQ(found.info.finite_points, wanted.info.finite_points) << name;
      EXPECT_EQ(englishTexts(found.info.warnings), englishTexts(wanted.info.warnings)) << name;
      EXPECT_EQ(bitsOf(*found.info.bounds), bitsOf(*wanted.info.bounds)) << name;
    }
  }
}

TEST(ScanBuilder, ManyPointsMeetTheSameLimitAsOne) {
  const Points points = randomPoints(0, 5);
  ScanBuilder enough("one.ply", points.size());
  addTogether(points, enough);
  EXPECT_EQ(enough.finish().points.size(), points.size());
  ScanBuilder fewer("one.ply", points.size() - 1);
  EXPECT_THROW(addTogether(points, fewer), FileError);
}

class Kept : public PointSink {
 public:
  void expect(std::uint64_t count) override { expected = count; }
  void take(std::span<const std::array<float, 3>> some) override {
    points.insert(points.end(), some.begin(), some.end());
    most = std::max(most, some.size());
  }
  Points points;
  std::uint64_t expected = 0;
  std::size_t most = 0;
};

TEST(ScanBuilder, PointsThatLeaveAreThoseThatWouldHaveStayed) {
  for (const auto& [name, points] : clouds()) {
    ScanBuilder stay("one.ply", 1'000'000);
    addTogether(points, stay);
    const Scan wanted = stay.finish();
    Kept kept;
    ScanBuilder leave("one.ply", 1'000'000);
    leave.leaveTo(&kept);
    leave.expectPoints(points.size());
    constexpr std::size_t kSome = 50'000;
    for (std::size_t i = 0; i < points.size(); i += kSome) {
      const std::size_t end = std::min(i + kSome, points.size());
      addTogether({points.begin() + static_cast<std::ptrdiff_t>(i),
                   points.begin() + static_cast<std::ptrdiff_t>(end)},
                  leave);
      leave.passOn();
      EXPECT_LE(leave.keptCount(), end) << name;
    }
    const Scan found = leave.finish();
    EXPECT_TRUE(found.points.empty()) << name;
    EXPECT_TRUE(haveSameBits(kept.points, wanted.points)) << name;
    EXPECT_EQ(kept.expected, points.size()) << name;
    EXPECT_LT(kept.most, points.size()) << name;  // Not all at the end.
    EXPECT_EQ(found.info.finite_points, wanted.info.finite_points) << name;
    EXPECT_EQ(found.origin, wanted.origin) << name;
  }
}

}  // namespace
}  // namespace relievo
