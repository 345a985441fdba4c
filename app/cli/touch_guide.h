// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/cli/verbs/touch_setup.h"

namespace relievo::batch {

/// Does `--guide` name a file, and not an outline?
bool isGuideFile(const std::string& guide);

/// What the hand is led along, laid into the setup's space; nothing without `--guide`.
/// @throw ArgumentError  there is no outline  @throw FileError  no way can be read
void findGuide(TouchSetup& setup, const TouchArguments& arguments, const Surface& surface,
               const Task& task);

}  // namespace relievo::batch
