// SPDX-License-Identifier: BSD-3-Clause
// Messages in the languages of the catalogue, without a window.
#include "core/message/language.h"

#include <gtest/gtest.h>

#include "core/message/catalogue.h"
#include "ui/translations/message_languages.h"

namespace relievo {
namespace {

TEST(MessageLanguage, HasEverySentenceOfTheTableInGermanAndHindi) {
  ASSERT_EQ(messageLanguages().size(), 3U);
  for (const MessageLanguage& language : messageLanguages().subspan(1)) {
    for (const MessageRow& row : messageRows()) {
      if (row.id == MessageId::quoted) continue;
      for (const std::string_view english : {row.screen, row.spoken}) {
        if (english.empty()) continue;
        const auto found =
            std::find_if(language.sentences.begin(), language.sentences.end(),
                         [&](const TranslatedSentence& s) { return s.english == english; });
        ASSERT_NE(found, language.sentences.end()) << language.tag << ": " << english;
        EXPECT_FALSE(found->translated.empty()) << english;
      }
    }
  }
}

TEST(MessageLanguage, FillsPartsNumbersAndForms) {
  const auto length = [](double cm) {
    return said<MessageId::sayable_nearly>(said<MessageId::sayable_part_cm>(
        NumberArgument{.value = cm, .digits = 1, .form = NumberArgument::Form::trimmed}));
  };
  EXPECT_EQ(textIn(messageLanguage("en"), length(2.5)), "nearly 2.5 centimetres");
  EXPECT_EQ(textIn(messageLanguage("de"), length(2.5)), "knapp 2,5 Zentimeter");
  EXPECT_EQ(textIn(messageLanguage("hi"), length(2.5)), "लगभग 2.5 सेंटीमीटर");
  EXPECT_EQ(textIn(messageLanguage("en"), said<MessageId::sayable_cm>(1)), "1 centimetre");
}

TEST(MessageLanguage, ForEarsItIsTheSentenceForEars) {
  const Message message = said<MessageId::described_not_measured>(
      NumberArgument{.value = 25, .digits = 1, .form = NumberArgument::Form::trimmed},
      said<MessageId::share_quarter>());
  EXPECT_EQ(textIn(messageLanguage("de"), message), "Nicht gemessen: 25 % der Oberfläche.");
  EXPECT_EQ(spokenIn(messageLanguage("de"), message),
            "Nicht gemessen: etwa ein Viertel der Oberfläche.");
}

TEST(MessageLanguage, OfATagOrALocaleAndEnglishForOthers) {
  EXPECT_EQ(messageLanguage("de").tag, "de");
  EXPECT_EQ(messageLanguage("de_AT").tag, "de");
  EXPECT_EQ(messageLanguage("hi-IN").tag, "hi");
  EXPECT_EQ(messageLanguage("en_GB").tag, "en");
  EXPECT_EQ(messageLanguage("fr").tag, "en");
  EXPECT_EQ(messageLanguage("").tag, "en");
}

}  // namespace
}  // namespace relievo
