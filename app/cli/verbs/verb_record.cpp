// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <memory>
#include <utility>

#include "app/cli/json.h"
#include "app/cli/options/look_arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/verb.h"
#include "app/cli/verbs/devices/live_device.h"
#include "app/cli/verbs/touch_setup.h"
#include "app/cli/verbs/verb_files.h"
#include "core/base/failure.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/foreign/foreign_device.h"
#include "haptics/device/haply/haply_device.h"
#include "haptics/device_catalog.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/events.h"
#include "haptics/record/loop_recording.h"
#include "haptics/record/sample_drain.h"
#include "haptics/record/sample_log.h"

namespace relievo::batch {
namespace {

/// The stroke's place at a time since its start; its last one afterwards.
DeviceMm placeAt(const Stroke& stroke, double t_s, const HapticSpace& space, StrokeFrame frame) {
  const double t = stroke.points.front().t_s + t_s;
  std::size_t next = 0;
  while (next < stroke.points.size() && stroke.points[next].t_s <= t) ++next;
  const StrokePoint& a = stroke.points[next == 0 ? 0 : next - 1];
  const StrokePoint& b = stroke.points[std::min(next, stroke.points.size() - 1)];
  const double part = b.t_s > a.t_s ? (t - a.t_s) / (b.t_s - a.t_s) : 0;
  const ViewMm p{a.x_mm + part * (b.x_mm - a.x_mm), a.y_mm + part * (b.y_mm - a.y_mm),
                 a.z_mm + part * (b.z_mm - a.z_mm)};
  return frame == StrokeFrame::device ? DeviceMm{p.x, p.y, p.z} : space.deviceFromView(p);
}

/// Leads the hand along the stroke until the sink has all it wants.
/// @return false: the computer is about to sleep
bool drive(SteeredDevice* hand, const Stroke& stroke, const TouchSetup& setup,
           const LoopRecording& sink, EndBeforeSleep& sleep, const Task& task) {
  const std::int64_t start_ns = monotonicNs();
  for (std::int64_t next_ns = start_ns; !sink.done(); next_ns += 1'000'000) {
    task.check();
    if (sleep.wanted()) return false;
    if (hand != nullptr && !stroke.points.empty()) {
      const double t_s = 1e-9 * static_cast<double>(monotonicNs() - start_ns);
      hand->moveTo(placeAt(stroke, t_s, *setup.space, setup.options.frame));
    }
    sleepUntil(next_ns);
  }
  return true;
}

/// Only an open one tells what it can do.
bool tellsOnceOpen(const Device& device) {
  return dynamic_cast<const foreign::ForeignDevice*>(&device) != nullptr ||
         dynamic_cast<const haply::HaplyDevice*>(&device) != nullptr;
}

/// A Falcon must be homed before its first tick, a device of Haply set up: a core that begins with
/// a fault keeps zero.
void makeReady(Device& device, double seconds, const Task& task) {
  if (auto* const haply = dynamic_cast<haply::HaplyDevice*>(&device)) {
    waitUntilReady(*haply, seconds, task);
  }
  auto* const falcon = dynamic_cast<falcon::FalconDevice*>(&device);
  if (falcon == nullptr) return;
  falcon->open();
  waitUntilReady(*falcon, seconds, "nothing was recorded", task);
}

CommandResult reported(const std::string& file, std::uint64_t rows, HapticLoop& loop,
                       const LoopRecording& sink, const std::string& limited, bool slept) {
  const LoopStats& stats = loop.stats().front();
  const bool failed = sink.fault() != DeviceFault::none;
  const std::string fault(describe(sink.fault()));
  Json json;
  json["file"] = file;
  json["device"] = loop.device().id;
  json["device_name"] = loop.device().name;
  json["ticks"] = rows;
  json["gaps"] = sink.gaps();
  json["rate_hz"] = stats.rate_hz;
  json["late_ticks"] = stats.late_ticks;
  json["worst_period_ms"] = stats.worst_period_ms;
  json["watchdog_cuts"] = stats.watchdog_cuts;
  json["zero_demanded"] = stats.audit.zero_demanded;
  json["violations"] = stats.audit.violations();
  json["largest_force_n"] = stats.audit.largest_n;
  json["realtime"] = loop.realtime().realtime;
  json["limited"] = limited.empty() ? Json() : Json(limited);
  json["fault"] = failed ? Json(fault) : Json();
  if (slept) {
    tell("The computer went to sleep: the recording ended there and is saved.");
  } else if (failed) {
    tell("From \"" + fault +
         "\" on there was no force; the recording is saved. Look at the device in 'relievo "
         "devices', then begin again.");
  }
  return {.json = reportText(json),
          .lines = {file + ": " + std::to_string(rows) + " ticks with " + loop.device().name +
                    ", " + std::to_string(stats.late_ticks) + " late"},
          .exit_code = slept || failed ? kDeviceExit : 0};
}

CommandResult runRecord(const TouchArguments& asked, const Task& task) {
  if (!(asked.seconds > 0) || !(asked.seconds <= 86'400)) {
    throw failure<MessageId::option_seconds>();
  }
  const Stroke stroke = asked.stroke.empty() ? Stroke{} : strokeFile(asked.stroke);
  std::unique_ptr<Device> device = makeDevice(asked.device);
  if (asked.safety == "off" && !device->info().simulated) {
    throw failure<MessageId::option_safety>(asked.device);
  }
  const bool is_steered = dynamic_cast<const SteeredDevice*>(device.get()) != nullptr;
  requireUse("--grip", !asked.grip.empty(), !is_steered, "--device of one that a person holds");
  checkTouch(asked);
  TouchArguments a = asked;
  if (tellsOnceOpen(*device)) {
    device->open();
    a.told = device->info();
  }
  TouchSetup setup = prepareTouch(a, task);
  if (!setup.limited.empty()) tell(setup.limited);
  makeReady(*device, a.ready_s, task);
  // Which of several it was is known now.
  if (!device->info().simulated) setup.device = device->info().id + ", " + device->info().name;
  auto* hand = dynamic_cast<SteeredDevice*>(device.get());
  if (hand != nullptr && !stroke.points.empty()) {
    hand->placeAt(placeAt(stroke, 0, *setup.space, setup.options.frame));
  }
  const std::unique_ptr<SampleLog> log =
      openLog(a.out, touchHeader(a, setup, task), setup.space.get(), LogKind::recording);
  LoopRecording sink(*log, static_cast<std::uint64_t>(std::ceil(1000 * a.seconds)));
  constexpr int kSettlingExchanges = 1000;
  auto loop = std::make_unique<HapticLoop>(
      std::move(device),
      LoopOptions{.settling_exchanges = kSettlingExchanges, .chain = setup.options.chain});
  // Before the start: the first tick already sees both, and a replay can begin with it.
  loop->spaces().write(*setup.space);
  loop->options().write(setup.core);
  EndBeforeSleep sleep;
  bool slept = false;
  loop->start();
  if (!loop->realtime().note.empty()) tell(loop->realtime().note);
  {
    SampleDrain drain(loop->samples(),
                      {[&sink](std::span<const HapticSample> batch) { sink.take(batch); }});
    try {
      slept = !drive(hand, stroke, setup, sink, sleep, task);
    } catch (const Cancelled&) {
      tell("Stopped early; what was recorded is saved.");
    }
    loop->stop();
  }
  sleep.atZero();
  if (!sink.error().empty()) throw WriteError(sink.error(), "E401");
  loop->stats().update();
  log->close(loopLines(loop->stats().front()));
  return reported(a.out, log->rows(), *loop, sink, setup.limited, slept);
}

}  // namespace

void declareRecord(CLI::App& verb, TouchArguments& arguments) {
  arguments.device = "virtual";
  addTouchOptions(verb, arguments);
  verb.add_option("--device", arguments.device,
                  "virtual[:GRIP], falcon[:SERIAL], haply[:ID], plugin:FILE/ID or mouse");
  verb.add_option("--grip", arguments.grip,
                  "How the device stands: upright, before you; flat: the relief lies, and is "
                  "pressed down; left, right: beside you, turned to you")
      ->check(CLI::IsMember({"upright", "flat", "left", "right"}));
  takes(verb.add_option("--seconds", arguments.seconds, "How long; 10"),
        {.low = 1e-3, .high = 86400, .unit = "s"});
  takes(verb.add_option("--ready", arguments.ready_s,
                        "Seconds until a device must be homed or set up; 60"),
        {.low = 1, .high = 600, .unit = "s"});
  verb.add_option("--stroke", arguments.stroke, "CSV that leads a simulated hand");
  verb.add_option("-o,--output", arguments.out, "LOG.csv or LOG.h5")->required();
  verb.add_option("--frame", arguments.frame, "Frame of the stroke: view or device")
      ->check(CLI::IsMember({"view", "device"}));
}

Verb recordVerb(std::vector<std::string> words) {
  auto arguments = std::make_shared<TouchArguments>();
  arguments->words = std::move(words);
  return {.name = "record",
          .help = "Touch a region with a device in real time and record every millisecond",
          .declare = [arguments](CLI::App& verb) { declareRecord(verb, *arguments); },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runRecord(*arguments, task); }};
}

}  // namespace relievo::batch
