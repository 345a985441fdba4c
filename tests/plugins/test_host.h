// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <QAction>
#include <QPointer>
#include <QStandardPaths>
#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/base/error.h"
#include "core/message/message.h"
#include "core/session/firmness.h"
#include "plugins/api/plugin.h"

namespace relievo::test {

/// A second host: remembers what plugins say.
class TestHost : public ShownWindow,
                 public Controls,
                 public TouchDisplay,
                 public Messages,
                 public Recordings,
                 public Host {
 public:
  TestHost() : Host{*this, *this, *this, *this, *this} {}
  ~TestHost() override {
    for (const auto& [title, panel] : panels) delete panel;
  }
  void addPanel(const QString& title, QWidget* panel) override { panels[title] = panel; }
  void addAction(const QString& menu, QAction* action) override {
    action->setParent(this);
    menus[action->objectName()] = menu;
    actions[action->objectName()] = action;
  }
  void showProbe(const Probe& probe) override { probes.push_back(probe); }
  void plot(std::span<const ForcePoint> samples) override {
    plotted.insert(plotted.end(), samples.begin(), samples.end());
    ++plots;
  }
  void showStatus(const TouchStatus& new_status) override {
    status = new_status;
    ++statuses;
  }
  void announce(const QString& text, SaidBecause why) override {
    announcements << text;
    (why == SaidBecause::noticed ? noticed : answers) << text;
  }
  /// As for ears.
  void say(const std::vector<Message>& sentences, SaidBecause why) override {
    QStringList texts;
    for (const Message& sentence : sentences) {
      texts << QString::fromStdString(englishSpoken(sentence));
    }
    announcements << texts.join(' ');
    because.push_back(why);
    if (voice != nullptr) voice->speak(sentences, why);
  }
  void hush() override {
    ++hushed;
    if (voice != nullptr) voice->hush();
  }
  void setVoice(Voice* speaker) override { voice = speaker; }
  bool hasVoice() const override { return voice != nullptr && voice->isOn(); }
  bool isSpeaking() const override { return voice != nullptr && voice->isSpeaking(); }
  ObjectPlace placeAt(double /*x_mm*/, double /*y_mm*/) const override { return object; }
  bool run(const QString& command) override {
    if (command.startsWith(QLatin1String("button:"))) {
      offered << command;
      return takes_buttons;
    }
    commands << command;
    return possible;
  }
  std::shared_ptr<const RegionWindow> shownWindow() const override { return window; }
  /// Read from disk, and so later: the test answers.
  std::vector<float> finerHeights(const RegionWindow& asked) override {
    finer_asked.push_back(asked.id);
    return {};
  }
  /// Answers at once: a file is what `rasters` says, the same at every place.
  void readFirmness(const QString& file) override {
    const auto found = rasters.find(file);
    if (found == rasters.end()) {
      Q_EMIT firmnessRead(file, nullptr, QStringLiteral("There is no raster."));
      return;
    }
    auto firmness = std::make_shared<FirmnessMap>();
    firmness->file = file.toStdString();
    firmness->sha256 = "a1b2";
    firmness->parts = {found->second};
    Q_EMIT firmnessRead(file, firmness, {});
  }
  std::vector<float> firmnessUnder(const FirmnessMap& firmness,
                                   const RegionWindow& /*window*/) const override {
    if (!rasters_fit) throw ArgumentError("It does not fit.");
    return std::vector<float>(kWindowCount, firmness.parts.front());
  }
  bool showRegion(const Region& region) override {
    regions.push_back(region);
    return true;
  }
  std::uint8_t edges() const override { return at_edges; }
  void turnView(double azimuth_deg, double elevation_deg, double tilt_deg) override {
    tilted_deg += tilt_deg;
    turned_az_deg += azimuth_deg;
    turned_el_deg += elevation_deg;
  }
  void pushView(const ViewPush& push) override {
    pushed.right += push.right;
    pushed.up += push.up;
    pushed.nearer *= push.nearer;
  }
  QString recordingHeader(const QString& /*file*/) const override {
    return QStringLiteral("input relief.ply\nunit mm");
  }
  void showError(const QString& sentence, const QString& code) override {
    errors << sentence + ' ' + code;
  }
  QString scanName() const override { return scan; }
  QString recordingEnding() const override { return ending; }
  QString recordingFolder() const override {
    if (!folder.isEmpty()) return folder;
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) +
           QStringLiteral("/relievo");
  }
  void recordingSaved(const QString& file) override { recordings << file; }
  QString mapState(const QString& /*folder*/) const override { return map_state; }

  void showWindow(std::shared_ptr<const RegionWindow> shown) {
    window = std::move(shown);
    Q_EMIT windowShown(window);
  }

  std::map<QString, QPointer<QWidget>> panels;
  std::map<QString, QString> menus;
  std::map<QString, QAction*> actions;
  std::vector<Probe> probes;
  std::vector<ForcePoint> plotted;
  int plots = 0;  ///< One of each frame in which the loop ran on.
  TouchStatus status;
  int statuses = 0;            ///< That were shown.
  QStringList offered;         ///< Buttons that the window was asked about ...
  bool takes_buttons = false;  ///< ... and what it answered.
  QStringList announcements, commands, recordings, errors;
  QStringList answers, noticed;            ///< Of the announcements.
  std::vector<Region> regions;             ///< Asked to be shown.
  std::vector<std::uint64_t> finer_asked;  ///< Windows.
  std::map<QString, float> rasters;        ///< Names of files that can be read.
  bool rasters_fit = true, possible = true;
  QString map_state, scan = QStringLiteral("relief"), ending = QStringLiteral("csv");
  QString folder;  ///< Of recordings; empty: relievo in the documents folder.
  std::uint8_t at_edges = 0;
  double turned_az_deg = 0, turned_el_deg = 0, tilted_deg = 0;
  ViewPush pushed;
  std::shared_ptr<const RegionWindow> window;
  ObjectPlace object{.width_mm = 90, .height_mm = 60, .spacing_mm = 0.5};
  std::vector<SaidBecause> because;  ///< Of what was said in sentences of the catalogue.
  int hushed = 0;
  Voice* voice = nullptr;
};

}  // namespace relievo::test
