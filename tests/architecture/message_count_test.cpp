// SPDX-License-Identifier: BSD-3-Clause
// How many sentences are still outside the catalogue of messages (docs/adr/0142). The number only
// sinks: whoever moves a sentence writes the new one here.
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "tests/architecture/source_tree.h"

namespace relievo::architecture {
namespace {

/// Errors that are made of a sentence where they are thrown.
constexpr int kSentencesLeft = 17;

int countOf(const std::string& text, const std::regex& pattern) {
  return static_cast<int>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), {}));
}

/// `throw FileError("...` and the like; not what quotes a message, nor a whole `Message message`,
/// and not a declaration.
int sentencesIn(const std::string& text) {
  static const std::regex kMade(
      "(throw|return) (relievo::)?(Argument|File|Write|Device|Graphics|ChangedInput)Error\\("
      "(?!said<|messageOf\\(|\\*?message\\))");
  return countOf(text, kMade);
}

bool isOfTheProgram(const std::string& path) {
  return isCpp(path) && !path.starts_with("tests/") && !path.starts_with("data/");
}

TEST(MessageCount, OfSentencesOutsideTheCatalogueSinks) {
  int left = 0;
  for (const auto& [path, text] : readTree(isOfTheProgram)) left += sentencesIn(text);
  EXPECT_EQ(left, kSentencesLeft);
}

TEST(MessageCount, NoFileRecognisesSentencesByPatterns) {
  static const std::regex kPattern("QRegularExpression::(escape|anchoredPattern)");
  for (const auto& [path, text] : readTree(isOfTheProgram)) {
    if (path == "ui/panels/replay_events.cpp") continue;  // Events of recordings, which are files.
    EXPECT_EQ(countOf(text, kPattern), 0) << path;
  }
}

/// Whoever adds a message then compiles again what says messages, and nothing else.
TEST(MessageCount, NoHeaderTakesTheNamesOfMessages) {
  static const std::regex kNames("#include \"core/(base/failure|message/catalogue)\\.h\"");
  for (const auto& [path, text] : readTree(isOfTheProgram)) {
    if (!path.ends_with(".h") || path == "core/base/failure.h") continue;
    EXPECT_EQ(countOf(text, kNames), 0) << path;
  }
}

TEST(MessageCount, SeesWhatIsCounted) {
  EXPECT_EQ(sentencesIn("throw FileError(\"x\"); return WriteError(name + \"y\");"), 2);
  EXPECT_EQ(sentencesIn("throw failure<MessageId::cancelled>(); throw FileError(messageOf(e));"),
            0);
  EXPECT_EQ(sentencesIn("throw ArgumentError(message); throw DeviceError(*message);"), 0);
  EXPECT_EQ(sentencesIn("throw FileError(message + \"x\"); throw FileError(message_text);"), 2);
}

}  // namespace
}  // namespace relievo::architecture
