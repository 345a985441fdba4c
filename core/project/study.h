// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// One sitting of one participant: which conditions are met, how often, and what was agreed to.
struct Study {
  std::string participant;              ///< A code, as isParticipantCode; never a name.
  std::string consent;                  ///< What was agreed to, when and how; not empty.
  std::vector<std::string> conditions;  ///< Names of places; 2 to 26.
  int repetitions = 1;                  ///< 1 to 100.
  std::uint64_t seed = 0;               ///< The same seed gives the same order and names.
};

/// A condition as it is shown: under a letter that says nothing of it.
struct StudyTrial {
  std::string blinded;        ///< "A" to "Z".
  std::size_t condition = 0;  ///< Of Study::conditions.
  friend bool operator==(const StudyTrial&, const StudyTrial&) = default;
};

/// 1 to 32 ASCII letters, digits, '-' and '_': also the name of a folder.
bool isParticipantCode(std::string_view text) noexcept;

/// @throw ArgumentError  no code, no consent, or too few or too many conditions
void check(const Study& study);

/// All conditions once in random order, then again in another one, and so on; none twice in a row.
/// Letters are dealt anew for each seed. The same on every computer. @throw as check
std::vector<StudyTrial> trialsOf(const Study& study);

/// Makes FOLDER/CODE/sitting_01, or the first number that is not there. @throw WriteError
std::filesystem::path makeSittingFolder(const std::filesystem::path& folder,
                                        const std::string& participant);

/// What a sitting was made with, beside the study itself.
struct SittingFacts {
  std::string program;      ///< "relievo 0.2.0".
  std::string input;        ///< File name of what is touched ...
  std::string sha256;       ///< ... and its checksum.
  std::string started_utc;  ///< ISO 8601.
};

/// A trial that began. Times are ISO 8601, UTC.
struct TrialRecord {
  int number = 1;
  std::string blinded, began_utc, ended_utc;  ///< Not ended: empty.
  std::vector<std::string> recordings;        ///< File names in the sitting's folder.
};

/// `sitting.json`: code, consent and order under blinded names; `key.json`: which condition has
/// which letter, and the seed. They take their places together. @throw WriteError
void writeSitting(const std::filesystem::path& folder, const Study& study,
                  const SittingFacts& facts);

/// `trials.csv`: number, condition (blinded), began, ended, recordings; whole each time.
/// @throw WriteError
void writeTrials(const std::filesystem::path& folder, const std::vector<TrialRecord>& trials);

}  // namespace relievo
