// SPDX-License-Identifier: BSD-3-Clause
// File > Export...: maps and meshes for other programs.
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
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

std::filesystem::path pathOf(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

}  // namespace

void MainWindow::makeExportCommand() {
  make({"export",
        tr("E&xport\u2026"),
        {},
        tr("A map or mesh for other programs"),
        [this] { chooseExport(); },
        {}});
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
  auto* dialog =
      new ExportDialog(document_.surface(), document_.project().region,
                       stemOf(document_.file(), QStringLiteral("-heights.origin.tif")), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ExportDialog::chosen, this,
          [this](const ExportOrder& order) { exportMap(order.choice, order.file); });
  dialog->open();
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
