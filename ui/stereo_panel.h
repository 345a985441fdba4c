// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  /// As drawn: with comfort limit the eye separation may be less than what was chosen.
  StereoOptions options() const;
  void setOn(bool on);
  void setComfort(bool keep);
  void show(const StereoOptions& options);
  /// The range the zero plane is chosen from.
  void setHeights(double low_mm, double high_mm);
  /// Of the detail view: heights in it, and millimetres of screen per millimetre of object.
  void setScale(double low_mm, double high_mm, double screen_per_mm);

 Q_SIGNALS:
  void changed(const StereoOptions& options);

 private:
  void tell();
  void showMeter();
  double farthestMm() const;
  double comfortableDeg() const;

  QCheckBox *on_, *automatic_, *swap_, *comfort_;
  QComboBox* kind_;
  QDoubleSpinBox *angle_, *plane_;
  QProgressBar* meter_;
  double low_mm_ = 0, high_mm_ = 0, screen_per_mm_ = 0;
};

/// A picture that says whether red is at the left eye: an L that only the left eye sees, an R that
/// only the right one sees. [GUI thread]
class GlassesDialog : public QDialog {
  Q_OBJECT
 public:
  GlassesDialog(bool swapped, QWidget* parent);
};

}  // namespace relievo
