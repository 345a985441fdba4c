// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QDialog>
#include <QWidget>

#include "core/relief/stereo.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QProgressBar;

namespace relievo {

/// Red and cyan for the two eyes, and how far apart they see the farthest point. [GUI thread]
class StereoPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StereoPanel(QWidget* parent = nullptr);
  /// What one view shows: heights, and millimetres of screen per millimetre of object.
  struct Shown {
    double low_mm = 0, high_mm = 0, screen_per_mm = 0;
  };

  /// As the detail view draws it: the eye separation may be less than what was chosen, by the limit
  /// of comfort, and with automatic depth it follows the heights shown.
  StereoOptions options() const;
  /// The same for a view that shows something else: automatic depth fills the comfortable range of
  /// each view.
  StereoOptions optionsFor(const Shown& shown) const;
  /// What was chosen, where options() has less; else nothing.
  std::optional<double> chosenAngleDeg() const;
  void setOn(bool on);
  void setKind(StereoMode kind);  ///< That setOn() gives.
  void setComfort(bool keep);
  void setAutomaticDepth(bool on);
  /// @param chosen_deg  as chosenAngleDeg()
  void show(const StereoOptions& options, const std::optional<double>& chosen_deg);
  /// The range the zero plane is chosen from.
  void setHeights(double low_mm, double high_mm);
  /// Of the detail view.
  void setShown(const Shown& shown);

 Q_SIGNALS:
  void changed(const StereoOptions& options);  ///< By a control.
  void drawnChanged();  ///< By what is shown: options() have another eye separation.

 private:
  void tell();
  void showControls();
  void showMeter();
  double farthestMm(const Shown& shown) const;
  double drawnDeg(const Shown& shown) const;

  QCheckBox *on_, *automatic_, *swap_, *comfort_, *depth_;
  QComboBox* kind_;
  QDoubleSpinBox *angle_, *plane_;
  QProgressBar* meter_;
  Shown shown_;
  /// With the eye separation that was chosen. The controls show it rounded, and take part of it
  /// over only where they are used.
  StereoOptions wanted_;
};

/// A picture that says whether red is at the left eye: an L that only the left eye sees, an R that
/// only the right one sees. [GUI thread]
class GlassesDialog : public QDialog {
  Q_OBJECT
 public:
  GlassesDialog(bool swapped, QWidget* parent);
};

}  // namespace relievo
