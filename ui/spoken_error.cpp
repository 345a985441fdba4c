// SPDX-License-Identifier: BSD-3-Clause
#include "ui/spoken_error.h"

#include <array>
#include <QCoreApplication>
#include <QRegularExpression>

namespace relievo {
namespace {

// Sentences of core/io, core/session, haptics/record and ui/video with their parts as %1, %2, ...:
// core knows no languages, and its error carries the sentence alone. A sentence that was reworded
// there is shown in English until it is here; language_test provokes the errors.
constexpr std::array kSentences{
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: there is no such file. Check the name and the folder."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: this account may not read it. Change its permissions, or copy "
        "it."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it is a folder. Choose one of the files in it."),
    QT_TRANSLATE_NOOP("Core", "Cannot read %1: it is empty (0 bytes). Copy or export it again."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: it has %2 points, none finite. Choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: its header has no end (%2). Copy or export it again."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: header promises %2 points, file ends at %3. Nothing was "
                      "loaded. Choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: header promises %2 points, file ends at %3. Nothing was "
                      "loaded. Load the %4 complete points, or choose another file."),
    QT_TRANSLATE_NOOP(
        "Core",
        "Cannot read %1: it is %2; this version reads %3. Convert it to one of these, "
        "or choose another file."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot read %1: the system stopped the import, probably for lack of memory. "
                      "Close other programs, or thin the scan out first."),
    QT_TRANSLATE_NOOP(
        "Core",
        "This needs about %1; %2 are free. Nothing was made. Choose cells of at least "
        "%3 (%4), or close other programs."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 has %2 cells, but the map is %3 mm: it is not a raster of the whole map, "
                      "and was not used. Cut it to the outline of the map."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 holds values outside 0 to 1, such as %2, and was not used. Scale them: 1 "
                      "where the ground is firm, 0 where it is softest."),
    QT_TRANSLATE_NOOP("Core",
                      "Cannot write %1: %2. Check the folder, its permissions and the free space."),
    QT_TRANSLATE_NOOP("Core",
                      "Recording stopped: disk full. %1 samples are saved and complete in \"%2\"."),
    QT_TRANSLATE_NOOP("Core",
                      "Video stopped: disk full. %1 s (%2 frames) are saved and complete in "
                      "\"%3\".")};

QRegularExpression formOf(const QString& sentence) {
  QString form = QRegularExpression::escape(sentence);
  for (int i = 1; i <= 4; ++i) form.replace(QStringLiteral("\\%%1").arg(i), QLatin1String("(.+)"));
  return QRegularExpression(QRegularExpression::anchoredPattern(form),
                            QRegularExpression::DotMatchesEverythingOption);
}

/// The parts in the translation's order, all at once: a part may itself contain "%1".
QString filled(const QString& sentence, const QStringList& parts) {
  QString text;
  for (int i = 0; i < sentence.size(); ++i) {
    const int number = i + 1 < sentence.size() ? sentence[i + 1].digitValue() : -1;
    if (sentence[i] == '%' && number >= 1 && number < parts.size()) {
      text += parts[number];
      ++i;
    } else {
      text += sentence[i];
    }
  }
  return text;
}

}  // namespace

QString spokenError(const QString& english) {
  for (const char* sentence : kSentences) {
    const auto match = formOf(QString::fromUtf8(sentence)).match(english);
    if (!match.hasMatch()) continue;
    return filled(QCoreApplication::translate("Core", sentence), match.capturedTexts());
  }
  return english;
}

QString spokenError(const std::exception& error) {
  return spokenError(QString::fromUtf8(error.what()));
}

}  // namespace relievo
