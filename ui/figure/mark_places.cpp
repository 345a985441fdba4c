// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/mark_places.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <QStringList>

#include "core/measure/measure_text.h"
#include "core/project/shown_lengths.h"
#include "ui/figure/figure_pictures.h"
#include "ui/figure/label_place.h"
#include "ui/vtk/scale_length.h"

namespace relievo {
namespace {

constexpr double kInsetPt = 3;
constexpr double kMostInset = 0.04;  // Of a panel's shorter side.
constexpr double kLetterSize = 1.15;

/// Lines of pieces that are joined again by a blank; nothing if one is too wide.
std::vector<QString> filled(const FigureInk& ink, const QStringList& pieces, double room,
                            double size) {
  std::vector<QString> lines;
  for (const QString& piece : pieces) {
    if (ink.width(piece, size) > room) return {};
    const QString longer = lines.empty() ? piece : lines.back() + ' ' + piece;
    if (lines.empty() || ink.width(longer, size) > room) {
      lines.push_back(piece);
    } else {
      lines.back() = longer;
    }
  }
  return lines;
}

class Places {
 public:
  Places(const FigureInk& ink, const MarkedSheet& sheet, std::size_t number)
      : ink_(ink),
        sheet_(sheet),
        number_(number),
        panel_(sheet.layout.panels[number]),
        space_(ink, panel_),
        inset_(space_.inset()) {}

  PanelMarks all() {
    const FigureRequest& f = sheet_.project.figure;
    if (f.scale_bar) add(scaleBar());
    if (f.letters && sheet_.layout.panels.size() > 1) letter(f.up_mark);
    if (f.up_mark) up();
    if (f.height_bar && !panel_.whole) heightBar();
    // Aside of what is there: a mark must not hide where a measurement ends.
    if (!panel_.whole) measurements();
    return std::move(placed_);
  }

 private:
  void add(PlacedMark mark) {
    taken_.push_back(mark.box);
    placed_.marks.push_back(std::move(mark));
  }
  void leaveOut(const std::string& name) { placed_.left_out.push_back(name); }
  bool addIfFree(const std::optional<PlacedMark>& mark) {
    if (!mark || !isFree(mark->box, space_.box(), taken_)) return false;
    add(*mark);
    return true;
  }
  double thick() const { return std::max(1.0, std::round(ink_.pt(1.6))); }

  // The bar's ends lie on whole pixels; its length is off by half a pixel at most.
  PlacedMark scaleBar() const {
    const QRectF& panel = space_.box();
    const ScaleLength length = scaleLength(0.25 * panel.width() * space_.mmPerPx());
    const double bar = std::round(length.mm / space_.mmPerPx());
    const QString label = QString::fromStdString(length.label);
    // Every picture has one: where its words are too large for the panel they are smaller.
    const double size = std::min({1.0, (panel.width() - 4 * inset_) / ink_.width(label),
                                  (panel.height() - thick() - 4.2 * inset_) / ink_.lineHeight()});
    const double width = std::max(bar, ink_.width(label, size)) + 2 * inset_;
    const double height = ink_.lineHeight(size) + thick() + 2.2 * inset_;
    const QRectF box(panel.left() + inset_, panel.bottom() - inset_ - height, width, height);
    const double x = std::round(box.left() + 0.5 * (width - bar));
    const double y = std::round(box.bottom() - inset_ - thick());
    return {.kind = PlacedMark::Kind::scale_bar,
            .box = box,
            .bar = {x, y, bar, thick()},
            .words = {{{x + 0.5 * bar, y - 0.8 * inset_}, label, true, size}}};
  }

  QSizeF upSize() const {
    const double arrow = ink_.pt(1.6 * ink_.textPt());
    return {std::max(ink_.width(upName(sheet_.surface)), 0.6 * arrow) + 2 * inset_,
            arrow + ink_.lineHeight() + inset_};
  }
  void up() {
    const QSizeF size = upSize();
    const double right = space_.box().right() - inset_ - size.width();
    double top = space_.box().top() + inset_;
    for (int i = 0; i < 2; ++i) {
      const QRectF box({right, top}, size);
      const PlacedMark mark{
          .kind = PlacedMark::Kind::up,
          .box = box,
          .words = {{{box.center().x(), box.bottom() - inset_}, upName(sheet_.surface), true}}};
      if (addIfFree(mark)) return;
      for (const QRectF& other : taken_) {  // Below the letter, if that is in its way.
        if (other.top() < top + 1) top = std::max(top, other.bottom() + 1);
      }
    }
    leaveOut("up mark");
  }

  std::optional<PlacedMark> letterWith(const std::vector<QString>& title) const {
    const QString name = QString(QLatin1Char(static_cast<char>('a' + static_cast<int>(number_))));
    const double name_width = 1.1 * ink_.width(name, kLetterSize);
    const double gap = title.empty() ? 0 : inset_;
    double widest = 0;
    for (const QString& line : title) widest = std::max(widest, ink_.width(line));
    const double more =
        title.empty() ? 0 : static_cast<double>(title.size() - 1) * ink_.lineHeight();
    const double first = ink_.lineHeight(kLetterSize);
    const QRectF box(space_.box().left() + inset_, space_.box().top() + inset_,
                     name_width + gap + widest + 2 * inset_, first + more);
    PlacedMark mark{.kind = PlacedMark::Kind::letter, .box = box, .words = {}};
    double baseline = box.top() + 0.72 * first;
    mark.words.push_back({{box.left() + inset_, baseline}, name, false, kLetterSize, true});
    for (const QString& line : title) {
      mark.words.push_back({{box.left() + inset_ + name_width + gap, baseline}, line});
      baseline += ink_.lineHeight();
    }
    return mark;
  }
  /// Beside the up mark if its title has room there, else above it.
  void letter(bool beside_up_mark) {
    const double alone = letterWith({})->box.width() + inset_;
    const double whole = space_.box().width() - 2 * inset_ - alone;
    const double beside = whole - upSize().width() - inset_;
    for (const double room : {beside_up_mark ? beside : whole, whole}) {
      const std::vector<QString> title = wrapped(ink_, panel_.title, room);
      if (title.empty() && !panel_.title.isEmpty()) continue;
      if (addIfFree(letterWith(title))) return;
    }
    if (!panel_.title.isEmpty()) leaveOut('\'' + panel_.title.toStdString() + '\'');
    if (!addIfFree(letterWith({}))) leaveOut("letter");
  }

  /// The relief's height at the picture's own scale, upright; nothing if it is too flat for that.
  std::optional<PlacedMark> heightBarOf(double most_mm) const {
    if (!(most_mm > 0)) return std::nullopt;
    const ScaleLength length = scaleLength(most_mm);
    const double bar = std::round(length.mm / space_.mmPerPx());
    if (bar < ink_.pt(2)) return std::nullopt;
    const QString label = QStringLiteral("height %1").arg(QString::fromStdString(length.label));
    const double width = ink_.width(label) + thick() + 3 * inset_;
    const double height = std::max(bar, ink_.lineHeight()) + 2 * inset_;
    const QRectF box(space_.box().right() - inset_ - width, space_.box().bottom() - inset_ - height,
                     width, height);
    const double bottom = std::round(box.bottom() - inset_);
    return PlacedMark{
        .kind = PlacedMark::Kind::height_bar,
        .box = box,
        .bar = {std::round(box.right() - inset_ - thick()), bottom - bar, thick(), bar},
        .words = {
            {{box.left() + inset_, box.center().y() + 0.35 * ink_.pt(ink_.textPt())}, label}}};
  }
  void heightBar() {
    const Surface& surface = sheet_.surface;
    const HeightRange z =
        heightRange(cutOut(surface, panel_.level, panel_.shown, 0, sheet_.project.gain));
    double most_mm = std::min(z.max_mm - z.min_mm, 0.22 * space_.box().height() * space_.mmPerPx());
    if (!heightBarOf(most_mm)) return;
    for (; const auto right = heightBarOf(most_mm); most_mm /= 2) {
      if (addIfFree(right)) return;
      if (taken_.empty()) continue;
      // Above the scale bar, on whole pixels as it is.
      const QPointF by(std::round(space_.box().left() + inset_ - right->box.left()),
                       std::round(taken_.front().top() - inset_ - right->box.bottom()));
      PlacedMark above = *right;
      above.box.translate(by);
      above.bar.translate(by);
      above.words.front().at += by;
      if (addIfFree(above)) return;
    }
    leaveOut("height bar");
  }

  void measurements() {
    const ShownLengths lengths(sheet_.surface);
    for (std::size_t i = 0; i < sheet_.measured.size(); ++i) {
      const Measurement& m = sheet_.project.measurements[i];
      const auto label = labelOf(ink_, space_, {m, sheet_.measured[i], lengths}, taken_);
      if (label) {
        add(*label);
      } else {
        leaveOut("value of " + m.name);
      }
    }
  }

  const FigureInk& ink_;
  const MarkedSheet& sheet_;
  std::size_t number_;
  const FigurePanel& panel_;
  PanelSpace space_;
  double inset_;
  std::vector<QRectF> taken_;
  PanelMarks placed_;
};

}  // namespace

PanelSpace::PanelSpace(const FigureInk& ink, const FigurePanel& panel)
    : box_(ink.pixels(panel.paper)), shown_(panel.shown) {
  mm_per_px_ = std::max(shown_.width_mm / box_.width(), shown_.height_mm / box_.height());
  inset_ = std::min(ink.pt(kInsetPt), kMostInset * std::min(box_.width(), box_.height()));
}

QPointF PanelSpace::at(double x_mm, double y_mm) const {
  const double right = x_mm - shown_.x_mm - 0.5 * shown_.width_mm;
  const double up = y_mm - shown_.y_mm - 0.5 * shown_.height_mm;
  return box_.center() + QPointF(right, -up) / mm_per_px_;
}

QString upName(const Surface& surface) {
  const auto& m = surface.view_from_file.m;
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (std::abs(m[4 + k]) > std::abs(m[4 + axis])) axis = k;
  }
  const double length = std::hypot(m[4], m[5], m[6]);
  if (std::abs(m[4 + axis]) < 0.999 * length) return QStringLiteral("up");
  const ScanInfo& info = surface.info;
  // A raster states a unit by its projection, or as a map of ours, in millimetres.
  const bool map = info.format.starts_with("LAS") || info.format.starts_with("LAZ") ||
                   ((info.format.starts_with("GeoTIFF") || info.format.starts_with("ESRI")) &&
                    info.unit && *info.unit != LengthUnit::mm);
  if (map && axis == 1 && m[5] > 0) return QStringLiteral("N");
  const char letter = "xyz"[axis];
  return (m[4 + axis] < 0 ? QStringLiteral("\u2212%1") : QStringLiteral("%1")).arg(letter);
}

std::vector<QString> wrapped(const FigureInk& ink, const QString& text, double room, double size) {
  if (text.isEmpty()) return {};
  QStringList clauses = text.split(QStringLiteral(", "));
  for (int i = 0; i + 1 < clauses.size(); ++i) clauses[i] += ',';
  std::vector<QString> lines = filled(ink, clauses, room, size);
  return lines.empty() ? filled(ink, text.split(' '), room, size) : lines;
}

std::vector<PanelMarks> placeMarks(const FigureInk& ink, const MarkedSheet& sheet) {
  std::vector<PanelMarks> panels;
  for (std::size_t i = 0; i < sheet.layout.panels.size(); ++i) {
    panels.push_back(Places(ink, sheet, i).all());
  }
  return panels;
}

std::string leftOutText(const std::vector<PanelMarks>& panels) {
  std::map<std::string, std::string> letters_of;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    for (const std::string& name : panels[i].left_out) {
      std::string& letters = letters_of[name];
      letters += (letters.empty() ? "" : ", ") + std::string(1, static_cast<char>('a' + i));
    }
  }
  std::string text;
  for (const auto& [name, letters] : letters_of) {
    text += text.empty() ? "No room in the picture for: " : "; ";
    text += name + (panels.size() > 1 ? " (" + letters + ")" : "");
  }
  return text.empty() ? text : text + ".";
}

}  // namespace relievo
