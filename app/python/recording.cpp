// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/verbs/force_plot.h"
#include "app/cli/verbs/verb_files.h"
#include "app/python/bindings.h"
#include "app/python/errors.h"
#include "app/python/input.h"
#include "app/python/interruptible.h"
#include "app/python/numbers.h"
#include "app/python/plain_numbers.h"
#include "core/base/failure.h"
#include "core/provenance/name_text.h"
#include "core/recording/force_curve.h"
#include "core/recording/log_table.h"
#include "core/session/large/memory_guard.h"
#include "haptics/record/events.h"
#include "haptics/record/sample_log.h"

namespace relievo::python {
namespace {

namespace py = pybind11;

/// What a hand did and felt, a row for every millisecond.
struct Recording {
  std::vector<TouchRow> rows;
  std::vector<double> force_n;  ///< Of each row, as plots show it.
  std::vector<LogEvent> events;
  std::string header, footer;
  std::string title;  ///< What stands above a plot of it.
};
using Recorded = std::shared_ptr<Recording>;

void addForces(Recording& recording) {
  recording.force_n.reserve(recording.rows.size());
  for (const TouchRow& row : recording.rows) recording.force_n.push_back(forcePoint(row).force_n);
}

Recorded read(const std::filesystem::path& file) {
  return interruptible([&](const Task& task) {
    LogTable log = readLog(file, LogUse::plot, task);
    auto recording = std::make_shared<Recording>();
    recording->rows = std::move(log.rows);
    recording->events = std::move(log.events);
    recording->header = std::move(log.header);
    recording->footer = std::move(log.footer);
    recording->title = escapedName(file.filename().string());
    addForces(*recording);
    return recording;
  });
}

/// A stroke whose times are no seconds has more rows than any computer remembers.
void requireRoom(const Stroke& stroke) {
  constexpr std::uint64_t kMb = 1'000'000;
  const std::optional<std::uint64_t> available = availableBytes();
  const std::uint64_t rows = strokeTicks(stroke);
  const std::uint64_t bytes = rows * (sizeof(TouchRow) + sizeof(double));
  if (!available || bytes <= *available) return;
  throw failure<MessageId::touch_needs_memory>(rows, bytes / kMb, *available / kMb);
}

/// The same ticks that `relievo touch` logs, and its log, if one is asked for.
Recorded touched(const OpenedSurface& opened, const batch::TouchArguments& arguments,
                 const std::optional<Stroke>& given, const Task& task) {
  batch::check(batch::filesOf(arguments));
  batch::checkTouch(arguments);
  const Stroke stroke = given ? *given : batch::strokeFile(arguments.stroke);
  requireRoom(stroke);
  const batch::TouchSetup setup = batch::prepareTouch(arguments, opened.surface, task);
  auto recording = std::make_shared<Recording>();
  recording->title = batch::touchTitle(arguments, opened.surface);
  std::unique_ptr<SampleLog> log;
  if (!arguments.out.empty()) {
    recording->header = batch::touchHeader(arguments, setup, opened.surface, task);
    log = openLog(arguments.out, recording->header, setup.space.get());
  }
  constexpr std::uint64_t kRoom = 1'000'000;  // A long one may be stopped before it needs more.
  recording->rows.reserve(std::min(strokeTicks(stroke), kRoom));
  std::optional<HapticSample> before;
  batch::touchAlong(
      stroke, setup, log.get(),
      [&](const HapticSample& sample, double t_s) {
        recording->rows.push_back(touchRow(sample, t_s));
        std::string event = before ? eventBetween(*before, sample) : eventAtStart(sample);
        if (!event.empty()) recording->events.push_back({t_s, sample.tick, std::move(event)});
        before = sample;
      },
      task);
  if (log) log->close();
  addForces(*recording);
  return recording;
}

Recorded touch(const OpenedSurface& opened, const Words& words, const py::object& points) {
  const batch::TouchArguments arguments = touchArguments(words);
  std::optional<Stroke> stroke;
  if (!points.is_none()) {
    stroke = strokeOf(points.cast<py::array_t<double, py::array::c_style>>());
  }
  return interruptible([&](const Task& task) { return touched(opened, arguments, stroke, task); });
}

py::str plotOf(const Recording& recording) {
  const PlainNumbers points_in_numbers;
  std::vector<ForcePoint> points;
  points.reserve(recording.rows.size());
  for (const TouchRow& row : recording.rows) points.push_back(forcePoint(row));
  return textOf(batch::forcePlotSvg(points, recording.title, batch::falconLimit()));
}

py::array rowsOf(const Recorded& recording) {
  return rowArray({recording, &recording->rows});
}

py::array columnOf(const Recorded& recording, const py::object& name) {
  if (!py::isinstance<py::str>(name)) {
    throw py::type_error("A column of a recording is called by a text, as 'hip_z_mm'.");
  }
  const py::array rows = rowsOf(recording);
  if (!py::bool_(rows.dtype().attr("fields").contains(name))) {
    throw py::key_error("There is no column '" + name.cast<std::string>() +
                        "'. relievo.COLUMNS lists them.");
  }
  return rows[name].cast<py::array>();
}

}  // namespace

void bindRecording(py::module_& module) {
  py::class_<Recording, Recorded>(
      module, "Recording",
      "What a hand did and felt: a row for every millisecond.\n\n"
      "recording['hip_z_mm'] is a column, shape (n,), called as in files (relievo.COLUMNS says "
      "units and meanings). Arrays share memory with the recording and cannot be written.")
      .def_property_readonly("rows", &rowsOf,
                             "Structured, shape (n,): a field for every column of numbers.")
      .def("__getitem__", &columnOf, py::arg("column"))
      .def("__len__", [](const Recording& recording) { return recording.rows.size(); })
      .def_property_readonly(
          "force_n",
          [](const Recorded& recording) {
            return lineArray(recording->force_n.data(), recording->force_n.size(), recording);
          },
          "float64, shape (n,): size of the force on the hand in N, as plots show it.")
      .def("plot_svg", &plotOf,
           "The paper's force figure as SVG: z of hand (red) and proxy (blue) in mm, force in N, "
           "against time in s. What `relievo touch --plot` draws.")
      .def("_repr_svg_", &plotOf, "So that a notebook shows it.")
      .def_property_readonly(
          "events",
          [](const Recording& recording) {
            py::list events;
            for (const LogEvent& event : recording.events) {
              events.append(py::make_tuple(event.t_s, event.tick, textOf(event.text)));
            }
            return events;
          },
          "What happened: (t_s, tick, text), in order.")
      .def_property_readonly(
          "header", [](const Recording& recording) { return textOf(recording.header); },
          "Lines before the rows of its file; empty of a touch that wrote none.")
      .def_property_readonly(
          "footer", [](const Recording& recording) { return textOf(recording.footer); },
          "Lines behind the first row of its file.");
  module.def("touch", &touch, py::arg("surface"), py::arg("words"), py::arg("points"));
  module.def("read_recording", &read, py::arg("file"));
  py::dict columns;
  for (const LogColumn& column : kNumberColumns) {
    columns[py::str(std::string(column.name))] =
        py::make_tuple(std::string(column.unit), std::string(column.description));
  }
  module.attr("COLUMNS") = columns;
}

}  // namespace relievo::python
