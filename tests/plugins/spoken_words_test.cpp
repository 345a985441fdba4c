// SPDX-License-Identifier: BSD-3-Clause
// Everything of fixed words that haptics says has a translation, and the window says that one.
#include "plugins/haptics/spoken_words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QFile>
#include <QSet>
#include <QTranslator>
#include <QXmlStreamReader>
#include <set>
#include <string>

#include "core/base/origin.h"
#include "haptics/commands/button_commands.h"
#include "haptics/device/device.h"
#include "haptics/device/falcon/link_status.h"

namespace relievo {
namespace {

std::set<std::string> saidByHaptics() {
  std::set<std::string> said;
  for (int i = 1; i <= static_cast<int>(ButtonCommand::restart_introduction); ++i) {
    said.emplace(commandWords(static_cast<ButtonCommand>(i)));
  }
  for (const bool one_button : {false, true}) {
    ButtonCommands commands({.one_button = one_button});
    said.emplace(commands.help());
    commands.toggleMoving();
    said.emplace(commands.help());
  }
  for (int i = 1; i <= static_cast<int>(DeviceFault::not_ready); ++i) {
    said.emplace(describe(static_cast<DeviceFault>(i)));
  }
  for (const std::string_view origin : kOriginNames) {
    if (origin != name(Origin::measured)) said.emplace(origin);
  }
  for (int i = 0; i <= static_cast<int>(falcon::LinkState::silent); ++i) {
    falcon::LinkStatus status;
    status.state = static_cast<falcon::LinkState>(i);
    said.insert(falcon::describe(status).spoken);
    status.attempt = 4;
    status.unplugged = 1;
    status.homing_is_long = true;
    said.insert(falcon::describe(status).spoken);
  }
  return said;
}

std::set<std::string> translated(const QString& language) {
  QFile file(QStringLiteral(RELIEVO_SOURCE_DIR "/ui/translations/relievo_%1.ts").arg(language));
  EXPECT_TRUE(file.open(QIODevice::ReadOnly));
  std::set<std::string> sources;
  QString context, source;
  for (QXmlStreamReader xml(&file); !xml.atEnd();) {
    if (xml.readNext() != QXmlStreamReader::StartElement) continue;
    if (xml.name() == QLatin1String("name")) context = xml.readElementText();
    if (xml.name() == QLatin1String("source")) source = xml.readElementText();
    if (xml.name() != QLatin1String("translation")) continue;
    const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
    if (context == QLatin1String("relievo::SpokenWords") && !unfinished &&
        !xml.readElementText().isEmpty()) {
      sources.insert(source.toStdString());
    }
  }
  return sources;
}

TEST(SpokenWords, AllThatHapticsSaysHasATranslation) {
  for (const char* language : {"de", "hi"}) {
    const std::set<std::string> known = translated(QString::fromLatin1(language));
    for (const std::string& words : saidByHaptics()) {
      EXPECT_TRUE(known.count(words) == 1) << language << ": " << words;
    }
  }
}

class Shouting : public QTranslator {
 public:
  bool isEmpty() const override { return false; }
  QString translate(const char* context, const char* source, const char* /*disambiguation*/,
                    int /*n*/) const override {
    if (QString::fromUtf8(context) != QLatin1String("relievo::SpokenWords")) return {};
    return QString::fromUtf8(source).toUpper();
  }
};

TEST(SpokenWords, AreSaidInTheWindowsLanguage) {
  int argc = 0;
  const QCoreApplication application(argc, nullptr);
  EXPECT_EQ(spokenText("Finer detail"), "Finer detail");
  Shouting shouting;
  QCoreApplication::installTranslator(&shouting);
  EXPECT_EQ(spokenText(commandWords(ButtonCommand::finer)), "FINER DETAIL");
}

}  // namespace
}  // namespace relievo
