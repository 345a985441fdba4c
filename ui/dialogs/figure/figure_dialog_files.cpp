// SPDX-License-Identifier: BSD-3-Clause
// Writing the figure dialog's files.
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/dialogs/figure/figure_error.h"
#include "ui/language/core_text.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

QStringList shownNames(const FigureFiles& files) {
  QStringList names;
  for (const auto& name : namesOf(files)) names += QFile::decodeName(name.c_str());
  return names;
}

}  // namespace

void FigureDialog::save() {
  const QString wrong = errorOf([this] { check(files()); });
  if (!wrong.isEmpty()) {
    showRefusal(wrong);
    return;
  }
  QStringList there;
  for (const QString& name : shownNames(files())) {
    const QFileInfo target(name);
    const QString folder = target.absolutePath();
    if (folder == own_folder_) QDir().mkpath(folder);
    if (!QFileInfo(folder).isDir()) {
      showRefusal(tr("There is no folder %1. Nothing was written. Choose another, or make it.")
                      .arg(shownPath(folder)));
      return;
    }
    if (target.exists()) there += name;
  }
  if (there.isEmpty()) {
    write();
  } else {
    askToReplace(there);
  }
}

void FigureDialog::askToReplace(const QStringList& there) {
  const QFileInfo first(there.front());
  QStringList shown;
  for (const QString& name : there) shown += shownPath(name);
  const QString question = there.size() == 1
                               ? tr("%1 exists already in %2. Replace it?")
                                     .arg(shownName(there.front()), shownPath(first.absolutePath()))
                               : tr("These files exist already. Replace them?") +
                                     QLatin1String("\n\n") + shown.join('\n');
  auto* box = new QMessageBox(QMessageBox::Warning, tr("Replace figure"), question,
                              QMessageBox::Cancel, this);
  box->setObjectName(QStringLiteral("figure_replace"));
  box->setTextFormat(Qt::PlainText);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setAccessibleName(box->windowTitle());
  nameButtons(*box->findChild<QDialogButtonBox*>());
  auto* replace = box->addButton(tr("&Replace"), QMessageBox::AcceptRole);
  replace->setAccessibleName(tr("Replace"));
  box->setDefaultButton(QMessageBox::Cancel);
  box->setEscapeButton(QMessageBox::Cancel);
  connect(replace, &QPushButton::clicked, this, &FigureDialog::write);
  box->open();
}

void FigureDialog::write() {
  delay_->stop();
  struct Written {
    QString error;
    bool all = false;
  };
  const auto result = std::make_shared<Written>();
  const auto there = std::make_shared<std::atomic<std::size_t>>(0);
  there_ = there;
  targets_ = shownNames(files());
  writing_ = true;
  worker_.start(
      [result, there, surface = surface_, project = wanted(), files = files()](const Task& task) {
        result->error = errorOf([&] {
          writeFigureFiles(*surface, project, files, task,
                           [&](std::size_t count) { *there = count; });
          result->all = true;
        });
      },
      [this, result, there, target = file()] {
        showRefusal(result->error);
        if (*there > 0) Q_EMIT written(target);
        if (result->all) accept();
      });
}

void FigureDialog::stop() {
  if (writing_) {
    const std::size_t count = *there_;
    QStringList names;
    for (const QString& name : targets_) names += shownName(name);
    showRefusal(count == 0 ? tr("Stopped. Nothing was written.")
                           : tr("Stopped. Only this was written: %1.")
                                 .arg(names.mid(0, static_cast<int>(count)).join(", ")));
    if (count > 0) Q_EMIT written(targets_.front());
  }
  worker_.cancel();
}

}  // namespace relievo
