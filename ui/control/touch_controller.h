// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>

#include "core/recording/force_curve.h"
#include "core/region/probe.h"
#include "ui/views/touch_readout.h"
#include "ui/window/controller.h"

namespace relievo {

class DetailView;
class MeasurePanel;
class ReplayControl;
class TimePlot;

/// What a touch module tells: where the hand is, what it feels, and how its loop runs. [GUI thread]
class TouchController : public Controller {
  Q_OBJECT
 public:
  TouchController(const ControllerParts& parts, DetailView& detail, TimePlot& plot,
                  ReplayControl& replay, MeasurePanel& measure);

  void showProbe(const Probe& probe);
  void plot(std::span<const ForcePoint> points);
  void show(const TouchReadout& readout);
  /// Why there is no touch; the status bar says so.
  void showMissing(const QString& reason);
  const TouchReadout& readout() const { return readout_; }
  /// What steps of detail are about: what is touched, else where the hand is.
  StepAbout about() const;
  void forgetProbe() { probe_.reset(); }
  bool stopForces();  ///< @return false: they were off

 Q_SIGNALS:
  void readoutShown(const relievo::TouchReadout& readout);

 private:
  void drawProbe(const Probe& probe);
  void showPosition(const ViewMm& position, std::optional<CellStatus> known);
  QString introduction() const;

  DetailView& detail_;
  TimePlot& plot_;
  ReplayControl& replay_;
  MeasurePanel& measure_;
  std::optional<Probe> probe_;
  TouchReadout readout_;
  bool is_present_ = false;
  quint64 late_ticks_seen_ = 0;
};

}  // namespace relievo
