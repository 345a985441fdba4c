// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <functional>
#include <QBasicTimer>
#include <QElapsedTimer>
#include <QObject>
#include <QPointer>

#include "ui/work/scheduling/coarse_pictures.h"

namespace relievo {

/// Lets what takes long on the window's thread, the pictures of its views and the results of
/// workers, happen one in a round of the event loop and not in a round in which the window is
/// painted or something else took long, so that keys and mouse are answered in between. [GUI
/// thread]
class RenderScheduler : public QObject {
 public:
  /// `work` is done once, after that of those who asked before; not if `who` is gone by then.
  void schedule(QObject* who, std::function<void()> work);
  CoarsePictures& coarse() { return coarse_; }

 protected:
  void timerEvent(QTimerEvent* event) override;

 private:
  struct Turn {
    QPointer<QObject> who;
    std::function<void()> work;
  };
  std::deque<Turn> turns_;
  CoarsePictures coarse_;
  QBasicTimer next_;
  bool worked_ = true;         ///< The round of the last turn may still go on.
  int rests_ = 0;              ///< Rounds that were let go by since then.
  QElapsedTimer since_round_;  ///< Since the last timer event or turn.
};

}  // namespace relievo
