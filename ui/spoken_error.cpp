// SPDX-License-Identifier: BSD-3-Clause
#include "ui/spoken_error.h"

#include <array>
#include <QCoreApplication>
#include <QRegularExpression>

#include "core/base/error.h"
#include "ui/message/message_text.h"

namespace relievo {
namespace {

// Sentences of core (base, io, measure, project, provenance, relief, replay, session),
// haptics/record, ui/figure, ui/vtk and ui/video with their parts as %1, %2, ...: core knows no
// languages, and its error carries the sentence alone. A sentence that was reworded there is shown
// in English until it is here; language_test provokes the errors.
constexpr std::array kSentences{
    // What is said of scans that are prepared.
    QT_TRANSLATE_NOOP("Core", "The reference."),
    QT_TRANSLATE_NOOP("Core", "As stored."),
    QT_TRANSLATE_NOOP("Core", "The pose that was found before was used."),
    QT_TRANSLATE_NOOP("Core", "%1 rms over %2 in common."),
    QT_TRANSLATE_NOOP("Core", "%1 rms over %2 in common. Weak %3: about %4."),
    QT_TRANSLATE_NOOP("Core",
                      "%1 rms over %2 in common. Nothing in the shape holds it %3: there it lies "
                      "as it was placed by hand."),
    QT_TRANSLATE_NOOP("Core", "%1 was left out: Not aligned: %2."),
    QT_TRANSLATE_NOOP("Core", "Not aligned: %1."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: %2 picked pairs; three or more are needed. Nothing was aligned."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: the picked places lie nearly in one line, which leaves open how the "
                      "scan is turned about it. Nothing was aligned; pick one more place well "
                      "beside that line."),
    QT_TRANSLATE_NOOP("Core",
                      "%1: the picked places are not equally far from each other on the two "
                      "scans. Nothing was aligned; look whether the pairs are in the same order "
                      "and the scans in the same unit."),
    QT_TRANSLATE_NOOP("Core", "%1 states no classes; all its points stay."),
    QT_TRANSLATE_NOOP("Core", "%1 states no pulses with several returns; all its points stay."),
    QT_TRANSLATE_NOOP("Core", "%1 states no intensities; all its points stay."),
    QT_TRANSLATE_NOOP("Core",
                      "No point is left after all steps. Nothing was written. Take a step out, or "
                      "widen its limits."),
    QT_TRANSLATE_NOOP("Core",
                      "'%1' has changed since it was read. Nothing was written. Close the dialog "
                      "and open the file again."),
    QT_TRANSLATE_NOOP(
        "Core", "No cell of the grid was hit by the scan. Nothing was made. Choose another view.")};

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

QString withCode(const QString& text, const QString& code) {
  if (code.isEmpty() || text.contains(code)) return text;
  return QStringLiteral("%1 (%2)").arg(text, code);
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
  const auto* const ours = dynamic_cast<const Error*>(&error);
  if (ours != nullptr && ours->message) return messageText(*ours->message);
  return spokenError(QString::fromUtf8(error.what()));
}

QString shownError(const QString& english, const QString& code) {
  return withCode(spokenError(english), code);
}

QString shownError(const std::exception& error) {
  const auto* ours = dynamic_cast<const Error*>(&error);
  return withCode(spokenError(error),
                  ours != nullptr ? QString::fromStdString(ours->code) : QString());
}

}  // namespace relievo
