// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/task.h"
#include "core/base/transform.h"
#include "core/base/unit.h"
#include "core/cloud/scan.h"
#include "core/depth/colours/colours.h"
#include "core/depth/colours/stored_colours.h"
#include "core/depth/depth_map.h"
#include "core/depth/depth_request.h"
#include "core/depth/fill/fill.h"
#include "core/depth/quality.h"
#include "core/depth/view.h"
#include "core/message/message.h"
#include "core/pyramid/pyramid.h"
#include "core/region/region.h"
#include "core/session/nodata.h"
#include "core/session/source/raster_scale.h"
#include "core/session/strays.h"

namespace relievo {

/// Everything chosen between a file and its surface; one record for window and command line.
struct SurfaceOptions {
  std::optional<LengthUnit> unit;              ///< Nothing: see unitInUse (unit_guess.h).
  UnitSource unit_source = UnitSource::given;  ///< How `unit` was chosen, if it was.
  std::optional<ViewChoice> view;              ///< Nothing: top for rasters, automatic for scans.
  std::optional<int> cells;                    ///< Samples across the longer side, >= 2.
  std::optional<double> spacing_mm;            ///< Or their distance; excludes `cells`.
  std::string engine = "cpu";                  ///< "cpu" or "depthbuffer".
  std::optional<PointRule> rule;               ///< For clouds. Nothing: from the data.
  StrayRule strays = StrayRule::drop;          ///< Few points far from all others.
  std::optional<NodataChoice> nodata;          ///< Nothing: as the file says.
  RasterScale raster;                          ///< Of rasters from elsewhere.
  HoleChoice holes;
  PyramidOptions pyramid;
};

struct StageSeconds {
  double read = 0, grid = 0, fill = 0, pyramid = 0, colours = 0;
};

class TiledMap;  // core/tiles/tiled_map.h

/// A file made touchable: depth map, pyramid and how they came about. Immutable once made.
struct Surface {
  ScanInfo info;
  bool is_raster = false;  ///< From a raster or from a map written by this program.
  LengthUnit unit = LengthUnit::mm;
  UnitSource unit_source = UnitSource::assumed;
  std::optional<ScaleInUse> raster_scale;  ///< Of rasters from elsewhere.
  ViewFromFile view_from_file;
  std::string view_name;      ///< "top", ..., "free"; what automatic chose.
  bool view_is_weak = false;  ///< Chosen automatically, and another may well be right.
  std::string engine;
  std::string rule;  ///< Which rule and why, in words: "1.6 points per cell: local quadratic".
  /// How exact the depth buffer was, its planes above the base plane; nothing from other engines.
  std::optional<DepthBufferFormat> depth_buffer;
  DepthMap map;
  QualityMap quality;                 ///< Points and spread per cell; empty if not known.
  std::optional<DepthLosses> losses;  ///< Nothing for rasters: their points are gone.
  Strays strays;                      ///< Of scans.
  /// A height that most likely stands for none, left out though nobody said so.
  std::optional<SuspectHeight> suspect_height;
  std::uint64_t missing = 0;  ///< Points or cells left out as none: options.nodata, or suspect.
  Pyramid pyramid;
  std::vector<StoredColours> colours;  ///< Per level of it; empty: the scan has none.
  /// Where the levels are if they are not in memory (core/session/large/tiled_surface.h); else
  /// null.
  std::shared_ptr<const TiledMap> tiles;
  DetailLadder ladder;
  std::vector<Hole> holes;        ///< Enclosed holes, largest first.
  std::vector<Message> messages;  ///< For people: how the grid was chosen, what was assumed.
  std::vector<Message> not_done;  ///< Requested steps that could not be done; exit status 4.
  StageSeconds seconds;
};

/// Grid, fill and pyramid of a scan that is already in memory. [worker]
/// @param engine  runs for options.engine; the caller supplies the OpenGL one
/// @throw ArgumentError, Cancelled, GraphicsError
Surface makeSurface(const Scan& whole, const SurfaceOptions& options, const DepthEngine& engine,
                    const Task& task = {});

/// A raster or a map read from a file becomes a surface as it is. [worker]
struct RasterMap;  // core/io/raster/raster.h
Surface makeSurface(const RasterMap& raster, const SurfaceOptions& options, const Task& task = {});

}  // namespace relievo
