// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/device/falcon_status_announcer.h"
#include "ui/message/message_text.h"

#include <array>
#include <QCoreApplication>

namespace relievo {

using falcon::LinkState;

namespace {
constexpr const char* kContext = "relievo::FalconStatusAnnouncer";
constexpr std::array<const char*, falcon::kArms> kFound{
    QT_TRANSLATE_NOOP("relievo::FalconStatusAnnouncer", "Top arm found."),
    QT_TRANSLATE_NOOP("relievo::FalconStatusAnnouncer", "Right arm found."),
    QT_TRANSLATE_NOOP("relievo::FalconStatusAnnouncer", "Left arm found.")};
}  // namespace

QString screenText(const Message& message) {
  const QString sentence = messageText(message);
  const std::string code = codeOf(message);
  if (code.empty()) return sentence;
  return QString::fromStdString(code) + QStringLiteral(": ") + sentence;
}

QString windowText(const falcon::LinkStatus& status) {
  QString text = screenText(falcon::describe(status));
  if (status.state != LinkState::no_firmware) return text;
  return text + QLatin1Char(' ') +
         QCoreApplication::translate("relievo::FalconStatusAnnouncer",
                                     "Touch > Device set-up > Firmware file takes one.");
}

QStringList FalconStatusAnnouncer::take(const falcon::LinkStatus& status) {
  QStringList news;
  if (status.state == LinkState::homing) {
    for (std::size_t i = 0; i < kFound.size(); ++i) {
      const bool is_new = (status.homed >> i & 1U) != 0 && (homed_said_ >> i & 1U) == 0;
      if (is_new) news << QCoreApplication::translate(kContext, kFound[i]);
    }
    homed_said_ = status.homed;
  } else {
    homed_said_ = 0;
  }
  // An attempt more is no news; that it goes on after three of them is (journeys 4.0).
  const QString words = spokenMessage(falcon::describe(status));
  if (words != said_) news << words;
  said_ = words;
  return news;
}

}  // namespace relievo
