// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <iostream>

#include "app/cli/json.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "core/base/failure.h"
#include "core/exhibit/exhibit.h"
#include "core/exhibit/visit_counts.h"
#include "core/project/openable.h"
#include "ui/translations/message_languages.h"

namespace relievo::batch {
namespace {

struct ExhibitArguments {
  std::string action, file;
};

std::vector<std::string> languageTags() {
  std::vector<std::string> tags;
  for (const MessageLanguage& language : messageLanguages()) tags.emplace_back(language.tag);
  return tags;
}

CommandResult runCheck(const std::string& file, const Task& task) {
  const ExhibitCheck check = checkExhibit(file, languageTags());
  const Exhibit& exhibit = check.exhibit;
  std::vector<std::string> faults;
  for (const Message& fault : check.faults) faults.push_back(englishText(fault));
  Json objects = Json::array();
  for (const ExhibitObject& object : exhibit.objects) {
    task.check();
    std::error_code unknown;
    if (std::filesystem::exists(object.file, unknown)) {
      // What cannot be opened shall be known before a visitor is there.
      const std::optional<Message> refusal = openingRefusal(object.file, task);
      if (refusal) faults.push_back(englishText(*refusal));
    }
    objects.push_back({{"id", object.id}, {"file", object.file.string()}});
  }
  CommandResult outcome;
  outcome.json = reportText(Json{{"file", file},
                                 {"languages", exhibit.languages},
                                 {"objects", objects},
                                 {"records", recordsFolder(exhibit).string()},
                                 {"faults", faults}});
  if (faults.empty()) {
    outcome.lines = {file + ": " + counted(exhibit.objects.size(), "object", "objects") + " in " +
                     counted(exhibit.languages.size(), "language", "languages")};
    return outcome;
  }
  constexpr int kCannotRead = 2;
  for (const std::string& fault : faults) tell(fault);
  outcome.exit_code = kCannotRead;
  return outcome;
}

CommandResult makePin() {
  std::string digits;
  std::getline(std::cin, digits);
  if (!isPin(digits)) throw failure<MessageId::exhibit_pin_digits>();
  const StaffPin pin = newStaffPin(digits);
  const Json json{{"staff_pin", {{"salt", pin.salt}, {"sha256", pin.sha256}}}};
  // Without the outer braces: a line for the file of the exhibit.
  const std::string text = json.dump();
  return {.json = text, .lines = {text.substr(1, text.size() - 2)}};
}

CommandResult showCounts(const std::string& file) {
  const Exhibit exhibit = readExhibit(file, languageTags());
  const VisitCounts counts(recordsFolder(exhibit));
  if (counts.problem()) tell(englishText(*counts.problem()));
  CommandResult outcome;
  Json days = Json::object();
  outcome.lines.emplace_back("day,object,starts,touched_s");
  for (const auto& [day, objects] : counts.days()) {
    for (const auto& [object, count] : objects) {
      days[day][object] = {{"starts", count.starts}, {"touched_s", count.touched_s}};
      outcome.lines.push_back(day + "," + object + "," + std::to_string(count.starts) + "," +
                              Json(count.touched_s).dump());
    }
  }
  outcome.json = reportText(Json{{"days", days}});
  return outcome;
}

CommandResult runExhibitVerb(const ExhibitArguments& a, const Task& task) {
  if (a.action == "pin") {
    if (!a.file.empty()) throw failure<MessageId::exhibit_pin_takes_no_file>();
    return makePin();
  }
  if (a.file.empty()) throw failure<MessageId::exhibit_needs_file>(a.action);
  return a.action == "check" ? runCheck(a.file, task) : showCounts(a.file);
}

}  // namespace

Verb exhibitVerb() {
  auto arguments = std::make_shared<ExhibitArguments>();
  return {.name = "exhibit",
          .help = "Check the file of an exhibit, make its PIN, read its counts",
          .declare =
              [arguments](CLI::App& verb) {
                verb.add_option("ACTION", arguments->action,
                                "check: every fault of FILE, a sentence each; pin: what the file "
                                "keeps of a PIN, from standard input; counts: starts and seconds "
                                "of touch, by day and object")
                    ->required()
                    ->check(CLI::IsMember({"check", "pin", "counts"}));
                verb.add_option("FILE", arguments->file, "The exhibit; pin takes none");
              },
          .run = [arguments](const Task& task) { return runExhibitVerb(*arguments, task); }};
}

}  // namespace relievo::batch
