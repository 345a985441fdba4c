// SPDX-License-Identifier: BSD-3-Clause
#include "app/python/numbers.h"

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/recording/log_columns.h"

namespace relievo::python {
namespace {

namespace py = pybind11;

/// A capsule gives nobody a buffer to write to, so that NumPy refuses to make the array writable
/// again.
py::array view(const py::dtype& type, std::vector<py::ssize_t> shape,
               std::vector<py::ssize_t> strides, const void* numbers, Owner owner) {
  auto keeper = std::make_unique<Owner>(std::move(owner));
  const py::capsule base(keeper.get(), [](void* kept) { delete static_cast<Owner*>(kept); });
  static_cast<void>(keeper.release());  // The capsule has it.
  py::array array(type, std::move(shape), std::move(strides), numbers, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

template <class Number>
py::array gridView(const py::dtype& type, const Number* numbers, GridSize size, Owner owner) {
  constexpr auto kBytes = static_cast<py::ssize_t>(sizeof(Number));
  return view(type, {size.rows, size.cols}, {kBytes * size.cols, kBytes}, numbers,
              std::move(owner));
}

/// Where a number of a row lies, as NumPy names its type.
struct Field {
  std::string_view column;
  std::size_t offset;
  const char* type;
};

static_assert(std::is_standard_layout_v<TouchRow>);
static_assert(sizeof(bool) == 1 && sizeof(CellStatus) == 1 && sizeof(int) == 4);
constexpr std::size_t kX = 0;
constexpr std::size_t kY = sizeof(double);
constexpr std::size_t kZ = 2 * sizeof(double);
// The test of recordings compares every one of them with what a file says.
constexpr std::array<Field, kNumberColumns.size()> kFields{{
    {"t_s", offsetof(TouchRow, t_s), "f8"},
    {"tick", offsetof(TouchRow, tick), "u8"},
    {"hip_x_mm", offsetof(TouchRow, hip) + kX, "f8"},
    {"hip_y_mm", offsetof(TouchRow, hip) + kY, "f8"},
    {"hip_z_mm", offsetof(TouchRow, hip) + kZ, "f8"},
    {"proxy_x_mm", offsetof(TouchRow, proxy) + kX, "f8"},
    {"proxy_y_mm", offsetof(TouchRow, proxy) + kY, "f8"},
    {"proxy_z_mm", offsetof(TouchRow, proxy) + kZ, "f8"},
    {"f_x_N", offsetof(TouchRow, force) + kX, "f8"},
    {"f_y_N", offsetof(TouchRow, force) + kY, "f8"},
    {"f_z_N", offsetof(TouchRow, force) + kZ, "f8"},
    {"f_cmd_N", offsetof(TouchRow, unlimited_n), "f8"},
    {"clamp", offsetof(TouchRow, clamped), "?"},
    {"contact", offsetof(TouchRow, contact), "?"},
    {"nx", offsetof(TouchRow, normal) + kX, "f8"},
    {"ny", offsetof(TouchRow, normal) + kY, "f8"},
    {"nz", offsetof(TouchRow, normal) + kZ, "f8"},
    {"k_Npm", offsetof(TouchRow, stiffness_n_per_m), "f8"},
    {"detail", offsetof(TouchRow, detail), "i4"},
    {"region_id", offsetof(TouchRow, window_id), "u8"},
    {"origin", offsetof(TouchRow, origin), "u1"},
    {"buttons", offsetof(TouchRow, buttons), "u4"},
    {"rate_Hz", offsetof(TouchRow, rate_hz), "f8"},
    {"dev_hip_x_mm", offsetof(TouchRow, hand_hip) + kX, "f8"},
    {"dev_hip_y_mm", offsetof(TouchRow, hand_hip) + kY, "f8"},
    {"dev_hip_z_mm", offsetof(TouchRow, hand_hip) + kZ, "f8"},
    {"dev_proxy_x_mm", offsetof(TouchRow, hand_proxy) + kX, "f8"},
    {"dev_proxy_y_mm", offsetof(TouchRow, hand_proxy) + kY, "f8"},
    {"dev_proxy_z_mm", offsetof(TouchRow, hand_proxy) + kZ, "f8"},
    {"age_s", offsetof(TouchRow, age_s), "f8"},
}};
static_assert(
    [] {
      for (std::size_t i = 0; i < kFields.size(); ++i) {
        if (kFields[i].column != kNumberColumns[i].name) return false;
      }
      return true;
    }(),
    "the columns of recordings, in their order");

py::dtype rowType() {
  py::list names;
  py::list types;
  py::list offsets;
  for (const Field& field : kFields) {
    names.append(std::string(field.column));
    types.append(field.type);
    offsets.append(field.offset);
  }
  return {names, types, offsets, sizeof(TouchRow)};
}

}  // namespace

py::array gridArray(const float* numbers, GridSize size, Owner owner) {
  return gridView(py::dtype::of<float>(), numbers, size, std::move(owner));
}

py::array gridArray(const CellStatus* origins, GridSize size, Owner owner) {
  return gridView(py::dtype::of<std::uint8_t>(), origins, size, std::move(owner));
}

py::array lineArray(const double* numbers, std::size_t count, Owner owner) {
  return view(py::dtype::of<double>(), {static_cast<py::ssize_t>(count)}, {sizeof(double)}, numbers,
              std::move(owner));
}

py::array transformArray(const double* numbers, Owner owner) {
  constexpr py::ssize_t kSide = 4;
  return view(py::dtype::of<double>(), {kSide, kSide}, {kSide * sizeof(double), sizeof(double)},
              numbers, std::move(owner));
}

py::array rowArray(const std::shared_ptr<const std::vector<TouchRow>>& rows) {
  return view(rowType(), {static_cast<py::ssize_t>(rows->size())}, {sizeof(TouchRow)}, rows->data(),
              rows);
}

Stroke strokeOf(const py::array_t<double, py::array::c_style>& points) {
  const auto numbers = points.unchecked<2>();
  Stroke stroke;
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i) {
    stroke.points.push_back({.t_s = numbers(i, 0),
                             .x_mm = numbers(i, 1),
                             .y_mm = numbers(i, 2),
                             .z_mm = numbers(i, 3)});
  }
  return stroke;
}

}  // namespace relievo::python
