// SPDX-License-Identifier: BSD-3-Clause
// What is drawn over the relief, and what lies behind it.
#include "ui/dialogs/figure/figure_form.h"
#include "ui/dialogs/figure/figure_form_parts.h"
#include "ui/dialogs/figure/figure_form_rows.h"

namespace relievo {
namespace {

constexpr std::size_t kOutline = 3;  // Index of the window's outline.
constexpr std::array<const char*, 8> kMarks{
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Scale &bar"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "&Height bar"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "&Up mark"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Window's &outline"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Hat&ch"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Le&gend"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "Letters a, b"),
    QT_TRANSLATE_NOOP("relievo::FigureForm", "&Measurements")};

}  // namespace

FigureMarkRows::FigureMarkRows(FigureFormRows& rows) {
  constexpr std::array<const char*, 8> kNames{
      "figure_scale_bar", "figure_height_bar", "figure_up",      "figure_outline",
      "figure_hatch",     "figure_legend",     "figure_letters", "figure_measurements"};
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    marks_[i] = rows.field<QCheckBox>(FigureForm::tr(kMarks[i]), kNames[i],
                                      FigureForm::tr("Drawn in points, whatever the density"));
  }
  transparent_ = rows.field<QCheckBox>(FigureForm::tr("Tra&nsparent paper"), "figure_transparent",
                                       FigureForm::tr("No white behind the relief"));
}

void FigureMarkRows::show(const FigureRequest& f) {
  transparent_->setChecked(f.transparent);
  const std::array<bool, 8> marks{f.scale_bar, f.height_bar, f.up_mark, f.window_outline,
                                  f.hatch,     f.legend,     f.letters, f.measurements};
  for (std::size_t i = 0; i < marks.size(); ++i) marks_[i]->setChecked(marks[i]);
}

void FigureMarkRows::writeTo(FigureRequest& f) const {
  f.transparent = transparent_->isChecked();
  const std::array<bool*, 8> marks{&f.scale_bar, &f.height_bar, &f.up_mark, &f.window_outline,
                                   &f.hatch,     &f.legend,     &f.letters, &f.measurements};
  for (std::size_t i = 0; i < marks.size(); ++i) *marks[i] = marks_[i]->isChecked();
}

void FigureMarkRows::limit(FigureLayout layout, StereoPrint stereo) {
  const bool whole = layout == FigureLayout::reference_detail || layout == FigureLayout::plot;
  setUsable(marks_[kOutline], whole,
            FigureForm::tr("It is drawn on the whole object, which this layout lacks"));
  // What is on can be turned off: it may be what the figure is refused for.
  setUsable(transparent_, !isAnaglyph(stereo) || transparent_->isChecked(),
            FigureForm::tr("An anaglyph needs its background"));
}

}  // namespace relievo
