// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/batch/arguments.h"
#include "core/base/task.h"
#include "core/region/window.h"
#include "core/session/surface.h"
#include "haptics/loop/haptic_core.h"
#include "haptics/record/stroke.h"

namespace relievo::batch {

/// Options of the verbs that touch: `touch`, `record`, and `replay`, which repeats them.
struct TouchArguments {
  MapArguments map;
  RegionArguments region;
  std::string stroke, out, plot;
  std::string device;  ///< Empty: none is attached.
  std::string surface = "auto", proxy = "converged", frame = "view";
  std::string safety;  ///< Empty: on with a device, off without.
  double stiffness_n_per_mm = 0.5;
  std::vector<double> friction;  ///< One value or two: static, dynamic.
  double damping = 0;
  double seconds = 10;             ///< `record` only.
  std::vector<std::string> words;  ///< The command line, for the log.
};
/// All options that decide what is felt; not where the stroke comes from or the log goes.
void addTouchOptions(CLI::App& verb, TouchArguments& arguments);
void declareTouch(CLI::App& verb, TouchArguments& arguments);   ///< Of `touch`.
void declareRecord(CLI::App& verb, TouchArguments& arguments);  ///< Of `record`.

/// What is touched, and how.
struct TouchSetup {
  Surface surface;
  RegionWindow window;
  std::unique_ptr<HapticSpace> space;  ///< On the heap: 900 kB by value.
  StrokeOptions options;
  HapticOptions core;  ///< The same for the core, within what the device can do.
};
/// @throw ArgumentError, FileError, DeviceError (no such device)
TouchSetup prepareTouch(const TouchArguments& arguments, const Task& task);

/// Comment lines of the log: enough to repeat it, and where it comes from in one line.
std::string touchHeader(const TouchArguments& arguments, const TouchSetup& setup, const Task& task);

}  // namespace relievo::batch
