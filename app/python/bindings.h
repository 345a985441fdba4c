// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace relievo::python {

// Each adds its classes and functions to the extension. [interpreter held]

/// Surface, Grid and Window; `open`.
void bindSurface(pybind11::module_& module);
/// Recording; `touch` and `read_recording`.
void bindRecording(pybind11::module_& module);

}  // namespace relievo::python
