// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/cli/json.h"
#include "app/cli/options/number_option.h"
#include "app/cli/options/prepare_arguments.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/base/replaceable.h"
#include "core/file/output_set.h"
#include "core/io/export/write_cloud.h"
#include "core/io/formats/text_file.h"
#include "core/provenance/prepared_state.h"

namespace relievo::batch {
namespace {

struct PrepareVerbArguments {
  PrepareArguments prepare;
  std::optional<double> memory_mb;
  std::string out, write_recipe;
};

Json stepsJson(const PreparedFiles& made) {
  Json steps = Json::array();
  for (std::size_t i = 0; i < made.prepared.answer.steps.size(); ++i) {
    const StepResult& step = made.prepared.answer.steps[i];
    Json parameters = Json::parse(toJson(made.again.steps.at(i)));
    parameters.erase("kind");
    if (parameters.is_null()) parameters = Json::object();
    steps.push_back({{"kind", kindOf(made.again.steps[i])},
                     {"parameters", parameters},
                     {"before", step.before},
                     {"after", step.after},
                     {"seconds", step.seconds},
                     {"note", englishText(step.notes)},
                     {"done", step.done}});
  }
  return steps;
}

Json scansJson(const Prepared& prepared) {
  Json scans = Json::array();
  for (std::size_t i = 0; i < prepared.answer.poses.size(); ++i) {
    Json& scan = scans.emplace_back();
    scan["pose"] = prepared.answer.poses[i].m;
    if (!prepared.answer.align) continue;
    const AlignVerdict& v = prepared.answer.align->scans.at(i);
    scan["start"] = v.start.m;
    scan["rms_mm"] = v.rms_mm;
    scan["share"] = v.share;
    scan["tight_share"] = v.tight_share;
    scan["stability"] = v.stability;
    scan["weak_direction"] = v.weak_direction;
    scan["uncertainty_mm"] = v.uncertainty_mm;
    scan["verdict"] = englishText(v.words);
    scan["holds"] = v.holds;
  }
  return scans;
}

std::string reportOf(const PrepareVerbArguments& a, const PreparedFiles& made) {
  const Scan& scan = made.prepared.scan;
  Json json;
  json["file"] = a.out;
  json["inputs"] = Json::array();
  for (std::size_t i = 0; i < made.inputs.size(); ++i) {
    json["inputs"].push_back({{"file", made.inputs[i].file},
                              {"sha256", made.inputs[i].sha256},
                              {"points", made.points[i]}});
  }
  json["steps"] = stepsJson(made);
  json["scans"] = scansJson(made.prepared);
  json["loops"] = Json::array();
  if (made.prepared.answer.align) {
    for (const AlignLoop& loop : made.prepared.answer.align->loops) {
      json["loops"].push_back({{"scans", loop.scans}, {"deg", loop.deg}, {"mm", loop.mm}});
    }
  }
  json["points"] = scan.points.size();
  json["faces"] = scan.triangles.size();
  json["colours"] = std::count_if(scan.colours.begin(), scan.colours.end(),
                                  [](const Rgba& colour) { return colour[3] != 0; });
  json["unit"] = name(made.prepared.unit);
  json["pcl"] = made.prepared.answer.pcl;
  json["flann"] = made.prepared.answer.flann;
  json["warnings"] = Json::array();
  for (const Message& warning : made.prepared.answer.warnings) {
    json["warnings"].push_back(englishText(warning));
  }
  json["not_done"] = Json::array();
  for (const auto& why : made.prepared.notDone()) json["not_done"].push_back(englishText(why));
  return reportText(json);
}

std::vector<std::string> linesOf(const PrepareVerbArguments& a, const PreparedFiles& made) {
  std::vector<std::string> lines;
  std::uint64_t before = 0;
  for (const std::uint64_t points : made.points) before += points;
  for (std::size_t i = 0; i < made.prepared.answer.steps.size(); ++i) {
    const StepResult& step = made.prepared.answer.steps[i];
    lines.push_back(std::string(kindOf(made.again.steps[i])) + ": " +
                    std::to_string(step.before - step.after) + " points left out" +
                    (step.done ? "" : ", not done"));
  }
  lines.push_back(a.out + ": " + std::to_string(made.prepared.scan.points.size()) + " of " +
                  std::to_string(before) + " points");
  return lines;
}

CommandResult runPrepare(const PrepareVerbArguments& a, const Task& task) {
  if (std::filesystem::path(a.out).extension() != ".ply") {
    throw failure<MessageId::prepared_name>(a.out);
  }
  requireReplaceable(a.out);
  PrepareOptions options;
  if (a.memory_mb) {
    if (!(*a.memory_mb >= 64) || !(*a.memory_mb <= 1e9)) {
      throw failure<MessageId::option_memory_of_steps>();
    }
    options.max_memory_bytes = static_cast<std::uint64_t>(*a.memory_mb) << 20U;
  }
  const PreparedFiles made = preparedFiles(a.prepare, options, a.out, task);
  OutputSet set;
  OutputSet cloud;
  writeCloud(cloud.file(a.out), made.prepared.scan,
             {.state = preparedState(made.again, made.prepared, made.inputs),
              .normals = made.prepared.answer.normals},
             task);
  if (!a.write_recipe.empty()) {
    // Named as they are found from the recipe's own folder.
    const std::filesystem::path folder = std::filesystem::path(a.write_recipe).parent_path();
    const auto files = scansOf(a.prepare, made.again);
    Recipe recipe = made.again;
    for (std::size_t i = 0; i < recipe.scans.size() && !a.prepare.files.empty(); ++i) {
      recipe.scans[i].file = relativePath(files[i], folder.empty() ? "." : folder);
    }
    writeTextFile(set.file(a.write_recipe), recipeText(recipe) + "\n");
  }
  set.takes(cloud);
  set.commit();
  return {.json = reportOf(a, made),
          .lines = linesOf(a, made),
          .exit_code = made.prepared.notDone().empty() ? 0 : 4};
}

VerbFiles filesOf(const PrepareVerbArguments& a) {
  VerbFiles files;
  files.reads(a.prepare.recipe, "the recipe that is read");
  constexpr std::string_view kPoints = "points:";
  if (a.prepare.align.starts_with(kPoints)) {
    files.reads(a.prepare.align.substr(kPoints.size()), "the file of pairs that is read");
  }
  for (const auto& scan : scansOf(a.prepare, recipeOf(a.prepare))) {
    files.reads(scan, "the scan itself");
  }
  files.writes(a.out);
  files.writes(a.write_recipe);
  return files;
}

}  // namespace

Verb prepareVerb() {
  auto arguments = std::make_shared<PrepareVerbArguments>();
  return {.name = "prepare",
          .help = "Crop, clean, thin and join scans, and write them as one cloud",
          .declare =
              [arguments](CLI::App& verb) {
                addStepOptions(verb, arguments->prepare);
                verb.add_option("-o,--output", arguments->out, "OUT.ply")->required();
                verb.add_option("--write-recipe", arguments->write_recipe,
                                "Also write what was done, to do it again");
                takes(verb.add_option("--memory", arguments->memory_mb,
                                      "MB that the steps may take; 6144"),
                      {.low = 64, .high = 1e9, .unit = "MB"});
              },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runPrepare(*arguments, task); }};
}

}  // namespace relievo::batch
