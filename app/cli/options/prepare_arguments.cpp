// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/prepare_arguments.h"

#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>
#include <cmath>
#include <string_view>
#include <utility>

#include "app/cli/arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/state.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/io/formats/lines.h"
#include "core/io/formats/text_file.h"
#include "core/io/import.h"
#include "core/provenance/prepared_state.h"

namespace relievo::batch {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostRecipeBytes = 16U << 20U;
constexpr const char* kPairsHeader = "scan,x,y,z,ref_x,ref_y,ref_z";

int wholeNumber(const std::string& option, double value) {
  if (value != std::floor(value) || std::abs(value) > 1e9) {
    throw failure<MessageId::option_no_whole_number>(option,
                                                     NumberArgument{.value = value, .digits = 6});
  }
  return static_cast<int>(value);
}

CropBox cropOf(const std::string& text) {
  const std::vector<double> c = numberList("--crop", text, 6);
  return {.min = {c[0], c[1], c[2]}, .max = {c[3], c[4], c[5]}};
}

/// As many numbers as there are.
std::vector<double> anyNumbers(const std::string& option, const std::string& text) {
  const auto commas = static_cast<std::size_t>(std::count(text.begin(), text.end(), ','));
  return numberList(option, text, commas + 1);
}

/// Numbers, or "ground" and the like would be another table to keep.
Classes classesOf(const std::string& text) {
  Classes step;
  for (const double number : anyNumbers("--classes", text)) {
    const int kept = wholeNumber("--classes", number);
    if (kept < 0 || kept > 255) throw failure<MessageId::option_classes>();
    step.keep.push_back(static_cast<std::uint8_t>(kept));
  }
  return step;
}

Returns returnsOf(const std::string& text) {
  const auto* const known = std::find(kReturnNames.begin(), kReturnNames.end(), text);
  if (known == kReturnNames.end()) {
    throw failure<MessageId::option_none_of>("--returns", text, "first, last and single");
  }
  return {static_cast<ReturnChoice>(known - kReturnNames.begin())};
}

Lonely lonelyOf(const std::string& text) {
  constexpr std::string_view kAuto = "auto,";
  if (text.starts_with(kAuto)) {
    const auto count = numberList("--lonely", text.substr(kAuto.size()), 1);
    return {.neighbours = wholeNumber("--lonely", count[0])};
  }
  const std::vector<double> values = numberList("--lonely", text, 2);
  return {.radius_mm = values[0], .neighbours = wholeNumber("--lonely", values[1])};
}

/// With its arguments spelt out: compiled alone, g++ 12 warns wrongly else.
[[noreturn]] void refusePairs(const fs::path& file, std::size_t line, const std::string& why) {
  throw failure<MessageId::pairs_unreadable>(PathArgument(file), CountArgument(line),
                                             TextArgument(why), NameArgument(kPairsHeader));
}

/// Three or more places that were picked on a scan and on the reference.
std::vector<PickedPair> pairsIn(const fs::path& file) {
  const std::string text = readTextFile(file, kMostRecipeBytes);
  Lines lines(text);
  const auto refuse = [&](const std::string& why) { refusePairs(file, lines.number(), why); };
  if (!lines.next() || trimmed(lines.line()) != kPairsHeader) refuse("it has other columns");
  std::vector<PickedPair> pairs;
  while (lines.next()) {
    if (trimmed(lines.line()).empty()) continue;
    std::array<double, 7> v{};
    std::string_view rest = trimmed(lines.line());
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      const auto number = parseNumber(trimmed(rest.substr(0, comma)));
      if (!number || !std::isfinite(*number)) refuse("it has not seven numbers");
      v[i] = *number;
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    if (!rest.empty()) refuse("it has more than seven numbers");
    if (v[0] < 1 || v[0] > static_cast<double>(kMostScans) || v[0] != std::floor(v[0])) {
      refuse("scans are counted from 1");
    }
    pairs.push_back({.scan = static_cast<std::uint32_t>(v[0]) - 1,
                     .point = {v[1], v[2], v[3]},
                     .reference = {v[4], v[5], v[6]}});
  }
  return pairs;
}

Align alignOf(const PrepareArguments& a) {
  Align step;
  constexpr std::string_view kPoints = "points:";
  if (a.align.starts_with(kPoints)) {
    step.method = AlignMethod::points;
    step.pairs = pairsIn(a.align.substr(kPoints.size()));
  } else if (a.align == "auto") {
    step.method = AlignMethod::automatic;
  } else if (!a.align.empty() && a.align != "stored") {
    throw failure<MessageId::option_none_of>("--align", a.align, "points:P.csv, auto and stored");
  }
  if (a.reference) {
    if (*a.reference < 1) throw failure<MessageId::option_reference_counted>();
    step.reference = *a.reference - 1;
  }
  if (a.seed) step.seed = *a.seed;
  return step;
}

Sparse sparseOf(const std::string& text) {
  const std::vector<double> v = anyNumbers("--sparse", text);
  if (v.size() != 2 && v.size() != 3) {
    throw failure<MessageId::option_sparse>(text);
  }
  return {.neighbours = wholeNumber("--sparse", v[0]),
          .factor = v[1],
          .off_surface = v.size() == 3 ? v[2] : 0};
}

Base baseOf(const PrepareArguments& a) {
  if (a.base != "lay" && a.base != "crop") {
    throw failure<MessageId::option_neither>("--base", a.base, "lay", "crop");
  }
  Base step{.lay = a.base == "lay"};
  if (a.seed) step.seed = *a.seed;
  return step;
}

/// In the order in which they are done.
std::vector<Step> stepsOf(const PrepareArguments& a) {
  std::vector<Step> steps;
  if (!a.crop.empty()) steps.emplace_back(cropOf(a.crop));
  if (!a.classes.empty()) steps.emplace_back(classesOf(a.classes));
  if (!a.returns.empty()) steps.emplace_back(returnsOf(a.returns));
  if (!a.intensity.empty()) {
    const std::vector<double> range = numberList("--intensity", a.intensity, 2);
    steps.emplace_back(Intensities{.low = range[0], .high = range[1]});
  }
  if (a.drop_duplicates) steps.emplace_back(Duplicates{});
  if (a.clean) {
    for (const Step& step : cleaningSteps()) steps.push_back(step);
  }
  if (!a.outliers.empty()) {
    const std::vector<double> v = numberList("--outliers", a.outliers, 2);
    steps.emplace_back(Outliers{.neighbours = wholeNumber("--outliers", v[0]), .deviations = v[1]});
  }
  if (!a.lonely.empty()) steps.emplace_back(lonelyOf(a.lonely));
  if (!a.sparse.empty()) steps.emplace_back(sparseOf(a.sparse));
  if (a.files.size() > 1 || !a.align.empty()) steps.emplace_back(alignOf(a));
  if (a.thin_mm) steps.emplace_back(Thin{.spacing_mm = *a.thin_mm});
  if (!a.base.empty()) steps.emplace_back(baseOf(a));
  if (a.normals) steps.emplace_back(Normals{.neighbours = *a.normals});
  return steps;
}

/// The option that would give a step.
std::string stepOption(const PrepareArguments& a) {
  const std::array<std::pair<const char*, bool>, 15> given{
      {{"--crop", !a.crop.empty()},
       {"--classes", !a.classes.empty()},
       {"--returns", !a.returns.empty()},
       {"--intensity", !a.intensity.empty()},
       {"--drop-duplicates", a.drop_duplicates},
       {"--clean", a.clean},
       {"--outliers", !a.outliers.empty()},
       {"--lonely", !a.lonely.empty()},
       {"--sparse", !a.sparse.empty()},
       {"--align", !a.align.empty()},
       {"--reference", a.reference.has_value()},
       {"--seed", a.seed.has_value()},
       {"--thin", a.thin_mm.has_value()},
       {"--base", !a.base.empty()},
       {"--normals", a.normals.has_value()}}};
  for (const auto& [option, is_given] : given) {
    if (is_given) return option;
  }
  return {};
}

/// @param read  the scan, where it is
void checkInput(const InputFile& input, const fs::path& read, const ScanSource& named,
                const PrepareArguments& a, const Task& task) {
  const fs::path recipe = a.recipe;
  if (named.sha256.empty()) {
    return requireOwn(recipe, {.file = read.string(), .sha256 = {}}, a.outside_files,
                      "Give it as FILE if it is the right one.", task);
  }
  if (named.sha256 == input.sha256) return;
  throw ChangedInputError(said<MessageId::scan_is_not_that_of_recipe>(
      fs::path(named.file).filename().string(), recipe.filename().string()));
}

}  // namespace

void addStepOptions(CLI::App& verb, PrepareArguments& a) {
  verb.add_option("FILE", a.files, "Scans of one object; none: those that the recipe names");
  verb.add_option("--recipe", a.recipe, "Do what this file says, in its order");
  verb.add_option("--unit", a.unit, "Unit of all coordinates: mm cm m in ft us-ft");
  takesList(verb.add_option("--crop", a.crop,
                            "X0,Y0,Z0,X1,Y1,Z1: keep this box, in the file's coordinates"),
            6, {.low = -kFarMm, .high = kFarMm});
  verb.add_option("--classes", a.classes, "Keep these LAS classes, such as 2,6");
  verb.add_option("--returns", a.returns,
                  "first, last or single: keep these returns of a pulse (LAS)");
  takesList(
      verb.add_option("--intensity", a.intensity, "LOW,HIGH: keep points of this stored intensity"),
      2, {.low = -1e12, .high = 1e12});
  verb.add_flag("--drop-duplicates", a.drop_duplicates, "Of equal points keep the first");
  verb.add_flag("--clean", a.clean, "Leave out stray points, by steps that suit most scans");
  verb.add_option("--outliers", a.outliers,
                  "K,SD: leave out points farther from their K nearest than the mean and SD "
                  "standard deviations");
  verb.add_option("--lonely", a.lonely,
                  "MM,N: leave out points with fewer than N others so near; auto,N: within four "
                  "spacings");
  verb.add_option("--sparse", a.sparse,
                  "K,F: leave out points F times as far from their K nearest as the densest of "
                  "these from theirs; K,F,T: then those T times as far off the surface as others");
  verb.add_option("--align", a.align, "points:P.csv, auto, or stored (where the files have them)");
  takes(verb.add_option("--reference", a.reference, "The scan that stays where it is, from 1"),
        {.low = 1, .high = 1e6});
  takes(verb.add_option("--seed", a.seed, "Of what is drawn by chance; 1"),
        {.low = 0, .high = 4294967295});
  takes(verb.add_option("--thin", a.thin_mm, "Keep one point in every cube of so many mm"),
        {.low = 1e-6, .high = 1e6, .unit = "mm"});
  verb.add_option("--base", a.base, "lay: the plane under the object level; crop: leave it out");
  takes(verb.add_option("--normals", a.normals, "Add normals, each from so many nearest points"),
        {.low = 3, .high = 1000});
  addScanOptions(verb, a.scan);
  addOutsideOption(verb, a.outside_files);
}

Recipe recipeOf(const PrepareArguments& a) {
  Recipe recipe;
  if (a.recipe.empty()) {
    recipe.steps = stepsOf(a);
    const bool uses_seed = std::any_of(recipe.steps.begin(), recipe.steps.end(), [](const Step& s) {
      return std::holds_alternative<Align>(s) || std::holds_alternative<Base>(s);
    });
    if (a.seed && !uses_seed) {
      throw failure<MessageId::option_seed>();
    }
    if (a.reference && a.files.size() < 2) {
      throw failure<MessageId::option_reference_needs_files>();
    }
  } else {
    const std::string option = stepOption(a);
    if (!option.empty()) {
      throw failure<MessageId::option_beside_recipe>(option);
    }
    recipe = recipeFromText(readTextFile(a.recipe, kMostRecipeBytes), a.recipe);
  }
  check(recipe);
  for (const Step& step : recipe.steps) {
    const auto* const align = std::get_if<Align>(&step);
    const std::size_t scans = a.files.empty() ? recipe.scans.size() : a.files.size();
    if (align != nullptr && scans > 0 && align->reference >= scans) {
      throw failure<MessageId::reference_beyond_scans>(align->reference + 1, scans);
    }
  }
  return recipe;
}

std::vector<fs::path> scansOf(const PrepareArguments& a, const Recipe& recipe) {
  std::vector<fs::path> files(a.files.begin(), a.files.end());
  if (files.empty()) {
    const fs::path folder = fs::path(a.recipe).parent_path();
    for (const ScanSource& scan : recipe.scans) {
      files.push_back((folder / scan.file).lexically_normal());
    }
  }
  if (files.empty()) throw failure<MessageId::no_file_to_prepare>();
  return files;
}

PreparedFiles preparedFiles(const PrepareArguments& a, const PrepareOptions& options,
                            const fs::path& out, const Task& task) {
  Recipe recipe = recipeOf(a);
  const std::vector<fs::path> files = scansOf(a, recipe);
  const fs::path folder = out.parent_path();
  const ImportOptions given = importOptions(a.scan);
  std::optional<LengthUnit> unit;
  if (!a.unit.empty()) {
    unit = lengthUnit(a.unit);
    if (!unit) {
      throw failure<MessageId::option_none_of>("--unit", a.unit, "mm, cm, m, in, ft and us-ft");
    }
  }
  PreparedFiles result;
  std::vector<Scan> scans;
  std::vector<ScanSource> sources;
  for (std::size_t i = 0; i < files.size(); ++i) {
    result.inputs.push_back(inputFile(files[i], folder.empty() ? fs::path(".") : folder, task));
    ScanSource source{.file = files[i].string(),
                      .unit = std::nullopt,
                      .parts = given.scan.parts,
                      .keep_withheld = given.scan.keep_withheld};
    if (i < recipe.scans.size() && a.files.empty()) {
      checkInput(result.inputs.back(), files[i], recipe.scans[i], a, task);
      source.unit = recipe.scans[i].unit;
      // What was given beside the recipe goes before it, as the unit does.
      if (source.parts.empty()) source.parts = recipe.scans[i].parts;
      source.keep_withheld = source.keep_withheld || recipe.scans[i].keep_withheld;
    }
    if (unit) source.unit = unit;
    sources.push_back(source);
    ImportOptions import = given;
    import.scan.parts = source.parts;
    import.scan.keep_withheld = source.keep_withheld;
    scans.push_back(importScan(files[i], import, task));
    result.points.push_back(scans.back().info.points);
    for (const std::string& text : englishTexts(scans.back().info.warnings)) tell(text);
  }
  recipe.scans = sources;
  std::vector<const Scan*> all;
  for (const Scan& scan : scans) all.push_back(&scan);
  result.prepared = prepare(all, recipe, options, task);
  for (const Message& warning : result.prepared.answer.warnings) tell(englishText(warning));
  if (!result.prepared.unit_known) {
    tell("No file states a unit; one file unit is taken as 1 mm. Give --unit if it is another.");
  }
  result.again = recipeAgain(recipe, result.prepared, result.inputs);
  return result;
}

}  // namespace relievo::batch
