// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/arguments.h"
#include "core/base/task.h"
#include "core/region/window.h"
#include "core/session/surface.h"
#include "haptics/device/device.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/loop/surface_preset.h"
#include "haptics/record/guided_run.h"
#include "haptics/record/sample_log.h"
#include "haptics/record/stroke.h"

namespace relievo::batch {

/// Options of the verbs that touch: `touch`, `record`, and `replay`, which repeats them.
struct TouchArguments {
  MapArguments map;
  RegionArguments region;
  std::string stroke, out, plot;
  std::string device;  ///< Empty: none is attached.
  std::string preset;  ///< Empty: none; a spring alone.
  // Each overrides the preset where it is given.
  std::string surface, proxy;  ///< Empty: the preset's, else auto and converged.
  std::optional<double> stiffness_n_per_mm, damping;
  std::vector<double> detail_stiffness_n_per_mm;  ///< Of Detail 1, 2, 3, and all finer ones.
  std::vector<double> friction;                   ///< One value or two: static, dynamic.
  std::optional<double> softest_part, texture_mm, magnet_n, magnet_reach_mm, contact_n, crossing_n;
  std::string firmness;  ///< A raster that says where the ground is firm; empty: the origins do.
  std::string frame = "view";
  /// "outline", "object" or a file with a way: what the hand is led along; empty: it is not led.
  std::string guide;
  std::optional<std::uint32_t> rounds;  ///< Of a closed one; nothing: once.
  /// As a recording has it; null: it is found anew.
  std::shared_ptr<const GuidePath> recorded_guide;
  std::optional<double> lift_n;  ///< As a recording had it; nothing: as the device's settings say.
  /// What a plug-in's device told of itself; nothing: what this build knows of the device.
  std::optional<DeviceInfo> told;
  std::string safety;              ///< Empty: on with a device, off without.
  std::string strength;            ///< A preset or percent; empty: all of it.
  std::string grip;                ///< A grip position; `record` only; empty: upright.
  double seconds = 10;             ///< `record` only, as what follows.
  double ready_s = 60;             ///< Until a Falcon must be homed.
  std::vector<std::string> words;  ///< The command line, for the log.
};
/// Before the newtons with which a grip was held, in a log's header.
inline constexpr std::string_view kLiftWords = "grip held with ";

/// All options that decide what is felt; not where the stroke comes from or the log goes.
void addTouchOptions(CLI::App& verb, TouchArguments& arguments);
void declareTouch(CLI::App& verb, TouchArguments& arguments);   ///< Of `touch`.
void declareRecord(CLI::App& verb, TouchArguments& arguments);  ///< Of `record`.

/// The feel that the arguments ask for: the preset's, overridden by what was given. Without a
/// preset F = -k d and nothing else, k = 0.5 N per mm of hand. @throw ArgumentError
SurfaceFeel feelOf(const TouchArguments& arguments);
void addFeelOptions(CLI::App& verb, TouchArguments& arguments);
/// The same in words for headers and reports: JSON, every value written out.
std::string feelJson(const TouchArguments& arguments);
/// How strong all forces are, 0 .. 1. @throw ArgumentError
double strengthOf(const TouchArguments& arguments);
/// Options that have no use together. @throw ArgumentError
void checkTouch(const TouchArguments& arguments);

/// The stroke in a file of the user's. @throw FileError  as `checkedFileSize` and `readStroke`
Stroke strokeFile(const std::filesystem::path& file);

/// What is touched, and how.
struct TouchSetup {
  Surface surface;  ///< Empty if the caller has it.
  RegionWindow window;
  std::unique_ptr<HapticSpace> space;  ///< On the heap: 900 kB by value.
  StrokeOptions options;
  /// What the hand is led along; null: it is not led. Under its id in `core`.
  std::shared_ptr<const GuidePath> guide;
  std::string guide_of;  ///< In words, for reports.
  std::string device;    ///< Which one it is, for headers; "none".
  HapticOptions core;    ///< The same for the core, within what the device can do.
  std::string limited;   ///< What was asked for and is more than that, in a sentence; or empty.
};
/// @throw ArgumentError, FileError, DeviceError (no such device)
TouchSetup prepareTouch(const TouchArguments& arguments, const Task& task);
/// The same on a surface that is open; it says nothing on stderr. @throw as above
TouchSetup prepareTouch(const TouchArguments& arguments, const Surface& surface, const Task& task);

/// Comment lines of the log: enough to repeat it, and where it comes from in one line.
std::string touchHeader(const TouchArguments& arguments, const TouchSetup& setup, const Task& task);
std::string touchHeader(const TouchArguments& arguments, const TouchSetup& setup,
                        const Surface& surface, const Task& task);

/// What stands above a plot of it.
std::string touchTitle(const TouchArguments& arguments, const Surface& surface);

/// Leads the hand along a stroke; each tick goes to `each`, then into the log, if there is one.
/// @return ticks @throw as runStroke and SampleLog::write
std::uint64_t touchAlong(const Stroke& stroke, const TouchSetup& setup, SampleLog* log,
                         const std::function<void(const HapticSample&, double t_s)>& each,
                         const Task& task);

}  // namespace relievo::batch
