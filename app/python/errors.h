// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>
#include <string>

namespace relievo::python {

/// Sentences and lines of files may name files, whose names hold any bytes; those that are no
/// characters are shown as "\\xff". [interpreter held]
pybind11::str textOf(const std::string& bytes);

/// From here on, every Error of this project that reaches Python is the class of the same name in
/// relievo._errors, with its sentence and its code. [interpreter held]
void translateErrors();

}  // namespace relievo::python
