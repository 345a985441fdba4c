// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/replay_panel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include "core/recording/force_curve.h"
#include "ui/panels/replay_events.h"
#include "ui/plots/curve_pens.h"
#include "ui/plots/least_ranges.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr double kMostShownS = 60;   // A longer recording is shown in parts ...
constexpr double kPartS = 20;        // ... of this length.
constexpr std::size_t kBins = 1500;  // Points per curve; a strip is a thousand pixels wide.
constexpr int kLeastPlotPx = 80;     // Below the controls there is still something to see.
constexpr double kStepS = 0.1, kLargeStepS = 1;

QToolButton* button(const char* name, const QString& text, const QString& tip) {
  auto* made = new QToolButton;
  made->setObjectName(QString::fromLatin1(name));
  made->setText(text);
  made->setAccessibleName(text);
  made->setToolTip(tip);
  made->setFocusPolicy(Qt::StrongFocus);
  return made;
}

/// The smallest and the largest value of each bin, so that no peak is lost.
QVector<QPointF> thinned(const TouchRecording& recording, double low_s, double high_s,
                         const std::function<double(const TouchRow&)>& value) {
  const auto at = [&](double t_s) {
    return std::lower_bound(recording.rows.begin(), recording.rows.end(), recording.startS() + t_s,
                            [](const TouchRow& row, double t) { return row.t_s < t; });
  };
  const auto first = at(low_s);
  const auto last = at(high_s + 1e-9);
  const auto step =
      std::max<std::ptrdiff_t>(1, (last - first) / static_cast<std::ptrdiff_t>(kBins));
  QVector<QPointF> curve;
  for (auto bin = first; bin < last; bin += std::min(step, last - bin)) {
    auto [low, high] =
        std::minmax_element(bin, bin + std::min(step, last - bin),
                            [&](const auto& a, const auto& b) { return value(a) < value(b); });
    if (low->t_s > high->t_s) std::swap(low, high);
    curve.append({low->t_s - recording.startS(), value(*low)});
    if (low != high) curve.append({high->t_s - recording.startS(), value(*high)});
  }
  return curve;
}

double largest(const QVector<QPointF>& curve) {
  double most = 0;
  for (const QPointF& p : curve) most = std::max(most, p.y());
  return most;
}

}  // namespace

ReplayPanel::ReplayPanel(ReplayPlayer& player, QWidget* parent)
    : QWidget(parent),
      player_(player),
      play_(button("replay_play_button", tr("Play"), tr("Play or pause (Space)"))),
      close_(button("replay_close_button", tr("Close"), tr("End the replay (Esc)"))),
      slider_(new QSlider(Qt::Horizontal)),
      time_(new QLabel),
      readout_(new QLabel),
      speed_(new QComboBox),
      heights_(tr("Height of hand and proxy in the recording"), tr("z (mm)"),
               curveNames(ForceStrip::heights), kPartS, this),
      forces_(tr("Force in the recording"), tr("force (N)"), curveNames(ForceStrip::forces), kPartS,
              this) {
  setObjectName(QStringLiteral("replay_panel"));
  setAccessibleName(tr("Replay"));
  layOut();
  connect(play_, &QToolButton::clicked, &player_, &ReplayPlayer::toggle);
  connect(close_, &QToolButton::clicked, this, &ReplayPanel::closeAsked);
  connect(slider_, &QSlider::valueChanged, this,
          [this](int ms) { player_.setTime(1e-3 * static_cast<double>(ms)); });
  connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int index) { player_.setSpeed(speed_->itemData(index).toDouble()); });
  connect(&player_, &ReplayPlayer::moved, this, &ReplayPanel::showTime);
  connect(&player_, &ReplayPlayer::playingChanged, this, [this](bool playing) {
    play_->setText(playing ? tr("Pause") : tr("Play"));
    play_->setAccessibleName(play_->text());
  });
  takeColours();
}

void ReplayPanel::layOut() {
  slider_->setObjectName(QStringLiteral("replay_slider"));
  slider_->setAccessibleName(tr("Place in the recording"));
  slider_->setToolTip(
      tr("Drag through the recording; left and right by 0.1 s, Page keys by 1 s, "
         "up and down by events"));
  slider_->setSingleStep(static_cast<int>(1000 * kStepS));
  slider_->setPageStep(static_cast<int>(1000 * kLargeStepS));
  slider_->setFocusPolicy(Qt::StrongFocus);
  slider_->installEventFilter(this);
  time_->setObjectName(QStringLiteral("replay_time"));
  time_->setAccessibleName(tr("Time in the recording"));
  speed_->setObjectName(QStringLiteral("replay_speed"));
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("How fast the recording is shown"));
  for (const double factor : {1.0, 0.5, 0.25, 0.1}) {
    speed_->addItem(QLocale().toString(factor) + QStringLiteral(" \u00d7"), factor);
  }
  auto* controls = new QHBoxLayout;
  controls->addWidget(play_);
  controls->addWidget(slider_, 1);
  controls->addWidget(time_);
  controls->addWidget(speed_);
  controls->addWidget(close_);
  auto* steps = new QHBoxLayout;
  steps->setSpacing(12);
  steps->addWidget(makeSteps());
  steps->addWidget(readout_, 1);
  auto* plots = new QHBoxLayout;
  plots->setSpacing(12);
  plots->addWidget(heights_.widget(), 1);
  plots->addWidget(forces_.widget(), 1);
  for (StripPlot* plot : {&heights_, &forces_}) plot->widget()->setMinimumHeight(kLeastPlotPx);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 2, 8, 2);
  column->setSpacing(2);
  column->addLayout(controls);
  column->addLayout(steps);
  column->addLayout(plots, 1);
  takeFont();
}

QWidget* ReplayPanel::makeSteps() {
  auto* row = new QWidget;
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 0, 0);
  const auto add = [this, line](const char* name, const QString& text, const QString& about,
                                const QString& key, auto action) {
    auto* made = button(name, text, QStringLiteral("%1 (%2)").arg(about, key));
    made->setAccessibleName(about);
    connect(made, &QToolButton::clicked, this, action);
    line->addWidget(made);
  };
  add("replay_event_before", tr("\u25c2 Event"), tr("Event before"), tr("Up"),
      [this] { Q_EMIT eventAsked(-1); });
  add("replay_event_next", tr("Event \u25b8"), tr("Next event"), tr("Down"),
      [this] { Q_EMIT eventAsked(1); });
  add("replay_sample_before", tr("\u25c2 Sample"), tr("Sample before"), tr("Shift+Left"),
      [this] { goByKey(Qt::Key_Left, Qt::ShiftModifier); });
  add("replay_sample_next", tr("Sample \u25b8"), tr("Next sample"), tr("Shift+Right"),
      [this] { goByKey(Qt::Key_Right, Qt::ShiftModifier); });
  readout_->setObjectName(QStringLiteral("replay_readout"));
  readout_->setAccessibleName(tr("Here in the recording"));
  readout_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  // A long note must not widen the window; its whole text is the tooltip.
  readout_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  return row;
}

void ReplayPanel::showReadout() {
  const TouchRow& row = player_.row();
  QString text = tr("HIP z %1 mm   proxy z %2 mm   force %3 N")
                     .arg(numberText(row.hip.z, 2), numberText(row.proxy.z, 2),
                          numberText(norm(row.force), 2));
  const TouchRecording& recording = *player_.recording();
  const TouchEvent* event = eventAt(recording, recording.startS() + player_.timeS());
  if (event != event_) {
    event_ = event;
    event_text_ = event == nullptr
                      ? QString()
                      : tr("   |   since %1 s: %2")
                            .arg(numberText(event->t_s - recording.startS(), 2), eventText(*event));
  }
  text += event_text_;
  if (text == readout_->toolTip()) return;
  readout_->setToolTip(text);
  readout_->setAccessibleDescription(text);
  readout_->setText(text);
}

void ReplayPanel::takeFont() {
  // Nothing beside the time jumps while it counts.
  const QString end = numberText(player_.durationS(), 2);
  time_->setMinimumWidth(QFontMetrics(font()).horizontalAdvance(tr("%1 of %2 s").arg(end, end)));
  slider_->setMinimumWidth(2 * QFontMetrics(font()).height());
  for (StripPlot* plot : {&heights_, &forces_}) plot->takeFont(font());
}

void ReplayPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) takeFont();
}

QString ReplayPanel::timeText() const {
  return tr("%1 of %2 s").arg(numberText(player_.timeS(), 2), numberText(player_.durationS(), 2));
}

void ReplayPanel::takeColours() {
  const ThemeColours& c = currentColours();
  heights_.setColours(c.base, c.border, c.quiet_text, curvePens(ForceStrip::heights, c));
  forces_.setColours(c.base, c.border, c.quiet_text, curvePens(ForceStrip::forces, c));
  heights_.setCursorColour(c.text);
  forces_.setCursorColour(c.text);
}

void ReplayPanel::showLoaded() {
  shown_ = player_.recording();
  event_ = nullptr;
  event_text_.clear();
  const QSignalBlocker quiet(slider_);
  slider_->setRange(0, static_cast<int>(std::lround(1000 * player_.durationS())));
  low_s_ = high_s_ = 0;
  takeFont();
}

void ReplayPanel::showTime() {
  if (player_.recording() == nullptr) return;
  if (shown_ != player_.recording()) showLoaded();
  const double t = player_.timeS();
  {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(1000 * t)));
  }
  const QString text = timeText();
  time_->setText(text);
  slider_->setAccessibleDescription(text);
  const double duration = player_.durationS();
  double low = 0, high = duration;
  if (duration > kMostShownS) {
    // Part by part, so that the curves stand still while the cursor goes through them.
    low = std::min(kPartS * std::floor(t / kPartS), duration - kPartS);
    high = low + kPartS;
  }
  if (low != low_s_ || high != high_s_) {
    low_s_ = low;
    high_s_ = high;
    showPart();
  }
  showReadout();
  cursor_s_ = t;
  heights_.setCursor(t);
  forces_.setCursor(t);
  heights_.replot();
  forces_.replot();
}

void ReplayPanel::showPart() {
  const TouchRecording& recording = *player_.recording();
  QVector<double> events;
  for (const TouchEvent& event : recording.events) events.append(event.t_s - recording.startS());
  heights_.setEvents(events);
  forces_.setEvents(events);
  heights_.setTimes(low_s_, high_s_);
  forces_.setTimes(low_s_, high_s_);
  const auto curve = [&](const std::function<double(const TouchRow&)>& value) {
    return thinned(recording, low_s_, high_s_, value);
  };
  double strongest = kLeastForceN;
  int heights = 0, forces = 0;
  for (const ForceCurve& shown : kForceCurves) {
    const QVector<QPointF> points =
        curve([&](const TouchRow& row) { return forcePoint(row).*shown.value; });
    if (shown.strip == ForceStrip::heights) {
      heights_.setCurve(heights++, points);
    } else {
      forces_.setCurve(forces++, points);
      strongest = std::max(strongest, largest(points));
    }
  }
  heights_.setRangeFromCurves(kLeastHeightMm);
  forces_.setRange(0, 1.05 * strongest);
}

bool ReplayPanel::goByKey(int key, Qt::KeyboardModifiers modifiers) {
  if (player_.recording() == nullptr) return false;
  if (modifiers == Qt::ShiftModifier && (key == Qt::Key_Left || key == Qt::Key_Right)) {
    player_.pause();
    player_.stepRows(key == Qt::Key_Right ? 1 : -1);
    return true;
  }
  if (modifiers != Qt::NoModifier) return false;
  const double t = player_.timeS();
  switch (key) {
    case Qt::Key_Left:
      player_.setTime(t - kStepS);
      return true;
    case Qt::Key_Right:
      player_.setTime(t + kStepS);
      return true;
    case Qt::Key_PageUp:
      player_.setTime(t - kLargeStepS);
      return true;
    case Qt::Key_PageDown:
      player_.setTime(t + kLargeStepS);
      return true;
    case Qt::Key_Up:
      Q_EMIT eventAsked(-1);
      return true;
    case Qt::Key_Down:
      Q_EMIT eventAsked(1);
      return true;
    case Qt::Key_Home:
      player_.setTime(0);
      return true;
    case Qt::Key_End:
      player_.setTime(player_.durationS());
      return true;
    case Qt::Key_Space:
      player_.toggle();
      return true;
    default:
      return false;
  }
}

void ReplayPanel::keyPressEvent(QKeyEvent* event) {
  if (!goByKey(event->key(), event->modifiers() & ~Qt::KeypadModifier)) {
    QWidget::keyPressEvent(event);
  }
}

// A slider's own Page keys go the other way round.
bool ReplayPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == slider_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (goByKey(key->key(), key->modifiers() & ~Qt::KeypadModifier)) return true;
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace relievo
