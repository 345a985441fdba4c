// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/foreign_files.h"

#include <algorithm>
#include <memory>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "core/project/project_files.h"
#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr std::size_t kMostNamed = 5;      // In a question; the others are counted.
constexpr std::size_t kMostLookedAt = 64;  // At once; that takes a few milliseconds.

/// All that the project names is in the folder of what names it: no checksum is needed.
bool allIsInFolder(const std::filesystem::path& host_file, const Project& project) {
  std::vector<std::string> files{project.file, project.figure.recording};
  for (const InputFile& recording : project.recordings) files.push_back(recording.file);
  files.insert(files.end(), project.figures.begin(), project.figures.end());
  return files.size() <= kMostLookedAt &&
         std::all_of(files.begin(), files.end(), [&](const std::string& file) {
           return file.empty() || isInFolderOf(host_file, file);
         });
}

QString listed(const std::vector<std::filesystem::path>& files) {
  QStringList lines;
  for (std::size_t i = 0; i < std::min(files.size(), kMostNamed); ++i) {
    lines << shownPath(pathFromBytes(files[i].native()));
  }
  const int more = static_cast<int>(files.size() - static_cast<std::size_t>(lines.size()));
  if (more > 0) lines << ForeignFiles::tr("and %n more", nullptr, more);
  return lines.join('\n');
}

}  // namespace

ForeignFiles::ForeignFiles(const ControllerParts& parts) : Controller(parts) {
  messages_.follow(worker_);
  connect(&messages_, &WindowMessages::cancelAsked, this, &ForeignFiles::cancel);
}

bool ForeignFiles::cancel() {
  if (!worker_.cancel()) return false;
  announce(tr("Cancelled. Nothing was changed."));
  return true;
}

void ForeignFiles::whenTheyMayBeRead(const Project& project, const HostFile& host_file,
                                     const Withhold& then) {
  const std::filesystem::path names_them = bytesOfPath(host_file.file);
  if (host_file.file.isEmpty() || allIsInFolder(names_them, project)) return then({});
  struct Found {
    std::vector<std::filesystem::path> files;
    QString error;
  };
  const auto found = std::make_shared<Found>();
  worker_.start(
      [found, project, names_them](const Task& task) {
        try {
          found->files = foreignFiles(names_them, project, task);
        } catch (const Cancelled&) {
          return;
        } catch (const Error& error) {
          found->error = shownError(error);
        }
      },
      [this, found, host_file, then] {
        if (!found->error.isEmpty()) {
          messages_.show(found->error);
        } else if (found->files.empty()) {
          then({});
        } else {
          ask(found->files, host_file, then);
        }
      });
}

void ForeignFiles::ask(const Files& files, const HostFile& host_file, const Withhold& then) {
  auto* box = new QMessageBox(
      QMessageBox::Warning, tr("Files elsewhere"),
      tr("%1 names %n file(s) outside of its folder that are not, by their checksums, what it was "
         "made from:",
         nullptr, static_cast<int>(files.size()))
              .arg(host_file.is_autosaved ? tr("The work that was kept")
                                          : shownName(host_file.file)) +
          QLatin1String("\n\n") + listed(files),
      QMessageBox::Yes | QMessageBox::No, &window_);
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
  connect(box, &QDialog::finished, this,
          [files, then](int answer) { then(answer == QMessageBox::Yes ? Files{} : files); });
  box->open();
}

bool ForeignFiles::isWithheld(const std::string& file) const {
  return std::find(withheld_.begin(), withheld_.end(), file) != withheld_.end();
}

}  // namespace relievo
