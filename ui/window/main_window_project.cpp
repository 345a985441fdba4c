// SPDX-License-Identifier: BSD-3-Clause
// Projects and figures: the window's state as a file, and back.
#include <algorithm>
#include <QAction>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QStandardPaths>

#include "core/base/error.h"
#include "core/io/input_facts.h"
#include "core/project/carried_state.h"
#include "core/project/project_files.h"
#include "core/session/colours/surface_colours.h"
#include "ui/dialogs/figure_dialog.h"
#include "ui/frame/message_strip.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/replay_control.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"
#include "ui/work/work_keeper.h"

namespace relievo {
namespace {

std::filesystem::path pathOf(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

bool endsIn(const QString& file, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) {
    return file.endsWith(QLatin1String(ending), Qt::CaseInsensitive);
  });
}

/// A recording among the tables that carry a state.
bool isLog(const QString& file) {
  // Others need not be asked about; of these a broken one is shown as what its name says.
  if (endsIn(file, {".h5", ".hdf5"})) return true;
  if (!endsIn(file, {".csv"})) return false;
  try {
    return inputFacts(pathOf(file)).is_log;
  } catch (const Error&) {
    return false;  // Whoever opens it says what is wrong.
  }
}

/// NAME-1.png, NAME-2.png, ... in the pictures folder: the first that is free.
QString freeFigureName(const QString& model) {
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::PicturesLocation) +
                         QLatin1String("/relievo/");
  for (int n = 1;; ++n) {
    const QString file = QStringLiteral("%1%2-figure-%3.png").arg(folder, model).arg(n);
    if (!QFileInfo::exists(file)) return file;
  }
}

}  // namespace

Project MainWindow::keptWork() const {
  Project p = document_.stored();
  const QString& file = document_.projectFile();
  if (!file.isEmpty()) p.saved_as = bytesOfPath(QFileInfo(file).absoluteFilePath());
  return p;
}

void MainWindow::showTitle() {
  if (!document_.isOpen()) return;
  const QString& project = document_.projectFile();
  const QString shown = project.isEmpty() ? document_.file() : project;
  // Qt puts a star at the first [*] where something is unsaved.
  const QString name = shownName(shown).replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
  setWindowTitle(tr("%1[*] \u2013 relievo").arg(name));
  setWindowModified(hasUnsavedWork());
}

void MainWindow::restore(const Project& project, const QString& from) {
  Project found = project;
  if (!from.isEmpty() && !QFileInfo::exists(pathFromBytes(project.file))) {
    try {  // Moved together with what carries the state, or in a package.
      found.file = foundInput(pathOf(from), project.file).string();
    } catch (const FileError&) {  // Said below.
    }
  }
  // What was kept of a crash lies among the program's own files, and names what it named before.
  const QString carrier = from.isEmpty() ? recovered_copy_ : from;
  whenFilesMayBeRead(found, carrier, [this, found, from](const auto& withheld) {
    const std::filesystem::path input = found.file;
    if (std::find(withheld.begin(), withheld.end(), input) != withheld.end()) {
      tellInputWithheld(found, from);
      return;
    }
    withheld_ = withheld;
    restoreNow(found, from);
  });
}

void MainWindow::restoreOnChosen(const Project& project, const QString& from) {
  Project others = project;
  others.file.clear();
  const QString carrier = from.isEmpty() ? recovered_copy_ : from;
  whenFilesMayBeRead(others, carrier, [this, project, from](const auto& withheld) {
    withheld_ = withheld;
    restoreNow(project, from);
  });
}

void MainWindow::restoreNow(const Project& project, const QString& from) {
  OpenRequest request;
  request.file = pathFromBytes(project.file);
  request.project = project;
  request.project_file = endsIn(from, {".json"}) ? from : pathFromBytes(project.saved_as);
  if (!QFileInfo::exists(request.file)) {
    strip_->show(tr("%1 needs %2, which has moved. Nothing was changed. Find it, or choose another "
                    "file. (E501)")
                     .arg(shownName(from), shownPath(request.file)),
                 {{tr("&Find it\u2026"), [this, project, from] { relink(project, from); }},
                  {tr("&Choose another\u2026"), [this] { chooseFile(); }}});
    return;
  }
  open(request);
}

void MainWindow::relink(const Project& project, const QString& from) {
  auto* dialog = new QFileDialog(this, tr("Find %1").arg(shownName(pathFromBytes(project.file))),
                                 QFileInfo(from).absolutePath());
  dialog->setObjectName(QStringLiteral("relink_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, [this, project, from](const QString& file) {
    Project found = project;
    found.file = bytesOfPath(file);
    restoreOnChosen(found, from);
  });
  dialog->open();
}

// What a file that was opened begins, beside the state that the document has of it.
void MainWindow::showRestored() {
  figure_view_.reset();
  if (measure_panel_->measuring()) measure_panel_->cancel();
  keeper_->forget();
  showTitle();
  if (!restoring_) {
    withheld_.clear();
    return;
  }
  const Project stored = *std::exchange(restoring_, std::nullopt)->project;
  if (stored.figure.look != ReliefLook{}) figure_view_ = document_.project().look;
  if (!recovered_copy_.isEmpty()) {
    WorkKeeper::discard(std::exchange(recovered_copy_, QString()));
    document_.noteUnsaved();
    keeper_->changed();
    showTitle();
  }
  if (!stored.sha256.empty() && stored.sha256 != document_.fileSha256().toStdString()) {
    strip_->show(tr("%1 has changed since this was saved (its checksum differs). It is shown as it "
                    "is now; results may differ. (E501)")
                     .arg(shownName(document_.file())),
                 {{tr("&Find it\u2026"), [this, stored] {
                     const QString& project = document_.projectFile();
                     relink(stored, project.isEmpty() ? document_.file() : project);
                   }}});
  }
}

bool MainWindow::restoreFromFile(const QString& file) {
  if (isLog(file)) {
    replay(file);  // It brings its state along.
    return true;
  }
  if (openPackage(file)) return true;
  if (!endsIn(file, {".json", ".png", ".tif", ".tiff", ".pdf", ".svg", ".csv"})) return false;
  try {
    const auto project = carriedProject(pathOf(file));
    if (!project) return false;  // A height map or points, then.
    restore(*project, file);
    return true;
  } catch (const Error& error) {
    if (!endsIn(file, {".json"})) return false;  // The readers say what is wrong.
    showDamaged(shownError(error));
    return true;
  }
}

// A project that cannot be read: what else there is.
void MainWindow::showDamaged(const QString& text) {
  std::vector<MessageStrip::Button> buttons{
      {tr("&Choose another\u2026"), [this] { chooseFile(); }}};
  if (keeper_->left()) {
    buttons.push_back({tr("&Work that was kept\u2026"), [this] { offerLeftWork(); }});
  }
  strip_->show(text, buttons);
}

void MainWindow::saveProject() {
  if (document_.projectFile().isEmpty()) {
    saveProjectAs();
  } else {
    saveProject(document_.projectFile());
  }
}

void MainWindow::saveProjectAs(const std::function<void()>& then) {
  const QFileInfo input(document_.file());
  auto* dialog = new QFileDialog(this, tr("Save project"), input.absolutePath(),
                                 tr("Projects (*.relievo.json)"));
  dialog->setObjectName(QStringLiteral("project_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QString ending = QStringLiteral(".relievo.json");
  dialog->selectFile(stemOf(document_.file(), ending) + ending);
  connect(dialog, &QFileDialog::fileSelected, this, [this, then](const QString& file) {
    saveProject(endsIn(file, {".json"}) ? file : file + QLatin1String(".relievo.json"));
    if (then && !hasUnsavedWork()) then();
  });
  dialog->open();
}

void MainWindow::saveProject(const QString& file) {
  try {
    writeProject(pathOf(file), document_.stored());
    document_.noteSaved(file);
    showTitle();
    keeper_->forget();
    settings_.addRecentFile(file);
    showRecent();
    announce(tr("%1 is saved").arg(shownName(file)));
  } catch (const Error& error) {
    strip_->show(shownError(error));
  }
}

void MainWindow::chooseFigure() {
  if (!document_.isOpen() || document_.busy()) return;
  Project now = document_.stored();
  const std::string plotted = isWithheld(now.figure.recording) ? now.figure.recording : "";
  if (!plotted.empty()) now.figure.recording.clear();
  // A figure starts as the view is painted and lit; a look that was chosen for it stays until the
  // view's changes.
  if (figure_view_ != now.look) now.figure.look = now.look;
  now.figures.clear();  // They belong to the work, not to what one of them shows.
  auto* dialog = new FigureDialog(
      document_.surface(), now,
      freeFigureName(stemOf(document_.file(), QStringLiteral("-figure-9999-heights.tif"))), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setModal(true);  // The state must not change below a preview of it.
  connect(dialog, &FigureDialog::requestChanged, this,
          [this, plotted](const FigureRequest& request) {
            document_.amend([&](Project& p) {
              p.figure = request;
              if (request.recording.empty()) p.figure.recording = plotted;  // Not lost.
            });
            figure_view_ = document_.project().look;
          });
  connect(dialog, &FigureDialog::written, this, [this](const QString& file) {
    noteFigure(file);
    const QFileInfo saved(file);
    announce(tr("%1 is saved in %2").arg(shownName(file), shownPath(saved.absolutePath())));
  });
  dialog->show();
}

/// Once for each surface: whoever has been told and goes on knows.
void MainWindow::warnOfRivalry() {
  const auto window = document_.window();
  if (!document_.isOpen() || !window || document_.surface() == warned_of_rivalry_) return;
  const Project& shown = document_.project();
  const double share =
      rivalShare(*document_.surface(), *window, shown.look.kind, printed(shown.stereo.mode));
  if (share <= kMostRivalShare) return;
  warned_of_rivalry_ = document_.surface();
  announce(tr("%1 % of this picture is a strong red or cyan, which one eye sees dark through the "
              "glasses. Grey stereo shows it to both")
               .arg(std::lround(100 * share)));
}

void MainWindow::shareRange() {
  // Heights that are exaggerated have values of their own.
  const bool alike = document_.isOpen() && document_.project().gain == 1;
  detail_->setRange(alike ? reference_->shownRange() : std::nullopt);
}

}  // namespace relievo
