// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/libraries.h"

#include "core/io/raster/png_version.h"
#include "core/io/raster/raster_file.h"
#include "core/neighbours/point_neighbours.h"
#include "core/prepare/pcl_version.h"
#include "core/provenance/parameters_json.h"
#include "core/recording/hdf5_version.h"

namespace relievo {

std::vector<LibraryVersion> coreLibraries() {
  return {{"FLANN", flannVersion()},
          {"GDAL", gdalVersion()},
          {"HDF5", hdf5Version()},
          {"PCL", pclVersion()},
          {"libpng", pngVersion()}};
}

std::string withLibraries(std::string_view made, const std::vector<LibraryVersion>& more) {
  Json json = Json::parse(made);
  for (const LibraryVersion& one : more) json["libraries"][one.name] = one.version;
  return json.dump();
}

}  // namespace relievo
