// SPDX-License-Identifier: BSD-3-Clause
// Translations are whole, every text goes through them, and nothing is cut when texts grow.
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSet>
#include <QTextStream>
#include <QToolBar>
#include <QToolButton>
#include <QTranslator>
#include <QtTest/QTest>
#include <QXmlStreamReader>

#include "core/base/failure.h"
#include "core/message/message.h"
#include "core/relief/relief_image.h"
#include "core/relief/stereo.h"
#include "core/session/large/memory_guard.h"
#include "tests/ui/gui_fixture.h"
#include "ui/dialogs/depth_map_dialog.h"
#include "ui/figure/figure.h"
#include "ui/language/error_text.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"

namespace relievo {
namespace {

/// Another language that nobody speaks: accents on every vowel, a third longer, between brackets.
/// What the window shows without brackets did not come from a translation.
class PseudoTranslator : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                    int n) const override {
    const QString from = QString::fromUtf8(context);
    if (!from.startsWith("relievo") && from != "Text" && from != "Core") return {};
    QString text = QString::fromUtf8(source);
    if (n >= 0) text.replace("%n", QString::number(n));
    constexpr std::array<std::pair<char16_t, char16_t>, 5> kAccents{
        {{u'a', u'á'}, {u'e', u'é'}, {u'i', u'í'}, {u'o', u'ó'}, {u'u', u'ü'}}};
    bool inside = false;  // Of a tag, whose name must stay.
    for (QChar& c : text) {
      if (c == '<') inside = true;
      if (c == '>') inside = false;
      for (const auto& [plain, accented] : kAccents) {
        if (!inside && c == QChar(plain)) c = QChar(accented);
      }
    }
    return QChar(0x27e6) + text + QString(1 + text.size() / 3, '~') + QChar(0x27e7);
  }
};

bool isTranslated(const QString& text) {
  if (text.contains(QChar(0x27e6))) return true;
  // Units, numbers, letters of axes, names of files and of the program are no words.
  static const QSet<QString> kNames{"relievo", "relief", "ply",    "mm",      "Ctrl",    "Shift",
                                    "Alt",     "Esc",    "Return", "English", "Deutsch", "Dubois"};
  QString word;
  for (const QChar c : text + ' ') {
    if (c.isLetter()) {
      word += c;
    } else {
      if (word.size() > 2 && !kNames.contains(word)) return false;
      word.clear();
    }
  }
  return true;
}

/// What tasks tell of themselves, from the sources.
QStringList stepsOfWork() {
  static const QRegularExpression kStep(QStringLiteral("\\.report\\(\\s*\"([^\"]+)\""));
  QStringList steps;
  for (const char* folder : {"/core", "/ui"}) {
    QDirIterator files(QStringLiteral(RELIEVO_SOURCE_DIR) + QLatin1String(folder), {"*.cpp"},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
      QFile file(files.next());
      EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << file.fileName().toStdString();
      auto found = kStep.globalMatch(QString::fromUtf8(file.readAll()));
      while (found.hasNext()) steps << found.next().captured(1);
    }
  }
  steps.removeDuplicates();
  return steps;
}

TEST(StepsOfWork, AreWordsOfEachLanguage) {
  const QStringList steps = stepsOfWork();
  ASSERT_GT(steps.size(), 25) << "they are told in another way now";
  for (const char* language : {"de", "hi"}) {
    QTranslator translator;
    ASSERT_TRUE(translator.load(
        QStringLiteral(":/translations/relievo_%1.qm").arg(QLatin1String(language))));
    for (const QString& step : steps) {
      EXPECT_FALSE(translator.translate("Core", step.toUtf8().constData()).isEmpty())
          << language << ": " << step.toStdString();
    }
  }
}

class PseudoTest : public GuiTest {
 protected:
  PseudoTest() {
    QCoreApplication::installTranslator(&pseudo_);
    restart();
  }
  ~PseudoTest() override { QCoreApplication::removeTranslator(&pseudo_); }

  /// Every text of a widget and its children that people see or hear.
  static QStringList untranslated(const QWidget& of) {
    QStringList found;
    const auto look = [&](const QObject* at, const QString& text) {
      // Names of files.
      if (at->objectName() == "surface_file" || text.contains(".ply")) return;
      if (!isTranslated(text)) found << at->objectName() + ": " + text;
    };
    QList<QWidget*> all = of.findChildren<QWidget*>();
    for (const auto* w : all) {
      look(w, w->toolTip());
      look(w, w->accessibleName());
      if (w->isWindow()) look(w, w->windowTitle());
      if (const auto* label = qobject_cast<const QLabel*>(w)) look(w, label->text());
      if (const auto* button = qobject_cast<const QAbstractButton*>(w)) look(w, button->text());
      if (const auto* box = qobject_cast<const QGroupBox*>(w)) look(w, box->title());
      if (const auto* box = qobject_cast<const QComboBox*>(w)) {
        for (int i = 0; i < box->count(); ++i) look(w, box->itemText(i));
      }
    }
    for (const auto* action : of.findChildren<QAction*>()) {
      if (action->objectName().startsWith("qt_") ||
          action->objectName() == "_q_qlineeditclearaction") {
        continue;
      }
      look(action, action->text());
      look(action, action->toolTip());
    }
    return found;
  }

  PseudoTranslator pseudo_;
};

TEST_F(PseudoTest, TheWindowShowsNothingUntranslated) {
  openRelief();
  window().setWindowTitle({});
  EXPECT_EQ(untranslated(window()).join('\n').toStdString(), "");
}

/// Errors as core says them: the files that cause them are real.
TEST_F(PseudoTest, FrequentErrorsOfFilesAreTranslated) {
  QFile(path("empty.ply")).open(QIODevice::WriteOnly);
  QFile headless(path("headless.ply")), pointless(path("pointless.xyz"));
  ASSERT_TRUE(headless.open(QIODevice::WriteOnly) && pointless.open(QIODevice::WriteOnly));
  headless.write("ply\nformat ascii 1.0\n");
  pointless.write("hello\n");
  QFile picture(path("picture.jpg"));
  ASSERT_TRUE(picture.open(QIODevice::WriteOnly));
  picture.write("\xff\xd8\xff\xe0 a photograph");
  picture.close();
  headless.close();
  pointless.close();
  QFile whole(writeRelief("cut.ply"));
  ASSERT_TRUE(whole.resize(whole.size() / 2));
  for (const char* name : {"missing.ply", "empty.ply", "headless.ply", "pointless.xyz", "cut.ply",
                           "picture.jpg", ""}) {
    window().open(path(name));
    ASSERT_TRUE(
        waitFor([&] { return !window().message().isEmpty() && !document().loader().busy(); }));
    const QString said = window().message();
    EXPECT_TRUE(said.startsWith(QString::fromUtf8("⟦Cánnót réád ")) &&
                said.contains(QString::fromLatin1(name)))
        << name << ": " << said.toStdString();
  }
}

TEST_F(PseudoTest, ErrorsOfProjectsAndOfOddFilesAreTranslatedAndNameNoLibrary) {
  const auto write = [&](const char* name, const QByteArray& bytes) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  };
  write("broken.relievo.json", "{\n \"relievo_project\": 2,\n oops");
  write("part.relievo.json", "{\"relievo_project\": 2}");
  write("newer.relievo.json", "{\"relievo_project\": 99}");
  write("other.relievo.json", "{\"a\": 1}");
  write("flat.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n");
  for (const char* name : {"broken.relievo.json", "part.relievo.json", "newer.relievo.json",
                           "other.relievo.json", "flat.ply"}) {
    window().open(path(name));
    ASSERT_TRUE(waitFor([&] { return window().message().contains(name); })) << name;
    const QString said = window().message();
    EXPECT_TRUE(said.startsWith(QChar(0x27e6))) << said.toStdString();
    EXPECT_FALSE(said.contains("exception")) << said.toStdString();
    if (name == std::string("broken.relievo.json")) {
      EXPECT_TRUE(said.contains(" 3)")) << "the line: " << said.toStdString();
    }
  }
}

TEST_F(PseudoTest, TheDepthMapsDialogSaysOfAnUnknownUnitInTheWindowsLanguage) {
  window().open(writeRelief());
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  ASSERT_EQ(document().surface()->unit_source, UnitSource::assumed);
  ASSERT_TRUE(window().runCommand("depth_map"));
  const auto* dialog = window().findChild<DepthMapDialog*>();
  ASSERT_TRUE(waitFor([dialog] { return !dialog->isStale(); }));
  EXPECT_FALSE(dialog->summary().contains("one file unit")) << dialog->summary().toStdString();
  EXPECT_TRUE(dialog->summary().contains(QString::fromUtf8("cárry nó ünít")))
      << dialog->summary().toStdString();
}

TEST_F(PseudoTest, ErrorsOfMemoryAndDiskAreTranslatedAndOthersStayAsTheyAre) {
  QString memory;
  try {
    requireMemory({{100000, 100000}, 0.1, 0, 0}, 1'000'000'000);
  } catch (const Error& error) {
    memory = spokenError(error);
  }
  EXPECT_TRUE(memory.contains(QString::fromUtf8("ábóüt"))) << memory.toStdString();
  const WriteError full =
      failure<MessageId::recording_stopped_disk_full>(12, std::filesystem::path("%1"));
  EXPECT_TRUE(spokenError(full).contains("\"%1\".")) << "a name is not filled in again";
  EXPECT_NE(spokenError(full), full.what());
  EXPECT_EQ(spokenError(FileError("This is new.")), "This is new.");
  EXPECT_EQ(shownError(full), spokenError(full) + " (E401)");
  EXPECT_EQ(shownError(QStringLiteral("This is new."), "E401"), "This is new. (E401)");
  EXPECT_EQ(shownError(FileError("It is gone (E501).", "E501")), "It is gone (E501).");
  EXPECT_EQ(shownError(FileError("It is odd.")), "It is odd.");
}

TEST_F(PseudoTest, WhatFiguresAreRefusedForIsTranslated) {
  const auto refused = [](const auto& work) {
    try {
      work();
    } catch (const Error& error) {
      return spokenError(error);
    }
    return QString("not refused");
  };
  const std::filesystem::path folder = path("").toStdString();
  const std::filesystem::path figure = folder / "figure.tif";
  const auto named = [&](const FigureFiles& files) { return refused([&] { check(files); }); };
  for (const QString& said :
       {named({.figure = folder / "figure.doc"}),
        named({.figure = figure, .heights = folder / "heights.png"}),
        named({.figure = figure, .heights = figure}), named({.figure = figure, .caption = folder}),
        refused([] { checkZeroPlane(999, 0, 10, 10); }), refused([] {
          checkRange({.range = {{2, 1}}});
        })}) {
    EXPECT_TRUE(said.startsWith(QChar(0x27e6))) << said.toStdString();
  }
}

TEST_F(PseudoTest, DialogsShowNothingUntranslated) {
  openRelief();
  for (const char* command :
       {"preferences", "keys", "figure", "depth_map", "prepare", "image", "history"}) {
    window().runCommand(command);
    QApplication::processEvents();
    int judged = 0;
    for (auto* dialog : window().findChildren<QDialog*>()) {
      if (!dialog->isVisible()) continue;
      EXPECT_EQ(untranslated(*dialog).join('\n').toStdString(), "") << command;
      dialog->close();
      ++judged;
    }
    EXPECT_EQ(judged, 1) << command;
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
}

/// The words that docs/notation.md replaced: no sentence of window or plug-ins says them.
TEST(Words, ThoseOfBeforeAreNotShown) {
  QFile file(QStringLiteral(RELIEVO_SOURCE_DIR "/ui/translations/relievo_de.ts"));
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  const QString sources = QString::fromUtf8(file.readAll());
  const QRegularExpression source(QStringLiteral("<source>(.*?)</source>"),
                                  QRegularExpression::DotMatchesEverythingOption);
  // A scan that others are aligned to is the reference; sounds knock and tick, commands do not.
  const QRegularExpression before(QStringLiteral(
      "\\b(Gain|gain:|Detail [0-9%]|flyers?|Engine|Beacons?|Lit stone|Edge tick|Contact tick|"
      "Firm ground|Reference view|M between|Hiccups?)\\b"));
  int sentences = 0;
  for (auto each = source.globalMatch(sources); each.hasNext(); ++sentences) {
    const QString words = each.next().captured(1);
    EXPECT_FALSE(before.match(words).hasMatch()) << words.toStdString();
  }
  EXPECT_GT(sentences, 1000);
}

/// The window in German.
class GermanTest : public GuiTest {
 protected:
  GermanTest() {
    EXPECT_TRUE(german_.load(QStringLiteral(":/translations/relievo_de.qm")));
    QCoreApplication::installTranslator(&german_);
    restart();
  }
  ~GermanTest() override { QCoreApplication::removeTranslator(&german_); }

  /// A coloured cloud of a survey, in metres that it does not state, and six points far off.
  QString writeSurvey() const {
    QFile file(path("survey.ply"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    constexpr int kSide = 120, kStrays = 6;
    QTextStream text(&file);
    text << "ply\nformat ascii 1.0\nelement vertex " << kSide * kSide + kStrays
         << "\nproperty double x\nproperty double y\nproperty double z\nproperty uchar red\n"
            "property uchar green\nproperty uchar blue\nend_header\n";
    for (int i = 0; i < kSide * kSide; ++i) {
      text << 512000 + i % kSide << ' ' << 5403000 + i / kSide << ' ' << i % 7 << " 200 100 50\n";
    }
    for (int i = 0; i < kStrays; ++i) {
      text << 522000 + 400 * i << ' ' << 5398000 + 700 * i << " 3 200 100 50\n";
    }
    return file.fileName();
  }

  QTranslator german_;
};

TEST_F(GermanTest, LargeTextOfTheUnitsQuestionLeavesRoomForTheViews) {
  window().resize(1440, 900);
  window().settings().setChoice("text_percent", 300);
  applyTextSize(300);
  QFile file(path("plain.xyz"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  for (int i = 0; i < 1600; ++i) {
    file.write(QByteArray::number(i % 40) + ' ' + QByteArray::number(i / 40) + ' ' +
               QByteArray::number(i % 7) + '\n');
  }
  file.close();
  window().open(file.fileName());
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  ASSERT_TRUE(waitFor([this] { return window().message().contains("Einheit"); }))
      << window().message().toStdString();
  QApplication::processEvents();
  EXPECT_GE(window().detailView().height(), 200);
  EXPECT_GE(window().detailView().width(), 200);
  applyTextSize(kLeastTextPercent);
}

TEST_F(GermanTest, WhatASurfaceSaysOfItselfIsGerman) {
  window().open(writeSurvey());
  ASSERT_TRUE(waitFor([this] { return document().isOpen() && !document().loader().busy(); }));
  const Surface& surface = *document().surface();
  ASSERT_EQ(surface.unit_source, UnitSource::guessed);
  ASSERT_EQ(surface.strays.points, 6U);
  ASSERT_FALSE(surface.colours.empty());
  ASSERT_GE(surface.messages.size(), 5U);
  const QString tip = child<QLabel>("surface_cells")->toolTip();
  ASSERT_TRUE(window().runCommand("depth_map"));
  const auto* dialog = window().findChild<DepthMapDialog*>();
  ASSERT_TRUE(waitFor([dialog] { return !dialog->isStale(); }));
  EXPECT_EQ(tip.split('\n').size(), static_cast<int>(surface.messages.size()));
  for (const Message& message : surface.messages) {
    const QString english = QString::fromStdString(englishText(message));
    EXPECT_FALSE(tip.contains(english)) << english.toStdString();
    EXPECT_FALSE(dialog->summary().contains(english)) << english.toStdString();
  }
  for (const char* words :
       {"von allen anderen entfernt", "eine Vermutung", "Der Scan hat Farben"}) {
    EXPECT_TRUE(tip.contains(words)) << words << " in: " << tip.toStdString();
  }
}

/// Labels and buttons that show less than their text.
QStringList cutTexts(const QWidget& of) {
  QStringList found;
  for (const auto* w : of.findChildren<QWidget*>()) {
    if (!w->isVisibleTo(&of)) continue;
    QString text;
    int needed = 0;
    if (const auto* label = qobject_cast<const QLabel*>(w)) {
      text = label->text();
      needed = label->wordWrap() ? label->heightForWidth(label->width()) - label->height()
                                 : label->sizeHint().width() - label->width();
    } else if (const auto* button = qobject_cast<const QAbstractButton*>(w)) {
      text = button->text();
      const auto* tool = qobject_cast<const QToolButton*>(w);
      if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly) continue;
      const int words = button->fontMetrics().size(Qt::TextShowMnemonic, text).width();
      const int picture = button->icon().isNull() ? 0 : button->iconSize().width() + 4;
      needed = words + picture + 4 - button->width();
    } else {
      continue;
    }
    if (!text.isEmpty() && needed > 1) {
      found << QStringLiteral("%1 (%2): %3").arg(w->objectName(), QString::number(needed), text);
    }
  }
  return found;
}

TEST_F(PseudoTest, LongerTextsAreNotCut) {
  window().resize(1440, 900);
  openRelief();
  QApplication::processEvents();
  EXPECT_EQ(cutTexts(window()).join('\n').toStdString(), "");
}

class TextSizeTest : public GuiTest, public ::testing::WithParamInterface<int> {
 protected:
  ~TextSizeTest() override { applyTextSize(100); }
};

TEST_P(TextSizeTest, NothingIsCutInTheSmallestWindow) {
  window().settings().setChoice("text_percent", GetParam());
  restart();
  const QSize smallest = GetParam() > 200 ? QSize(1440, 900) : QSize(1024, 640);
  window().resize(smallest);
  openRelief();
  QApplication::processEvents();
  EXPECT_EQ(cutTexts(window()).join('\n').toStdString(), "");
  EXPECT_LE(window().width(), smallest.width()) << "the window must not grow beyond the screen";
  EXPECT_LE(window().height(), smallest.height());
}
INSTANTIATE_TEST_SUITE_P(Percent, TextSizeTest, ::testing::Values(100, 200, 300));

class MnemonicTest : public GuiTest, public ::testing::WithParamInterface<const char*> {
 protected:
  MnemonicTest() {
    EXPECT_TRUE(translator_.load(QStringLiteral(":/translations/relievo_%1.qm").arg(GetParam())));
    QCoreApplication::installTranslator(&translator_);
    restart();
  }
  ~MnemonicTest() override { QCoreApplication::removeTranslator(&translator_); }

  QTranslator translator_;
};

TEST_P(MnemonicTest, DoNotRepeatWithinAMenuAndStandInGermanWords) {
  int letters = 0;
  for (const QMenu* menu : window().findChildren<QMenu*>()) {
    QString seen;
    for (const QAction* a : menu->actions()) {
      if (a->isSeparator() || a->objectName().startsWith("_q_")) continue;
      const int at = a->text().indexOf('&');
      ASSERT_GE(at, 0) << a->text().toStdString();
      const QChar letter = a->text()[at + 1].toLower();
      EXPECT_FALSE(seen.contains(letter)) << menu->title().toStdString() << ": "
                                          << seen.toStdString() << ", " << a->text().toStdString();
      seen += letter;
      if (GetParam() == std::string("de")) {
        EXPECT_FALSE(a->text().contains("(&")) << a->text().toStdString();
      }
      ++letters;
    }
  }
  EXPECT_GE(letters, 60);
}

TEST_P(MnemonicTest, AreNotSeenWhereNothingHasThem) {
  openRelief();
  const QRegularExpression letter(QStringLiteral("\\([A-Z]\\)"));
  int texts = 0;
  const auto plain = [&](const QString& text) {
    EXPECT_FALSE(text.contains(letter) || text.contains("(&")) << text.toStdString();
    texts += text.isEmpty() ? 0 : 1;
  };
  for (const auto* button : child<QToolBar>("tools")->findChildren<QToolButton*>()) {
    plain(button->text());
    plain(button->accessibleName());
  }
  for (const char* command : {"keys", "search_commands"}) {
    ASSERT_TRUE(window().runCommand(command));
    for (const auto* dialog : window().findChildren<QDialog*>()) {
      for (const auto* view : dialog->findChildren<QAbstractItemView*>()) {
        const QAbstractItemModel& model = *view->model();
        for (int row = 0; row < model.rowCount(); ++row) {
          for (int column = 0; column < model.columnCount(); ++column) {
            plain(model.index(row, column).data().toString());
          }
        }
      }
    }
  }
  ASSERT_TRUE(window().runCommand("package"));
  for (const auto* button : child<QDialog>("package_dialog")->findChildren<QPushButton*>()) {
    plain(button->accessibleName());
  }
  EXPECT_GE(texts, 150);
}
INSTANTIATE_TEST_SUITE_P(Languages, MnemonicTest, ::testing::Values("de", "hi"));

TEST(Translations, AreWholeAndKeepTheirPlaceholders) {
  for (const char* code : {"de", "hi"}) {
    QFile file(QStringLiteral(RELIEVO_SOURCE_DIR "/ui/translations/relievo_%1.ts").arg(code));
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << code;
    QXmlStreamReader xml(&file);
    QString source;
    int texts = 0;
    const auto marks = [](const QString& text) {
      QStringList list;
      for (int i = 0; i + 1 < text.size(); ++i) {
        if (text[i] == '%' && (text[i + 1].isDigit() || text[i + 1] == 'n')) list << text.mid(i, 2);
      }
      list.sort();
      return list.join(' ');
    };
    const auto check = [&](const QString& text) {
      EXPECT_FALSE(text.isEmpty()) << code << ": " << source.toStdString();
      for (const bool one : {true, false}) {  // Forms of number of the table of messages.
        const auto form = [one](int) { return one; };
        EXPECT_EQ(marks(withForms(text, form)).toStdString(),
                  marks(withForms(source, form)).toStdString())
            << code << ": " << source.toStdString();
      }
      EXPECT_EQ(text.contains('&'), source.contains('&')) << code << ": " << source.toStdString();
    };
    constexpr int kForms = 2;  // One, and others.
    int forms = kForms;        // Of the text before, if it has any.
    while (!xml.atEnd()) {
      xml.readNext();
      if (!xml.isStartElement()) continue;
      if (xml.name() == QLatin1String("source")) {
        EXPECT_EQ(forms, kForms) << code << ": " << source.toStdString();
        forms = kForms;
        source = xml.readElementText();
      }
      if (xml.name() == QLatin1String("numerusform")) {
        ++forms;
        check(xml.readElementText());
      }
      if (xml.name() != QLatin1String("translation")) continue;
      if (source.contains("%n")) forms = 0;
      ++texts;
      EXPECT_NE(xml.attributes().value("type"), QLatin1String("unfinished"))
          << code << ": " << source.toStdString();
      if (source.contains("%n")) continue;  // Its forms follow.
      check(xml.readElementText());
    }
    EXPECT_EQ(forms, kForms) << code << ": " << source.toStdString();
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    EXPECT_GT(texts, 800) << code;
  }
}

TEST(Translations, AreInTheProgramAndTheWindowSpeaksThem) {
  QStringList codes;
  for (const Language& language : languageList()) codes << language.code;
  EXPECT_EQ(codes, (QStringList{"en", "de", "hi"}));
  QTranslator german, hindi;
  ASSERT_TRUE(german.load(":/translations/relievo_de.qm"));
  ASSERT_TRUE(hindi.load(":/translations/relievo_hi.qm"));
  EXPECT_EQ(german.translate("relievo::WorkArea", "Window"), QString("Ausschnitt"));
  EXPECT_EQ(hindi.translate("relievo::WorkArea", "Window"), QString("विंडो"));
  QTranslator english;
  ASSERT_TRUE(english.load(":/translations/relievo_en.qm"));
  for (const int n : {1, 2}) {
    const QString text = english.translate(
        "relievo::OpenController",
        "relievo ended unexpectedly. Work on %1 of %2 was kept (%n step(s)).", nullptr, n);
    EXPECT_TRUE(text.endsWith(n == 1 ? "(%n step)." : "(%n steps).")) << text.toStdString();
  }
}

}  // namespace
}  // namespace relievo
