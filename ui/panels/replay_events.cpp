// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_events.h"

#include <array>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>

namespace relievo {
namespace {

/// As haptics/record writes it and as people read it; %1 and %2 are numbers. The number of a window
/// tells people nothing.
struct Happening {
  const char* written;
  const char* shown = nullptr;  ///< Null: as it is written.
};
constexpr std::array kHappenings{
    Happening{QT_TRANSLATE_NOOP("Event", "%1 samples dropped before this one")},
    Happening{QT_TRANSLATE_NOOP("Event", "resumed after %1 ms")},
    Happening{"new window: window %1 of detail %2",
              QT_TRANSLATE_NOOP("Event", "new window at resolution %2")},
    Happening{"window %1 of detail %2", QT_TRANSLATE_NOOP("Event", "window at resolution %2")},
    Happening{QT_TRANSLATE_NOOP("Event", "stiffness %1 N/m")},
    Happening{QT_TRANSLATE_NOOP("Event", "softened against swinging")},
    Happening{QT_TRANSLATE_NOOP("Event", "forces off")},
    Happening{QT_TRANSLATE_NOOP("Event", "forces wait for a clear hand")},
    Happening{QT_TRANSLATE_NOOP("Event", "forces rise")},
    Happening{QT_TRANSLATE_NOOP("Event", "forces on")},
    Happening{QT_TRANSLATE_NOOP("Event", "button %1 down")},
    Happening{QT_TRANSLATE_NOOP("Event", "button %1 up")},
    Happening{QT_TRANSLATE_NOOP("Event", "no fault")},
    Happening{QT_TRANSLATE_NOOP("Event", "the device did not answer in time")},
    Happening{QT_TRANSLATE_NOOP("Event", "the device was unplugged")},
    Happening{QT_TRANSLATE_NOOP("Event", "the device sent something unreadable")},
    Happening{QT_TRANSLATE_NOOP("Event", "the device is too hot")},
    Happening{QT_TRANSLATE_NOOP("Event", "the device reported an impossible position")},
    Happening{QT_TRANSLATE_NOOP("Event", "the device is not ready yet")}};

QString inWords(const QString& english) {
  for (const auto& [written, shown] : kHappenings) {
    QString form = QRegularExpression::escape(QString::fromUtf8(written));
    for (const char* part : {"\\%1", "\\%2"}) {
      form.replace(QLatin1String(part), QLatin1String("([0-9.]+)"));
    }
    const auto match = QRegularExpression(QRegularExpression::anchoredPattern(form)).match(english);
    if (!match.hasMatch()) continue;
    QString text = QCoreApplication::translate("Event", shown != nullptr ? shown : written);
    for (int i = 1; i <= match.lastCapturedIndex(); ++i) {
      text.replace(QStringLiteral("%%1").arg(i), match.captured(i));
    }
    return text;
  }
  return english;
}

}  // namespace

QString eventText(const TouchEvent& event) {
  const QString text = QString::fromStdString(event.text);
  if (event.is_note) return QCoreApplication::translate("Event", "note: %1").arg(text);
  QStringList parts;
  for (const QString& part : text.split(QStringLiteral("; "))) parts << inWords(part);
  return parts.join(QStringLiteral("; "));
}

}  // namespace relievo
