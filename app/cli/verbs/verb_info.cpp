// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>

#include "app/cli/json.h"
#include "app/cli/map_report.h"
#include "app/cli/options/map_option_use.h"
#include "app/cli/published/published_input.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/number_text.h"
#include "core/io/input_facts.h"
#include "core/io/raster/raster.h"
#include "core/project/embedded_state.h"
#include "core/project/file_set.h"
#include "core/project/package.h"
#include "core/provenance/name_text.h"
#include "core/provenance/provenance.h"
#include "core/session/nodata.h"
#include "core/session/open_input.h"
#include "core/session/source/unit_guess.h"
#include "core/session/strays.h"

namespace relievo::batch {
namespace {

std::vector<std::string> strayTexts(const Strays& strays) {
  std::vector<std::string> texts;
  for (const Message& message : strayWordsOfFile(strays)) texts.push_back(englishText(message));
  return texts;
}

Json jsonOf(const FilePoint& p) {
  return Json{p.x, p.y, p.z};
}

/// "[0.5,0.5,0.0] to [10.5,10.5,10.0]"
std::string boxText(const FileBounds& box) {
  const auto corner = [](const FilePoint& p) {
    return Json{shownNumber(p.x), shownNumber(p.y), shownNumber(p.z)}.dump();
  };
  return corner(box.min) + " to " + corner(box.max);
}

Json jsonOf(const std::optional<FileBounds>& box) {
  if (!box) return nullptr;
  return {{"min", jsonOf(box->min)}, {"max", jsonOf(box->max)}};
}

struct InfoArguments {
  std::string file, unit;
  std::vector<std::string> with;
  ScanArguments scan;
};

/// What is told of a file beside its ScanInfo.
struct FileFacts {
  ScanInfo info;
  std::map<int, std::uint64_t> classes;     ///< Points of each class.
  std::optional<IntensityRange> intensity;  ///< Smallest and largest of the points.
  Strays strays;
  std::optional<SuspectHeight> suspect_height;
  /// What a map is made of and the unit guessed from: the box without strays and without heights
  /// that stand for none.
  std::optional<FileBounds> box_in_use;
};

/// What a map leaves out if nobody says otherwise.
std::optional<double> leftOutOf(const std::optional<SuspectHeight>& suspect) {
  return suspect ? std::optional<double>(suspect->value) : std::nullopt;
}

FileFacts factsOf(const Scan& scan, const Task& task) {
  const std::optional<SuspectHeight> suspect = suspectHeight(scan);
  const ScanInUse in_use(scan, StrayRule::drop, leftOutOf(suspect), task);
  FileFacts facts{.info = scan.info,
                  .classes = {},
                  .intensity = std::nullopt,
                  .strays = in_use.strays(),
                  .suspect_height = suspect,
                  .box_in_use = in_use.scan().info.bounds};
  for (const std::uint8_t number : scan.classes) ++facts.classes[number];
  if (scan.info.intensity && !scan.intensities.empty()) {
    const auto [least, most] =
        std::minmax_element(scan.intensities.begin(), scan.intensities.end());
    const IntensityRange& range = *scan.info.intensity;
    const auto value = [&range](std::uint16_t stored) {
      return range.low + (range.high - range.low) * stored / 65535;
    };
    facts.intensity = IntensityRange{value(*least), value(*most)};
  }
  return facts;
}

FileFacts readFacts(const InfoArguments& a, const InputFacts& facts, const Task& task) {
  const OpenedInput source =
      openInput(a.file, {.import = importOptions(a.scan), .by_tiles = false, .facts = facts}, task);
  if (source.raster) {
    tellUnusedScanOptions(a.scan);
    const RasterMap& raster = *source.raster;
    const std::optional<SuspectHeight> suspect = suspectHeight(raster);
    return {.info = raster.info,
            .classes = {},
            .intensity = std::nullopt,
            .strays = {},
            .suspect_height = suspect,
            .box_in_use = suspect ? boundsWithout(raster, suspect->value) : raster.info.bounds};
  }
  return factsOf(*source.scan, task);
}

/// The keys for what is stored with the points; null or empty where there is none.
void addValues(const FileFacts& facts, Json& json) {
  const ScanInfo& info = facts.info;
  json["reader"] = info.reader;
  json["reference_system"] = nullptr;
  if (!info.reference_system.empty()) json["reference_system"] = info.reference_system;
  json["colour"] = nullptr;
  if (info.colour) {
    json["colour"] = {{"source", info.colour->source},
                      {"bits", info.colour->bits},
                      {"points", info.colour->points}};
  }
  json["intensity"] = nullptr;
  if (facts.intensity) {
    json["intensity"] = {{"low", facts.intensity->low}, {"high", facts.intensity->high}};
  }
  json["classes"] = Json::object();
  for (const auto& [number, points] : facts.classes) {
    json["classes"][std::to_string(number)] = points;
  }
  json["withheld"] = info.withheld;
  json["parts"] = Json::array();
  for (const ScanPart& part : info.parts) {
    Json entry{{"name", part.name}, {"points", part.points}, {"viewpoint", nullptr}};
    if (part.viewpoint) entry["viewpoint"] = jsonOf(*part.viewpoint);
    json["parts"].push_back(std::move(entry));
  }
}

/// The same for people: only what there is.
void addValueLines(const FileFacts& facts, std::vector<std::string>& lines) {
  const ScanInfo& info = facts.info;
  if (!info.reader.empty()) lines.push_back("read by " + info.reader);
  if (info.colour) {
    lines.push_back("colours from " + info.colour->source + ", " +
                    std::to_string(info.colour->bits) + " bits, of " +
                    std::to_string(info.colour->points) +
                    (info.colour->source == "texture" ? " corners" : " points"));
  }
  if (facts.intensity) {
    const IntensityRange& range = *facts.intensity;
    lines.push_back("intensities from " + roundTripText(std::array{shownNumber(range.low)}) +
                    " to " + roundTripText(std::array{shownNumber(range.high)}));
  }
  for (const auto& [number, points] : facts.classes) {
    lines.push_back("class " + std::to_string(number) + ": " + std::to_string(points) + " points");
  }
  for (std::size_t i = 0; i < info.parts.size() && info.parts.size() > 1; ++i) {
    const ScanPart& part = info.parts[i];
    lines.push_back("scan " + std::to_string(i + 1) +
                    (part.name.empty() ? "" : " \"" + part.name + "\"") + ": " +
                    std::to_string(part.points) + " points");
  }
}

/// "300 x 200 x 41.3 mm"
std::string sizeText(const FilePoint& size_mm) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), "%.4g x %.4g x %.4g mm", size_mm.x, size_mm.y, size_mm.z);
  return text.data();
}

bool isOnePlace(const std::filesystem::path& a, const std::filesystem::path& b) {
  return std::filesystem::absolute(a).lexically_normal() ==
         std::filesystem::absolute(b).lexically_normal();
}

/// Says of the files that commands write beside this one, and of those that were named, whether
/// they belong to it. @return  is one of those that were named of another set?
bool addSet(const InfoArguments& a, Json& json, std::vector<std::string>& lines) {
  std::vector<SetMember> members = filesBeside(a.file);
  bool named_other = false;
  for (const std::string& file : a.with) {
    std::erase_if(members, [&](const SetMember& m) { return isOnePlace(m.file, file); });
    members.push_back({file, membershipIn(a.file, file)});
    named_other = named_other || members.back().membership == SetMembership::other;
  }
  json["set"] = Json::array();
  for (const SetMember& member : members) {
    const std::string shown = shownName(member.file);
    json["set"].push_back(
        {{"file", textOfName(member.file.string())}, {"belongs", name(member.membership)}});
    switch (member.membership) {
      case SetMembership::same:
        lines.push_back(shown + " was written with it");
        break;
      case SetMembership::other:
        lines.push_back(shown + " was not written with it");
        tell(shown + " was not written with " + shownName(a.file) +
             ". Make both again before you use them together.");
        break;
      case SetMembership::unsaid:
        lines.push_back(shown + " does not say what it was written with");
    }
  }
  return named_other;
}

/// A file that shows or tells something of a scan, and is none.
struct Shown {
  std::string kind;
  InputFile of;
  std::string version;  ///< Of the program that made it.
  std::optional<Region> region;
};

/// Empty: points or heights, or nothing of ours.
std::string kindOf(const InputFacts& facts) {
  switch (facts.host_file) {
    case HostFileKind::picture:
      return "picture";
    case HostFileKind::recording:
      return "recording";
    case HostFileKind::table:
      return "table";
    default:
      return {};
  }
}

/// Pictures, drawings, recordings and tables of ours; maps and clouds hold points of their own.
std::optional<Shown> shownBy(const std::filesystem::path& file, const InputFacts& facts) {
  const std::string kind = kindOf(facts);
  const auto state = kind.empty() ? std::nullopt : embeddedStateOf(file);
  if (!state) return std::nullopt;
  Shown shown{.kind = kind, .of = {}, .version = {}, .region = {}};
  if (const std::optional<Project> project = embeddedProject(file, *state)) {
    shown.of = {project->file, project->sha256, project->bytes};
    shown.version = project->version;
    shown.region = project->region;
  } else {
    const Provenance made = provenanceFromJson(*state, shownName(file));
    shown.of = made.input;
    shown.version = made.version;
  }
  return shown;
}

CommandResult infoOfShown(const InfoArguments& a, const Shown& shown) {
  Json json;
  json["file"] = a.file;
  json["format"] = shown.kind + " of relievo";
  json["shows"] = textOfName(shown.of.file);
  json["input_sha256"] = shown.of.sha256;
  json["version"] = shown.version;
  json["level"] = nullptr;
  json["region_mm"] = nullptr;
  if (shown.region) {
    json["level"] = shown.region->level.value;
    json["region_mm"] = batch::jsonOf(*shown.region);
  }
  CommandResult outcome;
  outcome.lines = {a.file + ": " + shown.kind + " of relievo " + shown.version,
                   "of " + shownName(shown.of.file) + ", sha256 " + shown.of.sha256};
  if (addSet(a, json, outcome.lines)) outcome.exit_code = 5;
  outcome.json = reportText(json);
  return outcome;
}

std::optional<LengthUnit> givenUnit(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto unit = lengthUnit(text);
  if (!unit)
    throw failure<MessageId::option_none_of>("--unit", text, "mm, cm, m, in, ft and us-ft");
  return unit;
}

/// The unit of a file, and who says so.
struct UnitFacts {
  ScanInfo without_strays;  ///< What a guess looks at.
  LengthUnit unit = LengthUnit::mm;
  UnitSource source = UnitSource::assumed;

  bool isSaid() const { return source != UnitSource::assumed && source != UnitSource::guessed; }
};

UnitFacts unitFacts(const FileFacts& found, const std::optional<LengthUnit>& given) {
  UnitFacts facts{.without_strays = found.info};
  facts.without_strays.bounds = found.box_in_use;
  const UnitInUse used = unitInUse(facts.without_strays, given, UnitSource::given);
  facts.unit = used.unit;
  facts.source = used.source;
  return facts;
}

void tellDoubts(const FileFacts& found, const UnitFacts& unit) {
  for (const std::string& text : englishTexts(found.info.warnings)) tell(text);
  for (const std::string& text : strayTexts(found.strays)) tell(text);
  if (found.suspect_height) {
    tell(englishText(suspectWordsOfFile(*found.suspect_height)));
  }
  const auto words = unitWords(unit.without_strays, {unit.unit, unit.source});
  if (words) tell(englishText(*words));
}

Json jsonOfFacts(const InfoArguments& a, const FileFacts& found, const UnitFacts& unit) {
  const ScanInfo& info = found.info;
  Json json;
  json["file"] = a.file;
  json["format"] = info.format;
  json["points"] = info.points;
  json["finite_points"] = info.finite_points;
  json["faces"] = info.faces;
  json["bounds"] = jsonOf(info.bounds);
  json["bounds_in_use"] = jsonOf(found.box_in_use);
  json["size_mm"] = nullptr;
  json["likely_unit"] = nullptr;
  json["unit"] = name(unit.unit);
  json["unit_source"] = name(unit.source);
  json["dropped_faces"] = info.dropped_faces;
  if (info.bounds) {
    json["size_mm"] = jsonOf(mmPer(unit.unit) * (info.bounds->max - info.bounds->min));
    if (!unit.isSaid()) json["likely_unit"] = name(guessUnit(unit.without_strays).unit);
  }
  json["strays"] = straysJson(found.strays);
  json["likely_nodata"] = suspectJson(found.suspect_height);
  addValues(found, json);
  return json;
}

std::vector<std::string> linesOfFacts(const InfoArguments& a, const FileFacts& found,
                                      const UnitFacts& unit) {
  const ScanInfo& info = found.info;
  const std::string unit_name(name(unit.unit));
  // Names of a file's scans need not be UTF-8; JSON must be.
  std::vector<std::string> lines{a.file + ": " + info.format,
                                 std::to_string(info.points) + " points, " +
                                     std::to_string(info.finite_points) + " finite, " +
                                     std::to_string(info.faces) + " faces",
                                 "unit " + unit_name + " (" + std::string(name(unit.source)) + ")"};
  if (info.bounds) {
    lines.push_back("from " + boxText(*info.bounds));
    const FilePoint size_mm = mmPer(unit.unit) * (info.bounds->max - info.bounds->min);
    lines.push_back("size " + sizeText(size_mm) +
                    (unit.isSaid() ? "" : ", if one unit is 1 " + unit_name));
  }
  if (found.box_in_use && found.box_in_use != info.bounds) {
    lines.push_back("without what is left out from " + boxText(*found.box_in_use));
  }
  addValueLines(found, lines);
  return lines;
}

CommandResult runInfo(const InfoArguments& a, const Task& task) {
  const std::optional<LengthUnit> given = givenUnit(a.unit);
  const InputFacts facts = inputFacts(a.file, task);
  if (const auto shown = shownBy(a.file, facts)) return infoOfShown(a, *shown);
  if (facts.host_file == HostFileKind::package && isPackageOfRelievo(a.file)) {
    throw failure<MessageId::info_of_a_package>(shownName(a.file));
  }
  if (facts.kind == InputKind::tiled_map && std::filesystem::path(a.file).extension() == ".json") {
    return infoOfPublished(a.file, task);
  }
  const FileFacts found = readFacts(a, facts, task);
  const UnitFacts unit = unitFacts(found, given);
  tellDoubts(found, unit);
  Json json = jsonOfFacts(a, found, unit);
  CommandResult outcome;
  outcome.lines = linesOfFacts(a, found, unit);
  if (addSet(a, json, outcome.lines)) outcome.exit_code = 5;
  outcome.json = reportText(json);
  return outcome;
}

}  // namespace

Verb infoVerb() {
  auto arguments = std::make_shared<InfoArguments>();
  return {
      .name = "info",
      .help = "What a file holds: format, points, faces, box, unit",
      .declare =
          [arguments](CLI::App& verb) {
            mayBeWebAddress(verb.add_option("FILE", arguments->file,
                                            "Scan or raster, or the address of a published map"))
                ->required();
            verb.add_option("--with", arguments->with,
                            "Was this file written with FILE? More may follow; exit 5 if one "
                            "was not");
            verb.add_option("--unit", arguments->unit, "mm cm m in ft us-ft");
            addScanOptions(verb, arguments->scan);
          },
      .run = [arguments](const Task& task) { return runInfo(*arguments, task); }};
}

}  // namespace relievo::batch
