// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/panel/loop_health.h"

#include <array>
#include <numeric>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QStringList>
#include <QVBoxLayout>

namespace relievo {

namespace {
QString tr(const char* text, const char* about = nullptr, int n = -1) {
  return QCoreApplication::translate("relievo", text, about, n);  // Where lupdate puts a free tr().
}

QString number(std::uint64_t count) {
  return QString::number(count);
}

/// 20 µs, 5 ms.
QString timeText(std::int64_t ns) {
  constexpr std::int64_t kUs = 1'000, kMs = 1'000'000;
  if (ns >= kMs) return tr("%1 ms").arg(static_cast<double>(ns) / kMs);
  return tr("%1 µs").arg(static_cast<double>(ns) / kUs);
}

template <std::size_t N>
QStringList table(const std::array<std::int64_t, N>& edges_ns,
                  const std::array<std::uint64_t, N + 1>& counts) {
  const std::uint64_t all = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  const double whole = all > 0 ? static_cast<double>(all) : 1;
  QStringList lines;
  for (std::size_t i = 0; i <= N; ++i) {
    const QString bin = i < N ? tr("up to %1").arg(timeText(edges_ns[i]))
                              : tr("longer than %1").arg(timeText(edges_ns[N - 1]));
    lines << QStringLiteral("  %1 %2 %3 %")
                 .arg(bin, -20)
                 .arg(counts[i], 10)
                 .arg(100 * static_cast<double>(counts[i]) / whole, 8, 'f', 3);
  }
  return lines;
}

/// Lower: the hand may feel it.
constexpr double kGoodRateHz = 990;
}  // namespace

QString healthText(const LoopReport& report) {
  const LoopStats& stats = report.stats;
  if (stats.rate_hz <= 0) return tr("Not measured yet.");
  QStringList said;
  if (stats.watchdog_cuts > 0) {
    said << tr("Force interrupted %n time(s).", nullptr, static_cast<int>(stats.watchdog_cuts));
  }
  if (report.sample.softened > 0) {
    said << tr("Softened against swinging, times: %1.").arg(report.sample.softened);
  }
  if (stats.pauses > 0) {
    said << tr("Pauses after which the force rose anew: %1.").arg(number(stats.pauses));
  }
  if (stats.page_faults > 0) {
    said << tr("Waited for memory in %1 ticks.").arg(number(stats.faulty_ticks));
  }
  if (stats.at_rest) said << tr("Looks at the hand 250 times a second while it rests; before:");
  if (stats.rate_hz < kGoodRateHz) said << tr("Slow.");
  if (said.isEmpty()) said << tr("Runs well.");
  said << tr("%1 per second, %2 of %3 ticks late, longest gap %4 ms.")
              .arg(stats.rate_hz, 0, 'f', 0)
              .arg(number(stats.late_ticks), number(stats.ticks))
              .arg(stats.worst_period_ms, 0, 'f', 1);
  said << (report.realtime.realtime ? tr("Real-time priority granted.")
                                    : tr("No real-time priority; the tables say why."));
  said << (report.realtime.memory_locked ? tr("Memory locked.")
                                         : tr("Memory not locked; the tables say why."));
  return said.join(' ');
}

QString loopDetailsText(const LoopReport& report) {
  const LoopStats& stats = report.stats;
  QStringList lines{healthText(report),
                    QString(),
                    tr("Device: %1").arg(report.device),
                    tr("Computing, mean and longest: %1 µs, %2 µs")
                        .arg(stats.mean_tick_us, 0, 'f', 1)
                        .arg(stats.worst_tick_us, 0, 'f', 1),
                    tr("Page faults of the loop: %1, in %2 ticks")
                        .arg(number(stats.page_faults), number(stats.faulty_ticks)),
                    tr("Memory locked: %1 kB").arg(number(report.realtime.locked_bytes >> 10U)),
                    report.realtime.note.empty() ? tr("Real time: everything was granted.")
                                                 : QString::fromStdString(report.realtime.note),
                    QString(),
                    tr("Woken late by, in ticks:")};
  lines += table(LoopStats::kDelayEdgesNs, stats.delays);
  lines << QString() << tr("Time spent computing, in ticks:");
  lines += table(LoopStats::kWorkEdgesNs, stats.work);
  return lines.join('\n');
}

LoopDetailsDialog::LoopDetailsDialog(QWidget* parent) : QDialog(parent), text_(new QPlainTextEdit) {
  setObjectName(QStringLiteral("loopDetails"));
  setWindowTitle(tr("How the force loop runs"));
  text_->setObjectName(QStringLiteral("loopDetailsText"));
  text_->setAccessibleName(tr("Counts of the force loop since it began"));
  text_->setReadOnly(true);
  text_->setTabChangesFocus(true);
  text_->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addWidget(text_);
  column->addWidget(buttons);
  constexpr int kWidth = 520, kHeight = 560;
  resize(kWidth, kHeight);
}

void LoopDetailsDialog::show(const LoopReport& report) {
  if (text_->textCursor().hasSelection()) return;  // Somebody is about to copy it.
  const int at = text_->verticalScrollBar()->value();
  text_->setPlainText(loopDetailsText(report));
  text_->verticalScrollBar()->setValue(at);
}

}  // namespace relievo
