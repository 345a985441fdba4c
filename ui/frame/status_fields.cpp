// SPDX-License-Identifier: BSD-3-Clause
#include "ui/frame/status_fields.h"

#include <algorithm>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QProgressBar>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QToolButton>
#include <utility>

#include "ui/frame/announcer.h"
#include "ui/frame/status_rows.h"
#include "ui/language/core_text.h"

namespace relievo {
namespace {

constexpr int kWorkDelayMs = 300;
constexpr int kBarSteps = 1000;
constexpr int kMargin = 16;  // Of a field, pixels.

struct FieldFact {
  const char* object;  ///< Name for tests and scripts; stays when the words change.
  const char* name;
  const char* widest;  ///< Text the field is made wide enough for, so that nothing jumps.
};
constexpr std::array<FieldFact, kStatusFieldCount> kFields{{
    {"status_message", QT_TRANSLATE_NOOP("relievo::StatusFields", "Message"), ""},
    {"status_position", QT_TRANSLATE_NOOP("relievo::StatusFields", "Position"),
     "x 1234.56  y 1234.56  z 123.45 mm"},
    {"status_kind_of_surface", QT_TRANSLATE_NOOP("relievo::StatusFields", "Kind of surface"),
     "interpolated"},
    {"status_detail", QT_TRANSLATE_NOOP("relievo::StatusFields", "Resolution"), "Resolution 10/10"},
    {"status_force", QT_TRANSLATE_NOOP("relievo::StatusFields", "Force"), ""},
    {"status_force_rate", QT_TRANSLATE_NOOP("relievo::StatusFields", "Force rate"), ""},
    {"status_recording", QT_TRANSLATE_NOOP("relievo::StatusFields", "Recording"), ""},
    {"status_mouse", QT_TRANSLATE_NOOP("relievo::StatusFields", "Mouse"), ""},
}};

/// Text that a narrow window has no room for ends in dots.
class Field : public QLabel {
 public:
  Field(QWidget* parent, QString widest) : QLabel(parent), widest_(std::move(widest)) {
    setContentsMargins(6, 1, 6, 1);
    setTextFormat(Qt::PlainText);
    setStyleSheet(QStringLiteral("QLabel:focus { border: 1px solid palette(highlight); }"));
  }
  QSize sizeHint() const override {
    const QSize needed = QLabel::sizeHint();
    return {std::max(needed.width(), fontMetrics().horizontalAdvance(widest_) + kMargin),
            needed.height()};
  }

 protected:
  void paintEvent(QPaintEvent* event) override {
    const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
    if (shown == text()) {
      QLabel::paintEvent(event);
      return;
    }
    QPainter painter(this);
    drawFrame(&painter);
    style()->drawItemText(&painter, contentsRect(), Qt::AlignLeft | Qt::AlignVCenter, palette(),
                          isEnabled(), shown, foregroundRole());
  }

 private:
  QString widest_;
};

}  // namespace

StatusFields::StatusFields(QStatusBar& bar)
    : QObject(&bar),
      work_(new QWidget(&bar)),
      work_step_(new QLabel(work_)),
      work_bar_(new QProgressBar(work_)),
      cancel_(new QToolButton(work_)),
      work_delay_(new QTimer(this)),
      announcer_(new Announcer(&bar)) {
  bar.setSizeGripEnabled(false);
  auto* fields = new QWidget(&bar);
  auto* rows = new StatusRows(fields);
  rows->addWidget(work_);
  for (std::size_t i = 0; i < kStatusFieldCount; ++i) {
    auto* field = new Field(fields, QString::fromLatin1(kFields[i].widest));
    field->setAccessibleName(tr(kFields[i].name));
    field->setObjectName(QLatin1String(kFields[i].object));
    rows->addWidget(field);
    if (i == 0) rows->endOfFront();
    labels_[i] = field;
    field->setVisible(i == 0);
  }
  rows->lastIsSpare();
  rows_ = rows;
  auto* row = new QHBoxLayout(work_);
  row->setContentsMargins(4, 0, 4, 0);
  work_step_->setAccessibleName(tr("Running step"));
  work_bar_->setRange(0, kBarSteps);
  work_bar_->setTextVisible(false);
  work_bar_->setFixedSize(140, 10);
  work_bar_->setAccessibleName(tr("Progress"));
  cancel_->setText(tr("Cancel"));
  cancel_->setObjectName(QStringLiteral("cancel_work"));
  cancel_->setToolTip(tr("Stop this work; what is shown stays (Esc)"));
  cancel_->setAccessibleName(tr("Cancel"));
  cancel_->setFocusPolicy(Qt::StrongFocus);
  connect(cancel_, &QToolButton::clicked, this, &StatusFields::cancelAsked);
  row->addWidget(work_step_);
  row->addWidget(work_bar_);
  row->addWidget(cancel_);
  bar.addWidget(fields, 1);
  work_->hide();
  work_delay_->setSingleShot(true);
  work_delay_->setInterval(kWorkDelayMs);
  connect(work_delay_, &QTimer::timeout, work_, &QWidget::show);
}

void StatusFields::set(StatusField field, const QString& text, const QString& tip) {
  QLabel* label = this->label(field);
  if (label->text() == text && label->toolTip() == tip) return;
  label->setText(text);
  label->setToolTip(tip);
  // Its text is in the name that screen readers are told; they are not told of every change.
  if (label->accessibleDescription() != tip) label->setAccessibleDescription(tip);
  if (field == StatusField::pointer) {
    rows_->setSpareWanted(!text.isEmpty());
  } else if (field != StatusField::message) {
    label->setVisible(!text.isEmpty());
  }
  label->setFocusPolicy(text.isEmpty() ? Qt::NoFocus : Qt::TabFocus);
}

QString StatusFields::text(StatusField field) const {
  return label(field)->text();
}

QWidget* StatusFields::firstField() const {
  return labels_[0];
}

void StatusFields::tell(const QString& words) {
  announcer_->say(words);
}

void StatusFields::beginWork() {
  work_bar_->setValue(0);
  work_step_->setText(tr("Working"));
  work_delay_->start();
}

void StatusFields::showWork(const QString& step, double fraction) {
  work_step_->setText(coreText(step));
  work_bar_->setValue(static_cast<int>(fraction * kBarSteps));
}

void StatusFields::endWork() {
  work_delay_->stop();
  work_->hide();
}

}  // namespace relievo
