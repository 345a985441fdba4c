// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAction>
#include <QPointer>
#include <vector>

#include "plugins/api/host.h"
#include "ui/exhibit/chime.h"
#include "ui/window/main_window.h"
#include "ui/work/latest_worker.h"

namespace relievo {

class ExhibitControl;

/// What the window offers a plugin. Outlives no window. [GUI thread]
class WindowHost : public ShownWindow,
                   public Controls,
                   public TouchDisplay,
                   public Messages,
                   public Recordings {
  Q_OBJECT
 public:
  explicit WindowHost(MainWindow& window);
  Host& parts() { return parts_; }
  /// Panels and actions that came since the last call of either: they stay, or leave the window.
  void keepAdditions();
  void takeAdditionsBack();
  /// Buttons, commands and the hand are the exhibit's first; null: there is none. Not owned.
  void setExhibit(ExhibitControl* exhibit) { exhibit_ = exhibit; }

  void addPanel(const QString& title, QWidget* panel) override;
  void addAction(const QString& menu, QAction* action) override;
  void showProbe(const Probe& probe) override;
  void plot(std::span<const ForcePoint> samples) override;
  void showStatus(const TouchStatus& status) override;
  void announce(const QString& text, SaidBecause why) override;
  void say(const std::vector<Message>& sentences, SaidBecause why) override;
  void hush() override;
  void setVoice(Voice* voice) override;
  bool hasVoice() const override { return voice_ != nullptr && voice_->isOn(); }
  bool isSpeaking() const override { return voice_ != nullptr && voice_->isSpeaking(); }
  void showError(const QString& sentence, const QString& code) override;
  bool run(const QString& command) override;
  std::shared_ptr<const RegionWindow> shownWindow() const override;
  std::vector<float> finerHeights(const RegionWindow& window) override;
  void readFirmness(const QString& file) override;
  std::vector<float> firmnessUnder(const FirmnessMap& firmness,
                                   const RegionWindow& window) const override;
  ObjectPlace placeAt(double x_mm, double y_mm) const override;
  bool showRegion(const Region& region) override;
  std::uint8_t edges() const override;
  void turnView(double azimuth_deg, double elevation_deg, double tilt_deg) override;
  void pushView(const ViewPush& push) override;
  QString recordingHeader(const QString& file) const override;
  QString scanName() const override;
  QString recordingEnding() const override;
  QString recordingFolder() const override;
  void recordingSaved(const QString& file) override;
  QString mapState(const QString& folder) const override;

 private:
  static constexpr int kLowTonesPercent = 60;

  MainWindow& window_;
  Voice* voice_ = nullptr;
  ExhibitControl* exhibit_ = nullptr;
  SaidBecause window_says_because_ = SaidBecause::asked;
  Host parts_{*this, *this, *this, *this, *this};
  std::vector<QPointer<QWidget>> new_panels_;
  std::vector<QPointer<QAction>> new_actions_;
  Chime low_tones_{lowTonesWav(kLowTonesPercent)};  ///< Where no voice can say so.
  LatestWorker firmness_worker_, finer_worker_;
};

}  // namespace relievo
