// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/guided_run.h"

#include <algorithm>
#include <cmath>

#include "core/base/line_corners.h"

namespace relievo {

double distanceFromPath(const GuidePath& path, DeviceMm place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < path.stretches(); ++i) {
    least = std::min(least, distanceFromStretch(place, path.start(i), path.end(i)));
  }
  return least;
}

namespace {
/// Where the person wants the hand to be.
class Person {
 public:
  Person(const HapticSpace& space, StrokeFrame frame, const GuidedRun& run)
      : space_(space), frame_(frame), run_(run), aim_(run.start) {
    if (run.wish != nullptr) aim_ = wishedAt(run.wish->points.front().t_s);
  }
  DeviceMm at(double t_s, DeviceMm hand) {
    if (run_.wish != nullptr) return wishedAt(run_.wish->points.front().t_s + t_s);
    constexpr double kTickS = 0.001;
    aim_ = aim_ + (kTickS / std::max(kTickS, run_.gives_way_s)) * (hand - aim_);
    return aim_;
  }
  DeviceMm aim() const { return aim_; }

 private:
  DeviceMm wishedAt(double t_s) const {
    const ViewMm p = strokePlaceAt(*run_.wish, t_s);
    return frame_ == StrokeFrame::device ? DeviceMm{p.x, p.y, p.z} : space_.deviceFromView(p);
  }

  const HapticSpace& space_;
  StrokeFrame frame_;
  GuidedRun run_;
  DeviceMm aim_;
};
}  // namespace

GuidedFindings runGuided(const HapticSpace& space, const HapticOptions& core_options,
                         StrokeFrame frame, const GuidePath& path, SteeredDevice& device,
                         const GuidedRun& run,
                         const std::function<void(const HapticSample&, double t_s)>& each,
                         const Task& task) {
  GuidedFindings found;
  Person person(space, frame, run);
  HapticCore core(ForceChain::whole);
  DeviceMm hand = person.aim();
  device.placeAt(hand);
  double squares = 0, off_s = 0;
  std::uint64_t led = 0, along = 0;
  for (std::uint64_t n = 0; static_cast<double>(n) < 1000 * run.most_s; ++n) {
    constexpr std::uint64_t kTicksPerCheck = 1024;
    if (n % kTicksPerCheck == 0) task.check();
    const double t_s = static_cast<double>(n) / 1000;
    const auto now_ns = static_cast<std::int64_t>(n) * 1'000'000;
    if (n > 0) device.moveTo(person.at(t_s, hand));
    const DeviceReading reading = device.read(now_ns);
    hand = reading.position;
    HapticSample sample = core.tick(space, core_options, reading, now_ns, &path);
    device.send(sample.force, now_ns);
    sample.rate_hz = 1000;
    each(sample, t_s);
    if (sample.guide != GuidePhase::off) {
      ++led;
      found.largest_n = std::max(found.largest_n, norm(sample.force));
      if (sample.guide == GuidePhase::approaching) continue;
      const double off_mm = distanceFromPath(path, hand);
      squares += off_mm * off_mm;
      ++along;
    } else if (sample.guide_end != GuideEnd::none) {
      found.end = sample.guide_end;
      off_s += 0.001;
      if (off_s > kAfterS) break;
    }
  }
  found.led_s = static_cast<double>(led) / 1000;
  found.rms_mm = along > 0 ? std::sqrt(squares / static_cast<double>(along)) : 0;
  found.audit = core.audit();
  return found;
}

}  // namespace relievo
