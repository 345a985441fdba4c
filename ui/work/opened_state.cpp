// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/opened_state.h"

#include <algorithm>
#include <cmath>
#include <QFileInfo>

#include "core/base/failure.h"
#include "core/provenance/program.h"
#include "ui/language/error_text.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

/// The same square of view millimetres, as finely as this map can show it, if it has such a place.
void keepPlace(const Project& kept, const DetailLadder& ladder, Project& project) {
  project.gain = kept.gain;
  const Region& r = kept.region;
  if (!onMap(ladder, r)) return;
  if (r.side_mm >= wholeRegion(ladder).side_mm) return;  // All of it, here as there.
  project.region = regionFromRect(
      ladder, {.x_mm = r.x_mm, .y_mm = r.y_mm, .width_mm = r.side_mm, .height_mm = r.side_mm});
}

/// What goes on from the present state, or comes back with the request.
Project begunFrom(const LoadJob& job, const Project& present, bool is_step) {
  if (is_step) return present;
  Project p;
  if (job.open.project) {
    p = *job.open.project;
    p.azimuth_deg = turnedBack(p.azimuth_deg);
    p.elevation_deg = tilted(p.elevation_deg);
    p.picture.reset();  // It belongs to what the state came from, as these do.
    p.saved_as.clear();
    p.made.clear();
  } else {
    // How things are looked at goes on from file to file.
    p.look = present.look;
    p.stereo = present.stereo;
    p.chosen_eye_angle_deg = present.chosen_eye_angle_deg;
  }
  return p;
}

}  // namespace

double turnedBack(double azimuth_deg) {
  return std::remainder(azimuth_deg, 360.0);
}

double tilted(double elevation_deg) {
  return std::clamp(elevation_deg, -kMostTiltDeg, kMostTiltDeg);
}

std::optional<ViewChoice> shownView(const DocumentState& state) {
  const Surface& surface = *state.surface;
  const auto& chosen = state.project.options.view;
  if (surface.is_raster || !standardRotation(surface.view_name)) return chosen;
  return ViewChoice{.name = surface.view_name,
                    .rotation = std::nullopt,
                    .turn_deg = chosen ? chosen->turn_deg : std::array<double, 3>{}};
}

DocumentState openedState(const LoadJob& job, const DocumentState& present) {
  const bool is_step = !job.open.step.isEmpty() && present.surface != nullptr;
  DocumentState next;
  next.surface = job.outcome.surface;
  next.source = std::make_shared<const OpenedInput>(job.source);
  Project& p = next.project;
  p = begunFrom(job, present.project, is_step);
  if (is_step || !job.open.project) p.azimuth_deg = p.elevation_deg = 0;
  if (job.kept) {
    p.azimuth_deg = job.kept->azimuth_deg;
    p.elevation_deg = job.kept->elevation_deg;
    p.region = job.kept->region;
    p.gain = job.kept->gain;
  }
  p.file = bytesOfPath(job.open.file);
  p.sha256 = job.sha256.toStdString();
  p.bytes = static_cast<std::uint64_t>(QFileInfo(job.open.file).size());
  p.accept_incomplete = job.open.accept_incomplete;
  p.scan = job.open.scan;
  p.options = job.options;
  p.version = programVersion();
  return next;
}

QString placeWindow(const LoadJob& job, DocumentState& next) {
  const DetailLadder& ladder = next.surface->ladder;
  Region& region = next.project.region;
  const bool has_one = job.open.project && region.side_mm > 0;
  if (!has_one || region.level.value >= ladder.levels()) {
    region = wholeRegion(ladder);
    next.project.gain = 1;
  }
  if (job.kept) keepPlace(*job.kept, ladder, next.project);
  try {
    if (job.open.region) {
      const Region asked = regionFromRect(ladder, *job.open.region);
      if (!onMap(ladder, asked)) throw failure<MessageId::nothing_in_region>();
      region = asked;
    }
    for (int d = 1; job.open.detail && d < *job.open.detail && !job.open.region; ++d) {
      const StepAbout about{region.centreX(), region.centreY(), false};
      region = finer(ladder, region, about).value_or(region);
    }
  } catch (const ArgumentError& error) {
    return spokenError(error);
  }
  return {};
}

}  // namespace relievo
