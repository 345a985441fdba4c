// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/batch/json.h"
#include "app/batch/map_report.h"
#include "app/batch/verb.h"
#include "core/io/import.h"
#include "core/io/raster.h"
#include "core/session/nodata.h"
#include "core/session/strays.h"
#include "core/session/unit_guess.h"

namespace relievo::batch {
namespace {

struct InfoArguments {
  std::string file, unit;
  bool accept_incomplete = false;
};

struct Found {
  ScanInfo info;
  Strays strays;
  std::optional<SuspectHeight> suspect_height;
  /// What the unit is guessed from: the box without strays.
  std::optional<FileBounds> box;
};

Found look(const InfoArguments& a, const Task& task) {
  ImportOptions options;
  options.accept_incomplete = a.accept_incomplete;
  if (looksLikeRaster(a.file)) {
    const RasterMap raster = importRaster(a.file, options, task);
    return {.info = raster.info,
            .strays = {},
            .suspect_height = suspectHeight(raster),
            .box = raster.info.bounds};
  }
  const Scan scan = importScan(a.file, options, task);
  const ScanInUse in_use(scan, StrayRule::drop, std::nullopt, task);
  return {.info = scan.info,
          .strays = in_use.strays(),
          .suspect_height = suspectHeight(scan),
          .box = in_use.scan().info.bounds};
}

/// Of a file that is only looked at.
std::string strayText(const Strays& strays) {
  std::string words = strayWords(strays);
  const std::string left_out = strays.points == 1 ? "it was left out." : "they were left out.";
  if (const auto at = words.find(left_out); at != std::string::npos) {
    words.replace(at, left_out.size(),
                  "surfaces are made without " + std::string(strays.points == 1 ? "it" : "them") +
                      ", unless --strays keep is given.");
  }
  return words;
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
  const Found found = look(a, task);
  const ScanInfo& info = found.info;
  ScanInfo without_strays = info;
  without_strays.bounds = found.box;
  const auto [unit, source] = unitInUse(without_strays, given, UnitSource::given);
  for (const std::string& warning : info.warnings) tell(warning);
  if (found.strays.points > 0) tell(strayText(found.strays));
  if (found.suspect_height) tell(suspectWords(*found.suspect_height));
  if (const std::string words = unitWords(without_strays, {unit, source}); !words.empty()) {
    tell(words);
  }
  const bool nobody_said = source == UnitSource::assumed || source == UnitSource::guessed;

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
    if (nobody_said) json["likely_unit"] = name(guessUnit(without_strays).unit);
  }
  json["strays"] = straysJson(found.strays);
  json["likely_nodata"] = suspectJson(found.suspect_height);

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
                            (nobody_said ? ", if one unit is 1 " + std::string(name(unit)) : ""));
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
