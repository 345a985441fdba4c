// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/package_controller.h"

#include <algorithm>
#include <memory>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "core/base/failure.h"
#include "core/io/input_facts.h"
#include "core/project/embedded_state.h"
#include "core/project/package.h"
#include "core/project/unpacked_package.h"
#include "ui/control/foreign_files.h"
#include "ui/dialogs/package_dialog.h"
#include "ui/language/error_text.h"
#include "ui/work/file_names.h"
#include "ui/work/file_path.h"

namespace relievo {
namespace {

/// A file with its path as it is here, and its checksum.
InputFile asItIs(const QString& file, const Task& task) {
  InputFile known = inputFile(pathOf(file), {}, task);
  known.file = pathOf(QFileInfo(file).absoluteFilePath()).generic_string();
  return known;
}

/// @throw ArgumentError  the recording says that another scan was touched
void requireSameScan(const QString& recording, const Project& project) {
  const auto touched = embeddedProject(pathOf(recording));
  if (!touched || touched->sha256 == project.sha256) return;
  throw failure<MessageId::recording_of_other_input>(
      shownName(recording).toStdString(), shownName(pathFromBytes(touched->file)).toStdString());
}

}  // namespace

void PackageController::setDependencies(DependenciesOf dependencies) {
  dependencies_ = std::move(dependencies);
}

PackageController::PackageController(const ControllerParts& parts, const ForeignFiles& foreign)
    : Controller(parts), foreign_(foreign) {
  commands_.on(Command::package, this, [this] { choose(); });
  for (WorkQueue* work : {&work_, &unpack_work_}) {
    connect(work, &WorkQueue::busyChanged, &messages_, &WindowMessages::showBusy);
  }
  connect(&messages_, &WindowMessages::cancelAsked, this, [this] {
    if (work_.cancel()) announce(tr("Cancelled. Nothing was packed."));
    if (unpack_work_.cancel()) announce(tr("Cancelled. Nothing was opened."));
  });
}

void PackageController::choose() {
  if (!document_.isOpen() || document_.loader().busy() || work_.busy()) return;
  const QString& project = document_.saved().projectFile();
  const QString& near = project.isEmpty() ? document_.file() : project;
  const QString more = QStringLiteral("-package.zip");
  const QString name = isAddress(addressOrPath(near))
                           ? stemOf(near, more)
                           : QFileInfo(near).fileName().section('.', 0, 0);
  const QString stem = stemOf(name + '.', more);
  QStringList figures;
  for (const std::string& figure : document_.project().figures) {
    if (foreign_.isWithheld(figure)) continue;
    const QString file = pathFromBytes(figure);
    if (QFileInfo::exists(file)) figures << file;
  }
  QStringList recordings;
  for (const InputFile& recording : document_.project().recordings) {
    if (!foreign_.isWithheld(recording.file)) recordings << pathFromBytes(recording.file);
  }
  auto* dialog = new PackageDialog(
      {document_.file(), recordings, figures, QDir(folderFor(near)).filePath(stem + more)},
      &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { write(dialog->choice()); });
  dialog->open();
}

void PackageController::write(const PackageChoice& choice) {
  const auto error = std::make_shared<QString>();
  const auto files = std::make_shared<std::uint64_t>(0);
  work_.add(
      [choice, error, files, project = document_.stored(),
       dependencies = dependencies_](const Task& task) {
        try {
          Project packed = project;
          packed.recordings.clear();
          for (const QString& recording : choice.recordings) {
            requireSameScan(recording, project);
            packed.recordings.push_back(asItIs(recording, task));
          }
          PackageContents contents{.with_input = choice.with_input};
          for (const QString& figure : choice.figures) contents.figures.push_back(pathOf(figure));
          if (dependencies) {
            contents.dependencies = [&](const std::filesystem::path& recording, const Task& work) {
              return dependencies(recording, choice.with_input, work);
            };
          }
          const std::filesystem::path target = pathOf(choice.file);
          writePackage(target, packed, contents, task);
          *files = verifyPackage(target, task).files;
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const std::exception& failure) {
          *error = shownError(failure);
        }
      },
      [this, choice, error, files] {
        if (!error->isEmpty()) {
          messages_.show(*error);
        } else {
          announce(tr("%1 is packed: %n file(s), each with its checksum", nullptr,
                      static_cast<int>(*files))
                       .arg(shownName(choice.file)));
        }
        Q_EMIT ended(error->isEmpty());
      });
}

bool PackageController::unpack(const QString& file, const QString& into) {
  try {
    if (inputFacts(pathOf(file)).host_file != HostFileKind::package) return false;
  } catch (const Error&) {
    return false;  // Who opens it says why it cannot be read.
  }
  struct Unpacked {
    QString error, project;
    bool not_there = false;  ///< Another folder may take it.
    int problems = 0;
  };
  const auto unpacked = std::make_shared<Unpacked>();
  const QString parent = into.isEmpty() ? QFileInfo(file).absolutePath() : into;
  unpack_work_.add(
      [file, parent, unpacked](const Task& task) {
        try {
          const std::filesystem::path package = pathOf(file);
          unpacked->problems = static_cast<int>(verifyPackage(package, task).problems.size());
          if (unpacked->problems > 0) return;
          const auto folder = unpackedPackage(package, pathOf(parent), task);
          unpacked->project = pathFromBytes((folder / "project.json").string());
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const WriteError& failure) {
          unpacked->error = shownError(failure);
          unpacked->not_there = true;
        } catch (const std::exception& failure) {
          unpacked->error = shownError(failure);
        }
      },
      [this, file, unpacked] {
        if (unpacked->problems > 0) {
          messages_.show(tr("%n part(s) of %1 are not as they were packed. Nothing was opened. "
                            "'relievo project verify' names them.",
                            nullptr, unpacked->problems)
                             .arg(shownName(file)));
        } else if (unpacked->not_there) {
          messages_.show(unpacked->error,
                         {{tr("&Unpack elsewhere\u2026"), [this, file] { chooseFolder(file); }}});
        } else if (!unpacked->error.isEmpty()) {
          messages_.show(unpacked->error);
        } else {
          Q_EMIT this->unpacked(unpacked->project);
          announce(
              tr("%1 was unpacked into %2")
                  .arg(shownName(file), shownPath(QFileInfo(unpacked->project).absolutePath())));
        }
      });
  return true;
}

void PackageController::chooseFolder(const QString& package) {
  auto* dialog = new QFileDialog(&window_, tr("Unpack %1 into").arg(shownName(package)));
  dialog->setObjectName(QStringLiteral("unpack_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::Directory);
  dialog->setOption(QFileDialog::ShowDirsOnly, true);
  connect(dialog, &QFileDialog::fileSelected, this,
          [this, package](const QString& folder) { unpack(package, folder); });
  dialog->open();
}

}  // namespace relievo
