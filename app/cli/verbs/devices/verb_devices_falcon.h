// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/verb.h"

namespace relievo::batch {

struct SelfTestArguments {
  bool no_nudges = false;
  double rate_s = 2;    ///< For how long the rate is measured.
  double wait_s = 0;    ///< For a person to press and move.
  double ready_s = 60;  ///< Until it must be homed.
  std::string device = "falcon";
};
/// @throw DeviceError  it did not become ready
CommandResult falconSelfTest(const SelfTestArguments& arguments, const Task& task);

/// Force gain by a known weight, as in the window's set-up; Enter says that the weight hangs. The
/// result is kept in the settings. @throw DeviceError, ArgumentError, WriteError
CommandResult calibrateFalcon(double weight_g, const SelfTestArguments& which, const Task& task);

/// Kept in the settings. @throw WriteError
CommandResult setLeftHanded(bool left_handed);

}  // namespace relievo::batch
