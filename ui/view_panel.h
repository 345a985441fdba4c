// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "ui/vtk/relief_scene.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSlider;

namespace relievo {

/// From where the object is seen, and from where it is lit. [GUI thread]
class ViewPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ViewPanel(QWidget* parent = nullptr);
  void showView(const QString& name);
  /// "Use this view" and "Straighten" make sense only while the detail view is turned.
  void showTurned(bool turned);
  LightOptions light() const;

 Q_SIGNALS:
  void viewChosen(const QString& name);  ///< top bottom front back left right auto
  void useThisViewAsked();
  void straightenAsked();
  void lightChanged(const LightOptions& light);

 private:
  QLabel* now_;
  QPushButton *use_, *straighten_;
  QSlider *azimuth_, *elevation_;
  QLabel* light_text_;
};

/// Red and cyan for the two eyes. [GUI thread]
class StereoPanel : public QWidget {
  Q_OBJECT
 public:
  explicit StereoPanel(QWidget* parent = nullptr);
  StereoOptions options() const;
  void setOn(bool on);
  void show(const StereoOptions& options);
  /// The range the zero plane is chosen from.
  void setHeights(double low_mm, double high_mm);

 Q_SIGNALS:
  void changed(const StereoOptions& options);

 private:
  void tell();

  QCheckBox *on_, *automatic_;
  QDoubleSpinBox *angle_, *plane_;
};

}  // namespace relievo
