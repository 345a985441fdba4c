// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/options/figure_arguments.h"

#include <CLI/CLI.hpp>

#include "app/cli/options/eye_angle_range.h"
#include "app/cli/options/number_option.h"
#include "core/base/failure.h"

namespace relievo::batch {
namespace {

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find(at, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

/// Also by the word of `render` and of the window.
std::optional<StereoPrint> stereoOf(const std::string& text) {
  if (text == name(StereoMode::anaglyph)) return StereoPrint::grey;
  const auto print = stereoPrint(text);
  return print == StereoPrint::interlaced ? std::nullopt : print;
}

/// N of "N" and "1:N"; half of "2:1", twice as large as life, is "1:0.5".
double scaleOf(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) return numberList("--scale", text, 1)[0];
  const double paper = numberList("--scale", text.substr(0, colon), 1)[0];
  const double object = numberList("--scale", text.substr(colon + 1), 1)[0];
  if (!(paper > 0)) {
    throw failure<MessageId::option_scale_form>(text);
  }
  return object / paper;
}

/// As FigureForm::limit.
void refuseUseless(const FigureArguments& a, const FigureRequest& f) {
  const bool eyes = f.stereo != StereoPrint::off || a.both_eyes;
  const std::string stereo = "a kind of --stereo, or --both-eyes";
  requireUse("--eye-angle", a.eye_angle_deg.has_value(), eyes, stereo);
  requireUse("--zero-plane", a.zero_plane_mm.has_value(), eyes, stereo);
  requireUse("--swap-eyes", a.swap_eyes, eyes, stereo);
  requireUse("--any-parallax", a.any_parallax, eyes, stereo);
  requireUse("--recording", !a.recording.empty(), f.layout == FigureLayout::plot, "--layout plot");
}

constexpr std::array<const char*, 8> kMarks{"scalebar", "heightbar", "up",      "outline",
                                            "hatch",    "legend",    "letters", "measurements"};

}  // namespace

void addFigureOptions(CLI::App& verb, FigureArguments& a) {
  verb.add_option("--layout", a.layout, listOf(kFigureLayoutNames));
  takes(verb.add_option("--width-mm", a.width_mm, "Width on paper; 180"),
        {.low = 20, .high = 2000, .unit = "mm"});
  takes(verb.add_option("--dpi", a.dpi, "Dots per inch; 300"), {.low = 30, .high = 2400});
  verb.add_option("--scale", a.scale, "N or 1:N: the region at this scale instead of a width");
  takes(verb.add_option("--text-pt", a.text_pt, "Text size in points; 8"),
        {.low = 4, .high = 36, .unit = "pt"});
  addLookOptions(verb, a.look);
  verb.add_option("--stereo", a.stereo, listOf(kPaperStereoNames));
  takes(verb.add_option("--eye-angle", a.eye_angle_deg, "Between the eyes' directions, degrees; 4"),
        kEyeAngles);
  takes(verb.add_option("--zero-plane", a.zero_plane_mm, "Height of zero parallax, mm; mid height"),
        {.low = -kFarMm, .high = kFarMm, .unit = "mm"});
  verb.add_flag("--swap-eyes", a.swap_eyes, "Left and right eye change places");
  verb.add_flag("--any-parallax", a.any_parallax, "Do not keep to the comfort limit of 1 degree");
  verb.add_flag("--both-eyes", a.both_eyes, "Also write NAME.left.png and NAME.right.png");
  verb.add_option("--without", a.without, "Marks to leave out: " + listOf(kMarks))->delimiter(',');
  verb.add_flag("--transparent", a.transparent, "No paper behind the relief");
  verb.add_option("--recording", a.recording, "LOG.csv or LOG.h5, for --layout plot");
  verb.add_option("--measure", a.measure,
                  "NAME:KIND:X,Y;X,Y... in view mm, drawn and reported; KIND: " +
                      listOf(kMeasureKindNames) + "; area: ...@PLANE_MM; section: NX,NY,NZ,OFFSET");
}

FigureRequest figureRequest(const FigureArguments& a, FigureRequest f) {
  if (!a.layout.empty() || !a.stereo.empty()) f.eye = FigureEye::both;  // No longer that one's.
  if (!a.layout.empty()) {
    f.layout = word("--layout", a.layout, figureLayout(a.layout), kFigureLayoutNames);
  }
  if (!a.stereo.empty()) {
    f.stereo = word("--stereo", a.stereo, stereoOf(a.stereo), kPaperStereoNames);
  }
  f.look = reliefLook(a.look, f.look);
  if (a.width_mm && !a.scale.empty()) {
    throw failure<MessageId::option_scale_width>();
  }
  f.width_mm = a.width_mm.value_or(f.width_mm);
  f.dpi = a.dpi.value_or(f.dpi);
  f.text_pt = a.text_pt.value_or(f.text_pt);
  if (a.width_mm) f.scale_1_to.reset();  // One of the two decides.
  if (!a.scale.empty()) f.scale_1_to = scaleOf(a.scale);
  f.eye_angle_deg = a.eye_angle_deg.value_or(f.eye_angle_deg);
  if (a.zero_plane_mm) f.zero_plane_mm = a.zero_plane_mm;
  if (a.swap_eyes) f.swap_eyes = true;
  if (a.any_parallax) f.limit_parallax = false;
  if (a.transparent) f.transparent = true;
  if (!a.recording.empty()) f.recording = a.recording;
  const std::array<bool*, kMarks.size()> marks{&f.scale_bar,      &f.height_bar,  &f.up_mark,
                                               &f.window_outline, &f.hatch,       &f.legend,
                                               &f.letters,        &f.measurements};
  for (const std::string& mark : a.without) {
    const auto* const found = std::find(kMarks.begin(), kMarks.end(), mark);
    if (found == kMarks.end()) {
      throw failure<MessageId::option_none_of>("--without", mark, listOf(kMarks));
    }
    *marks[static_cast<std::size_t>(found - kMarks.begin())] = false;
  }
  refuseUseless(a, f);
  check(f);
  return f;
}

std::vector<Measurement> measurements(const FigureArguments& a) {
  std::vector<Measurement> list;
  for (const std::string& text : a.measure) {
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 3) {
      throw failure<MessageId::option_measure_form>(text);
    }
    Measurement m;
    m.name = parts[0];
    m.kind = word("--measure", parts[1], measureKind(parts[1]), kMeasureKindNames);
    if (m.kind == MeasureKind::section) {
      const std::vector<double> n = numberList("--measure", parts[2], 4);
      m.normal = {n[0], n[1], n[2]};
      m.plane_mm = n[3];
      list.push_back(m);
      continue;
    }
    const std::vector<std::string> with_plane = split(parts[2], '@');
    if (with_plane.size() > 2) throw failure<MessageId::option_measure_planes>(text);
    if (with_plane.size() == 2) m.plane_mm = numberList("--measure", with_plane[1], 1)[0];
    for (const std::string& place : split(with_plane[0], ';')) {
      const std::vector<double> at = numberList("--measure", place, 2);
      m.places.push_back({.x = at[0], .y = at[1]});
    }
    list.push_back(m);
  }
  return list;
}

}  // namespace relievo::batch
