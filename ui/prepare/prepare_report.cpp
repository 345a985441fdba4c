// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_report.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "ui/message/message_text.h"
#include "ui/prepare/prepare_widgets.h"
#include "ui/prepare/read_scans.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

QString count(std::uint64_t number) {
  return QLocale().toString(static_cast<qulonglong>(number));
}

QString loopText(const AlignLoop& loop) {
  QStringList scans;
  for (const std::uint32_t scan : loop.scans) scans << QString::number(scan + 1);
  return PrepareReport::tr("The chain of scans %1 misses its beginning by %2 mm.")
      .arg(scans.join(QStringLiteral(", ")), numberText(loop.mm, 3));
}

QString verdictText(const AlignVerdict& verdict) {
  QString text = messageText(verdict.words);
  if (verdict.rms_mm <= 0 || !verdict.holds) return text;
  text += ' ' + PrepareReport::tr("%1 % of its points lie within one spacing.")
                    .arg(numberText(100 * verdict.tight_share, 0));
  if (verdict.uncertainty_mm > 0) {
    text += ' ' +
            PrepareReport::tr("It may be off by %1 mm.").arg(numberText(verdict.uncertainty_mm, 3));
  }
  return text;
}

}  // namespace

PrepareReport::PrepareReport() {
  total_ = prepareText("prepare_total", tr("How many points stay"));
  QFont bold = total_->font();
  bold.setBold(true);
  total_->setFont(bold);
  details_ = prepareText("prepare_words", tr("What was done"));
  problem_ = prepareText("prepare_problem", tr("Problem"));
  problem_->hide();
  auto* texts = new QWidget;
  auto* lines = new QVBoxLayout(texts);
  lines->setContentsMargins(0, 0, 0, 0);
  for (QLabel* label : {problem_, total_, details_}) lines->addWidget(label);
  lines->addStretch(1);
  setWidget(texts);
  setWidgetResizable(true);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::NoFocus);
  setMinimumHeight(4 * fontMetrics().height());
}

void PrepareReport::showProblem(const QString& sentence) {
  problem_->setText(sentence);
  problem_->setVisible(!sentence.isEmpty());
}

void PrepareReport::showAdvice(const QString& text) {
  details_->setText(text);
}

void PrepareReport::clear() {
  total_->clear();
  details_->clear();
}

QString PrepareReport::total() const {
  return total_->text();
}

/// What is said of where the scans lie.
QStringList PrepareReport::alignTexts(const PrepareResult& result, const AlignAnswer* found,
                                      const ReadScans& reads) const {
  QStringList lines;
  const auto& aligned = result.prepared.answer.align;
  const AlignAnswer* const answer = found != nullptr ? found : (aligned ? &*aligned : nullptr);
  if (answer == nullptr || answer->scans.size() != result.used.size()) return lines;
  for (std::size_t i = 0; i < answer->scans.size(); ++i) {
    const AlignVerdict& verdict = answer->scans[i];
    if (verdict.words.empty()) continue;
    lines << tr("%1: %2", "scan, words")
                 .arg(reads.nameOf(result.choices.inputs[result.used[i]]), verdictText(verdict));
  }
  for (const AlignLoop& loop : answer->loops) lines << loopText(loop);
  return lines;
}

void PrepareReport::showResult(const PrepareResult& result, const AlignAnswer* found,
                               CloudColour colour, const ReadScans& reads) {
  std::uint64_t before = 0, shown = 0;
  for (const auto& scan : result.scans) {
    before += scan->scan->points.size();
    shown += scan->shown.size();
  }
  const auto& prepared = result.prepared;
  const bool made = !prepared.scan.points.empty();
  total_->setText(
      made ? tr("%1 of %2 points stay.").arg(count(prepared.scan.points.size()), count(before))
           : tr("%1 points.").arg(count(before)));
  QStringList lines;
  if (shown < before) lines << tr("%1 of them are drawn.").arg(count(shown));
  if (colour == CloudColour::distance) {
    lines << tr(
        "Blue lies on the surface of the other scans, red three spacings from it; grey: no "
        "other scan is near.");
  }
  lines << alignTexts(result, found, reads);
  for (const StepResult& step : prepared.answer.steps) {
    if (!step.notes.empty()) lines << messageText(step.notes);
  }
  for (const auto& scan : result.scans) {
    if (scan->scan->info.withheld > 0) {
      lines << tr("%1 points that the file marks as withheld are left out.")
                   .arg(count(scan->scan->info.withheld));
    }
  }
  details_->setText(lines.join('\n'));
}

}  // namespace relievo
