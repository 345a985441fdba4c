// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/package_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/language/core_text.h"
#include "ui/style/dialog_size.h"
#include "ui/style/mnemonic.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kPathRole = Qt::UserRole;

bool isRecording(const QString& file) {
  const QString ending = QFileInfo(file).suffix().toLower();
  return ending == QLatin1String("csv") || ending == QLatin1String("h5") ||
         ending == QLatin1String("hdf5");
}

QPushButton* button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QString::fromLatin1(name));
  made->setAccessibleName(withoutMnemonic(text).remove(u'\u2026'));
  made->setToolTip(tip);
  return made;
}

void packByAddress(QCheckBox& input, const QString& map) {
  input.setText(PackageDialog::tr("The map %1, by its address").arg(shownInMenu(map)));
  input.setToolTip(
      PackageDialog::tr("Of a map on the web only what was looked at is on this computer"));
  input.setChecked(false);
  input.setEnabled(false);
}

}  // namespace

PackageDialog::PackageDialog(const Offer& offer, QWidget* parent) : QDialog(parent) {
  setObjectName(QStringLiteral("package_dialog"));
  setWindowTitle(tr("Export archive package"));
  auto* column = new QVBoxLayout(this);
  auto* about = new QLabel(
      tr("One zip with this work as a project, what is ticked here, a README, and the checksum of "
         "each file. Recordings bring the rasters along that they need to be repeated."));
  about->setWordWrap(true);
  column->addWidget(about);
  const QFileInfo input(offer.input);
  with_input_ = new QCheckBox(
      tr("The &scan %1, %2")
          .arg(shownInMenu(offer.input),
               QLocale().formattedDataSize(input.size(), 1, QLocale::DataSizeSIFormat)));
  with_input_->setObjectName(QStringLiteral("package_input"));
  with_input_->setAccessibleName(tr("The scan %1").arg(shownName(offer.input)));
  with_input_->setToolTip(tr("Off: only its name and checksum, if it may not be given away"));
  with_input_->setChecked(true);
  if (isAddress(addressOrPath(offer.input))) packByAddress(*with_input_, offer.input);
  column->addWidget(with_input_);
  auto* title = new QLabel(tr("Recordings and &figures"));
  column->addWidget(title);
  files_ = new QListWidget;
  files_->setObjectName(QStringLiteral("package_files"));
  files_->setAccessibleName(tr("Recordings and figures"));
  files_->setToolTip(tr("Ticked files are packed"));
  title->setBuddy(files_);
  column->addWidget(files_, 1);
  for (const QString& file : offer.recordings + offer.figures) {
    if (QFileInfo::exists(file)) add(file);
  }
  auto* more =
      button(tr("&Add\u2026"), "package_add", tr("Take another recording or figure along"));
  connect(more, &QPushButton::clicked, this, &PackageDialog::ask);
  column->addWidget(more, 0, Qt::AlignLeft);

  auto* place = new QHBoxLayout;
  auto* label = new QLabel(tr("&Package"));
  file_ = new QLineEdit(QDir::toNativeSeparators(offer.file));
  file_->setObjectName(QStringLiteral("package_file"));
  file_->setAccessibleName(tr("Package"));
  file_->setToolTip(tr("Where the package is saved"));
  label->setBuddy(file_);
  auto* elsewhere = button(tr("&Browse\u2026"), "package_browse", tr("Choose another place"));
  connect(elsewhere, &QPushButton::clicked, this, &PackageDialog::browse);
  place->addWidget(label);
  place->addWidget(file_, 1);
  place->addWidget(elsewhere);
  column->addLayout(place);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  save_ = buttons->button(QDialogButtonBox::Save);
  save_->setObjectName(QStringLiteral("package_save"));
  connect(file_, &QLineEdit::textChanged, this,
          [this](const QString& text) { save_->setEnabled(!text.trimmed().isEmpty()); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  resizeToText(*this, {64, 20});
}

void PackageDialog::add(const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  for (int i = 0; i < files_->count(); ++i) {
    if (files_->item(i)->data(kPathRole).toString() != path) continue;
    files_->item(i)->setCheckState(Qt::Checked);
    return;
  }
  const QString name = shownName(file);
  auto* item = new QListWidgetItem(
      isRecording(file) ? tr("Recording %1").arg(name) : tr("Figure %1").arg(name), files_);
  item->setData(kPathRole, path);
  item->setToolTip(shownAsTip(path));
  item->setFlags(item->flags() | Qt::ItemIsUserCheckable);
  item->setCheckState(Qt::Checked);
}

void PackageDialog::ask() {
  const QStringList chosen = QFileDialog::getOpenFileNames(
      this, tr("Take along"), QFileInfo(file_->text()).absolutePath(),
      tr("Recordings and figures (*.csv *.h5 *.hdf5 *.png *.tif *.tiff *.pdf *.svg)"));
  for (const QString& file : chosen) add(file);
}

void PackageDialog::browse() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export archive package"),
                                                    file_->text(), tr("Packages (*.zip)"));
  if (!file.isEmpty()) file_->setText(QDir::toNativeSeparators(file));
}

PackageChoice PackageDialog::choice() const {
  PackageChoice choice;
  choice.file = QDir::fromNativeSeparators(file_->text().trimmed());
  if (!choice.file.endsWith(QLatin1String(".zip"), Qt::CaseInsensitive)) {
    choice.file += QLatin1String(".zip");
  }
  choice.with_input = with_input_->isChecked();
  for (int i = 0; i < files_->count(); ++i) {
    if (files_->item(i)->checkState() != Qt::Checked) continue;
    const QString file = files_->item(i)->data(kPathRole).toString();
    (isRecording(file) ? choice.recordings : choice.figures) << file;
  }
  return choice;
}

}  // namespace relievo
