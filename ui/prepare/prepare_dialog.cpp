// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_dialog.h"

#include <algorithm>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>

#include "ui/language/core_text.h"
#include "ui/language/error_text.h"
#include "ui/prepare/step_form.h"
#include "ui/prepare/step_words.h"
#include "ui/work/file_names.h"
#include "ui/work/surface_work.h"

namespace relievo {
namespace {

constexpr int kDelayMs = 250;  // Between the last change and the work.

/// What was read of a file does not depend on its unit, nor on whether it is used.
bool sameRead(const PrepareInput& a, const PrepareInput& b) {
  return a.file == b.file && a.read == b.read && a.accept_incomplete == b.accept_incomplete;
}

/// NAME-prepared.ply, NAME-prepared-2.ply, ... beside the scan: the first that is free.
QString freeName(const QFileInfo& scan) {
  const QString base = scan.absolutePath() + '/' +
                       stemOf(scan.filePath(), QStringLiteral("-prepared-9999.recipe.json"));
  QString file = base + QLatin1String("-prepared.ply");
  for (int n = 2; QFileInfo::exists(file); ++n) {
    file = QStringLiteral("%1-prepared-%2.ply").arg(base).arg(n);
  }
  return file;
}

std::filesystem::path pathOf(const QString& file) {
  return QFile::encodeName(file).toStdString();
}

/// For a shell: between single quotes.
QString quoted(const QString& word) {
  return '\'' + QString(word).replace('\'', QLatin1String("'\\''")) + '\'';
}

}  // namespace

PrepareDialog::PrepareDialog(const PrepareStart& start, QWidget* parent)
    : QDialog(parent), state_({.inputs = start.inputs, .steps = {}}), delay_(new QTimer(this)) {
  setObjectName(QStringLiteral("prepare_dialog"));
  setWindowTitle(tr("Prepare"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  layOut();
  view_->look(start.view);
  other_view_->look(start.view);
  side_->setCurrentIndex(side_->findData(QString::fromStdString(relievo::nameOf(start.view))));
  const QFileInfo first(QFile::decodeName(start.inputs.front().file.c_str()));
  file_->setText(QDir::toNativeSeparators(freeName(first)));
  delay_->setSingleShot(true);
  delay_->setInterval(kDelayMs);
  connect(delay_, &QTimer::timeout, this, &PrepareDialog::compute);
  connect(&worker_, &LatestWorker::busyChanged, this, &PrepareDialog::showBusy);
  connect(&worker_, &LatestWorker::progressed, this, [this](const QString& step, double fraction) {
    step_name_->setText(wordsOfWork(step));
    bar_->setValue(static_cast<int>(100 * fraction));
  });
  showLists();
  showBusy(false);
  if (!start.scan) {
    compute();
    return;
  }
  // What is drawn of it is chosen in the worker, too.
  reading_ = true;
  const auto read = std::make_shared<std::shared_ptr<const ReadScan>>();
  worker_.start(
      [read, start](const Task& task) {
        outcomeOf([&] {
          *read = shownOf(start.scan, start.sha256, kMostShownPoints, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, read, input = start.inputs.front()] {
        reading_ = false;
        if (*read) reads_.emplace_back(input, *read);
        compute();
      });
}

PrepareDialog::~PrepareDialog() {
  worker_.disconnect();
  painter_.disconnect();
}

// The child reports the kind of the step that it does.
QString PrepareDialog::wordsOfWork(const QString& step) const {
  for (const PrepareStep& known : state_.now().steps) {
    if (step == QLatin1String(kindOf(known.step).data())) return nameOfStep(known.step);
  }
  return coreText(step);
}

void PrepareDialog::choicesChanged() {
  stale_ = true;
  recipe_file_.clear();
  recompute_->setText(tr("Recom&pute *"));
  showLists();
  if (pick_) return;  // After all pairs are picked.
  if (live_->isChecked()) delay_->start();
}

std::shared_ptr<const ReadScan> PrepareDialog::heldReadOf(const PrepareInput& input) const {
  const auto found = std::find_if(reads_.begin(), reads_.end(),
                                  [&](const auto& known) { return sameRead(known.first, input); });
  return found == reads_.end() ? nullptr : found->second;
}

const ReadScan* PrepareDialog::readOf(const PrepareInput& input) const {
  return heldReadOf(input).get();
}

LengthUnit PrepareDialog::unitOf(const PrepareInput& input) const {
  if (input.unit) return *input.unit;
  const ReadScan* const read = readOf(input);
  return read != nullptr ? read->scan->info.unit.value_or(LengthUnit::mm) : LengthUnit::mm;
}

void PrepareDialog::refuse(const QString& sentence) {
  problem_->setText(sentence);
  problem_->setVisible(!sentence.isEmpty());
  ok_->setEnabled(sentence.isEmpty());
  if (sentence.isEmpty()) return;
  take_when_made_ = false;
  Q_EMIT said(sentence);
}

void PrepareDialog::compute() {
  delay_->stop();
  if (reading_) return;  // What is read then is prepared as it is chosen then.
  stale_ = true;
  const std::vector<std::size_t> used = state_.usedInputs();
  if (used.empty()) {
    refuse(tr("No scan is chosen. Tick one in the list of scans."));
    return;
  }
  for (const std::size_t i : used) {
    if (readOf(state_.now().inputs[i]) != nullptr) continue;
    readNext(i);
    return;
  }
  prepareNow();
}

void PrepareDialog::readNext(std::size_t i) {
  struct Reading {
    std::shared_ptr<const ReadScan> scan;
    SurfaceOutcome outcome;
  };
  reading_ = true;
  const PrepareInput input = state_.now().inputs[i];
  const std::size_t most = kMostShownPoints / std::max<std::size_t>(1, state_.now().inputs.size());
  const auto reading = std::make_shared<Reading>();
  worker_.start(
      [reading, input, most](const Task& task) {
        reading->outcome = outcomeOf([&] {
          reading->scan = readScan(input, most, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, reading, input] {
        reading_ = false;
        if (reading->scan) {
          reads_.emplace_back(input, reading->scan);
          showLists();
          compute();
        } else if (!reading->outcome.cancelled) {
          refuse(shownError(reading->outcome.error, reading->outcome.code));
        }
      });
}

void PrepareDialog::prepareNow() {
  struct Making {
    PrepareResult result;
    SurfaceOutcome outcome;
  };
  const auto making = std::make_shared<Making>();
  PrepareResult& r = making->result;
  r.choices = state_.now();
  r.recipe = state_.recipe();
  r.used = state_.usedInputs();
  for (const std::size_t i : r.used) r.scans.push_back(heldReadOf(r.choices.inputs[i]));
  if (!result_) {  // Something to see while the steps are done.
    auto stored = std::make_shared<PrepareResult>(r);
    stored->prepared.answer.poses.resize(r.scans.size());
    result_ = stored;
    showPicture();
  }
  worker_.start(
      [making](const Task& task) {
        making->outcome = outcomeOf([&] {
          std::vector<const Scan*> scans;
          for (const auto& scan : making->result.scans) scans.push_back(scan->scan.get());
          making->result.prepared = prepare(scans, making->result.recipe, {}, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, making] {
        if (making->outcome.cancelled) return;
        if (!making->outcome.error.isEmpty()) {
          refuse(shownError(making->outcome.error, making->outcome.code));
          return;
        }
        showMade(std::shared_ptr<const PrepareResult>(making, &making->result));
      });
}

void PrepareDialog::showMade(const std::shared_ptr<const PrepareResult>& made) {
  result_ = made;
  if (made->prepared.answer.align) {
    state_.keepPoses(made->choices, made->recipe, *made->prepared.answer.align);
  }
  refuse({});
  stale_ = delay_->isActive();
  if (!stale_) recompute_->setText(tr("Recom&pute"));
  showNumbers();
  showWords();
  showPicture();
  showPicks();
  Q_EMIT said(total_->text());
  if (take_when_made_) take();
}

void PrepareDialog::showPicture() {
  if (!result_ || pick_) return;
  const CloudWish wish{static_cast<CloudStage>(stage_->currentIndex()),
                       static_cast<CloudColour>(colour_->currentIndex())};
  const auto cloud = std::make_shared<CloudPoints>();
  painter_.start(
      [cloud, wish, result = result_](const Task& task) {
        outcomeOf([&] {
          *cloud = cloudOf(*result, wish, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, cloud] {
        if (!pick_) view_->setCloud(cloud);
        showOutline();
      });
}

void PrepareDialog::done(int result) {
  painter_.cancel();
  worker_.outliveJob(*this);
  QDialog::done(result);
}

void PrepareDialog::showBusy(bool busy) {
  bar_->setVisible(busy);
  step_name_->setVisible(busy);
  stop_->setVisible(busy);
  if (!busy) return;
  bar_->setValue(0);
  ok_->setEnabled(true);  // May be pressed before the work is done.
}

QString PrepareDialog::outputFile() const {
  QString file = QDir::fromNativeSeparators(file_->text().trimmed());
  if (!file.endsWith(QLatin1String(".ply"), Qt::CaseInsensitive)) file += QLatin1String(".ply");
  return QFileInfo(file).absoluteFilePath();
}

// What is on show is written; if the choices are newer than that, after they were computed.
void PrepareDialog::take() {
  if (pick_) endPicking();
  if (stale_) {
    take_when_made_ = true;
    if (!worker_.busy() || delay_->isActive()) compute();
    return;
  }
  take_when_made_ = false;
  const QString file = outputFile();
  write([result = result_, file](const Task& task) { writePrepared(*result, pathOf(file), task); },
        [this, file] {
          Q_EMIT prepared(file);
          accept();
        });
}

void PrepareDialog::write(const std::function<void(const Task&)>& work,
                          const std::function<void()>& then) {
  const auto outcome = std::make_shared<SurfaceOutcome>();
  worker_.start(
      [outcome, work](const Task& task) {
        *outcome = outcomeOf([&] {
          task.report("Writing the scan", 0);
          work(task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, outcome, then] {
        if (outcome->cancelled) return;
        if (outcome->error.isEmpty()) {
          then();
        } else {
          refuse(shownError(outcome->error, outcome->code));
          ok_->setEnabled(true);  // Another name may do.
        }
      });
}

void PrepareDialog::saveRecipe() {
  if (stale_) return;
  auto* dialog = new QFileDialog(this, tr("Save recipe"), QFileInfo(outputFile()).absolutePath(),
                                 tr("Recipes (*.json)"));
  dialog->setObjectName(QStringLiteral("recipe_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("json"));
  dialog->selectFile(QFileInfo(outputFile()).completeBaseName() + QLatin1String(".json"));
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
    write([result = result_, file](const Task& task) { writeRecipe(*result, pathOf(file), task); },
          [this, file] {
            recipe_file_ = file;
            showNumbers();
            Q_EMIT said(tr("%1 is saved").arg(shownName(file)));
          });
  });
  dialog->open();
}

void PrepareDialog::copyCommand() {
  if (recipe_file_.isEmpty()) return;
  QGuiApplication::clipboard()->setText(QStringLiteral("relievo prepare --recipe %1 -o %2")
                                            .arg(quoted(recipe_file_), quoted(outputFile())));
  Q_EMIT said(tr("The command is in the clipboard"));
}

void PrepareDialog::chooseFile() {
  auto* dialog = new QFileDialog(this, tr("Prepared scan"), QFileInfo(outputFile()).absolutePath(),
                                 tr("Scans (*.ply)"));
  dialog->setObjectName(QStringLiteral("prepared_file_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("ply"));
  dialog->selectFile(QFileInfo(outputFile()).fileName());
  connect(dialog, &QFileDialog::fileSelected, this,
          [this](const QString& file) { file_->setText(QDir::toNativeSeparators(file)); });
  dialog->open();
}

}  // namespace relievo
