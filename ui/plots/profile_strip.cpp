// SPDX-License-Identifier: BSD-3-Clause
#include "ui/plots/profile_strip.h"

#include <algorithm>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/style/palette.h"

namespace relievo {
namespace {

constexpr int kLeastLines = 3;  // Of text, that a curve is high.
constexpr int kManyRows = 10;

bool sameRows(const std::vector<ProfileRow>& a, const std::vector<ProfileRow>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const ProfileRow& x, const ProfileRow& y) {
                      return x.along_mm == y.along_mm && x.point.at.z == y.point.at.z &&
                             x.point.at.x == y.point.at.x && x.point.at.y == y.point.at.y;
                    });
}

}  // namespace

/// The curve itself.
class ProfileStrip::Canvas : public QWidget {
 public:
  explicit Canvas(ProfileStrip& strip) : QWidget(&strip), strip_(strip) {
    setObjectName(QStringLiteral("profile_curve"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName(ProfileStrip::tr("Profile"));
    setToolTip(ProfileStrip::tr(
        "Press to put the cursor, drag to choose a piece. Arrows move the cursor, with Shift they "
        "choose a piece"));
  }
  QSize minimumSizeHint() const override { return {120, kLeastLines * fontMetrics().height()}; }

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    if (strip_.isEmpty()) return;
    const ThemeColours& c = currentColours();
    QColor piece = c.highlight;
    piece.setAlpha(70);
    QPainter painter(this);
    drawProfile(painter, rect(), font(), strip_.shown(),
                {c.base, c.border, c.quiet_text, c.proxy, c.hip, piece});
    if (!hasFocus()) return;
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() != Qt::LeftButton || strip_.isEmpty()) return;
    strip_.setCursorRow(rowAt(event->localPos()), false);
  }
  void mouseMoveEvent(QMouseEvent* event) override {
    if ((event->buttons() & Qt::LeftButton) == 0 || strip_.isEmpty()) return;
    strip_.setCursorRow(rowAt(event->localPos()), true);
  }
  void keyPressEvent(QKeyEvent* event) override {
    const bool plain =
        (event->modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) == 0;
    const std::optional<int> row = plain && !strip_.isEmpty() ? rowBy(event->key()) : std::nullopt;
    if (!row) return QWidget::keyPressEvent(event);
    const int last = static_cast<int>(strip_.shown().rows.size()) - 1;
    strip_.setCursorRow(static_cast<std::size_t>(std::clamp(*row, 0, last)),
                        (event->modifiers() & Qt::ShiftModifier) != 0);
  }

 private:
  std::size_t rowAt(const QPointF& point) const {
    return profileRowAt(rect(), font(), strip_.shown(), point);
  }
  std::optional<int> rowBy(int key) const {
    const int last = static_cast<int>(strip_.shown().rows.size()) - 1;
    const int now = static_cast<int>(strip_.shown().cursor.value_or(0));
    switch (key) {
      case Qt::Key_Left:
        return now - 1;
      case Qt::Key_Right:
        return now + 1;
      case Qt::Key_PageUp:
        return now + kManyRows;
      case Qt::Key_PageDown:
        return now - kManyRows;
      case Qt::Key_Home:
        return 0;
      case Qt::Key_End:
        return last;
      default:
        return std::nullopt;
    }
  }

  ProfileStrip& strip_;
};

ProfileStrip::ProfileStrip(QWidget* parent)
    : QWidget(parent),
      readout_(new QLabel),
      save_(new QToolButton),
      close_(new QToolButton),
      canvas_(new Canvas(*this)) {
  setObjectName(QStringLiteral("profile_strip"));
  setAccessibleName(tr("Profile under the views"));
  readout_->setObjectName(QStringLiteral("profile_readout"));
  readout_->setAccessibleName(tr("Length and depth"));
  readout_->setTextFormat(Qt::PlainText);
  readout_->setWordWrap(true);
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  save_->setText(tr("Save\u2026"));
  save_->setObjectName(QStringLiteral("profile_save_button"));
  save_->setAccessibleName(tr("Save profile"));
  save_->setToolTip(tr("Save the curve as it is shown, or its numbers"));
  close_->setText(QStringLiteral("\u00d7"));
  close_->setObjectName(QStringLiteral("profile_close_button"));
  close_->setAccessibleName(tr("Hide profile"));
  close_->setToolTip(tr("Hide the curve; the Measure menu shows it again"));
  for (QToolButton* button : {save_, close_}) button->setFocusPolicy(Qt::StrongFocus);
  auto* head = new QHBoxLayout;
  head->setContentsMargins(10, 2, 4, 0);
  head->addWidget(readout_, 1);
  head->addWidget(save_);
  head->addWidget(close_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addLayout(head);
  column->addWidget(canvas_, 1);
  connect(save_, &QToolButton::clicked, this, &ProfileStrip::saveAsked);
  connect(close_, &QToolButton::clicked, this, &ProfileStrip::closeAsked);
}

void ProfileStrip::show(const QString& name, const std::vector<ProfileRow>& rows) {
  if (name == name_ && sameRows(rows, shown_.rows)) return;
  const bool same = sameRows(rows, shown_.rows);
  name_ = name;
  if (!same) shown_ = {rows, {}, {}};
  showReadout();
  if (!same) Q_EMIT cursorMoved();
}

std::optional<ViewMm> ProfileStrip::cursorAt() const {
  if (!shown_.cursor) return std::nullopt;
  return shown_.rows[*shown_.cursor].point.at;
}

QString ProfileStrip::readout() const {
  if (isEmpty()) return {};
  return tr("Profile %1: %2").arg(name_, profileText(shown_));
}

std::string ProfileStrip::drawing() const {
  return profileDrawing(shown_, font(),
                        QSizeF(canvas_->size()) + QSizeF(0, fontMetrics().height()));
}

void ProfileStrip::takeColours() {
  canvas_->update();
}

void ProfileStrip::setCursorRow(std::size_t row, bool piece) {
  if (!piece) {
    shown_.mark.reset();
  } else if (!shown_.mark) {
    shown_.mark = shown_.cursor.value_or(row);
  }
  shown_.cursor = row;
  showReadout();
  Q_EMIT cursorMoved();
}

void ProfileStrip::showReadout() {
  readout_->setText(readout());
  fitReadout();
  canvas_->setAccessibleDescription(readout());
  canvas_->update();
}

/// A splitter asks for no height for a width: the lines that it wraps into would be cut. Without
/// text a label answers -1.
void ProfileStrip::fitReadout() {
  const int width = readout_->width();
  if (width > 0) readout_->setMinimumHeight(std::max(0, readout_->heightForWidth(width)));
}

void ProfileStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitReadout();
}

void ProfileStrip::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange) fitReadout();
}

}  // namespace relievo
