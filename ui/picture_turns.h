// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <QBasicTimer>
#include <QObject>
#include <QPointer>

namespace relievo {

/// Lets the views of a window draw one after the other, one in a round of the event loop and not in
/// the round in which the window is painted, so that keys and mouse are answered in between.
/// [GUI thread]
class PictureTurns : public QObject {
 public:
  /// `draw` is called once, after those who asked before; not if `who` is gone by then.
  void ask(QObject* who, std::function<void()> draw);

 protected:
  void timerEvent(QTimerEvent* event) override;

 private:
  struct Turn {
    QPointer<QObject> who;
    std::function<void()> draw;
  };
  std::deque<Turn> turns_;
  QBasicTimer next_;
  bool rested_ = false;  ///< A round went by since the last picture.
};

}  // namespace relievo
