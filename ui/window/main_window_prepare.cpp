// SPDX-License-Identifier: BSD-3-Clause
// Surface > Prepare..., and several scans that are opened together.
#include <cmath>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

#include "core/base/error.h"
#include "core/io/input_facts.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/start_page.h"
#include "ui/language/spoken_error.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

std::filesystem::path pathOf(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

/// Which directions of the file a view looks along, without its scale.
Rotation rotationOf(const ViewFromFile& view_from_file) {
  const auto& m = view_from_file.m;
  const double scale = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  return {m[0] / scale, m[1] / scale, m[2] / scale, m[4] / scale, m[5] / scale,
          m[6] / scale, m[8] / scale, m[9] / scale, m[10] / scale};
}

/// Those that hold points. @throw Error  none can be read here
QStringList scansAmong(const QStringList& files) {
  std::vector<std::filesystem::path> paths;
  for (const QString& file : files) paths.push_back(pathOf(file));
  const auto facts = inputFacts(paths);
  QStringList scans;
  for (int i = 0; i < files.size(); ++i) {
    const auto& of_file = facts[static_cast<std::size_t>(i)];
    if (of_file && of_file->kind == InputKind::scan) scans << files[i];
  }
  return scans;
}

}  // namespace

void MainWindow::makePrepareCommands() {
  commands_.on(Command::open_folder, this, [this] { chooseFolder(); });
  commands_.on(Command::prepare, this, [this] { choosePrepare(); });
}

void MainWindow::chooseFolder() {
  auto* dialog = new QFileDialog(this, tr("Open folder"));
  dialog->setObjectName(QStringLiteral("open_folder_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly, true);
  const QString folder = settings_.layout(QStringLiteral("folder")).toString();
  if (!folder.isEmpty()) dialog->setDirectory(folder);
  connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::openFolder);
  dialog->open();
}

void MainWindow::openFolder(const QString& folder) {
  settings_.setLayout(QStringLiteral("folder"), QFileInfo(folder).absoluteFilePath());
  QStringList files;
  for (const QFileInfo& file :
       QDir(folder).entryInfoList(scanPatterns(), QDir::Files, QDir::Name)) {
    files << file.absoluteFilePath();
  }
  try {
    files = scansAmong(files);
  } catch (const Error& error) {
    strip_->show(shownError(error));
    return;
  }
  if (files.isEmpty()) {
    strip_->show(tr("There is no scan in %1. Nothing was opened.").arg(shownPath(folder)));
    return;
  }
  openTogether(files);
}

void MainWindow::openPaths(const QStringList& paths) {
  if (paths.size() == 1 && QFileInfo(paths.front()).isDir()) {
    openFolder(paths.front());
  } else {
    openTogether(paths);
  }
}

void MainWindow::openTogether(const QStringList& files) {
  if (files.size() == 1) {
    open(files.front());
    return;
  }
  if (files.size() > static_cast<int>(kMostScans)) {
    strip_->show(tr("%1 files are more than the %2 scans that can be joined. Nothing was opened.")
                     .arg(files.size())
                     .arg(kMostScans));
    return;
  }
  whenNothingIsUnsaved([this, files] {
    PrepareStart start;
    for (const QString& file : files) {
      PrepareInput input;
      input.file = pathOf(QFileInfo(file).absoluteFilePath());
      input.unit = settings_.unitOfFolder(file);
      start.inputs.push_back(input);
    }
    showPrepare(start, [this](const QString& file) {
      OpenRequest request;
      request.file = file;
      restoring_.reset();
      open(request);
    });
  });
}

void MainWindow::choosePrepare() {
  if (document_.busy() || !document_.canRemake() || !document_.source().scan) return;
  const Project& opened = document_.project();
  PrepareInput input{
      .file = opened.file, .read = opened.scan, .accept_incomplete = opened.accept_incomplete};
  // What the window takes the coordinates for; a recipe has to say so where the file does not.
  const Surface& surface = *document_.surface();
  if (surface.unit_source != UnitSource::assumed && surface.unit_source != UnitSource::file) {
    input.unit = surface.unit;
  }
  showPrepare({.inputs = {input},
               .scan = document_.source().scan,
               .sha256 = opened.sha256,
               .view = rotationOf(surface.view_from_file)},
              [this](const QString& file) {
                OpenRequest request;
                request.file = file;
                request.step = tr("Prepare");
                // The prepared file says its unit.
                request.options = document_.project().options;
                request.options->unit.reset();
                request.options->unit_source = UnitSource::given;
                open(request);
              });
}

void MainWindow::showPrepare(const PrepareStart& start,
                             const std::function<void(const QString&)>& then) {
  auto* dialog = new PrepareDialog(start, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &PrepareDialog::said, this, &MainWindow::announce);
  connect(dialog, &PrepareDialog::prepared, this, then);
  dialog->setModal(true);  // The document must not change below it.
  dialog->show();
}

}  // namespace relievo
