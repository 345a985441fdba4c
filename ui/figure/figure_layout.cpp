// SPDX-License-Identifier: BSD-3-Clause
#include "ui/figure/figure_layout.h"

#include <algorithm>
#include <cmath>

#include "core/base/failure.h"
#include "core/project/caption.h"
#include "core/project/shown_lengths.h"
#include "core/relief/relief_image.h"
#include "core/session/large/tiled_surface.h"
#include "core/session/map_facts.h"
#include "ui/figure/figure_plot.h"

namespace relievo {
namespace {

constexpr double kGapMm = 2;
constexpr double kPlotMm = 26;   // Height of one plot's box at least,
constexpr double kPlotEm = 9.2;  // and times the text's size: its numbers stand above each other.
constexpr double kLeastPaperMm = 20, kMostPaperMm = 2000;
constexpr int kMostLevels = 4;
constexpr double kLeastPlotEm = 9;      // Across, with its numbers.
constexpr double kEnoughSamples = 600;  // Across the reference: no more is seen on a page.

RectMm rectOf(const Region& r) {
  return {r.x_mm, r.y_mm, r.side_mm, r.side_mm};
}

RectMm rectOf(const DetailLadder& map) {
  return {map.left_mm, map.bottom_mm, map.width_mm, map.height_mm};
}

/// The coarsest level that shows the whole object finely enough.
Level levelOfWhole(const DetailLadder& map) {
  const double longer = std::max(map.width_mm, map.height_mm);
  int level = map.levels() - 1;
  while (level > 0 && longer / map.spacings_mm[static_cast<std::size_t>(level)] < kEnoughSamples) {
    --level;
  }
  return {level};
}

/// Three digits; from a thousand on whole numbers, which are read more easily than an exponent.
NumberArgument shown(double value) {
  constexpr double kWholeFrom = 999.5;
  if (value >= kWholeFrom) return {.value = value};
  return {.value = value, .digits = 3, .form = NumberArgument::Form::significant};
}

void checkPaper(const FigureSheet& sheet) {
  const bool tiny = sheet.width_mm < kLeastPaperMm;
  if (!tiny && sheet.width_mm <= kMostPaperMm && sheet.height_mm <= kMostPaperMm) return;
  const NumberArgument width = shown(sheet.width_mm), height = shown(sheet.height_mm);
  if (tiny) throw failure<MessageId::figure_too_small>(width, height);
  throw failure<MessageId::figure_too_large>(width, height);
}

bool needsLegend(const Surface& surface, const Project& project) {
  const FigureRequest& f = project.figure;
  if (!f.legend) return false;
  if (hasLegend(f.look.kind)) return true;
  const auto shares = legendShares(surface, project).shares;
  return f.hatch && shares[static_cast<std::size_t>(CellStatus::interpolated)] +
                            shares[static_cast<std::size_t>(CellStatus::base_plane)] >
                        0;
}

FigurePanel regionPanel(const Project& p, QRectF paper) {
  FigurePanel panel;
  panel.paper = paper;
  panel.shown = rectOf(p.region);
  panel.level = p.region.level;
  return panel;
}

class Sheet {
 public:
  Sheet(const Surface& surface, const Project& project)
      : ladder_(surface.ladder),
        p_(project),
        f_(project.figure),
        aspect_(ladder_.width_mm / ladder_.height_mm) {}

  FigureSheet pictures() {
    switch (f_.layout) {
      case FigureLayout::detail:
        detail();
        break;
      case FigureLayout::reference_detail:
      case FigureLayout::plot:
        referenceAndDetail();
        break;
      case FigureLayout::before_after:
        pair(tr("as measured"), tr("filled"), side(2), true);
        sheet_.panels.front().as_measured = true;
        break;
      case FigureLayout::levels:
        levels();
        break;
    }
    sheet_.paper_per_mm = side_mm_ / p_.region.side_mm;
    return sheet_;
  }

 private:
  static QString tr(const char* text) { return QString::fromLatin1(text); }

  /// Of the region's panel, with `count` of them in a row.
  double side(int count, double gap_mm = kGapMm) const {
    if (f_.scale_1_to) return p_.region.side_mm / *f_.scale_1_to;
    return (f_.width_mm - (count - 1) * gap_mm) / count;
  }
  /// A page names two pictures; without names they touch, as projectors halve a frame.
  double eyesGap() const { return f_.letters ? kGapMm : 0; }
  void grow() {
    for (const FigurePanel& panel : sheet_.panels) {
      sheet_.width_mm = std::max(sheet_.width_mm, panel.paper.right());
      sheet_.height_mm = std::max(sheet_.height_mm, panel.paper.bottom());
    }
  }
  void detail() {
    if (f_.eye != FigureEye::both) {
      alone((f_.eye == FigureEye::left) != f_.swap_eyes ? -1 : 1);
    } else if (f_.stereo == StereoPrint::side_by_side) {
      pair({}, {}, side(2, eyesGap()), true, eyesGap());
      eyes();
    } else if (f_.stereo == StereoPrint::over_under) {
      pair({}, {}, side(1), false, eyesGap());
      eyes();
    } else {
      alone(0);
    }
  }
  void alone(int eye) {
    side_mm_ = side(1);
    sheet_.panels.push_back(regionPanel(p_, {0, 0, side_mm_, side_mm_}));
    sheet_.panels.front().eye = eye;
    grow();
  }
  void eyes() {
    const int first = f_.swap_eyes ? 1 : -1;
    sheet_.panels[0].eye = first;
    sheet_.panels[1].eye = -first;
    for (FigurePanel& panel : sheet_.panels) {
      panel.title = panel.eye < 0 ? tr("left eye") : tr("right eye");
    }
  }
  void pair(const QString& first, const QString& second, double side_mm, bool beside,
            double gap_mm = kGapMm) {
    side_mm_ = side_mm;
    const double step = side_mm + gap_mm;
    sheet_.panels.push_back(regionPanel(p_, {0, 0, side_mm, side_mm}));
    sheet_.panels.push_back(
        regionPanel(p_, {beside ? step : 0, beside ? 0 : step, side_mm, side_mm}));
    sheet_.panels[0].title = first;
    sheet_.panels[1].title = second;
    grow();
  }
  void referenceAndDetail() {
    side_mm_ = f_.scale_1_to ? side(1) : (f_.width_mm - kGapMm) / (aspect_ + 1);
    // A long frieze stands above its detail, or the detail would be a stamp beside it.
    const bool stacked = aspect_ > 2.5;
    FigurePanel whole;
    whole.whole = true;
    whole.shown = rectOf(ladder_);
    whole.level = levelOfWhole(ladder_);
    if (stacked) {
      const double width = f_.scale_1_to ? std::max(side_mm_, 0.5 * f_.width_mm) : f_.width_mm;
      if (!f_.scale_1_to) side_mm_ = 0.6 * f_.width_mm;
      whole.paper = {0, 0, width, width / aspect_};
      sheet_.panels.push_back(whole);
      sheet_.panels.push_back(
          regionPanel(p_, {0, whole.paper.bottom() + kGapMm, side_mm_, side_mm_}));
    } else {
      whole.paper = {0, 0, side_mm_ * aspect_, side_mm_};
      sheet_.panels.push_back(whole);
      sheet_.panels.push_back(
          regionPanel(p_, {whole.paper.right() + kGapMm, 0, side_mm_, side_mm_}));
    }
    grow();
  }
  void levels() {
    const int count = std::min(ladder_.levels(), kMostLevels);
    const int across = count == 4 ? 2 : count;
    side_mm_ = side(across);
    const ShownLengths lengths(std::max(ladder_.width_mm, ladder_.height_mm));
    for (int i = 0; i < count; ++i) {
      const double step = side_mm_ + kGapMm;
      const int row = i / across;
      FigurePanel panel = regionPanel(p_, {(i % across) * step, row * step, side_mm_, side_mm_});
      panel.level = {count - 1 - i};
      panel.title = QStringLiteral("level %1, %2")
                        .arg(panel.level.value)
                        .arg(QString::fromStdString(lengths.text(
                            ladder_.spacings_mm[static_cast<std::size_t>(panel.level.value)], 3)));
      sheet_.panels.push_back(panel);
    }
    grow();
  }

  const DetailLadder& ladder_;
  const Project& p_;
  const FigureRequest& f_;
  double aspect_;
  double side_mm_ = 1;
  FigureSheet sheet_;
};

}  // namespace

ReliefLook figureLook(const Surface& surface, const Project& project) {
  ReliefLook look = project.figure.look;
  const auto level = static_cast<std::size_t>(project.region.level.value);
  if (hasRadius(look.kind)) look.radius_mm = radiusMm(look, surface.ladder.spacings_mm.at(level));
  look.unmeasured = false;  // Figures have their hatch.
  return look;
}

LegendShares legendShares(const Surface& surface, const Project& project) {
  const FigureLayout layout = project.figure.layout;
  if (layout == FigureLayout::reference_detail || layout == FigureLayout::plot) {
    return {.shares = mapFacts(surface).shares, .of_object = true};
  }
  return {.shares = sharesOf(windowOf(surface, project.region, project.gain))};
}

FigureSheet layOut(const Surface& surface, const Project& project) {
  const FigureRequest& f = project.figure;
  FigureSheet sheet = Sheet(surface, project).pictures();
  const double line = 1.5 * f.text_pt * kMmPerPoint;
  if (f.layout == FigureLayout::plot) {
    const double em = f.text_pt * kMmPerPoint;
    if (sheet.width_mm < kLeastPlotEm * em) {
      throw failure<MessageId::plot_text_too_large>(shown(f.text_pt), shown(sheet.width_mm));
    }
    const double gap = std::max(kGapMm, kPlotGapEm * em);
    const double high = std::max(kPlotMm, kPlotEm * em);
    sheet.heights_plot = {0, sheet.height_mm + gap, sheet.width_mm, high};
    sheet.force_plot = {0, sheet.heights_plot.bottom() + gap, sheet.width_mm, 0.75 * high};
    sheet.height_mm = sheet.force_plot.bottom() + 2 * line;
  }
  if (needsLegend(surface, project)) {
    sheet.legend = {0, sheet.height_mm + 0.4 * line, sheet.width_mm, 1.2 * line};
    if (hasLegend(f.look.kind)) sheet.legend.setHeight(2.7 * line);
    sheet.height_mm = sheet.legend.bottom();
  }
  checkPaper(sheet);
  return sheet;
}

}  // namespace relievo
