// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/prepared_state.h"

#include "core/provenance/name_text.h"
#include "core/provenance/parameters_json.h"
#include "core/provenance/program.h"

namespace relievo {
namespace {

constexpr int kSchema = 1;
constexpr std::string_view kKey = "relievo_prepared";

/// Poses of scans that did not hold are none to use again.
bool allHold(const AlignAnswer& align) {
  return std::all_of(align.scans.begin(), align.scans.end(),
                     [](const AlignVerdict& verdict) { return verdict.holds; });
}

}  // namespace

Recipe recipeAgain(const Recipe& recipe, const Prepared& prepared,
                   const std::vector<InputFile>& inputs) {
  Recipe again = recipe;
  again.scans.clear();
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    // Which part of the file was read stays as it was chosen.
    ScanSource source = i < recipe.scans.size() ? recipe.scans[i] : ScanSource{};
    source.file = inputs[i].file;
    source.sha256 = inputs[i].sha256;
    source.unit = prepared.unit_known ? std::optional(prepared.unit) : std::nullopt;
    again.scans.push_back(source);
  }
  for (std::size_t i = 0; i < again.steps.size(); ++i) {
    auto* const align = std::get_if<Align>(&again.steps[i]);
    if (align == nullptr || align->method == AlignMethod::stored || !prepared.answer.align ||
        !prepared.answer.steps.at(i).done || !allHold(*prepared.answer.align)) {
      continue;
    }
    align->poses.clear();
    for (const AlignVerdict& verdict : prepared.answer.align->scans) {
      align->poses.push_back(verdict.pose);
    }
  }
  return again;
}

std::string preparedState(const Recipe& recipe_again, const Prepared& prepared,
                          const std::vector<InputFile>& inputs) {
  Json json;
  json[std::string(kKey)] = kSchema;
  json["program"] = {
      {"name", "relievo"}, {"version", programVersion()}, {"commit", programCommit()}};
  for (const InputFile& input : inputs) json["inputs"].push_back(jsonOf(input));
  json["recipe"] = Json::parse(recipeText(recipe_again, -1));
  json["steps"] = Json::array();
  for (std::size_t i = 0; i < prepared.answer.steps.size(); ++i) {
    const StepResult& step = prepared.answer.steps[i];
    json["steps"].push_back({{"kind", kindOf(recipe_again.steps.at(i))},
                             {"before", step.before},
                             {"after", step.after},
                             {"done", step.done}});
  }
  for (const Pose& pose : prepared.answer.poses) json["poses"].push_back(pose.m);
  json["pcl"] = prepared.answer.pcl;
  json["flann"] = prepared.answer.flann;
  // A file name need not be UTF-8; JSON must be.
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::string recipeText(const Recipe& recipe, int indent) {
  Recipe named = recipe;
  for (ScanSource& scan : named.scans) scan.file = textOfName(scan.file);
  return toJson(named, indent);
}

Recipe recipeFromText(std::string_view text, const std::string& source) {
  Recipe recipe = recipeFromJson(text, source);
  for (ScanSource& scan : recipe.scans) scan.file = nameFromText(scan.file);
  return recipe;
}

bool isPreparedState(std::string_view json) noexcept {
  const std::size_t first = json.find_first_not_of(" \t\r\n{");
  return first != std::string_view::npos && json.substr(first).starts_with("\"relievo_prepared\"");
}

}  // namespace relievo
