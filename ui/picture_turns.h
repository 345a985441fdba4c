// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

namespace relievo {

/// Lets the views of a window draw one after the other, one in a round of the event loop and not in
/// a round in which the window is painted or something else took long, so that keys and mouse are
/// answered in between.
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
  bool drew_ = true;           ///< The round of the last picture may still go on.
  int rests_ = 0;              ///< Rounds that were let go by since then.
  QElapsedTimer since_round_;  ///< Since the last timer event or picture.
};

}  // namespace relievo
