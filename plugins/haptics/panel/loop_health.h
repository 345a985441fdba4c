// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <QString>

#include "haptics/loop/haptic_loop.h"

class QPlainTextEdit;

namespace relievo {

/// What the panel shows of the running loop.
struct LoopReport {
  HapticSample sample;
  LoopStats stats;
  RealtimeGrant realtime;
  QString device;
  QString not_ready;      ///< Why the device cannot be used now, and what helps; empty: it can.
  QString fallback;       ///< Why it is not the device that was chosen; empty: it is.
  QString take_back;      ///< What brings back a force that was taken away; empty: none was.
  QString heat;           ///< How warm its motors are; empty: it does not say.
  bool actuated = false;  ///< The device can push back.
};

/// How the force loop runs, in one sentence or two, the worst first.
QString healthText(const LoopReport& report);

/// All that was counted: wake-ups and work as tables, and what the system granted.
QString loopDetailsText(const LoopReport& report);

/// Shows loopDetailsText() while it is open. [GUI thread]
class LoopDetailsDialog : public QDialog {
  Q_OBJECT
 public:
  explicit LoopDetailsDialog(QWidget* parent);
  void show(const LoopReport& report);
  using QWidget::show;

 private:
  QPlainTextEdit* text_;
};

}  // namespace relievo
