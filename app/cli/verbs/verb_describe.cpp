// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <cmath>

#include "app/cli/json.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/describe/describe.h"
#include "core/message/catalogue.h"
#include "ui/translations/message_languages.h"

namespace relievo::batch {
namespace {

struct DescribeArguments {
  MapArguments map;
  std::string language = "en";
  bool spoken = false;
};

/// "middle_left": the name of the message without what all of them begin with.
std::string nameOf(Ninth ninth) {
  std::string name(rowOf(messageOf(ninth).id).name);
  return name.substr(name.find('_') + 1);
}

Json jsonOf(const std::optional<Ninth>& ninth) {
  return ninth ? Json(nameOf(*ninth)) : Json();
}

Json jsonOf(const RaisedArea& area) {
  return {{"place", nameOf(area.ninth)},
          {"centroid_mm", {area.x_mm, area.y_mm}},
          {"size_mm", {area.width_mm, area.height_mm}},
          {"share", area.share},
          {"rim", area.is_rim}};
}

Json jsonOf(const Description& d) {
  Json json{{"left_mm", d.object.x_mm},
            {"bottom_mm", d.object.y_mm},
            {"size_mm", {d.object.width_mm, d.object.height_mm}},
            {"heights_mm", {d.heights.min_mm, d.heights.max_mm}},
            {"most_span_mm", d.most_span_mm},
            {"separability", d.separability},
            {"threshold_mm", d.threshold_mm},
            {"mirrored_sides", d.mirrored_sides ? Json(*d.mirrored_sides) : Json()},
            {"mirrored_ends", d.mirrored_ends ? Json(*d.mirrored_ends) : Json()},
            {"roughest", jsonOf(d.roughest)},
            {"smoothest", jsonOf(d.smoothest)},
            {"not_measured", d.not_measured},
            {"largest_gap", jsonOf(d.largest_gap)}};
  json["highest"] = nullptr;
  if (d.highest) {
    json["highest"] = {{"place", nameOf(d.highest->ninth)},
                       {"at_mm", {d.highest->x_mm, d.highest->y_mm, d.highest->height_mm}}};
  }
  json["raised_areas"] = Json::array();
  for (const RaisedArea& area : d.raised) json["raised_areas"].push_back(jsonOf(area));
  for (std::size_t n = 0; n < kNinths; ++n) {
    const double mm = d.roughness_mm[n];
    json["roughness_mm"][nameOf(static_cast<Ninth>(n))] = mm < 0 ? Json() : Json(mm);
  }
  return json;
}

CommandResult runDescribe(const DescribeArguments& a, const Task& task) {
  const Surface surface = loadForVerb(a.map, task);
  const Description description = describe(surface);
  const MessageLanguage& language = messageLanguage(a.language);
  CommandResult outcome;
  outcome.exit_code = exitCodeAfter(surface);
  Json sentences = Json::array();
  for (const Message& sentence : sentencesOf(description)) {
    const std::string text = textIn(language, sentence), spoken = spokenIn(language, sentence);
    sentences.push_back({{"text", text}, {"spoken", spoken}});
    outcome.lines.push_back(a.spoken ? spoken : text);
  }
  outcome.json = reportText(Json{{"file", a.map.file},
                                 {"language", language.tag},
                                 {"facts", jsonOf(description)},
                                 {"sentences", sentences}});
  return outcome;
}

}  // namespace

Verb describeVerb() {
  auto arguments = std::make_shared<DescribeArguments>();
  return {.name = "describe",
          .help = "What the relief is like, in sentences and numbers, for who does not see it",
          .declare =
              [arguments](CLI::App& verb) {
                addMapOptions(verb, arguments->map);
                std::vector<std::string> tags;
                for (const MessageLanguage& l : messageLanguages()) tags.emplace_back(l.tag);
                verb.add_option("--lang", arguments->language, "The sentences' language; en")
                    ->check(CLI::IsMember(tags));
                verb.add_flag("--spoken", arguments->spoken,
                              "Sentences for ears: short, units as words");
              },
          .run = [arguments](const Task& task) { return runDescribe(*arguments, task); }};
}

}  // namespace relievo::batch
