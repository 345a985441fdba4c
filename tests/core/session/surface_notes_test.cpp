// SPDX-License-Identifier: BSD-3-Clause
// What a surface says of itself, in English, word for word: reports, logs and scripts have these
// sentences, whatever the language of the window is.
#include <gtest/gtest.h>

#include "core/depth/fill/fill.h"
#include "core/depth/rules/cell_size.h"
#include "core/depth/rules/point_rule.h"
#include "core/message/catalogue.h"
#include "core/session/choices.h"
#include "core/session/colours/surface_colours.h"
#include "core/session/loss_report.h"
#include "core/session/nodata.h"
#include "core/session/source/raster_scale.h"
#include "core/session/source/unit_guess.h"
#include "core/session/strays.h"

namespace relievo {
namespace {

template <MessageId id, class... Given>
std::string english(Given&&... given) {
  return englishText(said<id>(std::forward<Given>(given)...));
}

std::array<double, kOriginCount> sharesOf(double measured, double interpolated) {
  std::array<double, kOriginCount> shares{};
  shares[static_cast<std::size_t>(CellStatus::measured)] = measured;
  shares[static_cast<std::size_t>(CellStatus::interpolated)] = interpolated;
  return shares;
}

TEST(SurfaceNotes, OfTheGrid) {
  const Message why =
      proposeCells(
          {.side_mm = 100, .covered_mm2 = 10'000, .points = 25'000, .points_per_cell = 2.5})
          .reason;
  EXPECT_EQ(english<MessageId::grid_chosen>(101, why),
            "Grid: 101 samples across (2.5 points a cell).");
  EXPECT_EQ(english<MessageId::grid_chosen>(800, said<MessageId::grid_of_mesh>()),
            "Grid: 800 samples across (mesh: the paper's grid of 800 samples).");
  EXPECT_EQ(english<MessageId::grid_of_one_spot>(), "all points lie on one spot");
  EXPECT_EQ(english<MessageId::grid_of_the_points>(), "the points lie on a regular grid");
  EXPECT_EQ(english<MessageId::points_on_one_line>(),
            "Seen from here the points lie on one line of cells, so that next to nothing can be "
            "seen or touched. Choose another view, or more cells.");
}

/// 100 samples, 100 / 99 mm apart: 2.551 points a cell.
TEST(SurfaceNotes, OfPointsACellAreRoundedDown) {
  const CellProposal found = proposeCells(
      {.side_mm = 100, .covered_mm2 = 10'000, .points = 25'000, .points_per_cell = 2.57});
  EXPECT_EQ(found.cells, 100);
  EXPECT_EQ(englishText(found.reason), "2.5 points a cell");
}

TEST(SurfaceNotes, OfTheHeights) {
  for (const auto& [rule, words] : {std::pair{PointRule::front, "front-most point"},
                                    std::pair{PointRule::second, "second point from the front"},
                                    std::pair{PointRule::top_mean, "mean of the top layer"},
                                    std::pair{PointRule::median, "median of the points"},
                                    std::pair{PointRule::mean, "mean of the points"},
                                    std::pair{PointRule::splat, "bilinear splat"},
                                    std::pair{PointRule::quadratic, "local quadratic"},
                                    std::pair{PointRule::lowest, "rear-most point"}}) {
    EXPECT_EQ(describe(rule), words);
    EXPECT_EQ(englishText(ruleMessage(rule)), words);
  }
  const NumberArgument density{.value = 2.46, .digits = 1};
  const auto heights = [](PointRule rule, const Message& why) {
    return english<MessageId::heights_by_rule>(ruleAndWhy({.rule = rule, .reason = why}));
  };
  EXPECT_EQ(heights(PointRule::quadratic, said<MessageId::rule_by_density>(density)),
            "Heights: 2.5 points per cell: local quadratic.");
  EXPECT_EQ(heights(PointRule::top_mean, said<MessageId::rule_by_layers>(density)),
            "Heights: 2.5 points per cell in several layers: mean of the top layer.");
  EXPECT_EQ(heights(PointRule::median, said<MessageId::rule_by_one_layer>(density)),
            "Heights: 2.5 points per cell in one layer: median of the points.");
  EXPECT_EQ(heights(PointRule::front, said<MessageId::rule_one_point_each>()),
            "Heights: one point at each sample: front-most point.");
  EXPECT_EQ(heights(PointRule::mean, said<MessageId::rule_as_chosen>()),
            "Heights: as chosen: mean of the points.");
  EXPECT_EQ(heights(PointRule::front, said<MessageId::rule_of_depth_buffer>()),
            "Heights: depth buffer: front-most point.");
  EXPECT_EQ(english<MessageId::points_were_merged>(),
            "The points were merged as they came; stray points were not looked for.");
}

TEST(SurfaceNotes, OfTheDepthBuffer) {
  const auto mm = [](double value) {
    return NumberArgument{.value = value,
                          .digits = 3,
                          .form = NumberArgument::Form::significant,
                          .unit = MessageUnit::millimetre};
  };
  EXPECT_EQ(english<MessageId::depth_buffer_is_exact_to>(24, mm(12.345), mm(7.4e-7), mm(3.7e-7)),
            "Depth buffer of 24 bits over 12.3 mm: steps of 7.4e-07 mm, heights exact to 3.7e-07 "
            "mm.");
  EXPECT_EQ(english<MessageId::float_depth_buffer_is_exact_to>(32, mm(12), mm(0.5), mm(0.25)),
            "Depth buffer of 32 bits, floating point, over 12 mm: steps of 0.5 mm, heights exact "
            "to 0.25 mm.");
}

TEST(SurfaceNotes, OfTheView) {
  EXPECT_EQ(english<MessageId::view_fit_uncertain>(),
            "The object is as thick one way as the other; its best-fit plane is not certain.");
  EXPECT_EQ(english<MessageId::view_axes_uncertain>(),
            "The object is as long one way as the other; its principal axes are not certain.");
}

TEST(SurfaceNotes, OfHolesThatAreLeft) {
  Hole left, filled;
  left.area_mm2 = 123.456;
  filled.filled = true;
  const auto words = [&](HoleRule rule, double most) {
    return englishText(holesLeft({left, filled}, {.rule = rule, .max_area_mm2 = most}).value());
  };
  EXPECT_EQ(words(HoleRule::interpolate, 50),
            "1 of 2 holes filled. The largest left (123.5 mm2) is larger than the limit of 50 mm2 "
            "and now rests on the base plane.");
  EXPECT_EQ(words(HoleRule::membrane, 500),
            "1 of 2 holes filled. The largest left (123.5 mm2) is too large for a membrane or has "
            "too little rim and now rests on the base plane.");
}

TEST(SurfaceNotes, OfWhatWasLost) {
  DepthLosses losses;
  losses.hidden_share = 0.25;
  losses.outliers = 1;
  EXPECT_EQ(englishText(lossReport(losses, 12, sharesOf(0.1234, 0.5))),
            "Seen from here 25 % of the scan is hidden and cannot be felt. Turn the object, or "
            "continue. 1 points far off all their neighbours were left out. 12 cells showed the "
            "object's back through gaps of its front; they were interpolated instead. Most cells "
            "are interpolated: 12.3 % of the map is measured. A coarser grid would rest on more.");
  HiddenSurface hidden;
  hidden.cells = 20;
  OriginCounts cells{};
  cells[static_cast<std::size_t>(CellStatus::measured)] = 100;
  EXPECT_EQ(englishText(mixedLayerWords(PointRule::mean, hidden, cells).value()),
            "In 20 % of the cells the points lie in several layers, front and back, and the chosen "
            "height per cell makes one height of them. Choose the mean of the top layer (topmean) "
            "to keep them apart.");
}

TEST(SurfaceNotes, OfStrays) {
  EXPECT_EQ(englishText(strayWords({.points = 12, .all = 20'000, .share_of_box = 0.9999})),
            "12 of 20 000 points lie 99.9 % of the box away from all others; they were left out.");
  EXPECT_EQ(englishText(strayWords({.points = 1, .all = 20'000, .share_of_box = 0.5})),
            "1 of 20 000 points lies 50 % of the box away from all others; it was left out.");
  EXPECT_EQ(englishText(strayWords({.points = 1, .all = 999, .share_of_box = 0.5, .kept = true})),
            "1 of 999 points lies 50 % of the box away from all others; it was kept.");
  EXPECT_EQ(englishText(strayWords({.points = 2, .all = 999, .share_of_box = 0.5, .kept = true})),
            "2 of 999 points lie 50 % of the box away from all others; they were kept.");
  EXPECT_EQ(englishText(strayWords({.all = 20'000, .grouped = 1500, .share_of_box_grouped = 0.9})),
            "1 500 of 20 000 points lie together 90 % of the box away from all others; they were "
            "left out.");
  EXPECT_EQ(englishText(strayWords(
                {.all = 20'000, .grouped = 150, .share_of_box_grouped = 0.9, .groups_kept = true})),
            "150 of 20 000 points lie together 90 % of the box away from all others; they were "
            "kept, as they may belong to the object.");
  EXPECT_TRUE(strayWords({.all = 20'000}).empty());
}

TEST(SurfaceNotes, OfAFileThatIsOnlyLookedAt) {
  EXPECT_EQ(englishText(strayWordsOfFile({.points = 3, .all = 99, .share_of_box = 0.5})),
            "3 of 99 points lie 50 % of the box away from all others; surfaces are made without "
            "them, unless --strays keep is given.");
  EXPECT_EQ(
      englishText(strayWordsOfFile({.points = 2, .all = 99, .share_of_box = 0.5, .unused = 1})),
      "1 of 99 points lies 50 % of the box away from all others; surfaces are made without "
      "it, unless --strays keep is given. 1 vertex belongs to no face and lies outside of "
      "the object; surfaces are made without it, unless --strays keep is given.");
  EXPECT_EQ(englishText(strayWordsOfFile(
                {.all = 20'000, .grouped = 150, .share_of_box_grouped = 0.9, .groups_kept = true})),
            "150 of 20 000 points lie together 90 % of the box away from all others; surfaces are "
            "made with them, as they may belong to the object, unless --strays drop-groups is "
            "given.");
  EXPECT_EQ(englishText(suspectWordsOfFile({.value = -9999, .count = 4, .all = 12})),
            "4 of 12 heights are -9999, which often stands for a missing one; surfaces are made "
            "without them, unless --nodata none is given.");
}

TEST(SurfaceNotes, OfVerticesThatNoFaceUses) {
  EXPECT_EQ(englishText(strayWords({.points = 1, .all = 99, .share_of_box = 0.5, .unused = 1})),
            "1 vertex belongs to no face and lies outside of the object; it was left out.");
  EXPECT_EQ(englishText(strayWords({.points = 5, .all = 99, .share_of_box = 0.5, .unused = 2})),
            "3 of 99 points lie 50 % of the box away from all others; they were left out. "
            "2 vertices belong to no face and lie outside of the object; they were left out.");
  EXPECT_EQ(englishText(strayWords(
                {.points = 2, .all = 99, .share_of_box = 0.5, .kept = true, .unused = 2})),
            "2 of 99 points lie 50 % of the box away from all others; they were kept.");
}

TEST(SurfaceNotes, OfHeightsThatStandForNone) {
  EXPECT_EQ(englishText(suspectWords({.value = -9999, .count = 1204, .all = 40'000})),
            "1 204 of 40 000 heights are -9999, which often stands for a missing one; they were "
            "left out. Say --nodata none to take them as heights, --nodata -9999 to leave them "
            "out without this message.");
  EXPECT_EQ(englishText(missingWords(1, -9999)), "1 height of -9999 was taken as missing.");
  EXPECT_EQ(englishText(missingWords(1204, 1e30)), "1 204 heights of 1e+30 were taken as missing.");
}

TEST(SurfaceNotes, OfUnitsThatNobodyStated) {
  ScanInfo info;
  info.format = "OBJ";
  const UnitInUse assumed{};
  const std::string plain =
      "The points carry no unit; one file unit was taken as 1 mm. Give the unit if it is another.";
  EXPECT_EQ(englishText(unitWords(info, assumed).value()), plain);
  info.bounds = FileBounds{{0, 0, 0}, {300, 200, 40}};
  EXPECT_EQ(englishText(unitWords(info, assumed).value()), plain);
  info.bounds = FileBounds{{0, 0, 0}, {8.7, 13.9, 11}};
  EXPECT_EQ(englishText(unitWords(info, assumed).value()),
            plain +
                " More likely is cm, 87 x 139 x 110 mm: an object of this shape is seldom as "
                "small.");
  info.bounds = FileBounds{{0, 0, 0}, {1, 0.8, 0.7}};
  EXPECT_EQ(englishText(unitWords(info, assumed).value()),
            plain +
                " More likely is m, 1000 x 800 x 700 mm: it is smaller than anything scanned "
                "in millimetres.");
  info.bounds = FileBounds{{0, 0, 0}, {8000, 9000, 300}};
  EXPECT_EQ(englishText(unitWords(info, assumed).value()),
            plain +
                " More likely is m, 8e+06 x 9e+06 x 3e+05 mm: it is larger than most that is "
                "in millimetres.");
  info.bounds = FileBounds{{512022, 5403117, 226}, {512549, 5403502, 357}};
  EXPECT_EQ(
      englishText(unitWords(info, {.unit = LengthUnit::m, .source = UnitSource::guessed}).value()),
      "The points carry no unit; one file unit was taken as 1 m, a guess: its coordinates "
      "are those of a map projection. Give the unit if it is another, for example feet.");
  EXPECT_EQ(english<MessageId::unit_of_format>(), "files of this format are in metres as a rule");
  EXPECT_EQ(english<MessageId::unit_of_far_off>(), "it lies as far off as in a map projection");
  EXPECT_EQ(english<MessageId::unit_of_usual>(), "of its size");
}

TEST(SurfaceNotes, OfRastersOfUnknownSize) {
  ScaleInUse scale{.pixel_mm = 1, .height_mm = 0.0012342, .is_placed = false};
  EXPECT_EQ(englishText(scaleWords(scale).value()),
            "The raster does not say how large it is; its samples were taken to lie 1 mm apart, "
            "and a step of its values to be 0.001234 mm high. Say --pixel-size and --height-scale "
            "in mm; --height-zero is the value on the base plane.");
  scale.height_source = UnitSource::guessed;
  EXPECT_EQ(englishText(scaleWords(scale).value()),
            "The raster does not say how large it is; its samples were taken to lie 1 mm apart, "
            "and a step of its values to be 0.001234 mm high, a guess: with steps of a unit it "
            "would be higher than it is long, with these it is about a tenth as high. Say "
            "--pixel-size and --height-scale in mm; --height-zero is the value on the base plane.");
}

TEST(SurfaceNotes, OfMapsAndColours) {
  EXPECT_EQ(english<MessageId::map_without_origins>(),
            "The map has no origins of its own; every height was taken as measured.");
  EXPECT_EQ(english<MessageId::map_taken_as_it_is>(),
            "A map written by this program is taken as it is; its holes were not treated anew.");
  EXPECT_EQ(english<MessageId::map_has_colours_beside>(),
            "The map has colours beside it; the relief images 'natural' and 'intensity' show what "
            "there is.");
  EXPECT_EQ(english<MessageId::colours_left_aside>(said<MessageId::quoted>("It is odd.")),
            "It is odd. The map is shown without colours.");
  EXPECT_EQ(englishText(colourWords({.measured = 1000, .own = 982})),
            "The scan has colours; 98.2 % of the measured cells have one of their own. The relief "
            "image 'natural' shows them.");
  EXPECT_EQ(englishText(intensityWords({.measured = 3, .own = 1}, {.low = 0.125, .high = 65535})),
            "The scan has intensities; 33.3 % of the measured cells have one of their own. The "
            "relief image 'intensity' shows them, black at 0.125 and white at 65535.");
  EXPECT_EQ(english<MessageId::quality_of_clouds_only>(),
            "Points and spread per cell are known for point clouds by the method CPU only; no "
            "quality map was written.");
}

TEST(SurfaceNotes, OfMapsByTiles) {
  EXPECT_EQ(english<MessageId::first_view_of_some_points>(3),
            "A first view from 3 % of the points.");
  EXPECT_EQ(english<MessageId::went_on_with_earlier_work>(CountArgument::grouped(1'200'000), 1, 4),
            "Went on with earlier work: 1 200 000 points were in tiles, 1 of 4 rows of tiles had "
            "their heights.");
  EXPECT_EQ(english<MessageId::damaged_work_made_anew>(2),
            "2 of its files were damaged and were made anew.");
  EXPECT_EQ(english<MessageId::colours_need_memory>(1234),
            "The scan's colours were left out: with them this map needs about 1234 MB of memory. "
            "Allow more with --memory.");
  EXPECT_EQ(english<MessageId::colours_not_by_tiles>(),
            "Colours beside a map are not read by tiles; its levels are made without. Leave out "
            "--memory, or make the map from its scan.");
}

}  // namespace
}  // namespace relievo
