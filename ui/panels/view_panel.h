// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "ui/vtk/relief_scene.h"

class QLabel;
class QPushButton;
class QSlider;

namespace relievo {

/// From where the object is seen, and, in a part of its own, from where it is lit. [GUI thread]
class ViewPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ViewPanel(QWidget* parent = nullptr);
  /// Stands elsewhere; belongs to whoever lays it out.
  QWidget* lightPart() const { return light_part_; }
  void showView(const QString& name);
  /// "Use this view" and "Straighten" make sense only while the detail view is turned.
  void showTurned(bool turned);
  LightOptions light() const;
  void showLight(const LightOptions& light);
  /// @param shading  0 ... 1 (ReliefLook::shading) @param usable  the look is one that has it
  void showShading(double shading, bool usable);

 Q_SIGNALS:
  void viewChosen(const QString& name);  ///< top bottom front back left right auto
  void useThisViewAsked();
  void straightenAsked();
  void lightChanged(const LightOptions& light);
  void shadingChanged(double shading);  ///< 0 ... 1.

 private:
  void makeLightPart();
  void tellLight();
  void tellShading();

  QLabel* now_;
  QWidget* light_part_;
  QPushButton *use_, *straighten_;
  QSlider *azimuth_, *elevation_;
  QLabel* light_text_;
  QSlider* shading_;
  QLabel* shading_text_;
};

}  // namespace relievo
