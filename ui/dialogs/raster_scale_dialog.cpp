// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/raster_scale_dialog.h"

#include <cmath>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>

#include "ui/dialogs/figure/figure_number.h"
#include "ui/language/core_text.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr int kDecimals = 3, kStepDecimals = 12;
constexpr double kLeastStepMm = 1e-12;

FigureNumber* number(const QString& name, const QString& title, const QString& tip) {
  auto* field = new FigureNumber;
  field->setObjectName(name);
  field->setAccessibleName(title);
  field->setToolTip(tip);
  return field;
}

}  // namespace

RasterScaleDialog::RasterScaleDialog(const RasterHead& raster, const ScaleInUse& now,
                                     QWidget* parent)
    : QDialog(parent),
      now_(now),
      cells_(raster.size),
      low_(raster.info.bounds->min.z),
      high_(raster.info.bounds->max.z),
      pixel_(number(QStringLiteral("raster_pixel"), tr("Distance of the pixels"),
                    tr("From one sample to the next, on the object"))),
      step_(number(QStringLiteral("raster_step"), tr("Height of a step"),
                   tr("By how much the surface rises where the value grows by 1"))),
      zero_(number(QStringLiteral("raster_zero"), tr("Value on the base plane"),
                   tr("Samples with this value lie at height 0, lower ones below it"))),
      deeper_(new QCheckBox(tr("&Larger values lie deeper"))),
      has_zero_(new QCheckBox(tr("&Base plane at the value"))),
      size_(new QLabel) {
  setObjectName(QStringLiteral("raster_scale_dialog"));
  setWindowTitle(tr("Size of the samples"));
  const QString mm = QStringLiteral(" mm");
  pixel_->setLimits(1e-6, 1e6, kDecimals, mm);
  step_->setLimits(kLeastStepMm, 1e6, kDecimals, mm);
  step_->setDecimals(kStepDecimals);  // Of 32 bits a step is far below a nanometre.
  step_->setMinimum(kLeastStepMm);
  zero_->setLimits(-1e12, 1e12, 0, {});
  pixel_->show(now.pixel_mm);
  step_->show(std::abs(now.height_mm));
  zero_->show(now.zero.value_or(now.lowest(low_, high_)));
  deeper_->setObjectName(QStringLiteral("raster_deeper"));
  deeper_->setToolTip(tr("As in pictures of distances from a camera"));
  deeper_->setChecked(now.height_mm < 0);
  has_zero_->setObjectName(QStringLiteral("raster_has_zero"));
  has_zero_->setToolTip(tr("Otherwise it is the lowest sample"));
  has_zero_->setChecked(now.zero.has_value());
  size_->setObjectName(QStringLiteral("raster_size"));
  size_->setAccessibleName(tr("Size that follows"));
  size_->setWordWrap(true);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    accept();
    Q_EMIT chosen(scale());
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (FigureNumber* field : {pixel_, step_, zero_}) {
    connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            &RasterScaleDialog::showSize);
  }
  connect(has_zero_, &QCheckBox::toggled, this, &RasterScaleDialog::showSize);
  auto* layout = new QFormLayout(this);
  layout->addRow(tr("&Distance of the pixels"), pixel_);
  layout->addRow(tr("&Height of a step of 1"), step_);
  layout->addRow(deeper_);
  layout->addRow(has_zero_, zero_);
  layout->addRow(tr("Size"), size_);
  layout->addRow(buttons);
  showSize();
}

RasterScale RasterScaleDialog::scale() const {
  const double step_mm = step_->valueOr(std::abs(now_.height_mm));
  return {.pixel_mm = pixel_->valueOr(now_.pixel_mm),
          .height_mm = deeper_->isChecked() ? -step_mm : step_mm,
          .zero = has_zero_->isChecked() ? std::optional(zero_->value()) : std::nullopt};
}

void RasterScaleDialog::showSize() {
  zero_->setEnabled(has_zero_->isChecked());
  const double mm = pixel_->value();
  size_->setText(
      sizeText({mm * (cells_.cols - 1), mm * (cells_.rows - 1), step_->value() * (high_ - low_)}));
}

}  // namespace relievo
