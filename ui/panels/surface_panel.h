// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QStringList>
#include <QWidget>

#include "ui/work/document.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;

namespace relievo {

/// Unit and facts of the open surface; all else of it is in the depth map dialog. [GUI thread]
class SurfacePanel : public QWidget {
  Q_OBJECT
 public:
  explicit SurfacePanel(Document& document, QWidget* parent = nullptr);

 Q_SIGNALS:
  void unitChosen(LengthUnit unit);

 private:
  void showSurface();

  Document& document_;
  QLabel *file_, *size_, *cells_, *holes_;
  QComboBox* unit_;
};

/// The window on the surface in numbers: corner, side, level, height gain, hand scale.
class RegionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit RegionPanel(Document& document, QWidget* parent = nullptr);

 private:
  void showWindow();
  void typed();

  Document& document_;
  QDoubleSpinBox *x_, *y_, *side_, *gain_;
  QComboBox* level_;
  QStringList level_names_;  ///< As they stand in it.
  QSlider* gain_slider_;
  QLabel* hand_scale_;
  bool showing_ = false;
};

}  // namespace relievo
