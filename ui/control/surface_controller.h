// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ui/window/controller.h"

namespace relievo {

class DetailView;
class ScanView;
class TouchController;

/// Which part of the surface is shown, from where, how it is made, and the steps that led there.
/// [GUI thread]
class SurfaceController : public Controller {
  Q_OBJECT
 public:
  SurfaceController(const ControllerParts& parts, DetailView& detail, const ScanView& scan,
                    const TouchController& touch);

  /// Makes the relief anew from where the turned detail view looks.
  void useThisView();
  /// Makes the relief anew from where the scan in 3-D is looked at.
  void useScanView();

 private:
  void makeCommands();
  void stepDetail(bool finer);
  void moveWindow(double dx, double dy, const QString& moved);
  void chooseDepthMap();
  void showHistory();  ///< In the texts of undo and redo.
  void showSteps();

  DetailView& detail_;
  const ScanView& scan_;
  const TouchController& touch_;
};

}  // namespace relievo
