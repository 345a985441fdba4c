// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QWidget>

#include "core/session/surface.h"
#include "ui/work/surface_work.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace relievo {

/// The fields of a `SurfaceOptions`, the record that `relievo depthmap` fills from its options.
/// Choices that a source does not have are disabled and say why. [GUI thread]
class DepthMapForm : public QWidget {
  Q_OBJECT
 public:
  DepthMapForm(OpenedInput source, const Surface& present, const SurfaceOptions& options,
               QWidget* parent = nullptr);

  SurfaceOptions options() const;

 Q_SIGNALS:
  void changed();

 private:
  void addSource(QFormLayout* layout);
  void addGrid(QFormLayout* layout);
  void addHoles(QFormLayout* layout);
  void show(const SurfaceOptions& options);
  void showSize();
  void limit();
  template <class Widget>
  Widget* field(QFormLayout* layout, const QString& title, const char* name, const QString& tip);

  const OpenedInput source_;
  const SurfaceOptions first_;    ///< What has no field stays as it was.
  const LengthUnit unit_before_;  ///< Of the present map.
  const double spacing_mm_;       ///< Of the present map: offered when cells are chosen by size.
  const int cells_across_;
  QComboBox *unit_ = nullptr, *view_ = nullptr, *engine_ = nullptr, *rule_ = nullptr;
  QComboBox *cell_choice_ = nullptr, *holes_ = nullptr, *strays_ = nullptr;
  std::array<QDoubleSpinBox*, 3> turn_{};
  QSpinBox* cells_ = nullptr;
  QDoubleSpinBox *spacing_ = nullptr, *factor_ = nullptr, *hole_area_ = nullptr;
  QLabel *size_ = nullptr, *base_ = nullptr;
};

}  // namespace relievo
