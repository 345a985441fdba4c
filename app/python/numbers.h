// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/grid.h"
#include "core/recording/touch_row.h"
#include "haptics/record/stroke.h"

namespace relievo::python {

// Arrays of NumPy over numbers that C++ has: nothing is copied, nothing can be written, and the
// numbers stay as long as an array of them does. Each is a new object over the same memory.
// [interpreter held]

/// Keeps alive what numbers lie in.
using Owner = std::shared_ptr<const void>;

/// Shape (rows, cols), row 0 at the lowest y.
pybind11::array gridArray(const float* numbers, GridSize size, Owner owner);
/// The same of origins: uint8, the codes of `CellStatus`.
pybind11::array gridArray(const CellStatus* origins, GridSize size, Owner owner);
/// Shape (n,).
pybind11::array lineArray(const double* numbers, std::size_t count, Owner owner);
/// Shape (4, 4) of the 16 numbers of a transform.
pybind11::array transformArray(const double* numbers, Owner owner);
/// Shape (n,): one field for each number of a recording's row, called as in files.
pybind11::array rowArray(const std::shared_ptr<const std::vector<TouchRow>>& rows);

/// Rows of t_s, x_mm, y_mm, z_mm. @pre shape (n, 4)
Stroke strokeOf(const pybind11::array_t<double, pybind11::array::c_style>& points);

}  // namespace relievo::python
