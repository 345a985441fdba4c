// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/tiled_map_dialog.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "core/base/threads.h"
#include "ui/dialogs/depth_map_preview.h"
#include "ui/dialogs/named_fields.h"
#include "ui/dialogs/scan_choices.h"
#include "ui/language/core_text.h"
#include "ui/style/dialog_size.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr int kPathRole = Qt::UserRole;
constexpr int kShownNames = 4;  // Of the list, without a scroll bar.

}  // namespace

TiledMapDialog::TiledMapDialog(const TiledMapOrder& begun, QWidget* parent)
    : QDialog(parent),
      names_(
          namedField(new QListWidget, "tiles_scan", tr("Scan"),
                     tr("LAS, LAZ or binary PLY files and folders of them, which are one scan, or "
                        "one height raster"))),
      files_(namedButton(tr("F&iles\u2026"), "tiles_files", tr("Take files into the list"))),
      folder_(namedButton(tr("Fo&lder\u2026"), "tiles_folder",
                          tr("Take all LAS, LAZ and PLY files of a folder"))),
      remove_(
          namedButton(tr("&Remove"), "tiles_remove", tr("Take the chosen entries from the list"))),
      browse_(namedButton(tr("&Browse\u2026"), "tiles_browse", tr("Choose another place"))),
      file_(namedField(new QLineEdit, "tiles_file", tr("Map"),
                       tr("Where the finest level is written; the others lie beside it"))),
      unit_(namedField(new QComboBox, "tiles_unit", tr("Unit of the file"),
                       tr("Length unit of the file's coordinates"))),
      view_(namedField(new QComboBox, "tiles_view", tr("View"),
                       tr("From which side the object is seen"))),
      memory_(namedField(new QSpinBox, "tiles_memory", tr("Memory"),
                         tr("What the work may take beside the program itself"))),
      threads_(namedField(new QSpinBox, "tiles_threads", tr("Cores"), tr("How many work at once"))),
      keeps_(namedField(new QCheckBox(tr("&Keep what is finished, to go on after a stop")),
                        "tiles_keeps", tr("Keep what is finished, to go on after a stop"),
                        tr("In a folder beside the map, until the map is made"))),
      opens_(namedField(new QCheckBox(tr("&Open the map when it is made")), "tiles_opens",
                        tr("Open the map when it is made"), tr("In the place of what is open"))),
      preview_(new DepthMapPreview),
      ready_(namedField(new QLabel, "tiles_ready", tr("What is ready"), {})),
      step_(namedField(new QLabel, "tiles_step", tr("What is being done"), {})),
      problem_(namedField(new QLabel, "tiles_problem", tr("Problem"), {})),
      bar_(namedField(new QProgressBar, "tiles_progress", tr("Progress"), {})),
      stop_(namedButton(tr("&Stop"), "tiles_stop", tr("Stop the work"))) {
  setObjectName(QStringLiteral("tiled_map_dialog"));
  setWindowTitle(tr("Map by tiles"));
  fillChoices();
  auto* columns = new QHBoxLayout;
  columns->addLayout(form(), 3);
  columns->addLayout(readyColumn(), 2);
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns, 1);
  problem_->setWordWrap(true);
  problem_->hide();
  all->addWidget(problem_);
  all->addLayout(bottomRow());
  fill(begun);
  showBusy(false);
  follow();
  resizeToText(*this, {120, 26});
}

void TiledMapDialog::fillChoices() {
  names_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  names_->setMinimumHeight(kShownNames * fontMetrics().lineSpacing());
  unit_->addItem(tr("From the file"), -1);
  addUnits(*unit_);
  view_->addItem(tr("From the file"), QString());
  addViews(*view_);
  memory_->setRange(64, 1'000'000);
  memory_->setSingleStep(500);
  memory_->setSuffix(QStringLiteral(" MB"));
  threads_->setRange(0, kMostThreads);
  threads_->setSpecialValueText(tr("All"));
  bar_->setRange(0, 100);
}

void TiledMapDialog::fill(const TiledMapOrder& order) {
  if (order.unit) unit_->setCurrentIndex(unit_->findData(static_cast<int>(*order.unit)));
  view_->setCurrentIndex(std::max(0, view_->findData(order.view)));
  memory_->setValue(order.memory_mb);
  threads_->setValue(order.threads);
  keeps_->setChecked(order.keeps_parts);
  opens_->setChecked(order.opens);
  is_proposed_ = order.file.isEmpty();
  file_->setText(order.file);
  addNames(order.names);
}

QBoxLayout* TiledMapDialog::scanRow() {
  connect(files_, &QPushButton::clicked, this, [this] {
    addNames(QFileDialog::getOpenFileNames(
        this, tr("Map by tiles"), {},
        tr("Scans and height rasters (*.las *.laz *.ply *.tif *.tiff *.asc *.png);;All files "
           "(*)")));
  });
  connect(folder_, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Map by tiles"));
    if (!folder.isEmpty()) addNames({folder});
  });
  connect(remove_, &QPushButton::clicked, this, [this] {
    qDeleteAll(names_->selectedItems());
    follow();
  });
  connect(names_, &QListWidget::itemSelectionChanged, this, &TiledMapDialog::follow);
  auto* beside = new QVBoxLayout;
  for (QPushButton* one : {files_, folder_, remove_}) beside->addWidget(one);
  beside->addStretch(1);
  auto* row = new QHBoxLayout;
  row->addWidget(names_, 1);
  row->addLayout(beside);
  return row;
}

QBoxLayout* TiledMapDialog::fileRow() {
  connect(file_, &QLineEdit::textEdited, this, [this] { is_proposed_ = false; });
  connect(file_, &QLineEdit::textChanged, this, &TiledMapDialog::follow);
  connect(browse_, &QPushButton::clicked, this, &TiledMapDialog::browse);
  auto* row = new QHBoxLayout;
  row->addWidget(file_, 1);
  row->addWidget(browse_);
  return row;
}

QFormLayout* TiledMapDialog::form() {
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  const auto row = [&](const QString& title, QWidget* widget, QLayout* layout = nullptr) {
    auto* label = new QLabel(title);
    label->setBuddy(widget);  // A row of several fields has none of its own.
    if (layout != nullptr) {
      form->addRow(label, layout);
    } else {
      form->addRow(label, widget);
    }
  };
  row(tr("Sca&n"), names_, scanRow());
  row(tr("&Map"), file_, fileRow());
  row(tr("&Unit of the file"), unit_);
  row(tr("&View"), view_);
  row(tr("M&emory"), memory_);
  row(tr("&Cores"), threads_);
  form->addRow(keeps_);
  form->addRow(opens_);
  return form;
}

QBoxLayout* TiledMapDialog::readyColumn() {
  preview_->setObjectName(QStringLiteral("tiles_preview"));
  preview_->setAccessibleName(tr("What is ready of the map"));
  preview_->setStale(false);
  preview_->setMaskShown(false);  // A sample leaves more unmeasured than the map will.
  ready_->setWordWrap(true);
  ready_->setText(tr("While the map is made, what is ready of it is shown here."));
  auto* column = new QVBoxLayout;
  column->addWidget(preview_, 1);
  column->addWidget(ready_);
  return column;
}

QBoxLayout* TiledMapDialog::bottomRow() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  nameButtons(*buttons);
  buttons->button(QDialogButtonBox::Close)->setAutoDefault(false);  // Return makes the map.
  make_ = namedButton(tr("M&ake"), "tiles_make", tr("Make the map"));
  make_->setDefault(true);
  buttons->addButton(make_, QDialogButtonBox::ActionRole);
  connect(make_, &QPushButton::clicked, this, &TiledMapDialog::makeAsked);
  connect(stop_, &QPushButton::clicked, this, &TiledMapDialog::stopAsked);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  auto* row = new QHBoxLayout;
  row->addWidget(step_);
  row->addWidget(bar_, 1);
  row->addWidget(stop_);
  row->addStretch(1);
  row->addWidget(buttons);
  return row;
}

void TiledMapDialog::addNames(const QStringList& names) {
  for (const QString& name : names) {
    const QString path = QFileInfo(name).absoluteFilePath();
    auto* item = new QListWidgetItem(shownName(path), names_);
    item->setData(kPathRole, path);
    item->setToolTip(shownAsTip(path));
  }
  if (names_->count() > 0 && is_proposed_) {
    const QString first = names_->item(0)->data(kPathRole).toString();
    const QString more = QStringLiteral("-map.relievo.origin.tif");
    file_->setText(folderFor(first) + '/' + stemOf(first, more) +
                   QLatin1String("-map.relievo.tif"));
  }
  follow();
}

void TiledMapDialog::browse() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Map by tiles"), file_->text(), tr("GeoTIFF (*.tif)"));
  if (file.isEmpty()) return;
  is_proposed_ = false;
  file_->setText(file);
}

void TiledMapDialog::follow() {
  remove_->setEnabled(stop_->isHidden() && !names_->selectedItems().isEmpty());
  make_->setEnabled(stop_->isHidden() && names_->count() > 0 && !file_->text().isEmpty());
}

TiledMapOrder TiledMapDialog::order() const {
  TiledMapOrder made;
  for (int i = 0; i < names_->count(); ++i) {
    made.names << names_->item(i)->data(kPathRole).toString();
  }
  const QString file = file_->text();
  const QString ending = QStringLiteral(".tif");
  made.file = file.endsWith(ending, Qt::CaseInsensitive) ? file : file + ending;
  if (const int unit = unit_->currentData().toInt(); unit >= 0) {
    made.unit = static_cast<LengthUnit>(unit);
  }
  made.view = view_->currentData().toString();
  made.memory_mb = memory_->value();
  made.threads = threads_->value();
  made.keeps_parts = keeps_->isChecked();
  made.opens = opens_->isChecked();
  return made;
}

void TiledMapDialog::showReady(const DepthMapPicture& picture, const QString& words) {
  preview_->setPicture(picture);
  ready_->setText(words);
}

void TiledMapDialog::showProgress(const QString& step, double fraction, const QString& left) {
  step_->setText(left.isEmpty() ? step : QStringLiteral("%1, %2").arg(step, left));
  bar_->setValue(static_cast<int>(100 * fraction));
}

void TiledMapDialog::showBusy(bool busy) {
  for (QWidget* one : std::initializer_list<QWidget*>{step_, bar_, stop_}) one->setVisible(busy);
  for (QWidget* one : std::initializer_list<QWidget*>{names_, files_, folder_, browse_, file_,
                                                      unit_, view_, memory_, threads_, keeps_}) {
    one->setEnabled(!busy);
  }
  if (busy) {
    bar_->setValue(0);
    step_->clear();
    preview_->setPicture({});  // Of other choices, perhaps.
    ready_->setText(tr("Nothing of it can be seen yet."));
  }
  follow();
}

void TiledMapDialog::showProblem(const QString& text) {
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
}

}  // namespace relievo
