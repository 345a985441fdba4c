// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/system_unit.h"

#include <ogr_spatialref.h>

#include <array>
#include <string>

#include "core/io/file_check.h"
#include "core/io/gdal_session.h"
#include "core/io/las_unit.h"
#include "core/io/number_text.h"
#include "core/io/unit_text.h"

namespace relievo {

double addUnitOfSystem(std::string_view head, const LasHeader& header, ScanInfo& info) {
  if (info.unit) return 1;
  const auto code = lasSystem(head, header);
  if (!code) return 1;
  const std::string system = "It names its coordinate system, EPSG:" + std::to_string(*code) + ", ";
  const GdalErrors silent;
  OGRSpatialReference reference;
  if (reference.importFromEPSG(*code) != OGRERR_NONE) {
    info.warnings.push_back(system + "which is not known here, and no unit; state it with --unit.");
    return 1;
  }
  if (reference.IsGeographic()) {
    info.warnings.push_back(system +
                            "whose x and y are degrees, not lengths, so shapes will be wrong. "
                            "Reproject it to metres.");
    return 1;
  }
  const double metres = reference.GetLinearUnits();
  info.unit = unitOfMetres(metres);
  if (!info.unit) {
    info.warnings.push_back(system + "whose unit of " + roundTripText(std::array{metres}) +
                            " m is not known here; state it with --unit.");
  }
  return heightFactor(head, header, info);
}

double addUnitOfSystem(const std::filesystem::path& file, ScanInfo& info) {
  if (info.unit) return 1;
  const std::string head = readHead(file, kLasHeadBytes);
  return addUnitOfSystem(head, parseLasHeader(head, file), info);
}

}  // namespace relievo
