// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/firmness_row.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "plugins/haptics/panel/panel_widgets.h"
#include "plugins/haptics/shown_file.h"

namespace relievo {

FirmnessRow::FirmnessRow(QWidget* panel) : QObject(panel), panel_(panel) {
  name_ = readout("firmnessName", tr("Stiffness map in use"));
  choose_ = named(new QPushButton(tr("Choose…")), "firmnessChoose", tr("Choose a stiffness map"));
  choose_->setToolTip(
      tr("A raster over the whole map: 1 where the surface is stiff, 0 where it is as soft as set "
         "above. In place of where it was measured."));
  none_ = named(new QPushButton(tr("No&ne")), "firmnessNone",
                tr("No stiffness map: stiff where it was measured"));
  none_->setToolTip(tr("The surface is stiff where it was measured."));
  connect(choose_, &QPushButton::clicked, this, &FirmnessRow::ask);
  connect(none_, &QPushButton::clicked, this, [this] { Q_EMIT asked({}); });
}

void FirmnessRow::addTo(QFormLayout* form) {
  addLabelled(form, tr("Stiffness &map"), choose_, name_);
  auto* row = new QHBoxLayout;  // Of its own: beside them a name has no room.
  row->addWidget(choose_);
  row->addWidget(none_);
  form->addRow(row);
}

void FirmnessRow::setFile(const std::string& file) {
  file_ = file;
  show();
}

void FirmnessRow::setUsed(bool used) {
  used_ = used;
  show();
}

void FirmnessRow::ask() {
  auto* dialog = new QFileDialog(panel_, tr("Stiffness map"),
                                 QFileInfo(QFile::decodeName(file_.c_str())).absolutePath(),
                                 tr("Rasters (*.tif *.tiff *.asc *.png);;All files (*)"));
  dialog->setObjectName(QStringLiteral("firmness_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &FirmnessRow::asked);
  dialog->open();
}

void FirmnessRow::show() {
  const QString file = QFile::decodeName(file_.c_str());
  const QString name = shownFileName(file);
  const QString text = file_.empty() ? tr("where it was measured")
                       : used_       ? name
                                     : tr("%1 (not of this map)").arg(name);
  setTextIfNew(name_, text);
  name_->setToolTip(shownFilePath(file).toHtmlEscaped());
  choose_->setAccessibleDescription(text);
  none_->setEnabled(!file_.empty());
}

}  // namespace relievo
