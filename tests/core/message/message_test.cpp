// SPDX-License-Identifier: BSD-3-Clause
// Messages say their sentence with their parts, make the right error, and cross processes whole.
#include "core/message/message.h"

#include <gtest/gtest.h>

#include <clocale>
#include <set>
#include <string>
#include <utility>

#include "core/base/failure.h"
#include "core/base/task.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

using std::filesystem::path;

template <MessageId id, class... Given>
concept CanBeSaid = requires(Given... given) {
  said<id>(given...);
};

template <MessageId id>
concept CanBeThrown = requires {
  typename ErrorOfKind<FormOfMessage<id>::kKind>::Type;
};

// What does not fit its sentence does not compile.
static_assert(CanBeSaid<MessageId::log_row_unreadable, path, int>);
static_assert(!CanBeSaid<MessageId::log_row_unreadable, path>, "an argument is missing");
static_assert(!CanBeSaid<MessageId::log_row_unreadable, path, int, int>, "one is too many");
static_assert(!CanBeSaid<MessageId::log_row_unreadable, path, double>, "a measure is no count");
static_assert(!CanBeSaid<MessageId::log_row_unreadable, std::string, int>, "a text is no path");
static_assert(!CanBeSaid<MessageId::not_a_zip, path>, "a path is no name");
static_assert(!CanBeSaid<MessageId::memory_needed, int, int, int, int>, "a count has no unit");
static_assert(CanBeThrown<MessageId::not_a_zip>);
static_assert(!CanBeThrown<MessageId::is_read_only>, "a note is not thrown");

TEST(Message, HasItsPartsInItsSentence) {
  EXPECT_EQ(englishText(said<MessageId::log_row_unreadable>(path("a/b.csv"), 12)),
            "The log \"a/b.csv\" has a row that cannot be read: number 12.");
}

TEST(Message, PartsAreNotTakenForPlaces) {
  EXPECT_EQ(englishText(said<MessageId::field_unknown_word>("%2 %1", "%1")),
            "'%2 %1' is not a known '%1'.");
}

TEST(Message, NumbersDoNotFollowTheLocaleOfTheProcess) {
  if (std::setlocale(LC_NUMERIC, "de_DE.UTF-8") == nullptr) GTEST_SKIP() << "no German locale here";
  const NumberArgument fixed{.value = 8.94, .digits = 1};
  const NumberArgument significant{
      .value = 0.25, .digits = 3, .form = NumberArgument::Form::significant};
  const NumberArgument trimmed{.value = 1.50, .digits = 2, .form = NumberArgument::Form::trimmed};
  std::string said;
  for (const NumberArgument& number : {fixed, significant, trimmed}) {
    said += englishText(MessageArgument(number)) + ";";
  }
  std::setlocale(LC_NUMERIC, "C");
  EXPECT_EQ(said, "8.9;0.25;1.5;");
}

TEST(Message, NumbersHaveTheDigitsAndTheUnitThatWereAskedFor) {
  const NumberArgument gigabytes{.value = 4.26, .digits = 1, .unit = MessageUnit::gigabyte};
  const NumberArgument millimetres{.value = 0.012345,
                                   .digits = 3,
                                   .form = NumberArgument::Form::significant,
                                   .unit = MessageUnit::millimetre};
  EXPECT_EQ(englishText(MessageArgument(gigabytes)), "4.3 GB");
  EXPECT_EQ(englishText(MessageArgument(millimetres)), "0.0123 mm");
  EXPECT_EQ(englishText(MessageArgument(CountArgument(1234567))), "1234567");
  EXPECT_EQ(englishText(MessageArgument(CountArgument::grouped(1234567))), "1 234 567");
  EXPECT_EQ(englishText(MessageArgument(CountArgument::grouped(~std::uint64_t{0}))),
            "18 446 744 073 709 551 615");
  EXPECT_EQ(englishText(MessageArgument(CountArgument(-1))), "-1");
}

TEST(Message, ACauseIsSaidWithinAndInBracketsWithoutItsFullStop) {
  const Message cause = said<MessageId::field_not_whole>("level");
  EXPECT_EQ(englishText(said<MessageId::state_unreadable>("a.png", cause)),
            "a.png holds no state that this version can read. 'level' is not a whole number. "
            "Nothing was changed.");
  EXPECT_EQ(englishText(said<MessageId::project_damaged>("a", WordsArgument::clause(cause))),
            "The project a is damaged ('level' is not a whole number). Nothing was changed. Choose "
            "another file.");
}

TEST(Message, CountsTakeTheFormOfTheirNumber) {
  const auto text = [](std::int64_t samples) {
    return englishText(said<MessageId::recording_stopped_disk_full>(samples, path("a.csv")));
  };
  EXPECT_EQ(text(1), "Recording stopped: disk full. 1 sample is saved and complete in \"a.csv\".");
  for (const std::int64_t samples : {0, 2, 11, 21}) {
    EXPECT_EQ(text(samples), "Recording stopped: disk full. " + std::to_string(samples) +
                                 " samples are saved and complete in \"a.csv\".");
  }
}

TEST(Message, BracesOfNamesAreNoForms) {
  EXPECT_EQ(englishText(said<MessageId::recording_stopped>("{1|a|b}", 1, path("{2|c|d}"))),
            "Recording stopped: {1|a|b}. 1 sample is saved and complete in \"{2|c|d}\".");
  EXPECT_EQ(withForms(std::string("{x} {1| {"), [](int) { return true; }), "{x}  {");
}

TEST(Message, SentencesStandOneAfterTheOther) {
  const std::vector<Message> two{said<MessageId::pose_of_reference>(),
                                 said<MessageId::pose_as_stored>()};
  EXPECT_EQ(englishText(two), "The reference. As stored.");
  EXPECT_EQ(englishText(said<MessageId::scan_left_out>("a.ply", WordsArgument::sentences(two))),
            "a.ply was left out: The reference. As stored.");
}

TEST(Message, ForEarsItIsTheShorterSentenceWhereThereIsOne) {
  EXPECT_EQ(englishSpoken(said<MessageId::falcon_busy>()), "The Falcon is busy.");
  EXPECT_EQ(englishSpoken(said<MessageId::not_a_zip>("a")),
            englishText(said<MessageId::not_a_zip>("a")));
}

TEST(Message, AnErrorSaysItsSentenceItsCodeAndKeepsTheMessage) {
  const FileError error = failure<MessageId::packed_file_missing>(path("scan.ply"));
  EXPECT_STREQ(error.what(),
               "'scan.ply' is not there. Nothing was packed. Relink it, or take it out of the "
               "project.");
  EXPECT_EQ(error.code, "E501");
  ASSERT_TRUE(error.message);
  EXPECT_EQ(error.message->id, MessageId::packed_file_missing);
  EXPECT_FALSE(FileError("Some text.").message);
}

TEST(Message, WhatIsThrownIsOfTheKindThatTheTableSays) {
  EXPECT_THROW(throw failure<MessageId::too_few_cells>(), ArgumentError);
  EXPECT_THROW(throw failure<MessageId::hdf5_not_written>(), WriteError);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((Task{stop.get_token(), {}}.check()), Cancelled);
}

TEST(Message, OfAnErrorThatIsNotInTheTableItsTextIsQuoted) {
  EXPECT_EQ(englishText(messageOf(std::runtime_error("100 %1 wrong"))), "100 %1 wrong");
  const FileError ours = failure<MessageId::field_not_whole>("a");
  EXPECT_EQ(messageOf(ours).id, MessageId::field_not_whole);
}

TEST(Message, CrossesProcessesAsBytes) {
  const Message sent =
      said<MessageId::state_unreadable>("a %1", said<MessageId::field_count>("x", -3));
  const auto received = messageFromBytes(messageBytes(sent));
  ASSERT_TRUE(received);
  EXPECT_EQ(received->id, sent.id);
  EXPECT_EQ(englishText(*received), englishText(sent));
  const NumberArgument gigabytes{.value = 1.5, .digits = 1, .unit = MessageUnit::gigabyte};
  const Message measured =
      said<MessageId::memory_needed>(gigabytes, gigabytes, gigabytes, gigabytes);
  EXPECT_EQ(englishText(messageFromBytes(messageBytes(measured)).value()), englishText(measured));
}

TEST(Message, CrossesAsDeepAsItNests) {
  const Message along = said<MessageId::motion_along>(
      said<MessageId::direction>(NumberArgument{}, NumberArgument{}, NumberArgument{}));
  const Message refused = said<MessageId::pose_refused>(said<MessageId::pose_undecided>(along));
  const Message deep = said<MessageId::scan_left_out>("b.ply", WordsArgument::sentences({refused}));
  const auto received = messageFromBytes(messageBytes(deep));
  ASSERT_TRUE(received);
  EXPECT_EQ(englishText(*received), englishText(deep));
}

TEST(Message, OfBytesThatAreNoMessageIsNone) {
  const std::string whole =
      messageBytes(said<MessageId::state_unreadable>("a", said<MessageId::field_count>("x", 3)));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(messageFromBytes(std::string_view(whole).substr(0, size))) << size;
  }
  EXPECT_FALSE(messageFromBytes(whole + '\0'));
  EXPECT_FALSE(messageFromBytes("\xff\xff"));
  // Every byte changed: whatever comes back can be said.
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (int value = 0; value < 256; ++value) {
      std::string bytes = whole;
      bytes[at] = static_cast<char>(value);
      if (const auto message = messageFromBytes(bytes)) englishText(*message);
    }
  }
}

TEST(Catalogue, EveryMessageHasASentenceAndNoTwoAreTheSame) {
  std::set<std::pair<std::string, std::string>> sentences;
  std::size_t number = 0;
  for (const MessageRow& row : messageRows()) {
    EXPECT_EQ(static_cast<std::size_t>(row.id), number++) << row.name;
    EXPECT_NE(std::string(row.screen), "") << row.name;
    // The same for the screen with other words for ears is another message.
    EXPECT_TRUE(sentences.insert({row.screen, row.spoken}).second)
        << row.name << ": " << row.screen;
  }
  EXPECT_GT(number, 90U);
}

TEST(Catalogue, WhatIsThrownEndsAsASentenceDoes) {
  for (const MessageRow& row : messageRows()) {
    if (row.kind == MessageKind::note) continue;
    const std::string_view sentence = row.screen;
    EXPECT_TRUE(sentence.ends_with('.') || sentence.ends_with('?') || sentence.ends_with("%2"))
        << row.name;
  }
}

}  // namespace
}  // namespace relievo
