// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/export_dialog.h"

#include <array>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QStandardPaths>

#include "ui/language/core_text.h"

namespace relievo {
namespace {

constexpr std::array<std::pair<ExportFormat, const char*>, 8> kEndings{
    {{ExportFormat::cloud_geotiff, ".tif"},
     {ExportFormat::geotiff, ".tif"},
     {ExportFormat::gltf, ".glb"},
     {ExportFormat::ply, ".ply"},
     {ExportFormat::stl, ".stl"},
     {ExportFormat::xyz, ".xyz"},
     {ExportFormat::ascii_grid, ".asc"},
     {ExportFormat::vti, ".vti"}}};

/// A name in the documents folder that does not exist yet.
QString freeName(const QString& model, const QString& ending) {
  const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) +
                       QLatin1String("/relievo"));
  for (int n = 1;; ++n) {
    QString path = documents.filePath(QStringLiteral("%1-%2%3").arg(model).arg(n).arg(ending));
    if (!QFileInfo::exists(path)) return path;
  }
}

/// A choice as everything in a dialog is: named for speech, explained by a tip.
QComboBox* choiceOf(const char* name, const QString& title, const QString& tip) {
  auto* box = new QComboBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(title);
  box->setToolTip(tip);
  return box;
}

bool isFromTop(const Surface& surface) {
  const auto& m = surface.view_from_file.m;
  return m[0] > 0 && m[1] == 0 && m[2] == 0 && m[4] == 0 && m[6] == 0 && m[8] == 0 && m[9] == 0;
}

}  // namespace

ExportDialog::ExportDialog(std::shared_ptr<const Surface> surface, const Region& region,
                           const QString& model, std::vector<OtherExport> others, QWidget* parent)
    : QDialog(parent),
      surface_(std::move(surface)),
      region_(region),
      others_(std::move(others)),
      model_(model),
      format_(choiceOf("export_format", tr("Format"), tr("What the other program reads"))),
      part_(choiceOf("export_part", tr("Part"), tr("How much of the map is written"))),
      coordinates_(choiceOf("export_coordinates", tr("Coordinates"),
                            tr("In which coordinates and unit heights are written"))),
      file_(new QLineEdit),
      size_(new QLabel) {
  setObjectName(QStringLiteral("export_dialog"));
  setWindowTitle(tr("Export"));
  fillFormats();
  fillParts();
  fillCoordinates();
  file_->setText(freeName(model, ending()));
  connect(file_, &QLineEdit::textEdited, this, [this] { is_proposed_ = false; });
  file_->setObjectName(QStringLiteral("export_file"));
  file_->setAccessibleName(tr("File"));
  file_->setToolTip(tr("Where it is written"));
  file_->setMinimumWidth(360);
  size_->setObjectName(QStringLiteral("export_size"));
  size_->setAccessibleName(tr("Size"));
  auto* browse = new QPushButton(tr("&Browse\u2026"));
  browse->setAccessibleName(tr("Browse"));
  browse->setToolTip(tr("Choose another place"));
  connect(browse, &QPushButton::clicked, this, &ExportDialog::browse);
  for (QComboBox* box : {format_, part_, coordinates_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ExportDialog::follow);
  }
  auto* place = new QHBoxLayout;
  place->addWidget(file_, 1);
  place->addWidget(browse);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, [this] {
    QDir().mkpath(QFileInfo(chosenFile()).absolutePath());
    accept();
    if (other() != nullptr) {
      other()->write(chosenFile());
    } else {
      Q_EMIT chosen(order());
    }
  });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* layout = new QFormLayout(this);
  layout->addRow(tr("F&ormat"), format_);
  layout->addRow(tr("&Part"), part_);
  layout->addRow(tr("Coor&dinates"), coordinates_);
  auto* file_label = new QLabel(tr("&File"));
  layout->addRow(file_label, place);
  file_label->setBuddy(file_);  // A row of several fields has none of its own.
  layout->addRow(tr("Size"), size_);
  layout->addRow(buttons);
  follow();
}

void ExportDialog::fillFormats() {
  const std::array<QString, kEndings.size()> names{tr("Cloud-optimised GeoTIFF (.tif)"),
                                                   tr("GeoTIFF that relievo opens again (.tif)"),
                                                   tr("Mesh for web viewers, glTF (.glb)"),
                                                   tr("Mesh, PLY (.ply)"),
                                                   tr("Plate to print, STL (.stl)"),
                                                   tr("Points as text (.xyz)"),
                                                   tr("ESRI ASCII grid (.asc)"),
                                                   tr("VTK image (.vti)")};
  for (std::size_t i = 0; i < names.size(); ++i) {
    format_->addItem(names[i], static_cast<int>(kEndings[i].first));
  }
  for (const OtherExport& other : others_) format_->addItem(other.text);
}

void ExportDialog::fillParts() {
  part_->addItem(tr("Whole map"), -1);
  const int levels = surface_->ladder.levels();
  for (int level = 1; level < levels; ++level) {
    part_->addItem(tr("Whole map, resolution %1 of %2").arg(levels - level).arg(levels), level);
  }
  part_->addItem(tr("Window, 200 x 200 samples"), -2);
}

void ExportDialog::fillCoordinates() {
  coordinates_->addItem(tr("Millimetres above the base plane"), false);
  // Only a height that was seen from the top is a z of the file.
  if (isFromTop(*surface_)) coordinates_->addItem(tr("Those of the file"), true);
  coordinates_->setEnabled(coordinates_->count() > 1);
}

void ExportDialog::browse() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Export"), file_->text(),
      QStringLiteral("%1 (*%2)").arg(format_->currentText(), ending()));
  if (file.isEmpty()) return;
  is_proposed_ = false;
  file_->setText(file);
}

QString ExportDialog::ending() const {
  if (other() != nullptr) return other()->ending;
  const auto at = static_cast<std::size_t>(std::max(0, format_->currentIndex()));
  return QString::fromLatin1(kEndings[at].second);
}

const OtherExport* ExportDialog::other() const {
  const int at = format_->currentIndex() - static_cast<int>(kEndings.size());
  return at < 0 ? nullptr : &others_[static_cast<std::size_t>(at)];
}

QString ExportDialog::chosenFile() const {
  const QString file = file_->text();
  return file.endsWith(ending(), Qt::CaseInsensitive) ? file : file + ending();
}

void ExportDialog::follow() {
  if (is_proposed_) file_->setText(freeName(model_, ending()));
  const QFileInfo now(file_->text());
  QStringList known;
  for (const auto& [format, of_format] : kEndings) known << QString::fromLatin1(of_format);
  for (const OtherExport& one : others_) known << one.ending;
  for (const QString& of_format : known) {
    if (!file_->text().endsWith(of_format, Qt::CaseInsensitive)) continue;
    file_->setText(now.dir().filePath(now.completeBaseName() + ending()));
    break;
  }
  const bool is_map = other() == nullptr;
  part_->setEnabled(is_map);
  coordinates_->setEnabled(is_map && coordinates_->count() > 1);
  if (!is_map) {
    size_->setText(other()->size.isEmpty() ? tr("as long as its lines") : other()->size);
    return;
  }
  const MapExport choice = order().choice;
  const GridSize size = exportedSize(*surface_, choice);
  const QLocale locale;
  size_->setText(
      tr("%1 x %2 cells, about %3")
          .arg(locale.toString(size.cols), locale.toString(size.rows),
               locale.formattedDataSize(static_cast<qint64>(estimatedBytes(size, choice.format)), 1,
                                        QLocale::DataSizeSIFormat)));
}

ExportOrder ExportDialog::order() const {
  ExportOrder made;
  made.choice.format = static_cast<ExportFormat>(format_->currentData().toInt());
  made.choice.region = region_;
  const int part = part_->currentData().toInt();
  made.choice.part = part == -1   ? ExportPart::map
                     : part == -2 ? ExportPart::window
                                  : ExportPart::level;
  if (part > 0) made.choice.region.level = {part};
  made.choice.in_file_frame = coordinates_->currentData().toBool();
  made.file = chosenFile();
  return made;
}

}  // namespace relievo
