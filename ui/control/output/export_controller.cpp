// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/export_controller.h"

#include <memory>
#include <QFileInfo>

#include "core/base/error.h"
#include "core/base/replaceable.h"
#include "core/io/raster/raster.h"
#include "core/project/project_files.h"
#include "core/provenance/provenance.h"
#include "ui/control/output/picture_controller.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/language/error_text.h"
#include "ui/panels/measure_panel.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {

ExportController::ExportController(const ControllerParts& parts, const Sources& sources)
    : Controller(parts), sources_(sources) {
  commands_.on(Command::export_map, this, [this] { choose(); });
  messages_.follow(work_);
  connect(&messages_, &WindowMessages::cancelAsked, this, [this] {
    if (work_.cancel()) announce(tr("Cancelled. Nothing was exported."));
  });
}

void ExportController::choose() {
  if (!document_.isOpen()) return;
  auto* dialog = new ExportDialog(document_.surface(), document_.project().region,
                                  stemOf(document_.file(), QStringLiteral("-heights.origin.tif")),
                                  otherExports(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ExportDialog::chosen, this,
          [this](const ExportOrder& order) { write(order.choice, order.file); });
  dialog->open();
}

std::vector<OtherExport> ExportController::otherExports() {
  std::vector<OtherExport> others;
  const auto add_picture = [&](const QString& text, ImageSource source, const QSize& pixels) {
    others.push_back({text, QStringLiteral(".png"),
                      tr("%1 x %2 pixels; File > Image asks for others")
                          .arg(pixels.width())
                          .arg(pixels.height()),
                      [this, source, pixels](const QString& file) {
                        sources_.pictures.save(source, pixels, file);
                      }});
  };
  add_picture(tr("Picture of the detail view (.png)"), ImageSource::detail,
              sources_.detail.shotSize());
  add_picture(tr("Picture of the whole object (.png)"), ImageSource::reference,
              sources_.reference.shotSize());
  const std::vector<Measurement>& all = sources_.measure.measurements();
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
                          messages_.tellWritten(
                              file, [this, row, file] { sources_.measure.writeRow(row, file); });
                        }});
    }
  }
  return others;
}

void ExportController::write(const MapExport& choice, const QString& file) {
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
  work_.add(
      [work](const Task& task) {
        try {
          requireNotAnInput(work->file, {{.file = work->scan}});
          const std::filesystem::path folder = work->file.parent_path();
          work->provenance.input =
              inputFile(work->scan, folder.empty() ? std::filesystem::path(".") : folder, task);
          work->choice.state = toJson(work->provenance, -1);
          work->written =
              exportMap(work->file, *work->surface, work->choice, work->raster.get(), task);
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const std::exception& failure) {
          work->error = shownError(failure);
        }
      },
      [this, work, file] {
        if (!work->error.isEmpty()) {
          messages_.show(work->error);
          Q_EMIT ended(false);
          return;
        }
        announce(tr("%1 is saved").arg(shownName(file)));
        QStringList left_out;
        for (const std::string& words : work->written.left_out) {
          left_out << QString::fromStdString(words);
        }
        if (!left_out.isEmpty()) messages_.show(left_out.join(' '));
        Q_EMIT ended(left_out.isEmpty());
      });
}

}  // namespace relievo
