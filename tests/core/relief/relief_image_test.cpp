// SPDX-License-Identifier: BSD-3-Clause
#include "core/relief/relief_image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>

#include "core/base/error.h"

namespace relievo {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSpacing = 0.5;
constexpr int kSide = 101;
constexpr Cell kMiddle{.col = 50, .row = 50};

/// Heights z(x, y) with the origin on the middle sample.
DepthMap mapOf(const std::function<double(double, double)>& z) {
  DepthMap map;
  map.frame = {.size = {.cols = kSide, .rows = kSide},
               .spacing_mm = kSpacing,
               .first_x_mm = 0,
               .first_y_mm = 0};
  for (int row = 0; row < kSide; ++row) {
    for (int col = 0; col < kSide; ++col) {
      map.heights_mm.push_back(
          static_cast<float>(z((col - kMiddle.col) * kSpacing, (row - kMiddle.row) * kSpacing)));
    }
  }
  map.origins.assign(map.frame.size.count(), CellStatus::measured);
  return map;
}

double valueAt(const DepthMap& map, const ReliefLook& look, Cell cell = kMiddle) {
  return static_cast<double>(reliefValues(map, look).values[map.frame.size.index(cell)]);
}

/// A plane that rises by `slope_deg` toward `up_azimuth_deg` (0 = up, clockwise).
std::function<double(double, double)> plane(double slope_deg, double up_azimuth_deg) {
  const double t = std::tan(slope_deg * kDegree);
  const double a = up_azimuth_deg * kDegree;
  return [=](double x, double y) { return t * (x * std::sin(a) + y * std::cos(a)); };
}

/// A cone that opens upward, its tip cut off 5 mm from the axis: at a tip no grid is fine enough.
double cone(double x, double y) {
  return 0.75 * std::max(0.0, std::hypot(x, y) - 5);
}
/// Tangent of the angle at which its side stands 20 mm from the axis.
constexpr double kConeTangent = 0.75 * 15 / 20;

TEST(ReliefImage, AHillshadeIsTheCosineBetweenSurfaceAndLight) {
  const ReliefLook look{.kind = ReliefKind::hillshade,
                        .light = {.azimuth_deg = 315, .elevation_deg = 45}};
  EXPECT_NEAR(valueAt(mapOf(plane(0, 0)), look), std::sin(45 * kDegree), 1e-6);
  // A slope of 20 degrees that faces the light stands at 90 - 45 - 20 degrees from it.
  EXPECT_NEAR(valueAt(mapOf(plane(20, 135)), look), std::cos(25 * kDegree), 1e-6);
  EXPECT_NEAR(valueAt(mapOf(plane(20, 315)), look), std::cos(65 * kDegree), 1e-6);
  EXPECT_EQ(valueAt(mapOf(plane(60, 315)), look), 0);
}

TEST(ReliefImage, FourLightsShowASlopeThatOneLightLeavesDark) {
  const ReliefLook one{.kind = ReliefKind::hillshade};
  const ReliefLook four{.kind = ReliefKind::multi_hillshade};
  EXPECT_NEAR(valueAt(mapOf(plane(0, 0)), four), std::sin(45 * kDegree), 1e-6);
  // Facing east: the weights sin^2(90 - azimuth) are 1/2, 0, 1/2, 1 for 225, 270, 315, 360 degrees;
  // the shades (cos(aspect - azimuth) cos 45 sin 30 + sin 45 cos 30).
  double sum = 0;
  double weights = 0;
  for (const double azimuth : {225.0, 270.0, 315.0, 360.0}) {
    const double w = std::pow(std::sin((90 - azimuth) * kDegree), 2);
    sum += w * std::max(0.0, std::cos((90 - azimuth) * kDegree) * std::cos(45 * kDegree) *
                                     std::sin(30 * kDegree) +
                                 std::sin(45 * kDegree) * std::cos(30 * kDegree));
    weights += w;
  }
  const DepthMap east = mapOf(plane(30, 270));
  EXPECT_NEAR(valueAt(east, four), sum / weights, 1e-6);
  EXPECT_GT(valueAt(east, four), valueAt(east, one));
}

TEST(ReliefImage, SlopeIsThatOfThePlaneAndOfTheConeInDegrees) {
  const ReliefLook look{.kind = ReliefKind::slope};
  EXPECT_NEAR(valueAt(mapOf(plane(37, 200)), look), 37, 1e-4);
  EXPECT_NEAR(valueAt(mapOf(plane(37, 200)), look, {.col = 0, .row = 0}), 37, 1e-4);
  EXPECT_NEAR(valueAt(mapOf(cone), look, {.col = 90, .row = 50}), std::atan(0.75) / kDegree, 1e-3);
}

TEST(ReliefImage, LocalReliefOfAPlaneIsZeroAndOfABowlTheVarianceOfTheGaussian) {
  const ReliefLook look{.kind = ReliefKind::local_relief, .radius_mm = 5};
  EXPECT_NEAR(valueAt(mapOf(plane(25, 10)), look), 0, 1e-4);
  // z = c (x^2 + y^2) smoothed is z + 2 c sigma^2; sigma is half the radius.
  const double c = 0.02;
  const DepthMap bowl = mapOf([c](double x, double y) { return c * (x * x + y * y); });
  EXPECT_NEAR(valueAt(bowl, look), -2 * c * 2.5 * 2.5, 2e-3 * 2 * c * 2.5 * 2.5);
}

TEST(ReliefImage, TheSkyIsWholeOnAPlateauAndShutOutInAPit) {
  const ReliefLook look{.kind = ReliefKind::sky_view, .radius_mm = 20};
  EXPECT_NEAR(valueAt(mapOf(plane(0, 0)), look), 1, 1e-6);
  // On the axis of a cone that opens upward all horizons stand equally high.
  EXPECT_NEAR(valueAt(mapOf(cone), look), 1 - kConeTangent / std::hypot(1, kConeTangent), 1e-3);
  // From the floor of a hemispherical pit the rim stands at 45 degrees.
  const double r = 15;
  const DepthMap pit = mapOf([r](double x, double y) {
    const double d = std::hypot(x, y);
    return d < r ? r - std::sqrt(r * r - d * d) : r;
  });
  EXPECT_NEAR(valueAt(pit, look), 1 - std::sqrt(0.5), 0.01);
  // A slope of 30 degrees hides the sky uphill: the horizon toward an angle f has the tangent
  // tan(30) cos(f).
  double hidden = 0;
  for (int d = 0; d < 16; ++d) {
    const double t = std::max(0.0, std::tan(30 * kDegree) * std::cos(22.5 * d * kDegree));
    hidden += t / std::hypot(1, t) / 16;
  }
  EXPECT_NEAR(valueAt(mapOf(plane(30, 90)), look), 1 - hidden, 1e-5);
}

TEST(ReliefImage, OpennessIsARightAngleOnAPlaneLessInAHollowAndMoreOnAPeak) {
  const ReliefLook look{.kind = ReliefKind::openness, .radius_mm = 20};
  EXPECT_NEAR(valueAt(mapOf(plane(0, 0)), look), 90, 1e-5);
  EXPECT_NEAR(valueAt(mapOf(plane(30, 45)), look), 90, 1e-4);
  const double side = std::atan(kConeTangent) / kDegree;
  EXPECT_NEAR(valueAt(mapOf(cone), look), 90 - side, 0.05);
  const auto tent = [](double x, double y) { return -0.75 * std::hypot(x, y); };
  EXPECT_NEAR(valueAt(mapOf(tent), look), 90 + std::atan(0.75) / kDegree, 0.05);
}

TEST(ReliefImage, MultiScaleCurvatureIsThatOfTheSphereAndNothingOnAnyPlane) {
  const ReliefLook look{.kind = ReliefKind::curvature, .radius_mm = 8};
  EXPECT_NEAR(valueAt(mapOf(plane(0, 0)), look), 0, 1e-6);
  EXPECT_NEAR(valueAt(mapOf(plane(50, 20)), look), 0, 1e-5);
  EXPECT_NEAR(valueAt(mapOf(plane(50, 20)), look, {.col = 1, .row = 40}), 0, 1e-5) << "at the rim";
  const double big = 120;
  const auto ball = [big](double x, double y) { return std::sqrt(big * big - x * x - y * y); };
  const double expected = 3.0 / 8 / big * (8 + 4 + 2) / 3;
  EXPECT_NEAR(valueAt(mapOf(ball), look), expected, 0.02 * expected);
  const auto bowl = [&ball](double x, double y) { return -ball(x, y); };
  EXPECT_NEAR(valueAt(mapOf(bowl), look), -expected, 0.02 * expected);
  // Tilted, on the ball's flank.
  EXPECT_NEAR(valueAt(mapOf(ball), look, {.col = 80, .row = 50}), expected, 0.03 * expected);
}

TEST(ReliefImage, DeviationOfAWaveIsThatOfTheScaleWhereItIsMost) {
  const ReliefLook look{.kind = ReliefKind::multi_scale, .radius_mm = 8};
  EXPECT_NEAR(valueAt(mapOf(plane(25, 10)), look), 0, 0.1) << "a plane's rounding is no relief";
  // A wave along x, smoothed by sigma, has exp(-k^2 sigma^2 / 2) of its height. What is above the
  // mean is squared and smoothed likewise: at a crest the ratio is 1 / sqrt((1 + e) / 2), e the
  // damping of the doubled wave, and it is most at the largest sigma, 4.
  const double k = 2 * std::numbers::pi / 20;
  const auto wave = [k](double x, double) { return 0.5 * std::cos(k * x); };
  const double e = std::exp(-2 * k * k * 16);
  EXPECT_NEAR(valueAt(mapOf(wave), look), 1 / std::sqrt((1 + e) / 2), 0.01);
  EXPECT_NEAR(valueAt(mapOf(wave), look, {.col = 70, .row = 50}), -1 / std::sqrt((1 + e) / 2), 0.01)
      << "half a wave on";
}

TEST(ReliefImage, OcclusionIsTheSkyOnStoneUnderLamps) {
  const ReliefLook look{.kind = ReliefKind::occlusion, .radius_mm = 20};
  EXPECT_TRUE(isLit(look.kind));
  EXPECT_FALSE(hasLegend(look.kind));
  const DepthMap map = mapOf(cone);
  const ReliefValues values = reliefValues(map, look);
  const std::vector<std::uint8_t> colours = reliefColours(values, look);
  const std::size_t middle = map.frame.size.index({.col = 50, .row = 50});
  const double seen = 1 - kConeTangent / std::hypot(1, kConeTangent);
  EXPECT_NEAR(colours[3 * middle], 204 * seen, 1);
  const ReliefValues level = reliefValues(mapOf(plane(0, 0)), look);
  EXPECT_EQ(reliefColours(level, look)[3 * middle], 204);
}

TEST(ReliefImage, OutsideHasNoValueAndDoesNotDisturbItsNeighbours) {
  DepthMap map = mapOf(plane(20, 0));
  for (int row = 0; row < kSide; ++row) {
    for (int col = 60; col < kSide; ++col) {
      const std::size_t i = map.frame.size.index({.col = col, .row = row});
      map.origins[i] = CellStatus::outside;
      map.heights_mm[i] = -1000;
    }
  }
  for (const ReliefKind kind :
       {ReliefKind::hillshade, ReliefKind::multi_hillshade, ReliefKind::slope, ReliefKind::openness,
        ReliefKind::multi_scale, ReliefKind::curvature, ReliefKind::occlusion}) {
    const ReliefLook look{.kind = kind};
    const auto values = reliefValues(map, look).values;
    EXPECT_TRUE(std::isnan(values[map.frame.size.index({.col = 60, .row = 50})])) << name(kind);
    EXPECT_TRUE(std::isfinite(values[map.frame.size.index({.col = 59, .row = 50})])) << name(kind);
  }
  EXPECT_NEAR(valueAt(map, {.kind = ReliefKind::slope}, {.col = 59, .row = 50}), 20, 1e-4);
  EXPECT_NEAR(valueAt(map, {.kind = ReliefKind::local_relief}, {.col = 55, .row = 50}), 0, 1e-3);
}

TEST(ReliefImage, ColoursSpanTheDataAndAChosenRangeIsKept) {
  const DepthMap map = mapOf(plane(45, 90));
  ReliefLook look{.kind = ReliefKind::height};
  const ReliefValues found = reliefValues(map, look);
  EXPECT_NEAR(found.low, -24.5, 0.6);
  EXPECT_NEAR(found.high, 24.5, 0.6);
  look.range = {{0, 10}};
  const ReliefValues chosen = reliefValues(map, look);
  EXPECT_EQ(chosen.low, 0);
  EXPECT_EQ(chosen.high, 10);
  const auto colours = reliefColours(chosen, look);
  ASSERT_EQ(colours.size(), 3 * map.heights_mm.size());
  const auto colour_at = [&](int col) {
    const std::size_t i = 3 * map.frame.size.index({.col = col, .row = 50});
    return Rgb8{colours[i], colours[i + 1], colours[i + 2]};
  };
  EXPECT_EQ(colour_at(0), colourOf(ColourMap::viridis, 0));
  EXPECT_EQ(colour_at(60), colourOf(ColourMap::viridis, 0.5));
  EXPECT_EQ(colour_at(100), colourOf(ColourMap::viridis, 1));
}

Rgb8 colourAt(const std::vector<std::uint8_t>& colours, Cell cell = kMiddle) {
  const std::size_t i =
      3 * (static_cast<std::size_t>(cell.row) * kSide + static_cast<std::size_t>(cell.col));
  return {colours[i], colours[i + 1], colours[i + 2]};
}

GridColours ownColours(const Rgba& colour, const GreyAlpha& intensity) {
  GridColours own;
  own.colours.assign(std::size_t{kSide} * kSide, colour);
  own.intensities.assign(std::size_t{kSide} * kSide, intensity);
  return own;
}

TEST(OwnColours, WithoutShadingAreTheBytesOfTheScan) {
  const DepthMap map = mapOf(plane(30, 100));
  const GridColours own = ownColours({10, 200, 90, 255}, {77, 255});
  const ReliefLook natural{.kind = ReliefKind::natural, .shading = 0};
  EXPECT_EQ(colourAt(reliefColours(reliefValues(map, natural), natural, own)), (Rgb8{10, 200, 90}));
  const ReliefLook grey{.kind = ReliefKind::intensity, .shading = 0};
  EXPECT_EQ(colourAt(reliefColours(reliefValues(map, grey), grey, own)), (Rgb8{77, 77, 77}));
}

TEST(OwnColours, AreDarkenedByTheCosineToTheLightAsFarAsIsWanted) {
  // 30 degrees up toward 315 degrees, lit from there 45 degrees high: 75 degrees off the normal.
  const DepthMap map = mapOf(plane(30, 315));
  const GridColours own = ownColours({100, 200, 40, 255}, {0, 0});
  const double shade = std::cos(75 * kDegree) / std::sin(45 * kDegree);
  for (const double shading : {0.25, 0.5, 1.0}) {
    const ReliefLook look{.kind = ReliefKind::natural, .shading = shading};
    const Rgb8 made = colourAt(reliefColours(reliefValues(map, look), look, own));
    const double factor = 1 - shading + shading * shade;
    EXPECT_NEAR(made[0], 100 * factor, 0.51) << shading;
    EXPECT_NEAR(made[1], 200 * factor, 0.51) << shading;
  }
  const DepthMap level = mapOf(plane(0, 0));
  const ReliefLook look{.kind = ReliefKind::natural, .shading = 1};
  EXPECT_EQ(colourAt(reliefColours(reliefValues(level, look), look, own)), (Rgb8{100, 200, 40}));
}

TEST(OwnColours, SamplesWithoutOneAreStoneAndSurfacesWithoutAnyAreRefused) {
  const DepthMap map = mapOf(plane(0, 0));
  const ReliefLook look{.kind = ReliefKind::natural, .shading = 0};
  const Rgb8 stone =
      colourAt(reliefColours(reliefValues(map, look), look, ownColours({9, 9, 9, 0}, {0, 0})));
  EXPECT_GT(stone[0], 150);
  EXPECT_THROW(reliefColours(reliefValues(map, look), look), ArgumentError);
  EXPECT_FALSE(hasLegend(ReliefKind::natural));
  EXPECT_FALSE(isLit(ReliefKind::natural));
  EXPECT_FALSE(hasKeyLight(look));
  EXPECT_TRUE(hasKeyLight({.kind = ReliefKind::natural}));
  for (const double wrong : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(reliefValues(map, {.kind = ReliefKind::natural, .shading = wrong}), ArgumentError);
  }
}

TEST(ReliefImage, WrongNumbersAreRefused) {
  const DepthMap map = mapOf(plane(0, 0));
  EXPECT_THROW(reliefValues(map, {.kind = ReliefKind::sky_view, .radius_mm = -1}), ArgumentError);
  EXPECT_THROW(reliefValues(map, {.light = {.azimuth_deg = 0, .elevation_deg = 91}}),
               ArgumentError);
  EXPECT_THROW(reliefValues(map, {.range = {{1, 1}}}), ArgumentError);
}

/// CIE 1976 lightness of an sRGB colour.
double lightness(const Rgb8& rgb) {
  double y = 0;
  constexpr std::array<double, 3> kWeights{0.2126, 0.7152, 0.0722};
  for (std::size_t i = 0; i < 3; ++i) {
    const double c = rgb[i] / 255.0;
    y += kWeights[i] * (c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4));
  }
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColourMaps, EveryMapGrowsLighterAllTheWayInEvenSteps) {
  for (const std::string_view map_name : kColourMapNames) {
    const ColourMap map = *colourMap(map_name);
    double before = -1;
    double least = 100;
    double most = 0;
    for (int i = 0; i <= 20; ++i) {
      const double now = lightness(colourOf(map, i / 20.0));
      if (i > 0) {
        least = std::min(least, now - before);
        most = std::max(most, now - before);
      }
      before = now;
    }
    EXPECT_GT(least, 1.5) << name(map);
    // Batlow, even in colour difference, has its largest step of lightness where it is darkest.
    const bool wide = map == ColourMap::grey || map == ColourMap::batlow;
    EXPECT_LT(most, wide ? 7 : 6) << name(map);
  }
}

struct Anchor {
  double t;
  Rgb8 rgb;
};

/// Of any channel at any anchor.
int largestDeviation(ColourMap map, std::span<const Anchor> published) {
  int largest = 0;
  for (const Anchor& a : published) {
    const Rgb8 made = colourOf(map, a.t);
    for (std::size_t i = 0; i < 3; ++i) largest = std::max(largest, std::abs(made[i] - a.rgb[i]));
  }
  return largest;
}

// Entries of the published 256, about halfway between our colours, where a fit is at its worst.

TEST(ColourMaps, ViridisMeetsThePublishedColoursWithinOneStepAndItsEndsExactly) {
  constexpr std::array<Anchor, 15> kPublished{{{5 / 255.0, {70, 8, 92}},
                                               {16 / 255.0, {72, 24, 106}},
                                               {27 / 255.0, {72, 38, 119}},
                                               {37 / 255.0, {70, 51, 127}},
                                               {48 / 255.0, {66, 64, 134}},
                                               {69 / 255.0, {56, 88, 140}},
                                               {90 / 255.0, {46, 109, 142}},
                                               {112 / 255.0, {38, 130, 142}},
                                               {133 / 255.0, {31, 149, 139}},
                                               {154 / 255.0, {35, 169, 131}},
                                               {175 / 255.0, {61, 188, 116}},
                                               {197 / 255.0, {105, 205, 91}},
                                               {218 / 255.0, {157, 217, 59}},
                                               {239 / 255.0, {213, 226, 26}},
                                               {250 / 255.0, {241, 229, 29}}}};
  EXPECT_LE(largestDeviation(ColourMap::viridis, kPublished), 1);
  EXPECT_EQ(colourOf(ColourMap::viridis, 0), (Rgb8{68, 1, 84}));
  EXPECT_EQ(colourOf(ColourMap::viridis, 1), (Rgb8{253, 231, 37}));
}

TEST(ColourMaps, CividisMeetsThePublishedColoursWithinOneStepAndItsEndsExactly) {
  constexpr std::array<Anchor, 14> kPublished{{{8 / 255.0, {0, 40, 91}},
                                               {20 / 255.0, {0, 48, 112}},
                                               {24 / 255.0, {5, 51, 113}},
                                               {29 / 255.0, {20, 54, 112}},
                                               {40 / 255.0, {39, 62, 110}},
                                               {65 / 255.0, {68, 79, 108}},
                                               {106 / 255.0, {106, 108, 113}},
                                               {146 / 255.0, {142, 137, 120}},
                                               {178 / 255.0, {173, 162, 114}},
                                               {210 / 255.0, {207, 189, 98}},
                                               {232 / 255.0, {231, 209, 80}},
                                               {246 / 255.0, {247, 222, 62}},
                                               {252 / 255.0, {254, 228, 52}},
                                               {253 / 255.0, {254, 229, 53}}}};
  EXPECT_LE(largestDeviation(ColourMap::cividis, kPublished), 1);
  EXPECT_EQ(colourOf(ColourMap::cividis, 0), (Rgb8{0, 34, 78}));
  EXPECT_EQ(colourOf(ColourMap::cividis, 1), (Rgb8{254, 232, 56}));
}

TEST(ColourMaps, BatlowMeetsThePublishedColoursWithinOneStepAndItsEndsExactly) {
  constexpr std::array<Anchor, 12> kPublished{{{8 / 255.0, {8, 37, 91}},
                                               {24 / 255.0, {15, 59, 95}},
                                               {40 / 255.0, {19, 75, 97}},
                                               {72 / 255.0, {43, 101, 94}},
                                               {104 / 255.0, {90, 119, 69}},
                                               {120 / 255.0, {116, 126, 56}},
                                               {136 / 255.0, {145, 134, 45}},
                                               {168 / 255.0, {207, 147, 64}},
                                               {200 / 255.0, {249, 163, 128}},
                                               {216 / 255.0, {253, 175, 165}},
                                               {232 / 255.0, {253, 186, 199}},
                                               {248 / 255.0, {251, 198, 234}}}};
  EXPECT_LE(largestDeviation(ColourMap::batlow, kPublished), 1);
  EXPECT_EQ(colourOf(ColourMap::batlow, 0), (Rgb8{1, 25, 89}));
  EXPECT_EQ(colourOf(ColourMap::batlow, 1), (Rgb8{250, 204, 250}));
}

TEST(ReliefImage, EndsOfABarAreRoundAndHoldTheRange) {
  const auto ends = [](double low, double high) { return roundEnds(low, high); };
  EXPECT_EQ(ends(3.47, 28.91), std::pair(2.0, 30.0));
  EXPECT_EQ(ends(0, 20), std::pair(0.0, 20.0));
  EXPECT_NEAR(ends(-0.0137, 0.0098).first, -0.014, 1e-12);
  EXPECT_NEAR(ends(-0.0137, 0.0098).second, 0.01, 1e-12);
  EXPECT_EQ(ends(1203, 1204), std::pair(1203.0, 1204.0));
  for (const double size : {1e-9, 0.3, 7.0, 9e6}) {
    const auto [low, high] = ends(0.37 * size, 1.91 * size);
    EXPECT_LE(low, 0.37 * size);
    EXPECT_GE(high, 1.91 * size);
    EXPECT_LE(high - low, 1.2 * (1.91 - 0.37) * size * (1 + 1e-9));
  }
}

TEST(ColourMaps, NamesFindTheirKinds) {
  EXPECT_EQ(reliefKind("skyview"), ReliefKind::sky_view);
  EXPECT_EQ(colourMap("cividis"), ColourMap::cividis);
  EXPECT_EQ(colourMap("batlow"), ColourMap::batlow);
  EXPECT_FALSE(reliefKind("rainbow"));
  EXPECT_FALSE(colourMap("jet"));
}

}  // namespace
}  // namespace relievo
