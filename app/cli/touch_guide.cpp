// SPDX-License-Identifier: BSD-3-Clause
// What `touch --guide` leads a hand along.
#include "app/cli/touch_guide.h"

#include <memory>
#include <string_view>
#include <vector>

#include "core/base/failure.h"
#include "core/io/pipe_or_file.h"
#include "core/outline/outline.h"
#include "core/region/edges.h"
#include "core/region/hand.h"
#include "haptics/record/recorded_way.h"

namespace relievo::batch {
namespace {

constexpr std::string_view kOutline = "outline", kObject = "object";

std::string_view wordOf(OutlineOf of) {
  switch (of) {
    case OutlineOf::raised:
      return "raised area";
    case OutlineOf::sunk:
      return "sunken area";
    case OutlineOf::object:
      break;
  }
  return "object";
}

GuidePath pathAlong(const Outline& outline, const TouchSetup& setup, std::uint32_t rounds) {
  std::vector<DeviceMm> corners;
  for (const ViewMm& p : outline.corners) corners.push_back(setup.space->deviceFromView(p));
  return guidePath(corners, true, rounds);
}

GuidePath pathAlongWay(const TouchArguments& a, const TouchSetup& setup, const Task& task) {
  std::vector<TimedPlace> way;
  requirePipeOrFile(a.guide);
  for (const WayPoint& point : readWay(a.guide, task)) {
    way.push_back({point.t_s, setup.space->deviceFromView(point.place)});
  }
  return guideAlong(way);
}

}  // namespace

bool isGuideFile(const std::string& guide) {
  return !guide.empty() && guide != kOutline && guide != kObject;
}

void findGuide(TouchSetup& setup, const TouchArguments& a, const Surface& surface,
               const Task& task) {
  if (a.guide.empty()) return;
  GuidePath path;
  if (a.recorded_guide) {
    path = *a.recorded_guide;
    setup.guide_of = "as recorded";
  } else if (isGuideFile(a.guide)) {
    path = pathAlongWay(a, setup, task);
    setup.guide_of = "recorded way";
  } else {
    const double tolerance_mm = kOutlineToleranceMm / setup.space->device_per_view;
    const std::uint8_t edges = edgesOf(surface.ladder, setup.window.region);
    const std::vector<Outline> outlines = a.guide == kObject
                                              ? objectOutlines(setup.window, edges, tolerance_mm)
                                              : outlinesOf(setup.window, edges, tolerance_mm);
    if (outlines.empty()) throw failure<MessageId::guide_needs_outline>();
    path = pathAlong(outlines.front(), setup, a.rounds.value_or(1));
    setup.guide_of = wordOf(outlines.front().of);
  }
  path.id = 1;
  path.scene_id = setup.space->scene_id;
  setup.core.guide.path = path.id;
  setup.guide = std::make_shared<const GuidePath>(path);
}

}  // namespace relievo::batch
