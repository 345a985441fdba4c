// SPDX-License-Identifier: BSD-3-Clause
#include "ui/language/spoken_text.h"

#include <QLocale>
#include <QRegularExpression>

#include "core/describe/spoken_units.h"
#include "ui/translations/message_languages.h"

namespace relievo {

QString forEars(const QString& text) {
  static const QRegularExpression code(QStringLiteral("\\s*\\(E\\d{3}\\)"));
  const QString words = QString(text).remove(code);
  return QString::fromStdString(
      spokenUnits(messageLanguage(QLocale().name().toStdString()), words.toStdString()));
}

}  // namespace relievo
