// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

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

  /// How the region changed by a command that has no place: one level of detail, or to the whole.
  enum class Step : std::uint8_t { closer, wider, whole };
  /// Who tells of it instead of this one, in other words; null: nobody.
  void setTeller(std::function<void(Step)> tell) { tell_ = std::move(tell); }

 private:
  void makeCommands();
  void stepDetail(bool finer);
  void tell(Step step, const QString& words);
  void moveWindow(double dx, double dy, const QString& moved);
  void chooseDepthMap();
  void showHistory();  ///< In the texts of undo and redo.
  void showSteps();

  DetailView& detail_;
  const ScanView& scan_;
  const TouchController& touch_;
  std::function<void(Step)> tell_;
};

}  // namespace relievo
