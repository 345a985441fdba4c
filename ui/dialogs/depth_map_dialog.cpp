// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/depth_map_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>

#include "core/session/source/unit_guess.h"
#include "ui/dialogs/depth_map_form.h"
#include "ui/language/core_text.h"
#include "ui/language/unit_doubt.h"
#include "ui/message/message_text.h"
#include "ui/style/dialog_size.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr int kDelayMs = 250;  // Between the last change and the work.

QString percent(double share) {
  return QStringLiteral("%1 %").arg(numberText(100 * share, share > 0 && share < 0.0995 ? 2 : 1));
}

QLabel* wordsLabel(const char* name, const QString& title) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setAccessibleName(title);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

/// Shares of all cells; the measured ones are always named.
QString sharesText(const DepthMapPicture& picture) {
  QStringList parts;
  for (std::size_t i = 0; i < kOriginCount; ++i) {
    const auto origin = static_cast<CellStatus>(i);
    if (origin != CellStatus::measured && picture.shares[i] == 0) continue;
    const QString share = percent(picture.shares[i]);
    switch (origin) {
      case CellStatus::measured:
        parts << DepthMapDialog::tr("%1 of the cells are measured").arg(share);
        break;
      case CellStatus::interpolated:
        parts << DepthMapDialog::tr("%1 interpolated").arg(share);
        break;
      case CellStatus::base_plane:
        parts << DepthMapDialog::tr("%1 holes on the base plane").arg(share);
        break;
      case CellStatus::steep:
        parts << DepthMapDialog::tr("%1 too steep").arg(share);
        break;
      case CellStatus::outside:
        parts << DepthMapDialog::tr("%1 outside").arg(share);
        break;
    }
  }
  return parts.join(QStringLiteral(", ")) + '.';
}

QString holesText(const Surface& surface) {
  if (surface.holes.empty()) return DepthMapDialog::tr("No enclosed holes.");
  constexpr std::size_t kMostNamed = 6;
  QStringList areas;
  for (std::size_t i = 0; i < std::min(surface.holes.size(), kMostNamed); ++i) {
    const Hole& hole = surface.holes[i];
    const QString area = numberText(hole.area_mm2, hole.area_mm2 < 10 ? 2 : 0);
    areas << (hole.filled ? DepthMapDialog::tr("%1 (filled)").arg(area) : area);
  }
  if (surface.holes.size() > kMostNamed) areas << QStringLiteral("\u2026");
  return DepthMapDialog::tr("Enclosed holes: %1, of %2 mm\u00b2.")
      .arg(surface.holes.size())
      .arg(areas.join(QStringLiteral(", ")));
}

/// What a height field loses of this object.
QString lossesText(const DepthLosses& losses) {
  QString text = DepthMapDialog::tr("Hidden from here: %1; undercut: %2; too steep: %3.")
                     .arg(percent(losses.hidden_share), percent(losses.undercut_share),
                          percent(losses.steep_share));
  if (losses.outliers > 0) {
    text += ' ' + DepthMapDialog::tr("Stray points left out: %1.").arg(losses.outliers);
  }
  return text;
}

QString detailsText(const Surface& surface) {
  QStringList lines;
  const GridFrame& frame = surface.map.frame;
  const HeightRange z = heightRange(surface.map);
  lines << DepthMapDialog::tr("%1 \u00d7 %2 cells of %3, %4 levels; %5.")
               .arg(frame.size.cols)
               .arg(frame.size.rows)
               .arg(lengthText(frame.spacing_mm))
               .arg(surface.ladder.levels())
               .arg(sizeText(
                   {surface.map.widthMm(), surface.map.heightExtentMm(), z.max_mm - z.min_mm}));
  lines << holesText(surface);
  if (surface.losses) lines << lossesText(*surface.losses);
  for (const Message& undone : surface.not_done) lines << messageText(undone);
  const std::optional<Message> unit = unitWords(surface.info, {surface.unit, surface.unit_source});
  for (const Message& message : surface.messages) {
    const bool is_of_unit = unit && message.id == unit->id && surface.info.bounds;
    lines << (is_of_unit ? unitDoubt(surface) : messageText(message));
  }
  return lines.join('\n');
}

}  // namespace

struct DepthMapDialog::Made {
  SurfaceOptions options;
  SurfaceOutcome outcome;
  DepthMapPicture picture;
};

DepthMapDialog::DepthMapDialog(Document& document, QWidget* parent)
    : QDialog(parent),
      document_(document),
      form_(new DepthMapForm(document.source(), *document.surface(), document.project().options)),
      preview_(new DepthMapPreview),
      histogram_(new HeightHistogram),
      shares_(wordsLabel("depth_shares", tr("Shares of the cells"))),
      details_(wordsLabel("depth_details", tr("About this depth map"))),
      problem_(wordsLabel("depth_problem", tr("Problem"))),
      live_(new QCheckBox(tr("L&ive"))),
      mask_(new QCheckBox(tr("Sho&w what was not measured"))),
      recompute_(new QPushButton(tr("Recom&pute"))),
      cancel_work_(new QPushButton(tr("&Stop"))),
      bar_(new QProgressBar),
      step_(new QLabel),
      delay_(new QTimer(this)) {
  setObjectName(QStringLiteral("depth_map_dialog"));
  setWindowTitle(tr("Depth map"));
  layOut();
  delay_->setSingleShot(true);
  delay_->setInterval(kDelayMs);
  connect(delay_, &QTimer::timeout, this, &DepthMapDialog::compute);
  connect(form_, &DepthMapForm::changed, this, &DepthMapDialog::choicesChanged);
  connect(mask_, &QCheckBox::toggled, preview_, &DepthMapPreview::setMaskShown);
  connect(live_, &QCheckBox::toggled, this, [this](bool on) {
    if (on && stale_) compute();
  });
  connect(recompute_, &QPushButton::clicked, this, &DepthMapDialog::compute);
  connect(cancel_work_, &QPushButton::clicked, this, [this] {
    take_when_made_ = false;
    delay_->stop();
    worker_.cancel();
  });
  connect(&worker_, &LatestWorker::busyChanged, this, &DepthMapDialog::showBusy);
  connect(&worker_, &LatestWorker::progressed, this, [this](const QString& step, double fraction) {
    step_->setText(coreText(step));
    bar_->setValue(static_cast<int>(100 * fraction));
  });
  showBusy(false);
  compute();
}

DepthMapDialog::~DepthMapDialog() {
  worker_.disconnect();
}

void DepthMapDialog::nameControls() {
  recompute_->setObjectName(QStringLiteral("depth_recompute"));
  recompute_->setAccessibleName(tr("Recompute"));
  recompute_->setToolTip(tr("Make the preview of the choices shown"));
  recompute_->setAutoDefault(false);
  cancel_work_->setObjectName(QStringLiteral("depth_stop"));
  cancel_work_->setAccessibleName(tr("Stop"));
  cancel_work_->setToolTip(tr("Stop the work; the picture before stays"));
  cancel_work_->setAutoDefault(false);
  live_->setObjectName(QStringLiteral("depth_live"));
  live_->setAccessibleName(tr("Live preview"));
  live_->setToolTip(tr("Make the preview anew after each change"));
  live_->setChecked(true);
  mask_->setObjectName(QStringLiteral("depth_mask"));
  mask_->setAccessibleName(tr("Show what was not measured"));
  mask_->setToolTip(
      tr("Blue stripes: interpolated. Purple crosses: holes on the base plane. Orange: too steep"));
  mask_->setChecked(true);
  bar_->setAccessibleName(tr("Progress"));
  bar_->setRange(0, 100);
  step_->setAccessibleName(tr("What is being done"));
}

QScrollArea* DepthMapDialog::wordArea() {
  auto* words = new QWidget;
  auto* word_column = new QVBoxLayout(words);
  word_column->setContentsMargins(0, 0, 0, 0);
  QFont bold = shares_->font();
  bold.setBold(true);
  shares_->setFont(bold);
  problem_->hide();
  for (QLabel* label : {problem_, shares_, details_}) word_column->addWidget(label);
  word_column->addStretch(1);
  auto* word_area = new QScrollArea;
  word_area->setAccessibleName(tr("What the map is made of"));
  word_area->setWidget(words);
  word_area->setWidgetResizable(true);
  word_area->setFrameShape(QFrame::NoFrame);
  word_area->setMinimumHeight(4 * fontMetrics().height());
  return word_area;
}

QBoxLayout* DepthMapDialog::columns() {
  auto* left = new QScrollArea;
  left->setFocusPolicy(Qt::NoFocus);  // What stands in it has the keyboard.
  left->setWidget(form_);
  left->setWidgetResizable(true);
  left->setFrameShape(QFrame::NoFrame);
  left->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  left->setMinimumWidth(form_->minimumSizeHint().width() + 24);

  auto* switches = new QHBoxLayout;
  switches->addWidget(mask_);
  switches->addStretch(1);
  switches->addWidget(live_);
  switches->addWidget(recompute_);
  auto* right = new QVBoxLayout;
  right->addWidget(preview_, 4);
  right->addLayout(switches);
  right->addWidget(histogram_);
  right->addWidget(wordArea(), 1);
  auto* columns = new QHBoxLayout;
  columns->addWidget(left, 0);
  columns->addLayout(right, 1);
  return columns;
}

QBoxLayout* DepthMapDialog::bottomRow() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setObjectName(QStringLiteral("depth_ok"));
  connect(buttons, &QDialogButtonBox::accepted, this, &DepthMapDialog::take);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(step_);
  bottom->addWidget(bar_, 1);
  bottom->addWidget(cancel_work_);
  bottom->addStretch(1);
  bottom->addWidget(buttons);
  return bottom;
}

void DepthMapDialog::layOut() {
  nameControls();
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns(), 1);
  all->addLayout(bottomRow());
  resizeToText(*this, {134, 36});
}

QString DepthMapDialog::summary() const {
  return shares_->text() + '\n' + details_->text();
}

void DepthMapDialog::choicesChanged() {
  stale_ = true;
  preview_->setStale(true);
  recompute_->setText(tr("Recom&pute *"));
  if (live_->isChecked()) delay_->start();
}

void DepthMapDialog::compute() {
  delay_->stop();
  const auto made = std::make_shared<Made>();
  made->options = form_->options();
  stale_ = true;
  preview_->setStale(true);
  worker_.start(
      [made, source = document_.source(),
       engine = document_.loader().depthBuffer()](const Task& task) {
        made->outcome = outcomeOf([&] {
          auto surface = makeSurface(source, made->options, engine, task);
          made->picture = pictureOf(*surface, task);
          return surface;
        });
      },
      [this, made] { showMade(*made); });
}

void DepthMapDialog::showMade(const Made& made) {
  if (made.outcome.cancelled) return;
  const bool good = made.outcome.surface != nullptr;
  problem_->setVisible(!good);
  problem_->setText(made.outcome.code.isEmpty()
                        ? made.outcome.error
                        : tr("%1 (%2)").arg(made.outcome.error, made.outcome.code));
  ok_->setEnabled(good);
  if (!good) {
    take_when_made_ = false;
    shares_->clear();
    details_->clear();
    return;
  }
  made_ = std::make_shared<const Made>(made);
  stale_ = delay_->isActive();
  preview_->setPicture(made.picture);
  preview_->setStale(stale_);
  histogram_->setPicture(made.picture);
  shares_->setText(sharesText(made.picture));
  details_->setText(detailsText(*made.outcome.surface));
  recompute_->setText(tr("Recom&pute"));
  if (take_when_made_) take();
}

void DepthMapDialog::done(int result) {
  worker_.outliveJob(*this);
  QDialog::done(result);
}

void DepthMapDialog::showBusy(bool busy) {
  bar_->setVisible(busy);
  step_->setVisible(busy);
  cancel_work_->setVisible(busy);
  if (busy) {
    bar_->setValue(0);
    ok_->setEnabled(true);  // May be pressed before the work is done.
  }
}

// What is on show is taken; if the choices are newer than that, after they were computed.
void DepthMapDialog::take() {
  if (stale_) {
    take_when_made_ = true;
    if (!worker_.busy() || delay_->isActive()) compute();
    return;
  }
  const Surface& before = *document_.surface();
  const std::shared_ptr<const Made> made = made_;
  if (made->options.unit && made->options.unit_source == UnitSource::given &&
      made->outcome.surface->unit != before.unit) {
    Q_EMIT unitChosen(made->outcome.surface->unit);
  }
  document_.adopt(made->outcome.surface, made->options, tr("Depth map"));
  accept();
}

}  // namespace relievo
