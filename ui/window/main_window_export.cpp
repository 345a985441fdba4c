// SPDX-License-Identifier: BSD-3-Clause
// File > Export...: maps, meshes, pictures, profiles and sections for other programs.
#include <memory>
#include <QFile>
#include <QFileInfo>

#include "core/base/error.h"
#include "core/base/replaceable.h"
#include "core/io/raster/raster.h"
#include "core/project/project_files.h"
#include "core/provenance/provenance.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/measure_panel.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

std::filesystem::path pathOf(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

}  // namespace

void MainWindow::makeExportCommand() {
  commands_.on(Command::export_map, this, [this] { chooseExport(); });
}

void MainWindow::connectExports() {
  connect(&export_work_, &WorkQueue::busyChanged, this, &MainWindow::showBusy);
  connect(&export_work_, &WorkQueue::progressed, status_, &StatusFields::showWork);
  connect(status_, &StatusFields::cancelAsked, this, [this] {
    if (export_work_.cancel()) announce(tr("Cancelled. Nothing was exported."));
  });
}

void MainWindow::chooseExport() {
  if (!document_.isOpen()) return;
  auto* dialog = new ExportDialog(document_.surface(), document_.project().region,
                                  stemOf(document_.file(), QStringLiteral("-heights.origin.tif")),
                                  otherExports(), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ExportDialog::chosen, this,
          [this](const ExportOrder& order) { exportMap(order.choice, order.file); });
  dialog->open();
}

std::vector<OtherExport> MainWindow::otherExports() {
  std::vector<OtherExport> others;
  const auto add_picture = [&](const QString& text, ImageSource source, const QSize& pixels) {
    others.push_back(
        {text, QStringLiteral(".png"),
         tr("%1 x %2 pixels; File > Image asks for others")
             .arg(pixels.width())
             .arg(pixels.height()),
         [this, source, pixels](const QString& file) { saveImage(source, pixels, file); }});
  };
  add_picture(tr("Picture of the detail view (.png)"), ImageSource::detail, detail_->shotSize());
  add_picture(tr("Picture of the whole object (.png)"), ImageSource::reference,
              reference_->shotSize());
  const std::vector<Measurement>& all = measure_panel_->measurements();
  for (int row = 0; row < static_cast<int>(all.size()); ++row) {
    const Measurement& m = all[static_cast<std::size_t>(row)];
    const bool is_profile = m.kind == MeasureKind::profile;
    if (!is_profile && m.kind != MeasureKind::section) continue;
    const QString name = QString::fromStdString(m.name);
    for (const bool drawn : {true, false}) {
      const QString text =
          is_profile
              ? (drawn ? tr("Profile %1, drawing (.svg)") : tr("Profile %1, numbers (.csv)"))
              : (drawn ? tr("Section %1, drawing (.svg)") : tr("Section %1, numbers (.csv)"));
      others.push_back({text.arg(name),
                        drawn ? QStringLiteral(".svg") : QStringLiteral(".csv"),
                        {},
                        [this, row](const QString& file) {
                          tellWritten(file,
                                      [this, row, file] { measure_panel_->writeRow(row, file); });
                        }});
    }
  }
  return others;
}

void MainWindow::tellWritten(const QString& file, const std::function<void()>& write) {
  try {
    write();
    announce(tr("%1 is saved").arg(shownName(file)));
  } catch (const Error& error) {
    strip_->show(spokenError(error));
  }
}

void MainWindow::exportMap(const MapExport& choice, const QString& file) {
  struct Work {
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const RasterMap> raster;
    Provenance provenance;
    MapExport choice;
    std::filesystem::path scan, file;
    ExportedMap written;
    QString error;
  };
  const auto work = std::make_shared<Work>();
  work->surface = document_.surface();
  work->raster = document_.source().raster;
  work->provenance = document_.provenanceIn(file);
  work->provenance.view.reset();  // Of the map, whatever is shown of it.
  work->choice = choice;
  work->scan = pathOf(document_.file());
  work->file = pathOf(file);
  export_work_.add(
      [work](const Task& task) {
        try {
          requireNotAnInput(work->file, {{.file = work->scan}});
          const std::filesystem::path folder = work->file.parent_path();
          work->provenance.input =
              inputFile(work->scan, folder.empty() ? std::filesystem::path(".") : folder, task);
          work->choice.state = toJson(work->provenance, -1);
          work->written = relievo::exportMap(work->file, *work->surface, work->choice,
                                             work->raster.get(), task);
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const std::exception& failure) {
          work->error = shownError(failure);
        }
      },
      [this, work, file] {
        if (!work->error.isEmpty()) {
          strip_->show(work->error);
          closeIfAwaited(false);
          return;
        }
        announce(tr("%1 is saved").arg(shownName(file)));
        QStringList left_out;
        for (const std::string& words : work->written.left_out) {
          left_out << QString::fromStdString(words);
        }
        if (!left_out.isEmpty()) strip_->show(left_out.join(' '));
        closeIfAwaited(left_out.isEmpty());
      });
}

}  // namespace relievo
