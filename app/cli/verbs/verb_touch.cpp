// SPDX-License-Identifier: BSD-3-Clause
#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/cli/json.h"
#include "app/cli/large.h"
#include "app/cli/options/look_arguments.h"
#include "app/cli/options/number_option.h"
#include "app/cli/report_text.h"
#include "app/cli/state.h"
#include "app/cli/touch_guide.h"
#include "app/cli/verb.h"
#include "app/cli/verbs/devices/told_limits.h"
#include "app/cli/verbs/force_plot.h"
#include "app/cli/verbs/touch_setup.h"
#include "core/base/failure.h"
#include "core/file/output_set.h"
#include "core/io/formats/text_file.h"
#include "core/io/pipe_or_file.h"
#include "core/project/caption.h"
#include "core/provenance/embedded.h"
#include "core/provenance/name_text.h"
#include "core/recording/log_table.h"
#include "core/region/hand.h"
#include "core/session/finer_heights.h"
#include "core/session/firmness.h"
#include "core/session/large/tiled_surface.h"
#include "haptics/device_catalog.h"
#include "haptics/loop/device_limits.h"
#include "haptics/proxy/surface.h"
#include "haptics/proxy/texture.h"
#include "haptics/record/events.h"
#include "haptics/record/force_law.h"
#include "haptics/record/recorded_loop.h"
#include "haptics/record/sample_log.h"

namespace relievo::batch {
namespace {

/// One coefficient for both, or the static and the dynamic one.
void setFriction(const std::vector<double>& friction, ProxyOptions& options) {
  if (friction.empty()) return;
  options.static_friction = friction.front();
  options.dynamic_friction = friction.back();
  if (options.static_friction > 0 && options.kind != ProxyKind::converged) {
    throw failure<MessageId::option_friction_of_paper>();
  }
  const bool in_order =
      options.dynamic_friction >= 0 && options.static_friction >= options.dynamic_friction;
  if (!in_order || !(options.static_friction <= kMostFriction)) {
    throw failure<MessageId::option_friction>(Json(kMostFriction).dump());
  }
}

/// A device must not be able to jump; without one F = k d can be checked from outside.
bool safetyOf(const TouchArguments& a) {
  return a.safety.empty() ? !a.device.empty() : a.safety == "on";
}

StrokeOptions strokeOptions(const TouchArguments& a) {
  const SurfaceFeel feel = feelOf(a);
  StrokeOptions options;
  options.proxy = proxyOptions(feel);
  setFriction(a.friction, options.proxy);
  options.stiffness_n_per_mm = feel.stiffness_n_per_mm;
  options.stiffness_by_detail = feel.stiffness_by_detail;
  options.detail_stiffness = feel.detail_stiffness;
  options.damping_n_s_per_mm = feel.damping_n_s_per_mm;
  options.fields = feel.fields;
  options.transient = feel.transient;
  options.chain = safetyOf(a) ? ForceChain::whole : ForceChain::bare;
  options.strength = strengthOf(a);
  options.frame = a.frame == "device" ? StrokeFrame::device : StrokeFrame::view;
  return options;
}

std::string proxyName(const TouchArguments& a) {
  return Json::parse(feelJson(a))["proxy"].get<std::string>();
}

/// What a stroke showed, judged without the solver: by the heights of the window itself, or where
/// the surface is not bilinear by the surface's.
struct StrokeFindings {
  const RegionWindow& window;
  const HapticSpace& space;
  double limit_n = 0;  ///< Of a device.
  double largest_force_n = 0;
  std::uint64_t beyond_ticks = 0;  ///< With more than a device gives.
  double off_surface_mm = 0;       ///< Largest distance in z of a touching proxy from the surface.
  double force_to_normal_deg = 0;  ///< Largest angle between force and surface normal.
  std::uint64_t contact_ticks = 0;

  double heightUnder(const ViewMm& p) const {
    if (space.surface == SurfaceKind::bilinear) return windowHeightMm(window, p.x, p.y);
    const GridPoint grid = space.gridFromView(p);
    return space.viewFromGrid({grid.x, grid.y, surfaceHeight(space, grid.x, grid.y)}).z;
  }
  void add(const HapticSample& sample) {
    if (!sample.contact) return;
    ++contact_ticks;
    const double force_n = norm(sample.force);
    largest_force_n = std::max(largest_force_n, force_n);
    beyond_ticks += force_n > limit_n ? 1 : 0;
    const ViewMm& proxy = sample.proxy_view;
    off_surface_mm = std::max(off_surface_mm, std::abs(proxy.z - heightUnder(proxy)));
    if (force_n < 1e-6) return;
    const DeviceN along{sample.normal.x, sample.normal.y, sample.normal.z};
    const DeviceN across = (1 / force_n) * sample.force - along;
    // Chord to angle: exact for small angles, where the arc cosine is not.
    const double angle = 2 * std::asin(std::min(1.0, 0.5 * norm(across)));
    force_to_normal_deg = std::max(force_to_normal_deg, angle * 180 / 3.14159265358979323846);
  }
};

/// The device's own limit; without a device the Falcon's, which a hand might hold.
ForceLimit limitOf(const Device* device) {
  if (device != nullptr && device->info().max_force_n > 0) {
    return {device->info().name, device->info().max_force_n};
  }
  return falconLimit();
}

/// Where the log comes from, in one line; what decides the force stands in the header's parameters.
std::string stateOfTouch(const TouchArguments& a, const TouchSetup& setup, const Surface& surface,
                         const Task& task) {
  Provenance provenance = provenanceOfVerb(a.map, surface, a.out, task);
  provenance.view = ViewState{.region = setup.window.region, .gain = a.region.gain};
  Json touch = Json::parse(feelJson(a));
  if (!a.stroke.empty()) {
    const InputFile stroke = inputFile(a.stroke, {}, task);
    touch["stroke"] = {{"file", textOfName(stroke.file)}, {"sha256", stroke.sha256}};
  }
  if (!a.firmness.empty()) {
    const InputFile firmness = inputFile(a.firmness, {}, task);
    touch["firmness"] = {{"file", textOfName(firmness.file)}, {"sha256", firmness.sha256}};
  }
  if (isGuideFile(a.guide)) {
    const InputFile guide = inputFile(a.guide, {}, task);
    touch["guide"] = {{"file", textOfName(guide.file)}, {"sha256", guide.sha256}};
  } else if (!a.guide.empty()) {
    touch["guide"] = a.guide;
  }
  touch["frame"] = a.frame;
  touch["device"] = a.device;
  touch["safety"] = safetyOf(a);
  provenance.touch = touch.dump();
  return toJson(provenance, -1);
}

std::string_view wordOf(GuideEnd end) {
  switch (end) {
    case GuideEnd::none:
      break;
    case GuideEnd::arrived:
      return "arrived";
    case GuideEnd::you_lead:
      return "the hand leads";
    case GuideEnd::button:
      return "button";
    case GuideEnd::asked:
      return "asked";
    case GuideEnd::no_forces:
      return "no forces";
    case GuideEnd::surface:
      return "another surface";
  }
  return "time is over";
}

Json jsonOfGuide(const TouchSetup& setup, const GuidedFindings& found) {
  const GuidePath& path = *setup.guide;
  std::uint32_t pauses = 0;
  for (std::uint32_t i = 0; i < path.count; ++i) pauses += path.points[i].pause_s > 0 ? 1 : 0;
  return {{"along", setup.guide_of},
          {"closed", path.closed},
          {"rounds", path.rounds},
          {"length_mm", path.lengthMm()},
          {"points", path.count},
          {"pauses", pauses},
          {"ended", wordOf(found.end)},
          {"led_s", found.led_s},
          {"rms_mm", found.rms_mm},
          {"largest_force_n", found.largest_n},
          {"largest_fed_mw", found.audit.largest_fed_mw},
          {"violations", found.audit.violations()}};
}

std::string lineOfGuide(const TouchSetup& setup, const GuidedFindings& found) {
  return "Led along the " + setup.guide_of + " for " + shortNumber(found.led_s) + " s, " +
         shortNumber(setup.guide->lengthMm()) + " mm of hand a round, " +
         shortNumber(found.rms_mm) + " mm off it (rms), with " + shortNumber(found.largest_n) +
         " N at most; end: " + std::string(wordOf(found.end)) + ".";
}

/// Leads the hand from the middle of the window, or from where its stroke begins.
GuidedFindings touchGuided(const std::optional<Stroke>& stroke, const TouchSetup& setup,
                           SampleLog& log,
                           const std::function<void(const HapticSample&, double t_s)>& each,
                           const Task& task) {
  const Region& region = setup.window.region;
  GuidedRun run;
  run.start = setup.space->deviceFromView(
      handOver(setup.window, region.centreX(), region.centreY(), false, 0));
  if (stroke) run.wish = &*stroke;
  std::optional<HapticSample> before;
  return runGuided(
      *setup.space, setup.core, setup.options.frame, *setup.guide, *setup.options.device, run,
      [&](const HapticSample& sample, double t_s) {
        each(sample, t_s);
        log.write(sample, t_s, before ? eventBetween(*before, sample) : eventAtStart(sample));
        before = sample;
      },
      task);
}

/// The device that is to play the stroke's hand; null: none was named.
std::unique_ptr<Device> openSteered(const TouchArguments& a, TouchSetup& setup) {
  if (a.device.empty()) return nullptr;
  std::unique_ptr<Device> device = makeDevice(a.device);
  setup.options.device = dynamic_cast<SteeredDevice*>(device.get());
  if (setup.options.device == nullptr) throw failure<MessageId::stroke_moves_no_hand>(a.device);
  if (setup.guide && !(device->info().max_force_n > 0)) {
    throw failure<MessageId::guide_needs_a_hand>();
  }
  device->open();
  return device;
}

/// What was touched, and what came of it.
struct TouchReport {
  const TouchSetup& setup;
  const StrokeFindings& findings;
  ForceLimit limit;
  std::string device;  ///< Its id; empty: none.
  std::uint64_t ticks = 0;
  std::optional<GuidedFindings> led = std::nullopt;
};

Json jsonOfTouch(const TouchArguments& a, const TouchReport& report) {
  const TouchSetup& setup = report.setup;
  const StrokeFindings& findings = report.findings;
  const HandMapping hand = handMapping(setup.window);
  Json json;
  json["level"] = setup.window.region.level.value;
  json["region_mm"] = jsonOf(setup.window.region);
  json["scale_device_per_view"] = hand.device_per_view;
  json["device_from_view"] = jsonOf(hand.device_from_view);
  json["stiffness_n_per_mm"] =
      setup.core.stiffness_by_detail
          ? stiffnessForDetail(setup.space->detail, setup.core.detail_stiffness)
          : setup.core.force.stiffness_n_per_mm;
  const Json feel = Json::parse(feelJson(a));
  for (const char* entry : {"preset", "damping_n_s_per_mm", "surface", "friction", "proxy",
                            "softest_part", "texture_mm", "magnet_n", "contact_n", "crossing_n"}) {
    json[entry] = feel[entry];
  }
  json["ticks"] = report.ticks;
  json["view_from_file"] = jsonOf(setup.surface.view_from_file);
  json["gain"] = setup.window.gain;
  json["safety"] = safetyOf(a) ? "on" : "off";
  json["limited"] = setup.limited.empty() ? Json() : Json(setup.limited);
  json["device"] = report.device.empty() ? Json() : Json(report.device);
  json["largest_force_n"] = findings.largest_force_n;
  json["device_limit"] = {{"device", report.limit.device}, {"force_n", report.limit.force_n}};
  json["largest_device_force_n"] = std::min(findings.largest_force_n, report.limit.force_n);
  json["beyond_device_ticks"] = findings.beyond_ticks;
  json["contact_ticks"] = findings.contact_ticks;
  json["proxy_off_surface_mm"] = findings.off_surface_mm;
  json["force_to_normal_deg"] = findings.force_to_normal_deg;
  json["guide"] = report.led ? jsonOfGuide(setup, *report.led) : Json();
  return json;
}

std::vector<std::string> linesOfTouch(const TouchArguments& a, const TouchReport& report) {
  const StrokeFindings& findings = report.findings;
  const std::string beyond = findings.beyond_ticks > 0
                                 ? " (" + report.limit.device + ": " +
                                       shortNumber(report.limit.force_n) + " N at most, in " +
                                       std::to_string(findings.beyond_ticks) +
                                       " ticks less than the log says)"
                                 : std::string();
  std::vector<std::string> lines{
      a.out + ": " + std::to_string(report.ticks) + " ticks, largest force " +
      shortNumber(findings.largest_force_n) + " N" + beyond + ", 1 mm of hand = " +
      shortNumber(handMapping(report.setup.window).objectMmPerHandMm()) + " mm on the object"};
  if (report.led) lines.push_back(lineOfGuide(report.setup, *report.led));
  return lines;
}

CommandResult runTouch(const TouchArguments& a, const Task& task) {
  if (a.stroke.empty() && a.guide.empty()) throw failure<MessageId::touch_needs_stroke>();
  checkTouch(a);
  std::optional<Stroke> stroke;
  if (!a.stroke.empty()) stroke = strokeFile(a.stroke);
  TouchSetup setup = prepareTouch(a, task);
  OutputSet beside;  // What lies beside the recording, which takes its place first.
  writeWindowIfAsked(a.region, setup.surface, setup.window, beside);
  const std::unique_ptr<Device> device = openSteered(a, setup);

  if (!setup.limited.empty()) tell(setup.limited);
  const std::string header = touchHeader(a, setup, task);
  const std::unique_ptr<SampleLog> log = openLog(a.out, header, setup.space.get());
  const ForceLimit limit = limitOf(device.get());
  StrokeFindings findings{setup.window, *setup.space, limit.force_n};
  std::vector<ForcePoint> plot;
  const auto each = [&](const HapticSample& sample, double t_s) {
    findings.add(sample);
    if (!a.plot.empty()) plot.push_back(forcePoint(touchRow(sample, t_s)));
  };
  TouchReport report{.setup = setup,
                     .findings = findings,
                     .limit = limit,
                     .device = device ? device->info().id : std::string()};
  if (setup.guide) {
    report.led = touchGuided(stroke, setup, *log, each, task);
    report.ticks = log->rows();
  } else {
    report.ticks = touchAlong(*stroke, setup, log.get(), each, task);
  }
  if (!a.plot.empty()) {
    writeTextFile(beside.file(a.plot),
                  withState(forcePlotSvg(plot, touchTitle(a, setup.surface), limit),
                            headerLine(header, std::string(kStateKey) + " ")));
  }
  log->close(setup.guide ? guideLine(*setup.guide) : std::string());
  beside.commit();
  return {.json = reportText(jsonOfTouch(a, report)), .lines = linesOfTouch(a, report)};
}

}  // namespace

Stroke strokeFile(const std::filesystem::path& file) {
  requirePipeOrFile(file);
  return readStroke(file);
}

void checkTouch(const TouchArguments& a) {
  requireUse("--rounds", a.rounds.has_value(), !a.guide.empty() && !isGuideFile(a.guide),
             "--guide outline");
  if (!a.guide.empty() && (a.device.empty() || !safetyOf(a))) {
    throw failure<MessageId::guide_needs_a_hand>();
  }
  requireUse("--magnet-reach", a.magnet_reach_mm.has_value(), feelOf(a).fields.magnet_n > 0,
             "--magnet");
  requireUse("--strength", !a.strength.empty(), safetyOf(a), "--safety on");
  if (a.stiffness_n_per_mm && !a.detail_stiffness_n_per_mm.empty()) {
    throw failure<MessageId::option_stiffness_of_levels>();
  }
}

std::string touchTitle(const TouchArguments& a, const Surface& surface) {
  return escapedName(surface.info.file.filename().string()) + ", proxy " + proxyName(a);
}

std::uint64_t touchAlong(const Stroke& stroke, const TouchSetup& setup, SampleLog* log,
                         const std::function<void(const HapticSample&, double t_s)>& each,
                         const Task& task) {
  std::optional<HapticSample> before;
  return runStroke(
      *setup.space, setup.options, stroke,
      [&](const HapticSample& sample, double t_s) {
        each(sample, t_s);
        if (log == nullptr) return;
        log->write(sample, t_s, before ? eventBetween(*before, sample) : eventAtStart(sample));
        before = sample;
      },
      task);
}

namespace {

/// What is felt, and with which limits, whatever is touched.
TouchSetup setupWithoutSurface(const TouchArguments& a) {
  TouchSetup setup;
  setup.options = strokeOptions(a);
  setup.core = strokeHapticOptions(setup.options);
  setup.device = a.device.empty() ? "none" : a.device;
  if (!a.device.empty()) {
    const DeviceInfo device = a.told ? *a.told : makeDevice(a.device)->info();
    setup.core.grip = gripPosition(a.grip).value_or(GripPosition::upright);
    setup.limited = limitedText(setup.core, device);
    setup.core = withinDevice(setup.core, device);
    if (a.lift_n) setup.core.force.lift_n = *a.lift_n;
  }
  return setup;
}

void layUnderTheHand(TouchSetup& setup, const TouchArguments& a, const Surface& surface,
                     const Task& task) {
  const Region region = chosenRegion(surface, a.region);
  setup.window = windowOf(surface, region, a.region.gain);
  setup.space = std::make_unique<HapticSpace>();
  std::vector<float> firmness;
  if (!a.firmness.empty()) {
    firmness = firmnessUnder(readFirmness(a.firmness, task), surface.ladder, region);
  }
  fill(*setup.space, setup.window,
       {.detail = surface.ladder.detailOf(region.level), .levels = surface.ladder.levels()},
       feelOf(a).surface, {}, firmness);
  if (setup.options.fields.texture_mm > 0) {
    fillTexture(*setup.space, finerHeights(surface, region, a.region.gain));
  }
  findGuide(setup, a, surface, task);
}

}  // namespace

TouchSetup prepareTouch(const TouchArguments& a, const Task& task) {
  TouchSetup setup = setupWithoutSurface(a);
  setup.surface = openForVerb(a.map, task);
  warnIfAliased(setup.surface, chosenRegion(setup.surface, a.region));
  layUnderTheHand(setup, a, setup.surface, task);
  return setup;
}

TouchSetup prepareTouch(const TouchArguments& a, const Surface& surface, const Task& task) {
  TouchSetup setup = setupWithoutSurface(a);
  layUnderTheHand(setup, a, surface, task);
  return setup;
}

std::string touchHeader(const TouchArguments& a, const TouchSetup& setup, const Task& task) {
  return touchHeader(a, setup, setup.surface, task);
}

std::string touchHeader(const TouchArguments& a, const TouchSetup& setup, const Surface& surface,
                        const Task& task) {
  const std::string stroke =
      a.stroke.empty()
          ? std::string(a.guide.empty() ? "by hand" : "led")
          : "stroke " + escapedName(std::filesystem::path(a.stroke).filename().string());
  Json parameters = Json::parse(feelJson(a));
  parameters["command"] = Json::array();
  for (const std::string& word : a.words) parameters["command"].push_back(textOfName(word));
  parameters["safety"] = safetyOf(a);
  return "relievo log, schema 2\nversion " + std::string(RELIEVO_VERSION_STRING) + "\n" +
         lawLine() + "\ninput " + escapedName(surface.info.file.filename().string()) + "\nunit " +
         std::string(name(surface.unit)) + " (" + std::string(name(surface.unit_source)) +
         ")\ndevice " + setup.device + " (" + stroke + ")\nregion_mm " +
         jsonOf(setup.window.region).dump() + " level " +
         std::to_string(setup.window.region.level.value) + "\nproxy " + proxyName(a) +
         ", surface " + parameters["surface"].get<std::string>() + ", stiffness " +
         (parameters.contains("stiffness_n_per_mm") ? parameters["stiffness_n_per_mm"].dump()
                                                    : std::string("by detail")) +
         " N/mm, friction " + parameters["friction"].dump() + ", damping " +
         parameters["damping_n_s_per_mm"].dump() + " N s/mm, safety " +
         (safetyOf(a) ? "on" : "off") +
         (setup.core.force.lift_n > 0
              ? "\n" + std::string(kLiftWords) + Json(setup.core.force.lift_n).dump() + " N upward"
              : "") +
         (setup.core.grip != GripPosition::upright
              ? "\ngrip position " + std::string(name(setup.core.grip))
              : "") +
         (setup.limited.empty() ? "" : "\nlimits " + setup.limited) +
         (a.told ? "\n" + std::string(kToldLimits) + toldLimits(*a.told) : "") + "\nparameters " +
         parameters.dump() + "\n" + stateLine(stateOfTouch(a, setup, surface, task));
}

void addTouchOptions(CLI::App& verb, TouchArguments& arguments) {
  addMapOptions(verb, arguments.map);
  addRegionOptions(verb, arguments.region);
  addFeelOptions(verb, arguments);
  verb.add_option("--strength", arguments.strength,
                  "Of all forces: gentle (30 %), medium (60 %), full (100 %), or percent from 1 to "
                  "100; full");
  verb.add_option("--safety", arguments.safety,
                  "on: ramp, slew, limit and passivity as at a device; default with --device. off "
                  "only without one, or with a simulated one")
      ->check(CLI::IsMember({"on", "off"}));
}

void declareTouch(CLI::App& verb, TouchArguments& arguments) {
  addTouchOptions(verb, arguments);
  verb.add_option(
      "--stroke", arguments.stroke,
      "CSV: t_s,x_mm,y_mm,z_mm; with --guide what the hand wants instead of giving way");
  verb.add_option(
      "--guide", arguments.guide,
      "Lead the hand: outline (of the largest raised area, else of the object), object, "
      "or along the way of a recording or stroke, LOG.csv, LOG.h5");
  takes(verb.add_option("--rounds", arguments.rounds, "So often round the outline, 1 to 3"),
        {.low = 1, .high = kMostRounds});
  verb.add_option("-o,--output", arguments.out, "LOG.csv or LOG.h5")->required();
  verb.add_option("--plot", arguments.plot, "Also draw z and force against time, SVG");
  verb.add_option("--device", arguments.device,
                  "virtual[:light|relaxed|firm]: a hand that aims along the stroke and is pushed");
  verb.add_option("--frame", arguments.frame, "Frame of the stroke: view or device")
      ->check(CLI::IsMember({"view", "device"}));
}

VerbFiles filesOf(const TouchArguments& a) {
  VerbFiles files;
  files.reads(a.map.file);
  files.reads(a.stroke, "the stroke that is read");
  files.reads(a.firmness, "the stiffness map that is read");
  if (isGuideFile(a.guide)) files.reads(a.guide, "the way that the hand is led along");
  files.writes(a.out);
  files.writes(a.plot);
  files.writesMap(a.region.window_out);
  files.namesMap("--window-out", a.region.window_out);
  return files;
}

Verb touchVerb(std::vector<std::string> words) {
  auto arguments = std::make_shared<TouchArguments>();
  arguments->words = std::move(words);
  return {.name = "touch",
          .help = "Run a stroke over a region and log proxy and force at every millisecond",
          .declare = [arguments](CLI::App& verb) { declareTouch(verb, *arguments); },
          .files = [arguments] { return filesOf(*arguments); },
          .run = [arguments](const Task& task) { return runTouch(*arguments, task); }};
}

}  // namespace relievo::batch
