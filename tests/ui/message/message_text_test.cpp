// SPDX-License-Identifier: BSD-3-Clause
// Every message of the catalogue has its German and its Hindi, and a window shows them with the
// parts of the message.
#include "ui/message/message_text.h"

#include <gtest/gtest.h>

#include <map>
#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QTranslator>
#include <QXmlStreamReader>
#include <regex>
#include <set>
#include <span>
#include <string>

#include "core/base/failure.h"

namespace relievo {
namespace {

using std::filesystem::path;

/// What stands in a language's file under the catalogue's context.
std::map<std::string, QString> translations(const std::string& language) {
  QFile file(QStringLiteral(RELIEVO_SOURCE_DIR "/ui/translations/relievo_%1.ts")
                 .arg(QString::fromStdString(language)));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  std::map<std::string, QString> found;
  QString context, source;
  for (QXmlStreamReader xml(&file); !xml.atEnd();) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
    if (context != QLatin1String(kMessageContext) || unfinished) continue;
    found[source.toStdString()] = xml.readElementText();
  }
  return found;
}

/// The sentences of the table; the words of others have no translation.
std::set<std::string> sentences() {
  std::set<std::string> all;
  for (const MessageRow& row : messageRows()) {
    if (row.id != MessageId::quoted) all.insert(row.screen);
    if (row.spoken[0] != '\0') all.insert(row.spoken);
  }
  return all;
}

std::multiset<char> placesOf(const std::string& sentence) {
  std::multiset<char> places;
  for (std::size_t i = 0; i + 1 < sentence.size(); ++i) {
    if (sentence[i] == '%' && sentence[i + 1] >= '1' && sentence[i + 1] <= '9') {
      places.insert(sentence[i + 1]);
    }
  }
  return places;
}

class Language : public QTranslator {
 public:
  explicit Language(const std::string& language) : words_(translations(language)) {
    QCoreApplication::installTranslator(this);
  }
  ~Language() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    if (std::string_view(context) != kMessageContext) return {};
    const auto found = words_.find(source);
    return found == words_.end() ? QString() : found->second;
  }

 private:
  std::map<std::string, QString> words_;
};

class MessageTextTest : public ::testing::Test {
 protected:
  ~MessageTextTest() override { QLocale::setDefault(QLocale::c()); }
  int argc_ = 0;
  const QCoreApplication application_{argc_, nullptr};
};

TEST_F(MessageTextTest, EverySentenceOfTheTableHasEveryLanguageAndNoOtherHas) {
  for (const std::string language : {"de", "hi"}) {
    const auto known = translations(language);
    for (const std::string& sentence : sentences()) {
      EXPECT_TRUE(known.count(sentence) == 1 && !known.at(sentence).isEmpty())
          << language << ": " << sentence;
    }
    for (const auto& [source, translation] : known) {
      EXPECT_EQ(sentences().count(source), 1U) << language << ", nobody says: " << source;
    }
  }
}

TEST_F(MessageTextTest, TranslationsHaveThePlacesOfTheirSentences) {
  for (const std::string language : {"de", "hi"}) {
    for (const auto& [source, translation] : translations(language)) {
      for (const bool one : {true, false}) {
        const auto form = [one](int) { return one; };
        EXPECT_EQ(placesOf(withForms(translation.toStdString(), form)),
                  placesOf(withForms(source, form)))
            << language << ": " << source;
      }
    }
  }
}

/// "{1|...|...}" of counts, and nothing that only looks like it.
TEST_F(MessageTextTest, TranslationsHaveFormsOfNumberOfCountsAlone) {
  std::map<std::string, std::span<const std::size_t>> types;
  for (const MessageRow& row : messageRows()) types[row.screen] = row.arguments;
  for (const std::string language : {"de", "hi"}) {
    for (const auto& [source, translation] : translations(language)) {
      std::string text = translation.toStdString();
      static const std::regex kForm("\\{([1-9])\\|[^{}|]*\\|[^{}|]*\\}");
      for (std::smatch form; std::regex_search(text, form, kForm); text = form.suffix()) {
        const auto place = static_cast<std::size_t>(form.str(1)[0] - '1');
        ASSERT_LT(place, types[source].size()) << language << ": " << source;
        EXPECT_EQ(types[source][place], typeOfArgument<CountArgument>())
            << language << ": " << source;
      }
      EXPECT_EQ(text.find_first_of("{}"), std::string::npos) << language << ": " << source;
    }
  }
}

TEST_F(MessageTextTest, CountsTakeTheFormOfTheirNumberInTheLanguage) {
  const auto text = [](int samples) {
    return messageText(said<MessageId::recording_stopped_disk_full>(samples, path("a.csv")));
  };
  {
    const Language german("de");
    QLocale::setDefault(QLocale(QLocale::German));
    EXPECT_TRUE(text(1).contains("1 Abtastwert ist")) << text(1).toStdString();
    EXPECT_TRUE(text(0).contains("0 Abtastwerte sind")) << text(0).toStdString();
    EXPECT_TRUE(text(2).contains("2 Abtastwerte sind")) << text(2).toStdString();
  }
  const Language hindi("hi");
  QLocale::setDefault(QLocale(QLocale::Hindi));
  const QString one = QString::fromUtf8("नमूना"), more = QString::fromUtf8("नमूने");
  EXPECT_TRUE(text(1).contains(one) && text(0).contains(one)) << text(0).toStdString();
  EXPECT_TRUE(text(2).contains(more)) << text(2).toStdString();
}

TEST_F(MessageTextTest, ListsAndNestedWordsAreInTheLanguage) {
  const Language german("de");
  const Message missing = said<MessageId::falcon_homing>(
      WordsArgument({said<MessageId::falcon_arm_top>(), said<MessageId::falcon_arm_left>()}));
  const QString text = messageText(missing);
  EXPECT_TRUE(text.contains(messageText(said<MessageId::falcon_arm_top>()) + ", " +
                            messageText(said<MessageId::falcon_arm_left>())))
      << text.toStdString();
  EXPECT_FALSE(text.contains("left")) << text.toStdString();
  EXPECT_NE(spokenMessage(missing), text);
}

TEST_F(MessageTextTest, IsEnglishWithoutATranslation) {
  const Message message = said<MessageId::log_row_unreadable>(path("a.csv"), 12);
  EXPECT_EQ(messageText(message).toStdString(), englishText(message));
}

TEST_F(MessageTextTest, IsInTheLanguageWithItsPartsAsTheyAre) {
  const Language german("de");
  EXPECT_EQ(messageText(said<MessageId::log_row_unreadable>(path("%2 ä.csv"), 12)),
            QString::fromUtf8("Die Aufzeichnung „%2 ä.csv“ hat eine Zeile, die nicht gelesen "
                              "werden kann: Nummer 12."));
  EXPECT_EQ(messageText(messageOf(std::runtime_error("Words of a library."))),
            "Words of a library.");
}

TEST_F(MessageTextTest, ACauseIsInTheLanguageToo) {
  for (const std::string language : {"de", "hi"}) {
    const Language spoken(language);
    const Message cause = said<MessageId::field_not_whole>("level");
    const QString text =
        messageText(said<MessageId::project_damaged>("a", WordsArgument::clause(cause)));
    const QString sentence = messageText(cause);
    EXPECT_NE(sentence.toStdString(), englishText(cause));
    EXPECT_TRUE(text.contains(sentence.chopped(1) + ')')) << text.toStdString();
  }
}

TEST_F(MessageTextTest, NumbersAreThoseOfTheLocale) {
  const auto millimetres = [](double mm) {
    return NumberArgument{.value = mm, .digits = 3, .form = NumberArgument::Form::trimmed};
  };
  const Message where = said<MessageId::no_surface_at>(millimetres(1234.5), millimetres(2));
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_TRUE(messageText(where).contains("x 1234,5, y 2 mm")) << messageText(where).toStdString();
  QLocale::setDefault(QLocale(QLocale::English));
  EXPECT_TRUE(messageText(where).contains("x 1234.5, y 2 mm")) << messageText(where).toStdString();
  const Message many =
      said<MessageId::package_unpacks_too_large>("a.zip", CountArgument::grouped(1234567), 200);
  QLocale::setDefault(QLocale(QLocale::German));
  EXPECT_TRUE(messageText(many).contains("1.234.567 bytes")) << messageText(many).toStdString();
}

}  // namespace
}  // namespace relievo
