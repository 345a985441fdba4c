// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/image_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>

#include "ui/language/core_text.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr int kMostPixels = 16000;  // Above, software graphics return a black image.

QSpinBox* pixelField(const QString& name, const QString& title, int value) {
  auto* box = new QSpinBox;
  box->setObjectName(name);
  box->setAccessibleName(title);
  box->setToolTip(title);
  box->setRange(16, kMostPixels);
  box->setSuffix(QStringLiteral(" px"));
  box->setValue(value);
  return box;
}

/// A name in the pictures folder that does not exist yet.
QString freeName(const QString& model) {
  const QDir pictures(QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) +
                      QLatin1String("/relievo"));
  for (int n = 1;; ++n) {
    QString path = pictures.filePath(QStringLiteral("%1-%2.png").arg(model).arg(n));
    if (!QFileInfo::exists(path)) return path;
  }
}

}  // namespace

ImageDialog::ImageDialog(const QString& model, const QSize& first_size, QWidget* parent)
    : QDialog(parent),
      source_(new QComboBox),
      width_(pixelField(QStringLiteral("image_width"), tr("Width"), first_size.width())),
      height_(pixelField(QStringLiteral("image_height"), tr("Height"), first_size.height())),
      file_(new QLineEdit(freeName(model))),
      both_eyes_(new QCheckBox(tr("Both &eyes as files"))) {
  setObjectName(QStringLiteral("image_dialog"));
  setWindowTitle(tr("Save picture"));
  source_->setObjectName(QStringLiteral("image_source"));
  source_->setAccessibleName(tr("Picture of"));
  source_->setToolTip(tr("What the picture shows"));
  source_->addItem(tr("Detail view"), static_cast<int>(ImageSource::detail));
  source_->addItem(tr("Overview"), static_cast<int>(ImageSource::reference));
  source_->addItem(tr("Whole window"), static_cast<int>(ImageSource::window));
  file_->setObjectName(QStringLiteral("image_file"));
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("Where the picture is saved"));
  file_->setMinimumWidth(360);
  both_eyes_->setObjectName(QStringLiteral("image_both_eyes"));
  both_eyes_->setAccessibleName(withoutMnemonic(both_eyes_->text()));
  both_eyes_->setToolTip(
      tr("Also each eye's picture of the detail, as NAME.left.png and NAME.right.png"));
  connect(source_, QOverload<int>::of(&QComboBox::currentIndexChanged), both_eyes_,
          [this] { both_eyes_->setEnabled(choice().source == ImageSource::detail); });
  auto* browse = new QPushButton(tr("&Browse\u2026"));
  browse->setAccessibleName(tr("Browse"));
  browse->setToolTip(tr("Choose another place"));
  connect(browse, &QPushButton::clicked, this, [this] {
    const QString file = QFileDialog::getSaveFileName(this, tr("Save picture"), file_->text(),
                                                      tr("PNG pictures (*.png)"));
    if (!file.isEmpty()) file_->setText(file);
  });
  auto* sizes = new QHBoxLayout;
  sizes->addWidget(width_);
  sizes->addWidget(height_);
  sizes->addStretch(1);
  auto* place = new QHBoxLayout;
  place->addWidget(file_, 1);
  place->addWidget(browse);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    const ImageChoice made = choice();
    QDir().mkpath(QFileInfo(made.file).absolutePath());
    accept();
    Q_EMIT chosen(made);
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QFormLayout(this);
  layout->addRow(tr("&Picture of"), source_);
  // A row of several fields has none of its own that its label could lead to.
  const auto addRow = [layout](const QString& text, QLayout* fields, QWidget* first) {
    auto* label = new QLabel(text);
    layout->addRow(label, fields);
    label->setBuddy(first);
  };
  addRow(tr("Si&ze"), sizes, width_);
  addRow(tr("&File"), place, file_);
  layout->addRow(QString(), both_eyes_);
  layout->addRow(buttons);
}

ImageChoice ImageDialog::choice() const {
  QString file = file_->text();
  if (!file.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) file += QLatin1String(".png");
  return {static_cast<ImageSource>(source_->currentData().toInt()),
          {width_->value(), height_->value()},
          file,
          both_eyes_->isEnabled() && both_eyes_->isChecked()};
}

}  // namespace relievo
