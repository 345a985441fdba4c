// SPDX-License-Identifier: BSD-3-Clause
// Files that a project from elsewhere names: asked about before they are read
// (docs/adr/0136-outside-files.md).
#include <algorithm>
#include <memory>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "core/project/project_files.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"
#include "ui/language/core_words.h"
#include "ui/language/spoken_error.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr std::size_t kMostNamed = 5;      // In a question; the others are counted.
constexpr std::size_t kMostLookedAt = 64;  // At once; that takes a few milliseconds.

/// All that the project names is in the folder of what names it: no checksum is needed.
bool allIsInFolder(const std::filesystem::path& carrier, const Project& project) {
  std::vector<std::string> files{project.file, project.figure.recording};
  for (const InputFile& recording : project.recordings) files.push_back(recording.file);
  files.insert(files.end(), project.figures.begin(), project.figures.end());
  return files.size() <= kMostLookedAt &&
         std::all_of(files.begin(), files.end(), [&](const std::string& file) {
           return file.empty() || isInFolderOf(carrier, file);
         });
}

QString listed(const std::vector<std::filesystem::path>& files) {
  QStringList lines;
  for (std::size_t i = 0; i < std::min(files.size(), kMostNamed); ++i) {
    lines << shownPath(pathFromBytes(files[i].native()));
  }
  const int more = static_cast<int>(files.size() - static_cast<std::size_t>(lines.size()));
  if (more > 0) lines << MainWindow::tr("and %n more", nullptr, more);
  return lines.join('\n');
}

}  // namespace

void MainWindow::connectForeignFiles() {
  connect(&foreign_work_, &LatestWorker::busyChanged, this, &MainWindow::showBusy);
  connect(&foreign_work_, &LatestWorker::progressed, status_, &StatusFields::showWork);
  connect(status_, &StatusFields::cancelAsked, this, [this] {
    if (foreign_work_.cancel()) announce(tr("Cancelled. Nothing was changed."));
  });
}

void MainWindow::whenFilesMayBeRead(const Project& project, const QString& carrier,
                                    const Withhold& then) {
  const std::filesystem::path names_them = bytesOfPath(carrier);
  if (carrier.isEmpty() || allIsInFolder(names_them, project)) return then({});
  struct Found {
    std::vector<std::filesystem::path> files;
    QString error;
  };
  const auto found = std::make_shared<Found>();
  foreign_work_.start(
      [found, project, names_them](const Task& task) {
        try {
          found->files = foreignFiles(names_them, project, task);
        } catch (const Cancelled&) {
          return;
        } catch (const Error& error) {
          found->error = shownError(error);
        }
      },
      [this, found, carrier, then] {
        if (!found->error.isEmpty()) {
          strip_->show(found->error);
        } else if (found->files.empty()) {
          then({});
        } else {
          askForForeignFiles(found->files, carrier, then);
        }
      });
}

void MainWindow::askForForeignFiles(const std::vector<std::filesystem::path>& files,
                                    const QString& carrier, const Withhold& then) {
  auto* box = new QMessageBox(
      QMessageBox::Warning, tr("Files elsewhere"),
      tr("%1 names %n file(s) outside of its folder that are not, by their checksums, what it was "
         "made from:",
         nullptr, static_cast<int>(files.size()))
              .arg(carrier == recovered_copy_ ? tr("The work that was kept") : shownName(carrier)) +
          QLatin1String("\n\n") + listed(files),
      QMessageBox::Yes | QMessageBox::No, this);
  box->setObjectName(QStringLiteral("foreign_dialog"));
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setTextFormat(Qt::PlainText);
  box->setAccessibleName(tr("Files elsewhere"));
  box->setInformativeText(
      tr("Whoever made it chose these names. Shall they be read? What is not read stays named in "
         "it, and all else opens."));
  nameButtons(*box->findChild<QDialogButtonBox*>());
  box->button(QMessageBox::Yes)->setText(tr("&Read them"));
  box->button(QMessageBox::No)->setText(tr("&Do not read them"));
  box->setDefaultButton(QMessageBox::No);
  box->setEscapeButton(QMessageBox::No);
  connect(box, &QDialog::finished, this, [files, then](int answer) {
    then(answer == QMessageBox::Yes ? std::vector<std::filesystem::path>{} : files);
  });
  box->open();
}

bool MainWindow::isWithheld(const std::string& file) const {
  return std::find(withheld_.begin(), withheld_.end(), file) != withheld_.end();
}

void MainWindow::tellInputWithheld(const Project& project, const QString& carrier) {
  const std::string& kept = project.saved_as.empty() ? project.file : project.saved_as;
  strip_->show(
      tr("%1 was not opened: it needs %2, which is outside of its folder and was not read. "
         "Nothing was changed. Find it, or choose another file.")
          .arg(shownName(carrier.isEmpty() ? pathFromBytes(kept) : carrier),
               shownPath(pathFromBytes(project.file))),
      {{tr("&Find it\u2026"), [this, project, carrier] { relink(project, carrier); }},
       {tr("&Choose another\u2026"), [this] { chooseFile(); }}});
}

void MainWindow::askAboutWithheld() {
  if (withheld_.empty()) return;
  const int count = static_cast<int>(withheld_.size());
  questions_.emplace_back([this, count] {
    strip_->show(
        tr("%n file(s) that this project names were not read. They stay named in it, and "
           "are offered for no package and no figure.",
           nullptr, count));
  });
}

}  // namespace relievo
