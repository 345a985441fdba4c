// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "app/cli/arguments.h"
#include "app/python/parameters.h"
#include "core/base/task.h"
#include "core/session/surface.h"

namespace relievo::python {

/// A surface, and how it was asked for.
struct OpenedSurface {
  Surface surface;
  batch::MapArguments arguments;
};

/// As the verbs open a file; what there is to say is in Surface::messages, and nothing is written.
/// @throw Error
std::shared_ptr<OpenedSurface> openSurface(const batch::MapArguments& arguments, const Task& task);

}  // namespace relievo::python
