// SPDX-License-Identifier: BSD-3-Clause
// relievo._relievo: what the package `relievo` of Python calls; the verbs' own functions, with
// arrays of NumPy in place of files (docs/adr/0148).
#include <dlfcn.h>

#include <pybind11/pybind11.h>
#include <filesystem>
#include <string>
#include <string_view>

#include "app/cli/batch.h"
#include "app/python/bindings.h"
#include "app/python/errors.h"
#include "core/base/failure.h"
#include "core/base/origin.h"
#include "core/file/own_program.h"
#include "core/io/worker/reader_guard.h"
#include "core/io/worker/worker_process.h"
#include "core/provenance/program.h"

namespace py = pybind11;

namespace relievo::python {
namespace {

/// Where this extension lies.
std::filesystem::path ownFolder() {
  Dl_info here{};
  if (dladdr(reinterpret_cast<const void*>(&ownFolder), &here) == 0) return {};
  return std::filesystem::absolute(here.dli_fname).parent_path();
}

/// Installed, or in the folder where everything was built.
std::filesystem::path programFolder() {
  const std::filesystem::path folder = ownFolder();
  for (const char* const place : {RELIEVO_PROGRAMS_INSTALLED, RELIEVO_PROGRAMS_BUILT}) {
    std::error_code missing;
    std::filesystem::path found = (folder / place).lexically_normal();
    if (std::filesystem::is_regular_file(found / "relievo", missing)) return found;
  }
  return (folder / RELIEVO_PROGRAMS_INSTALLED).lexically_normal();
}

/// The program that draws. @throw GraphicsError  it is not installed
std::string drawingProgram() {
  const std::filesystem::path file = ownProgram("relievo-draw", "Pictures cannot be drawn:");
  if (file.empty()) throw failure<MessageId::drawing_not_installed>();
  return file.string();
}

}  // namespace
}  // namespace relievo::python

PYBIND11_MODULE(_relievo, module) {
  using namespace relievo;
  // As main() of relievo does: this process reads no scan, raster or picture (docs/adr/0146).
  forbidReaders();
  setProgramFolder(python::programFolder());
  python::translateErrors();
  module.doc() = "The functions of relievo's command line on arrays. Use the package relievo.";
  python::bindSurface(module);
  python::bindRecording(module);
  module.def("drawing_program", [] { return py::bytes(python::drawingProgram()); });
  module.def("version_text", &versionText);
  module.attr("__version__") = std::string(programVersion());
  py::list origins;
  for (const std::string_view name : kOriginNames) origins.append(std::string(name));
  module.attr("ORIGINS") = py::tuple(origins);
}
