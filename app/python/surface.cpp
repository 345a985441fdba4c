// SPDX-License-Identifier: BSD-3-Clause
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/cli/verb.h"
#include "app/python/bindings.h"
#include "app/python/errors.h"
#include "app/python/input.h"
#include "app/python/interruptible.h"
#include "app/python/numbers.h"
#include "core/message/message.h"
#include "core/region/smoothing.h"
#include "core/session/large/crop_level.h"
#include "core/session/large/memory_guard.h"
#include "core/session/large/tiled_surface.h"

namespace relievo::python {
namespace {

namespace py = pybind11;

/// Heights of a depth map or of a level, wherever they are.
struct Grid {
  Owner owner;
  GridFrame frame;
  int level = 0;
  double sigma_mm = 0;
  const float* heights_mm = nullptr;
  const CellStatus* origins = nullptr;  ///< Null of levels beyond the depth map.
  const float* measured = nullptr;      ///< Null of the finest.
};

using Opened = std::shared_ptr<OpenedSurface>;

Grid gridOf(const std::shared_ptr<const DepthMap>& map, int level, double sigma_mm) {
  Grid grid{.owner = map, .frame = map->frame, .level = level, .sigma_mm = sigma_mm};
  grid.heights_mm = map->heights_mm.data();
  grid.origins = map->origins.data();
  return grid;
}

/// Of a map by tiles, whose cells are read now. @throw ArgumentError  E102: more than memory holds
Grid tiledGrid(const Opened& opened, Level level) {
  return interruptible([&](const Task&) {
    const Surface& surface = opened->surface;
    requireMemory(levelFrame(surface, level), availableBytes());
    return gridOf(std::make_shared<const DepthMap>(cropLevel(surface, level)), level.value,
                  smoothingMm(surface.ladder, level));
  });
}

Grid depthMap(const Opened& opened) {
  if (opened->surface.tiles) return tiledGrid(opened, Level{0});
  return gridOf({opened, &opened->surface.map}, 0, 0);
}

Grid levelOf(const Opened& opened, int value) {
  const Surface& surface = opened->surface;
  const Level level{value};
  const GridFrame& frame = levelFrame(surface, level);  // Refuses what is no level.
  if (surface.tiles) return tiledGrid(opened, level);
  const PyramidLevel& made = surface.pyramid.levels[static_cast<std::size_t>(value)];
  Grid grid{.owner = opened,
            .frame = frame,
            .level = value,
            .sigma_mm = smoothingMm(surface.ladder, level)};
  grid.heights_mm = made.heights_mm.data();
  grid.measured = made.measured.empty() ? nullptr : made.measured.data();
  return grid;
}

using Window = std::shared_ptr<RegionWindow>;

Window windowOfRegion(const Opened& opened, const Words& words) {
  const batch::RegionArguments arguments = regionArguments(words);
  return interruptible([&](const Task&) {
    const Surface& surface = opened->surface;
    return std::make_shared<RegionWindow>(
        windowOf(surface, batch::chosenRegion(surface, arguments), arguments.gain));
  });
}

/// What the command line would say of that window on standard error; or empty.
std::string noteOfRegion(const Opened& opened, const Words& words) {
  const batch::RegionArguments arguments = regionArguments(words);
  return batch::aliasNote(opened->surface, batch::chosenRegion(opened->surface, arguments));
}

constexpr GridSize kWindowSize{.cols = kWindowSamples, .rows = kWindowSamples};

void bindGrid(py::module_& module) {
  py::class_<Grid>(module, "Grid",
                   "Heights on a square grid: a depth map or a level of a pyramid.\n\n"
                   "Sample [row, col] lies at first_x_mm + col * spacing_mm, first_y_mm + row * "
                   "spacing_mm of the view; row 0 has the lowest y (Matplotlib: origin='lower'). "
                   "Arrays share memory with the surface and cannot be written.")
      .def_property_readonly(
          "heights_mm",
          [](const Grid& g) { return gridArray(g.heights_mm, g.frame.size, g.owner); },
          "float32, shape (rows, cols): mm above the base plane; 0 where there is no object.")
      .def_property_readonly(
          "origins",
          [](const Grid& g) -> py::object {
            if (g.origins == nullptr) return py::none();
            return gridArray(g.origins, g.frame.size, g.owner);
          },
          "uint8, shape (rows, cols): where each height is from, as relievo.ORIGINS names it; "
          "None of a level of the pyramid.")
      .def_property_readonly(
          "measured",
          [](const Grid& g) -> py::object {
            if (g.measured == nullptr) return py::none();
            return gridArray(g.measured, g.frame.size, g.owner);
          },
          "float32, shape (rows, cols): share of measured cells under the kernel, 0 to 1; None of "
          "the finest level, whose origins say it.")
      .def_property_readonly(
          "shape",
          [](const Grid& g) { return py::make_tuple(g.frame.size.rows, g.frame.size.cols); },
          "(rows, cols)")
      .def_property_readonly(
          "spacing_mm", [](const Grid& g) { return g.frame.spacing_mm; },
          "Distance of neighbouring samples, the same in x and y.")
      .def_property_readonly(
          "first_x_mm", [](const Grid& g) { return g.frame.first_x_mm; }, "x of column 0.")
      .def_property_readonly(
          "first_y_mm", [](const Grid& g) { return g.frame.first_y_mm; }, "y of row 0.")
      .def_readonly("level", &Grid::level, "0 is the finest.")
      .def_readonly("sigma_mm", &Grid::sigma_mm,
                    "By how much it is smoother than the depth map: a Gaussian's standard "
                    "deviation in mm.");
}

void bindWindow(py::module_& module) {
  py::class_<RegionWindow, std::shared_ptr<RegionWindow>>(
      module, "Window",
      "A square of a level as it lies under the hand: 200 x 200 heights.\n\n"
      "Sample [row, col] lies at x_mm + (col + 0.5) * spacing_mm, y_mm + (row + 0.5) * spacing_mm; "
      "row 0 has the lowest y. Arrays share memory with the window and cannot be written.")
      .def_property_readonly(
          "heights_mm",
          [](const std::shared_ptr<RegionWindow>& w) {
            return gridArray(w->heights_mm.data(), kWindowSize, w);
          },
          "float32, shape (200, 200): mm above the base plane, times `gain`.")
      .def_property_readonly(
          "origins",
          [](const std::shared_ptr<RegionWindow>& w) {
            return gridArray(w->origins.data(), kWindowSize, w);
          },
          "uint8, shape (200, 200): of the map's cell nearest to each sample.")
      .def_property_readonly(
          "x_mm", [](const RegionWindow& w) { return w.region.x_mm; }, "Left edge.")
      .def_property_readonly(
          "y_mm", [](const RegionWindow& w) { return w.region.y_mm; }, "Lower edge.")
      .def_property_readonly(
          "side_mm", [](const RegionWindow& w) { return w.region.side_mm; }, "Width and height.")
      .def_property_readonly("spacing_mm", &RegionWindow::spacingMm, "side_mm / 200.")
      .def_property_readonly(
          "level", [](const RegionWindow& w) { return w.region.level.value; },
          "Of the pyramid; 0 is the finest.")
      .def_readonly("gain", &RegionWindow::gain, "Factor on heights; 1 is true to scale.")
      .def_readonly("min_mm", &RegionWindow::min_mm, "Lowest of heights_mm.")
      .def_readonly("max_mm", &RegionWindow::max_mm, "Highest of heights_mm.")
      .def_property_readonly(
          "object_mm_per_hand_mm",
          [](const RegionWindow& w) { return handMapping(w).objectMmPerHandMm(); },
          "So many mm on the object are 1 mm of hand.");
}

py::list textsOf(const std::vector<Message>& sentences) {
  py::list texts;
  for (const Message& sentence : sentences) texts.append(textOf(englishText(sentence)));
  return texts;
}

}  // namespace

void bindSurface(py::module_& module) {
  bindGrid(module);
  bindWindow(module);
  py::class_<OpenedSurface, std::shared_ptr<OpenedSurface>>(module, "OpenedSurface")
      .def_property_readonly("depth_map",
                             [](const std::shared_ptr<OpenedSurface>& s) { return depthMap(s); })
      .def(
          "level",
          [](const std::shared_ptr<OpenedSurface>& s, int level) { return levelOf(s, level); },
          py::arg("level"))
      .def(
          "window",
          [](const std::shared_ptr<OpenedSurface>& s, const Words& words) {
            return windowOfRegion(s, words);
          },
          py::arg("words"))
      .def(
          "note_of_window",
          [](const std::shared_ptr<OpenedSurface>& s, const Words& words) {
            return noteOfRegion(s, words);
          },
          py::arg("words"))
      .def_property_readonly("file",
                             [](const OpenedSurface& s) { return py::bytes(s.arguments.file); })
      .def_property_readonly("levels",
                             [](const OpenedSurface& s) { return s.surface.ladder.levels(); })
      .def_property_readonly("factor",
                             [](const OpenedSurface& s) { return s.surface.ladder.factor; })
      .def_property_readonly("bounds_mm",
                             [](const OpenedSurface& s) {
                               const DetailLadder& l = s.surface.ladder;
                               return py::make_tuple(l.left_mm, l.bottom_mm, l.width_mm,
                                                     l.height_mm);
                             })
      .def_property_readonly("by_tiles",
                             [](const OpenedSurface& s) { return s.surface.tiles != nullptr; })
      .def_property_readonly(
          "unit", [](const OpenedSurface& s) { return std::string(name(s.surface.unit)); })
      .def_property_readonly("view", [](const OpenedSurface& s) { return s.surface.view_name; })
      .def_property_readonly("rule", [](const OpenedSurface& s) { return s.surface.rule; })
      .def_property_readonly("messages",
                             [](const OpenedSurface& s) { return textsOf(s.surface.messages); })
      .def_property_readonly("not_done",
                             [](const OpenedSurface& s) { return textsOf(s.surface.not_done); })
      .def_property_readonly("view_from_file", [](const std::shared_ptr<OpenedSurface>& s) {
        return transformArray(s->surface.view_from_file.m.data(), s);
      });
  module.def(
      "open",
      [](const Words& words) {
        const batch::MapArguments arguments = mapArguments(words);
        return interruptible([&](const Task& task) { return openSurface(arguments, task); });
      },
      py::arg("words"));
}

}  // namespace relievo::python
