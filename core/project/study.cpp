// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/study.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "core/base/failure.h"
#include "core/file/atomic_file.h"
#include "core/file/output_set.h"
#include "core/io/formats/text_file.h"
#include "core/provenance/name_text.h"
#include "core/provenance/parameters_json.h"

namespace relievo {
namespace {

constexpr std::size_t kLongestCode = 32;
constexpr std::size_t kFewestConditions = 2, kMostConditions = 26;  // As many as letters.
constexpr int kMostRepetitions = 100;
constexpr int kMostSittings = 10'000;

/// From 0 to below `count`, each as likely. Standard distributions differ between libraries.
std::size_t below(std::size_t count, std::mt19937_64& random) {
  const std::uint64_t fair = std::mt19937_64::max() - std::mt19937_64::max() % count;
  std::uint64_t drawn = random();
  while (drawn >= fair) drawn = random();
  return static_cast<std::size_t>(drawn % count);
}

std::vector<std::size_t> shuffled(std::size_t count, std::mt19937_64& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[below(i, random)]);
  return order;
}

std::string letter(std::size_t index) {
  return std::string(1, static_cast<char>('A' + index));
}

std::string inQuotes(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

bool isParticipantCode(std::string_view text) noexcept {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_';
  };
  return !text.empty() && text.size() <= kLongestCode &&
         std::all_of(text.begin(), text.end(), is_allowed);
}

void check(const Study& study) {
  if (!isParticipantCode(study.participant)) {
    throw failure<MessageId::study_code>(escapedName(study.participant));
  }
  if (study.consent.find_first_not_of(" \t\n") == std::string::npos) {
    throw failure<MessageId::study_without_consent>();
  }
  const std::size_t count = study.conditions.size();
  if (count < kFewestConditions || count > kMostConditions || study.repetitions < 1 ||
      study.repetitions > kMostRepetitions) {
    throw failure<MessageId::study_conditions>(count, study.repetitions);
  }
}

std::vector<StudyTrial> trialsOf(const Study& study) {
  check(study);
  std::mt19937_64 random(study.seed);
  const std::size_t count = study.conditions.size();
  const std::vector<std::size_t> letters = shuffled(count, random);
  std::vector<StudyTrial> trials;
  for (int block = 0; block < study.repetitions; ++block) {
    std::vector<std::size_t> order = shuffled(count, random);
    // What was felt last would be felt twice without a pause.
    if (!trials.empty() && order.front() == trials.back().condition) {
      std::swap(order.front(), order[1 + below(count - 1, random)]);
    }
    for (const std::size_t condition : order) {
      trials.push_back({letter(letters[condition]), condition});
    }
  }
  return trials;
}

std::filesystem::path makeSittingFolder(const std::filesystem::path& folder,
                                        const std::string& participant) {
  const std::filesystem::path own = folder / participant;
  std::error_code error;
  std::filesystem::create_directories(own, error);
  for (int number = 1; !error && number <= kMostSittings; ++number) {
    const std::string digits = std::to_string(number);
    const std::filesystem::path sitting =
        own / ("sitting_" + std::string(digits.size() < 2 ? 1 : 0, '0') + digits);
    // Made by this call or by nobody: two programs never share one.
    if (std::filesystem::create_directory(sitting, error)) return sitting;
  }
  throw failure<MessageId::study_folder>(own, error.message());
}

void writeSitting(const std::filesystem::path& folder, const Study& study,
                  const SittingFacts& facts) {
  const std::vector<StudyTrial> trials = trialsOf(study);
  Json order = Json::array();
  Json key = Json::object();
  for (const StudyTrial& trial : trials) {
    order.push_back(trial.blinded);
    key[trial.blinded] = textOfName(study.conditions[trial.condition]);
  }
  const Json sitting{{"relievo_sitting", 1},
                     {"program", facts.program},
                     {"participant", study.participant},
                     {"consent", textOfName(study.consent)},
                     {"started_utc", facts.started_utc},
                     {"input", textOfName(facts.input)},
                     {"input_sha256", facts.sha256},
                     {"order", order}};
  const Json opened{{"relievo_sitting_key", 1},
                    {"participant", study.participant},
                    {"seed", study.seed},
                    {"repetitions", study.repetitions},
                    {"conditions", key}};
  OutputSet set;
  writeTextFile(set.file(folder / "key.json"), opened.dump(2) + "\n");
  writeTextFile(set.file(folder / "sitting.json"), sitting.dump(2) + "\n");
  set.commit();
}

void writeTrials(const std::filesystem::path& folder, const std::vector<TrialRecord>& trials) {
  std::string table = "trial,condition,began_utc,ended_utc,recordings\n";
  for (const TrialRecord& trial : trials) {
    std::string names;
    for (const std::string& name : trial.recordings) {
      names += (names.empty() ? "" : ";") + textOfName(name);
    }
    table += std::to_string(trial.number) + "," + trial.blinded + "," + trial.began_utc + "," +
             trial.ended_utc + "," + inQuotes(names) + "\n";
  }
  writeTextFile(folder / "trials.csv", table);
}

}  // namespace relievo
