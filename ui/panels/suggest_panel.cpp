// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/suggest_panel.h"

#include <cmath>
#include <QApplication>
#include <QCheckBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "ui/frame/side_panels.h"
#include "ui/language/error_text.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

QLabel* note(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setWordWrap(true);
  return label;
}

}  // namespace

SuggestPanel::SuggestPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      find_(new QPushButton(tr("Suggest windows"))),
      method_(note("suggest_method")),
      result_(note("suggest_result")),
      list_(new QListWidget),
      overlay_(new QCheckBox(tr("Show them in the overview"))) {
  setObjectName(QStringLiteral("suggest_panel"));
  setProperty(SidePanels::kFoldedAtFirst, true);
  find_->setObjectName(QStringLiteral("suggest_find"));
  find_->setAccessibleName(find_->text());
  find_->setToolTip(tr("Look for windows with relief that a hand feels (Ctrl+Shift+F)"));
  find_->setMinimumWidth(40);
  method_->setText(
      tr("Ranked by the share of a window whose relief is higher than what a hand on a grip just "
         "feels at that scale: the threshold of a fingertip (Louw, Kappers and Koenderink 2000) "
         "times %1, which is an estimate. Steep, filled and missing places do not count.")
          .arg(numberText(FeelOptions{}.grip_factor, 0)));
  list_->setObjectName(QStringLiteral("suggest_list"));
  list_->setAccessibleName(tr("Suggested windows"));
  list_->setToolTip(tr("A click or Enter shows the window at its resolution; undo goes back"));
  list_->setWordWrap(true);
  list_->setMinimumHeight(110);
  overlay_->setObjectName(QStringLiteral("suggest_overlay"));
  overlay_->setAccessibleName(overlay_->text());
  overlay_->setToolTip(tr("Frames with their ranks over the whole object"));
  overlay_->setChecked(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 0, 0, 6);
  column->addWidget(find_);
  column->addWidget(result_);
  column->addWidget(list_);
  column->addWidget(overlay_);
  column->addWidget(method_);
  connect(find_, &QPushButton::clicked, this, &SuggestPanel::find);
  connect(list_, &QListWidget::itemClicked, this, &SuggestPanel::go);
  connect(list_, &QListWidget::itemActivated, this, &SuggestPanel::go);
  connect(list_, &QListWidget::currentRowChanged, this, &SuggestPanel::shownChanged);
  connect(overlay_, &QCheckBox::toggled, this, &SuggestPanel::shownChanged);
  connect(&worker_, &LatestWorker::busyChanged, this, [this](bool is_busy) {
    find_->setEnabled(!is_busy && document_.isOpen());
    Q_EMIT busyChanged(is_busy);
  });
  connect(&worker_, &LatestWorker::progressed, this, &SuggestPanel::progressed);
  connect(&document_, &Document::surfaceChanged, this, &SuggestPanel::showSurface);
  showSurface();
}

int SuggestPanel::current() const {
  return list_->currentRow();
}

bool SuggestPanel::overlayWanted() const {
  return overlay_->isChecked();
}

// They are of the surface that they were looked for on; undo may bring it back, but not them.
void SuggestPanel::showSurface() {
  setEnabled(document_.isOpen());
  if (surface_ == document_.surface()) return;
  worker_.cancel();
  surface_ = document_.surface();
  windows_.clear();
  list_->clear();
  list_->hide();
  overlay_->hide();
  result_->hide();
  Q_EMIT shownChanged();
}

void SuggestPanel::find() {
  if (!document_.isOpen()) return;
  const auto surface = document_.surface();
  if (surface->tiles) {
    result_->setText(tr("This map is read by tiles; windows are suggested on maps in memory."));
    result_->show();
    Q_EMIT said(result_->text());
    return;
  }
  gain_ = document_.project().gain;
  asked_from_ = QApplication::focusWidget();
  struct Work {
    std::vector<FeelableWindow> windows;
    QString problem;
  };
  const auto work = std::make_shared<Work>();
  worker_.start(
      [work, surface, gain = gain_](const Task& task) {
        try {
          work->windows = feelableWindows(surface->map, surface->pyramid, {.gain = gain}, task);
        } catch (const Cancelled&) {  // Its end is not told.
        } catch (const std::exception& failure) {
          work->problem = shownError(failure);
        }
      },
      [this, work] {
        if (!work->problem.isEmpty()) {
          Q_EMIT said(work->problem);
        } else {
          showFound(work->windows);
        }
      });
}

bool SuggestPanel::cancel() {
  if (!worker_.cancel()) return false;
  Q_EMIT said(tr("Cancelled. Nothing was suggested."));
  return true;
}

QString SuggestPanel::rowText(std::size_t place) const {
  const FeelableWindow& w = windows_[place];
  const DetailLadder& ladder = surface_->ladder;
  return tr("%1. Resolution %2 of %3, %4: %5 % felt, relief about %6 wide")
      .arg(QString::number(place + 1), QString::number(ladder.detailOf(w.region.level)),
           QString::number(ladder.levels()), lengthText(w.region.side_mm),
           QString::number(std::lround(100 * w.felt_share)), lengthText(w.width_mm));
}

void SuggestPanel::showFound(const std::vector<FeelableWindow>& windows) {
  windows_ = windows;
  list_->clear();
  for (std::size_t i = 0; i < windows_.size(); ++i) {
    const FeelableWindow& w = windows_[i];
    auto* row = new QListWidgetItem(rowText(i), list_);
    row->setToolTip(tr("%1 % measured, %2 % steep")
                        .arg(std::lround(100 * w.measured_share))
                        .arg(std::lround(100 * w.steep_share)));
  }
  const bool any = !windows_.empty();
  result_->setText(any ? tr("Windows: %1, the best first").arg(windows_.size())
                       : tr("No window has relief that stands out from what a hand just feels."));
  result_->show();
  list_->setVisible(any);
  overlay_->setVisible(any);
  Q_EMIT shownChanged();
  Q_EMIT said(result_->text());
  if (!any) return;
  list_->setCurrentRow(0);
  // Once it has its place: then it is scrolled to, and Enter shows the best.
  // Whoever went elsewhere meanwhile stays there.
  QTimer::singleShot(0, list_, [this] {
    if (QApplication::focusWidget() == asked_from_) list_->setFocus(Qt::OtherFocusReason);
  });
}

void SuggestPanel::go() {
  const int row = current();
  if (row < 0 || row >= static_cast<int>(windows_.size())) return;
  const auto place = static_cast<std::size_t>(row);
  // It was looked for with this gain: with another one it would feel otherwise.
  document_.region().goTo(windows_[place].region, gain_, tr("Suggested window %1").arg(row + 1));
  Q_EMIT said(rowText(place));
}

}  // namespace relievo
