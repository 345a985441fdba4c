// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/recipe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace relievo {
namespace {

Recipe everyStep() {
  const double tilt = std::sqrt(0.5);
  Recipe recipe;
  recipe.scans = {{.file = "a/left.ply", .sha256 = std::string(64, 'a'), .unit = LengthUnit::m},
                  {.file = "right.las", .sha256 = "", .unit = std::nullopt}};
  recipe.steps = {
      CropBox{.min = {-1.25, 0, 1e6}, .max = {0.1, 2, 1e6 + 0.3}, .axes = {}, .keep_inside = false},
      CropOutline{.view = *standardRotation("front"),
                  .outline = {{0.1, 0}, {1, 0}, {1, 1.0 / 3}},
                  .keep_inside = true},
      Classes{.keep = {2, 6}, .keep_noise = true},
      Intensities{.low = 0.1, .high = 65535},
      Duplicates{},
      Outliers{.neighbours = 12, .deviations = 1.5},
      Lonely{.radius_mm = 0.7, .neighbours = 5},
      Lonely{},
      Sparse{.neighbours = 9, .factor = 3.5, .off_surface = 5},
      Align{.method = AlignMethod::points,
            .reference = 1,
            .pairs = {{.scan = 0, .point = {1, 2, 3}, .reference = {4, 5, 6.5}}},
            .seed = 42,
            .poses = {Pose{}, Pose{{tilt, -tilt, 0, 7, tilt, tilt, 0, 8, 0, 0, 1, 9, 0, 0, 0, 1}}}},
      Thin{.spacing_mm = 0.1},
      Base{.lay = true, .distance_mm = 0.25, .seed = 7},
      Normals{.neighbours = 20},
      Returns{ReturnChoice::single}};
  std::get<CropBox>(recipe.steps[0]).axes = {tilt, tilt, 0, -tilt, tilt, 0, 0, 0, 1};
  return recipe;
}

TEST(Recipe, ComesBackFromItsTextAsItWas) {
  const Recipe recipe = everyStep();
  ASSERT_NO_THROW(check(recipe));
  for (const int indent : {-1, 2}) {
    const std::string text = toJson(recipe, indent);
    EXPECT_EQ(recipeFromJson(text, "r.json"), recipe);
    EXPECT_EQ(toJson(recipeFromJson(text, "r.json"), indent), text);
  }
}

TEST(Recipe, WrittenByHandMayLeaveOutWhatHasADefault) {
  const Recipe recipe = recipeFromJson(
      R"({"relievo_recipe": 1, "steps": [
        {"kind": "crop_outline", "view": "left", "outline": [[0,0],[1,0],[0,1]], "keep": "inside"},
        {"kind": "lonely", "neighbours": 3}, {"kind": "base", "lay": false}]})",
      "r.json");
  ASSERT_EQ(recipe.steps.size(), 3U);
  EXPECT_EQ(std::get<CropOutline>(recipe.steps[0]).view, *standardRotation("left"));
  EXPECT_EQ(std::get<Lonely>(recipe.steps[1]), Lonely{});
  EXPECT_EQ(std::get<Base>(recipe.steps[2]), Base{});
}

std::string withStep(const std::string& step) {
  return R"({"relievo_recipe": 1, "steps": [)" + step + "]}";
}

TEST(Recipe, IsRefusedInWordsWhateverIsWrongWithIt) {
  const std::string pose_of_a_mirror =
      R"({"kind":"align","method":"stored","poses":[[-1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1]]})";
  std::string deep = R"({"relievo_recipe": 1, "steps": )";
  deep += std::string(100000, '[');
  std::string many = R"({"kind":"duplicates"})";
  for (int i = 0; i < 100; ++i) many += R"(,{"kind":"duplicates"})";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"", "Line 1 of it is not JSON."},
      {"{\n\"relievo_recipe\": 1,\n x}", "Line 3 of it is not JSON."},
      {"{}", "no 'relievo_recipe'"},
      {"[]", "no 'relievo_recipe'"},
      {R"({"relievo_recipe": 2, "steps": []})", "schema is 2"},
      {R"({"relievo_recipe": 1})", "steps"},
      {R"({"relievo_recipe": 1, "steps": [], "stpes": []})", "'stpes' is not a key"},
      {R"({"relievo_recipe": 1, "steps": [], "scans": [{"file": ""}]})", "'file'"},
      {R"({"relievo_recipe": 1, "steps": [], "scans": [{"file": "a\u0000b"}]})", "'file'"},
      {R"({"relievo_recipe": 1, "steps": [], "scans": [{"file": "a", "unit": "yard"}]})", "'unit'"},
      {R"({"relievo_recipe": 1, "steps": [], "scans": [{"file": "a", "sha256": "12"}]})", "sha256"},
      {withStep(R"({"kind":"polish"})"), "'polish' is no step"},
      {withStep(R"({"kind":"thin"})"), "spacing_mm"},
      {withStep(R"({"kind":"thin","spacing_mm":"1"})"), "not a number"},
      {withStep(R"({"kind":"thin","spacing_mm":1e999})"), "A number in it is too large."},
      {withStep(R"({"kind":"thin","spacing_mm":-1})"), "above 0 mm"},
      {withStep(R"({"kind":"thin","spacing_mm":0})"), "above 0 mm"},
      {withStep(R"({"kind":"thin","spacing_mm":1,"spacing":2})"), "'spacing' is not a key"},
      {withStep(R"({"kind":"outliers","neighbours":0,"deviations":2})"), "'neighbours' is 0"},
      {withStep(R"({"kind":"outliers","neighbours":4294967296,"deviations":2})"), "whole number"},
      {withStep(R"({"kind":"outliers","neighbours":8.5,"deviations":2})"), "whole number"},
      {withStep(R"({"kind":"outliers","neighbours":8,"deviations":-1})"), "'deviations'"},
      {withStep(R"({"kind":"sparse","neighbours":8,"factor":0.5})"), "'factor'"},
      {withStep(R"({"kind":"normals","neighbours":2})"), "'neighbours' is 2"},
      {withStep(R"({"kind":"classes","keep":[256]})"), "0 to 255"},
      {withStep(R"({"kind":"returns","keep":"second"})"), "none of first, last and single"},
      {withStep(R"({"kind":"intensities","low":2,"high":1})"), "below the lowest"},
      {withStep(R"({"kind":"crop_box","min":[0,0,0],"max":[1,-1,1],"keep":"inside"})"), "ends"},
      {withStep(R"({"kind":"crop_box","min":[0,0],"max":[1,1,1],"keep":"inside"})"), "3 numbers"},
      {withStep(R"({"kind":"crop_box","min":[0,0,0],"max":[1,1,1],"keep":"both"})"), "'keep'"},
      {withStep(R"({"kind":"crop_box","min":[0,0,0],"max":[1,1,1],"keep":"inside",)"
                R"("axes":[2,0,0,0,1,0,0,0,1]})"),
       "no rotation"},
      {withStep(R"({"kind":"crop_outline","outline":[[0,0],[1,1]],"keep":"inside"})"), "2 corners"},
      {withStep(pose_of_a_mirror), "a pose is no rotation"},
      {withStep(R"({"kind":"align","method":"guess"})"), "'method'"},
      {withStep(R"({"kind":"align","method":"auto"},{"kind":"align","method":"auto"})"), "twice"},
      {withStep(many), "at most 100"},
      {deep, "nested too deep"},
  };
  for (const auto& [text, words] : cases) {
    SCOPED_TRACE(text.substr(0, 200));
    try {
      recipeFromJson(text, "r.json");
      ADD_FAILURE() << "it was taken";
    } catch (const FileError& error) {
      const std::string message = error.what();
      EXPECT_TRUE(message.starts_with("r.json is no recipe")) << message;
      EXPECT_NE(message.find(words), std::string::npos) << message;
      EXPECT_TRUE(message.ends_with("Nothing was done.")) << message;
    }
  }
}

TEST(Recipe, NumbersThatAreNoneAreRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinite, -infinite}) {
    const std::vector<Step> steps{
        Outliers{.deviations = bad},
        Lonely{.radius_mm = bad},
        Thin{.spacing_mm = bad},
        Base{.distance_mm = bad},
        Intensities{.low = bad, .high = bad},
        CropBox{.min = {bad, 0, 0}, .max = {1, 1, 1}},
        CropOutline{.outline = {{0, 0}, {1, bad}, {1, 1}}},
        Align{.poses = {Pose{{bad, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}}};
    for (const Step& step : steps) {
      EXPECT_THROW(check(Recipe{.steps = {step}}), ArgumentError) << kindOf(step) << " " << bad;
    }
  }
}

TEST(Recipe, SaysWhichScansOfAFileAndWhetherWithheldPointsAreRead) {
  const Recipe recipe{.scans = {{.file = "arch.e57", .parts = {2, 3}},
                                {.file = "site.las", .keep_withheld = true}}};
  EXPECT_EQ(recipeFromJson(toJson(recipe), "r.json"), recipe);
  EXPECT_EQ(toJson(Recipe{.scans = {{.file = "a.ply"}}}).find("parts"), std::string::npos);
  for (const char* parts : {"[0]", "[\"2\"]", "[1.5]", "2", "[5000000000]"}) {
    const std::string text =
        R"({"relievo_recipe": 1, "steps": [], "scans": [{"file": "a.e57", "parts": )" +
        std::string(parts) + "}]}";
    EXPECT_THROW(recipeFromJson(text, "r.json"), FileError) << parts;
  }
}

TEST(Recipe, APoseIsRigidOrNone) {
  EXPECT_TRUE(isRigid(Pose{}));
  EXPECT_FALSE(isRigid(Pose{{1 + 2e-9, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}));
  EXPECT_TRUE(isRigid(Pose{{0, -1, 0, 3, 1, 0, 0, 5, 0, 0, 1, 1e6, 0, 0, 0, 1}}));
  EXPECT_FALSE(isRigid(Pose{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1}}));
  EXPECT_FALSE(isRigid(Pose{{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 1}}));
}

}  // namespace
}  // namespace relievo
