// SPDX-License-Identifier: BSD-3-Clause
#include "app/exhibit/exhibit_window.h"

#include <QElapsedTimer>
#include <QJsonDocument>
#include <QJsonObject>

#include "ui/language/language.h"

namespace relievo {
namespace {

QByteArray jsonOf(const QJsonObject& object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

/// As plugins/voice keeps its settings. No language of its own: the program's, which changes.
QByteArray voiceState(const ExhibitSpeech& speech) {
  return jsonOf(
      {{"own_voice", true},
       {"words_per_minute", speech.words_per_minute},
       {"volume_percent", speech.volume_percent},
       {"loudest_percent", speech.loudest_percent},
       {"room_loudest_percent", speech.room_loudest_percent.value_or(speech.loudest_percent)}});
}

/// As plugins/haptics does.
QByteArray touchState(const ExhibitTouch& touch) {
  constexpr int kShapes = 2, kRounds = 1;
  return jsonOf({{"device", QString::fromStdString(touch.device)},
                 {"strength_percent", touch.strength_percent},
                 {"limit_n", touch.limit_n},
                 {"introduction_shapes", kShapes},
                 {"guide_rounds", kRounds},
                 {"felt_patterns", touch.felt_patterns},
                 {"one_button", touch.one_button},
                 {"sound", touch.sounds_percent > 0},
                 {"sound_volume_percent", touch.sounds_percent}});
}

}  // namespace

std::vector<std::string> exhibitLanguages() {
  std::vector<std::string> tags;
  for (const Language& language : languageList()) tags.push_back(language.code.toStdString());
  return tags;
}

ExhibitWindow::ExhibitWindow(MainWindow& window, WindowHost& host, PluginLoader& plugins,
                             const Exhibit& exhibit)
    : host_(host),
      control_(window, exhibit, waysOf(plugins, exhibit),
               qEnvironmentVariableIntValue("RELIEVO_EXHIBIT_STARTS")) {
  host_.setExhibit(&control_);  // Which device is opened is nothing for visitors' ears.
  plugins.restore(QStringLiteral("haptics_plugin"), touchState(exhibit.touch));
}

ExhibitWindow::~ExhibitWindow() {
  host_.setExhibit(nullptr);
}

ExhibitWays ExhibitWindow::waysOf(PluginLoader& plugins, const Exhibit& exhibit) {
  QElapsedTimer since;
  since.start();
  constexpr double kMs = 1000;
  return {
      .say = [this](const std::vector<Message>& words) { host_.say(words, SaidBecause::asked); },
      .reset_voice =
          [&plugins, state = voiceState(exhibit.speech)] {
            plugins.restore(QStringLiteral("voice_plugin"), state);
          },
      .speaks = [this] { return host_.isSpeaking(); },
      .now_s = [since] { return static_cast<double>(since.elapsed()) / kMs; },
      .day = localDay};
}

}  // namespace relievo
