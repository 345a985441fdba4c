// SPDX-License-Identifier: BSD-3-Clause
// Everything that haptics says has a translation, and the window says that one, with its parts.
#include "plugins/haptics/spoken_words.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <QCoreApplication>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>
#include <QXmlStreamReader>
#include <string>
#include <vector>

#include "haptics/commands/button_commands.h"
#include "tests/plugins/said_by_haptics.h"
#include "tests/plugins/shouting.h"

namespace relievo {
namespace {

/// What stands in a language's file.
std::map<std::string, QString> translations(const QString& language) {
  QFile file(QStringLiteral(RELIEVO_SOURCE_DIR "/ui/translations/relievo_%1.ts").arg(language));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  std::map<std::string, QString> found;
  QString context, source;
  for (QXmlStreamReader xml(&file); !xml.atEnd();) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
    if (context != QLatin1String("relievo::SpokenWords") || unfinished) continue;
    found[source.toStdString()] = xml.readElementText();
  }
  return found;
}

class Speaking : public QTranslator {
 public:
  explicit Speaking(const QString& language) : words_(translations(language)) {
    QCoreApplication::installTranslator(this);
  }
  ~Speaking() override { QCoreApplication::removeTranslator(this); }
  bool isEmpty() const override { return false; }
  QString translate(const char* /*context*/, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    const auto found = words_.find(source);
    return found == words_.end() ? QString() : found->second;
  }

 private:
  std::map<std::string, QString> words_;
};

QString decoded(const std::string& text) {
  return QString::fromStdString(text);
}

QStringList numbersIn(const QString& text) {
  QStringList numbers;
  static const QRegularExpression kNumber(QStringLiteral("[0-9][0-9.]*[0-9]|[0-9]"));
  for (auto at = kNumber.globalMatch(text); at.hasNext();) numbers << at.next().captured();
  numbers.sort();
  return numbers;
}

class SpokenWords : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { said_ = new test::SaidByHaptics(test::saidByHaptics()); }
  static void TearDownTestSuite() { delete said_; }

  /// In capitals, but for the names.
  static QString shouted(const std::string& sentence) {
    QString text = decoded(sentence).toUpper();
    std::vector<std::string> names(said_->names.begin(), said_->names.end());
    std::sort(names.begin(), names.end(),
              [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const std::string& name : names) text.replace(decoded(name).toUpper(), decoded(name));
    return text;
  }

  static inline const test::SaidByHaptics* said_ = nullptr;
  int argc_ = 0;
  const QCoreApplication application_{argc_, nullptr};
};

TEST_F(SpokenWords, EveryWordOfWhatHapticsSaysIsTranslatedAndNamesAreCarriedOver) {
  const test::Shouting shouting;
  for (const std::string& sentence : said_->sentences) {
    EXPECT_EQ(spokenText(sentence).toStdString(), shouted(sentence).toStdString());
  }
}

TEST_F(SpokenWords, EveryLanguageKnowsThemAndCarriesTheirNumbersOver) {
  for (const char* language : {"de", "hi"}) {
    const Speaking speaking(QString::fromLatin1(language));
    for (const std::string& sentence : said_->sentences) {
      const QString spoken = spokenText(sentence);
      EXPECT_NE(spoken.toStdString(), sentence) << language;
      EXPECT_EQ(numbersIn(spoken), numbersIn(decoded(sentence)))
          << language << ": " << spoken.toStdString();
      for (const std::string& name : said_->names) {
        EXPECT_EQ(spoken.count(decoded(name)), decoded(sentence).count(decoded(name)))
            << language << ": " << spoken.toStdString();
      }
    }
  }
}

/// A sentence that was reworded in haptics leaves its old form behind.
TEST_F(SpokenWords, NothingIsTranslatedThatNobodySays) {
  // Novint's image and an OpenSSL without SHA-256 are not to be had here; libusb loses its context
  // only between two looks for a Falcon that is there.
  const std::set<std::string> cannot_be_brought_about{
      "%1 (recommended)",
      // Needs a hand that holds on in some directions alone.
      "Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, down %4 mm, out %5 mm, "
      "in %6 mm; a hand that holds on moves less.",
      "The hash of the firmware could not be computed. Nothing was loaded. Check that OpenSSL's "
      "library is whole and allows SHA-256.",
      "USB cannot be used"};
  const test::Shouting shouting;
  for (const std::string& sentence : said_->sentences) spokenText(sentence);
  for (const char* language : {"de", "hi"}) {
    for (const auto& [source, translation] : translations(QString::fromLatin1(language))) {
      EXPECT_FALSE(translation.isEmpty()) << language << ": " << source;
      EXPECT_NE(shouting.asked.count(source), cannot_be_brought_about.count(source))
          << language << ": " << source;
    }
  }
}

TEST_F(SpokenWords, AreSaidInTheWindowsLanguage) {
  EXPECT_EQ(spokenText("Finer detail"), "Finer detail");
  const test::Shouting shouting;
  EXPECT_EQ(spokenText(commandWords(ButtonCommand::finer)), "FINER DETAIL");
  EXPECT_EQ(spokenText("nvent_firmware.bin (recommended)"), "nvent_firmware.bin (RECOMMENDED)");
  EXPECT_EQ(spokenText("Nobody has said this."), "Nobody has said this.");
}

TEST_F(SpokenWords, ANameIsNotTakenForAWordOrAPlace) {
  const test::Shouting shouting;
  EXPECT_EQ(spokenText("There is no file \"left\". Nothing was loaded. Check its name."),
            "THERE IS NO FILE \"left\". NOTHING WAS LOADED. CHECK ITS NAME.");
  EXPECT_EQ(spokenText("\"%2\" cannot be read: why. Nothing was loaded. Check its permissions and "
                       "its folder's."),
            "\"%2\" CANNOT BE READ: why. NOTHING WAS LOADED. CHECK ITS PERMISSIONS AND ITS "
            "FOLDER'S.");
}

}  // namespace
}  // namespace relievo
