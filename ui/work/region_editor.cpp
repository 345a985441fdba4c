// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/region_editor.h"

#include <utility>

#include "ui/language/error_text.h"
#include "ui/work/document.h"
#include "ui/work/state_command.h"

namespace relievo {
namespace {

constexpr int kMergeGain = 1;
constexpr int kMergeZoom = 2;

/// @param grows  the window, as it does beyond the coarsest detail and shrinks below the finest
QString detailName(int from, int to, bool grows) {
  if (from == to) {
    return grows ? RegionEditor::tr("Larger window") : RegionEditor::tr("Smaller window");
  }
  return RegionEditor::tr("Resolution %1 \u2192 %2").arg(from).arg(to);
}

}  // namespace

bool RegionEditor::isAtRest() const {
  return document_.isOpen() && !inGesture();
}

StepAbout RegionEditor::aboutCentre() const {
  const Region& region = document_.project().region;
  return {region.centreX(), region.centreY(), false};
}

void RegionEditor::go(const std::optional<Region>& region, const QString& name) {
  if (!region) return;
  document_.edit(name, [&](Project& project) { project.region = *region; });
}

bool RegionEditor::finer(const StepAbout& about) {
  if (!isAtRest()) return false;
  const DetailLadder& ladder = document_.surface()->ladder;
  const auto next = relievo::finer(ladder, document_.project().region, about);
  if (!next) return false;
  go(next, detailName(document_.detail(), ladder.detailOf(next->level), false));
  return true;
}

bool RegionEditor::coarser(const StepAbout& about) {
  if (!isAtRest()) return false;
  const DetailLadder& ladder = document_.surface()->ladder;
  const auto next = relievo::coarser(ladder, document_.project().region, about);
  if (!next) return false;
  go(next, detailName(document_.detail(), ladder.detailOf(next->level), true));
  return true;
}

bool RegionEditor::whole() {
  if (!isAtRest()) return false;
  const Region next = wholeRegion(document_.surface()->ladder);
  if (next == document_.project().region) return false;
  go(next, tr("Whole object"));
  return true;
}

bool RegionEditor::move(double dx, double dy) {
  if (!isAtRest()) return false;
  const Region& region = document_.project().region;
  const auto next = moved(document_.surface()->ladder, region, dx, dy);
  if (!next || *next == region) return false;
  go(next, tr("Move window"));
  return true;
}

bool RegionEditor::setLevel(Level level) {
  if (!isAtRest() || level == document_.project().region.level) return false;
  const DetailLadder& ladder = document_.surface()->ladder;
  const auto next = atLevel(ladder, document_.project().region, level);
  if (!next) return false;
  go(next, detailName(document_.detail(), ladder.detailOf(level), false));
  return true;
}

bool RegionEditor::setRect(const RectMm& rect) {
  if (!isAtRest()) return false;
  try {
    const Region next = regionFromRect(document_.surface()->ladder, rect);
    if (next == document_.project().region) return false;
    go(next, tr("Choose window"));
    return true;
  } catch (const ArgumentError& error) {
    Q_EMIT document_.failed(spokenError(error), {}, {});
    return false;
  }
}

bool RegionEditor::setGain(double gain) {
  if (!isAtRest() || !(gain > 0) || gain == document_.project().gain) return false;
  document_.edit(
      tr("Vertical exaggeration"), [&](Project& project) { project.gain = gain; }, kMergeGain);
  return true;
}

bool RegionEditor::goTo(const Region& region, double gain, const QString& name) {
  if (!isAtRest() || !(gain > 0)) return false;
  return document_.edit(name, [&](Project& project) {
    project.region = region;
    project.gain = gain;
  });
}

bool RegionEditor::zoomTo(const Region& region) {
  if (!isAtRest() || region == document_.project().region) return false;
  document_.edit(
      tr("Zoom"), [&](Project& project) { project.region = region; }, kMergeZoom);
  return true;
}

void RegionEditor::beginGesture() {
  const Project& project = document_.project();
  if (!gesture_start_) gesture_start_ = {project.region, project.gain};
}

void RegionEditor::preview(const Region& region) {
  const Project& project = document_.project();
  if (!document_.isOpen() || !(region.side_mm > 0) || region == project.region) return;
  beginGesture();
  document_.showPlace(region, project.gain);
}

void RegionEditor::previewGain(double gain) {
  const Project& project = document_.project();
  if (!document_.isOpen() || !(gain > 0) || gain == project.gain) return;
  beginGesture();
  document_.showPlace(project.region, gain);
}

void RegionEditor::commit(const QString& name) {
  if (!gesture_start_) return;
  const Place start = *std::exchange(gesture_start_, std::nullopt);
  DocumentState before = document_.state();
  before.project.region = start.region;
  before.project.gain = start.gain;
  if (before == document_.state()) return;
  document_.history().push(
      new StateCommand(document_, std::move(before), document_.state(), name, -1));
}

void RegionEditor::revert() {
  if (!gesture_start_) return;
  const Place start = *std::exchange(gesture_start_, std::nullopt);
  document_.showPlace(start.region, start.gain);
}

}  // namespace relievo
