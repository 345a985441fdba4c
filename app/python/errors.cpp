// SPDX-License-Identifier: BSD-3-Clause
#include "app/python/errors.h"

#include <pybind11/pybind11.h>
#include <exception>

#include "core/base/error.h"

namespace relievo::python {

namespace py = pybind11;

namespace {

/// What Python calls the class of an error, as exit codes tell them apart.
const char* classOf(const Error& error) {
  if (dynamic_cast<const ArgumentError*>(&error) != nullptr) return "ArgumentError";
  if (dynamic_cast<const FileError*>(&error) != nullptr) return "FileError";
  if (dynamic_cast<const WriteError*>(&error) != nullptr) return "WriteError";
  if (dynamic_cast<const DeviceError*>(&error) != nullptr) return "DeviceError";
  if (dynamic_cast<const GraphicsError*>(&error) != nullptr) return "GraphicsError";
  if (dynamic_cast<const Cancelled*>(&error) != nullptr) return "Cancelled";
  return "Error";
}

}  // namespace

py::str textOf(const std::string& bytes) {
  return py::reinterpret_steal<py::str>(PyUnicode_DecodeUTF8(
      bytes.data(), static_cast<py::ssize_t>(bytes.size()), "backslashreplace"));
}

void translateErrors() {
  // The library says how it is called.  NOLINTNEXTLINE(performance-unnecessary-value-param)
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      const py::object type = py::module_::import("relievo._errors").attr(classOf(error));
      const py::object made = type(textOf(error.what()), textOf(error.code));
      PyErr_SetObject(type.ptr(), made.ptr());
    }
  });
}

}  // namespace relievo::python
