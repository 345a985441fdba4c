// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <QObject>

#include "haptics/loop/surface_preset.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace relievo {

/// The rows of the panel Touch that say how a surface feels, with the presets that set them
/// together. [GUI thread]
class FeelForm : public QObject {
  Q_OBJECT
 public:
  explicit FeelForm(QObject* parent);

  /// Adds preset, shape, proxy, stiffness, friction, damping, and how soft unmeasured ground is.
  void addSurfaceRows(QFormLayout* form);
  /// Adds what is felt beside the surface: edge cue, texture, contact impulse, magnet.
  void addCueRows(QFormLayout* form);

  SurfaceFeel feel() const;
  void setFeel(const SurfaceFeel& feel);  ///< Emits nothing.
  /// The stiffness of this level is shown. @param detail  from 1
  void setDetail(int detail);

 Q_SIGNALS:
  void changed();  ///< By the person.

 private:
  void buildSurface();
  void buildCues();
  void connectControls();
  void takePreset(int index);
  void takeStiffness(double value);
  void takeChange();
  void showPreset();
  void showStiffness();
  void showWhatDependsOnOthers();
  std::size_t level() const;  // Index of the shown level's own stiffness.

  QComboBox* preset_ = nullptr;
  QComboBox* surface_ = nullptr;
  QComboBox* proxy_ = nullptr;
  QDoubleSpinBox* stiffness_ = nullptr;
  QCheckBox* by_detail_ = nullptr;
  QDoubleSpinBox* friction_ = nullptr;
  QDoubleSpinBox* damping_ = nullptr;
  QDoubleSpinBox* soft_ = nullptr;
  QDoubleSpinBox* edge_ = nullptr;
  QDoubleSpinBox* texture_ = nullptr;
  QDoubleSpinBox* contact_ = nullptr;
  QDoubleSpinBox* magnet_ = nullptr;
  DetailStiffness detail_stiffness_ = kDetailStiffness;
  double fixed_stiffness_ = 0;  // The same at every level.
  double magnet_reach_mm_ = 3;  // No control of its own.
  int detail_ = 0;              // Shown last; 0: none yet.
};

}  // namespace relievo
