// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_legend.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/base/axis.h"
#include "core/project/caption.h"
#include "core/project/shown_lengths.h"
#include "ui/figure/label_place.h"

namespace relievo {
namespace {

const QColor kHatchDark(46, 52, 64), kHatchLight(246, 246, 242);
const QColor kHatchedStone(206, 205, 202), kHatchedPlane(176, 178, 182);
// Of rows, times the text's size.
constexpr double kSwatchRowEm = 1.8, kBarRowEm = 4.05, kLineEm = 1.3;

/// Diagonal lines as the relief's hatch draws them: single, or crossed over darker ground.
void swatch(FigureInk& ink, const QRectF& box, bool crossed) {
  QPainter& painter = ink.painter();
  painter.save();
  painter.setClipRect(box);
  painter.fillRect(box, crossed ? kHatchedPlane : kHatchedStone);
  const double step = ink.pt(5);
  // A light line beside every dark one: both show on any ground.
  for (const auto& [colour, aside] :
       {std::pair{kHatchLight, ink.pt(1)}, std::pair{kHatchDark, 0.0}}) {
    painter.setPen(ink.pen(colour, 0.7));
    for (double x = box.left() - box.height() + aside; x < box.right(); x += step) {
      painter.drawLine(QPointF(x, box.top()), QPointF(x + box.height(), box.bottom()));
      if (crossed) painter.drawLine(QPointF(x, box.bottom()), QPointF(x + box.height(), box.top()));
    }
  }
  painter.restore();
  painter.setPen(ink.pen(kInk, 0.4));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box);
}

struct Swatch {
  bool crossed = false;
  QString label;
};

std::vector<Swatch> swatchesOf(const Surface& surface, const Project& project) {
  std::vector<Swatch> swatches;
  if (!project.figure.hatch) return swatches;
  const auto [shares, of_object] = legendShares(surface, project);
  const QLatin1String whole(of_object ? "object" : "region");
  for (const auto& [origin, label, crossed] :
       {std::tuple{CellStatus::interpolated, "interpolated", false},
        std::tuple{CellStatus::base_plane, "hole, on the base plane", true}}) {
    const double share = shares[static_cast<std::size_t>(origin)];
    if (share == 0) continue;
    swatches.push_back(
        {crossed, QStringLiteral("%1, %2 % of the %3")
                      .arg(QLatin1String(label),
                           QString::fromStdString(shortNumber(100 * share, 3)), whole)});
  }
  return swatches;
}

QString titleOf(const ReliefValues& values, const ShownUnit& unit) {
  if (unit.name.empty()) return words(values.title);
  return QStringLiteral("%1 (%2)").arg(words(values.title), words(unit.name));
}

/// Lines of text within a room; smaller in the one case that a single word is wider.
struct FittedText {
  FittedText(const FigureInk& ink, const QString& text, double room)
      : lines(wrapped(ink, text, room)) {
    if (lines.empty()) {
      lines = {text};
      size = std::min(1.0, room / ink.width(text));
    }
    for (const QString& line : lines) width = std::max(width, ink.width(line, size));
  }
  /// Beyond the first.
  double moreLines() const { return static_cast<double>(lines.size()) - 1; }

  std::vector<QString> lines;
  double size = 1;
  double width = 0;  ///< Pixels.
};

constexpr int kMostTickSteps = 5, kLeastTickSteps = 2;
constexpr double kBarEm =
    13;  // Width of a bar, times the text's size; more if its numbers need it.

/// The bar that explains the colours: round numbers under it, as many decimals as their step needs.
class ColourBar {
 public:
  /// @param room  pixels; a bar that would be wider has fewer numbers
  ColourBar(const FigureInk& ink, const ReliefValues& values, const ShownUnit& unit, double room)
      : title_(ink, titleOf(values, unit), room) {
    const double low = values.low / unit.size;
    const double high = values.high / unit.size;
    for (int steps = kMostTickSteps; steps >= kLeastTickSteps; --steps) {
      place(ink, low, high - low, steps, room);
      if (width() <= room) return;
    }
    size_ = room / width();
  }

  /// With what the outermost numbers and the title stand out.
  double width() const { return size_ * (left_ + bar_ + right_); }
  double textSize() const { return size_ * title_.size; }
  double rowEm() const { return kBarRowEm + kLineEm * title_.moreLines(); }

  void draw(FigureInk& ink, const QPointF& corner, ColourMap colours) const {
    const double line = ink.lineHeight(size_);
    const QRectF bar(corner.x() + size_ * left_, corner.y() + 0.1 * line, size_ * bar_, 0.7 * line);
    paint(ink, bar, colours);
    double below = bar.bottom() + 0.95 * line;
    ink.painter().setPen(ink.pen(kInk, 0.4));
    for (const Tick& tick : ticks_) {
      const double x = bar.left() + tick.at * bar.width();
      ink.painter().drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + 0.15 * line));
      ink.text({x, below}, tick.label, Qt::AlignHCenter, size_);
    }
    for (const QString& words : title_.lines) {
      below += 0.95 * line;
      ink.text({bar.center().x(), below}, words, Qt::AlignHCenter, size_ * title_.size);
    }
  }

 private:
  static constexpr double kRounding = 1e-9;  // Of a step.

  void place(const FigureInk& ink, double low, double range, int steps, double room) {
    ticks_.clear();
    const double step = axisFor(low, low + range, steps, AxisEnds::exact).step;
    double widest = 0;
    for (double n = std::ceil(low / step - kRounding); n * step <= low + range + kRounding * step;
         ++n) {
      ticks_.push_back({(n * step - low) / range, numeral(tickText(n * step, step))});
      widest = std::max(widest, ink.width(ticks_.back().label));
    }
    const double em = ink.pt(ink.textPt());
    const double needed = (widest + 0.8 * em) * range / step;
    spread(ink, std::max(kBarEm * em, needed));
    if (width() > room) spread(ink, std::max(needed, std::min(bar_, room - widest)));
  }
  void spread(const FigureInk& ink, double bar) {
    bar_ = bar;
    left_ = right_ = std::max(0.0, 0.5 * (title_.width - bar_));
    for (const Tick& tick : ticks_) {
      const double half = 0.5 * ink.width(tick.label);
      left_ = std::max(left_, half - tick.at * bar_);
      right_ = std::max(right_, half - (1 - tick.at) * bar_);
    }
  }

  static void paint(FigureInk& ink, const QRectF& bar, ColourMap colours) {
    QPainter& painter = ink.painter();
    const int steps = 128;
    for (int i = 0; i < steps; ++i) {
      const Rgb8 c = colourOf(colours, (i + 0.5) / steps);
      const double from = bar.left() + bar.width() * i / steps;
      const double to = bar.left() + bar.width() * (i + 1) / steps;
      // Up to the end from each step on: no paper shines through between two of them.
      painter.fillRect(
          QRectF(from, bar.top(), i + 1 < steps ? bar.right() - from : to - from, bar.height()),
          QColor(c[0], c[1], c[2]));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(ink.pen(kInk, 0.4));
    painter.drawRect(bar);
  }

  struct Tick {
    double at = 0;  ///< Along the bar, 0 to 1.
    QString label;
  };
  FittedText title_;
  std::vector<Tick> ticks_;
  double bar_ = 0, left_ = 0, right_ = 0;  ///< Pixels, at the text's size.
  double size_ = 1;                        ///< Below 1 where not even the fewest numbers fit.
};

/// A swatch and its words.
struct Entry {
  bool crossed = false;
  FittedText words;
  double width = 0;
};

}  // namespace

struct FigureLegend::Impl {
  std::optional<ColourBar> bar;
  ColourMap colours;
  std::vector<Entry> entries;
  /// Upper left corners, from that of the legend: of the bar, if any, and of the entries.
  std::vector<QPointF> corners;
  double width = 0, height = 0;

  void place(const FigureInk& ink, double room) {
    const double em = ink.pt(ink.textPt());
    double x = 0, y = 0, row = 0;
    const auto next = [&](double across, double row_em) {
      if (x > 0 && x + across > room) {
        y += row;
        x = row = 0;
      }
      corners.emplace_back(x, y);
      width = std::max(width, x + across);
      x += across + ink.pt(10);
      row = std::max(row, row_em * em);
    };
    if (bar) next(bar->width(), bar->rowEm());
    for (const Entry& e : entries) next(e.width, kSwatchRowEm + kLineEm * e.words.moreLines());
    height = y + row;
  }
};

FigureLegend::FigureLegend(const FigureInk& ink, const Surface& surface, const Project& project,
                           const ReliefValues& values, double room)
    : impl_(std::make_unique<Impl>()) {
  const ReliefLook& look = project.figure.look;
  impl_->colours = coloursOf(look);
  if (hasLegend(look.kind)) {
    impl_->bar.emplace(ink, values, ShownLengths(surface).unitFor(values.unit), room);
  }
  const double field = 1.6 * ink.lineHeight() + ink.pt(3);
  for (const Swatch& s : swatchesOf(surface, project)) {
    const FittedText words(ink, s.label, room - field);
    impl_->entries.push_back({s.crossed, words, field + words.width});
  }
  impl_->place(ink, room);
}

FigureLegend::~FigureLegend() = default;

double FigureLegend::width() const {
  return impl_->width;
}

double FigureLegend::textSize() const {
  double size = impl_->bar ? impl_->bar->textSize() : 1;
  for (const Entry& e : impl_->entries) size = std::min(size, e.words.size);
  return size;
}

double FigureLegend::height() const {
  return impl_->height;
}

void FigureLegend::draw(FigureInk& ink, const QPointF& corner) const {
  const double line = ink.lineHeight();
  auto at = impl_->corners.begin();
  if (impl_->bar) impl_->bar->draw(ink, corner + *at++, impl_->colours);
  for (const Entry& e : impl_->entries) {
    const QPointF entry = corner + *at++;
    const QRectF field(entry.x(), entry.y() + 0.1 * line, 1.6 * line, 0.8 * line);
    swatch(ink, field, e.crossed);
    double baseline = field.bottom() - 0.12 * line;
    for (const QString& words : e.words.lines) {
      ink.text({field.right() + ink.pt(3), baseline}, words, Qt::AlignLeft, e.words.size);
      baseline += line;
    }
  }
}

}  // namespace relievo
