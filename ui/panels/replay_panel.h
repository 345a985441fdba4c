// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <utility>

#include "ui/panels/replay_player.h"
#include "ui/plots/strip_plot.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace relievo {

/// A replay's controls above its plots: play, a slider through the recording, speed, close; z of
/// hand and proxy and the force, with a cursor where the picture is. What is there stands between
/// them as text. Keys: Space plays and pauses, left and right go by 0.1 s, with Shift by a sample,
/// Page Up and Down by 1 s, up and down to the event before and after, Home and End to the ends.
/// [GUI thread]
class ReplayPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ReplayPanel(ReplayPlayer& player, QWidget* parent = nullptr);

  /// "3.42 of 10.00 s"
  QString timeText() const;
  void takeColours();
  /// Part of the recording that the plots show, seconds since its start.
  std::pair<double, double> shownS() const { return {low_s_, high_s_}; }
  double cursorS() const { return cursor_s_; }

 Q_SIGNALS:
  void closeAsked();
  void eventAsked(int direction);  ///< 1: the next, -1: the one before.

 protected:
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void layOut();
  QWidget* makeSteps();
  void showReadout();
  void takeFont();
  void showLoaded();
  void showTime();
  void showPart();
  bool goByKey(int key, Qt::KeyboardModifiers modifiers);

  ReplayPlayer& player_;
  QToolButton *play_, *close_;
  QSlider* slider_;
  QLabel *time_, *readout_;
  QComboBox* speed_;
  StripPlot heights_, forces_;
  const TouchRecording* shown_ = nullptr;  ///< Whose curves are drawn; compared, never followed.
  const TouchEvent* event_ = nullptr;      ///< Whose words are event_text_; likewise.
  QString event_text_;
  double low_s_ = 0, high_s_ = 0, cursor_s_ = 0;
};

}  // namespace relievo
