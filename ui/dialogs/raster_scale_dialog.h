// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

#include "core/io/raster/raster.h"
#include "core/session/source/raster_scale.h"

class QCheckBox;
class QLabel;

namespace relievo {

class FigureNumber;

/// Asks how large the samples of a raster are that does not say so itself, and shows what becomes
/// of it. [GUI thread]
class RasterScaleDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param now  what it is taken for
  RasterScaleDialog(const RasterHead& raster, const ScaleInUse& now, QWidget* parent);

  RasterScale scale() const;

 Q_SIGNALS:
  void chosen(const relievo::RasterScale& scale);

 private:
  void showSize();

  ScaleInUse now_;
  GridSize cells_;
  double low_, high_;  ///< Of the file's values.
  FigureNumber *pixel_, *step_, *zero_;
  QCheckBox *deeper_, *has_zero_;
  QLabel* size_;
};

}  // namespace relievo
