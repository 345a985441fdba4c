// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/batch/json.h"
#include "app/batch/verb.h"
#include "core/io/import.h"
#include "core/io/raster.h"
#include "core/session/unit_guess.h"

namespace relievo::batch {
namespace {

struct InfoArguments {
  std::string file, unit;
  bool accept_incomplete = false;
};

ScanInfo readInfo(const InfoArguments& a, const Task& task) {
  ImportOptions options;
  options.accept_incomplete = a.accept_incomplete;
  if (looksLikeRaster(a.file)) return importRaster(a.file, options, task).info;
  return importScan(a.file, options, task).info;
}

Json jsonOf(const FilePoint& p) {
  return Json{p.x, p.y, p.z};
}

/// "300 x 200 x 41.3 mm"
std::string sizeText(const FilePoint& size_mm) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.4g x %.4g x %.4g mm", size_mm.x, size_mm.y, size_mm.z);
  return text.data();
}

Outcome runInfo(const InfoArguments& a, const Task& task) {
  std::optional<LengthUnit> given;
  if (!a.unit.empty()) {
    given = lengthUnit(a.unit);
    if (!given) {
      throw ArgumentError("--unit: '" + a.unit + "' is none of mm, cm, m, in, ft and us-ft.");
    }
  }
  const ScanInfo info = readInfo(a, task);
  const LengthUnit unit = given.value_or(info.unit.value_or(LengthUnit::mm));
  const UnitSource source =
      given ? UnitSource::given : (info.unit ? UnitSource::file : UnitSource::assumed);
  for (const std::string& warning : info.warnings) tell(warning);
  if (source == UnitSource::assumed) {
    std::string text =
        "The file states no unit; one file unit is taken as 1 mm. Give --unit if it is another.";
    if (info.bounds) {
      const LengthUnit likely = guessedUnit(*info.bounds);
      text += " From its size " + std::string(name(likely)) + " is likely" +
              (likely == unit
                   ? "."
                   : ": " + sizeText(mmPer(likely) * (info.bounds->max - info.bounds->min)) + ".");
    }
    tell(text);
  }

  Json json;
  json["file"] = a.file;
  json["format"] = info.format;
  json["points"] = info.points;
  json["finite_points"] = info.finite_points;
  json["faces"] = info.faces;
  json["bounds"] = nullptr;
  if (info.bounds) {
    json["bounds"] = {{"min", jsonOf(info.bounds->min)}, {"max", jsonOf(info.bounds->max)}};
  }
  json["size_mm"] = nullptr;
  json["likely_unit"] = nullptr;
  json["unit"] = name(unit);
  json["unit_source"] = name(source);
  json["dropped_faces"] = info.dropped_faces;
  if (info.bounds) {
    json["size_mm"] = jsonOf(mmPer(unit) * (info.bounds->max - info.bounds->min));
    if (source == UnitSource::assumed) json["likely_unit"] = name(guessedUnit(*info.bounds));
  }

  Outcome outcome{.json = json.dump(2), .lines = {}};
  outcome.lines = {a.file + ": " + info.format,
                   std::to_string(info.points) + " points, " + std::to_string(info.finite_points) +
                       " finite, " + std::to_string(info.faces) + " faces",
                   "unit " + std::string(name(unit)) + " (" + std::string(name(source)) + ")"};
  if (info.bounds) {
    outcome.lines.push_back("from " + json["bounds"]["min"].dump() + " to " +
                            json["bounds"]["max"].dump());
    const FilePoint size_mm = mmPer(unit) * (info.bounds->max - info.bounds->min);
    outcome.lines.push_back("size " + sizeText(size_mm) +
                            (source == UnitSource::assumed ? ", if one unit is 1 mm" : ""));
  }
  return outcome;
}

}  // namespace

Verb infoVerb() {
  auto arguments = std::make_shared<InfoArguments>();
  return {.name = "info",
          .help = "What a file holds: format, points, faces, box, unit",
          .declare =
              [arguments](CLI::App& verb) {
                verb.add_option("FILE", arguments->file, "Scan or raster")->required();
                verb.add_option("--unit", arguments->unit, "mm cm m in ft us-ft");
                verb.add_flag("--load-incomplete", arguments->accept_incomplete,
                              "Count the complete records of a cut file (E101)");
              },
          .run = [arguments](const Task& task) { return runInfo(*arguments, task); }};
}

}  // namespace relievo::batch
