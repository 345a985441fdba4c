// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/system_unit.h"

#include <array>
#include <string>

#include "core/io/formats/number_text.h"
#include "core/io/formats/unit_text.h"
#include "core/io/raster/raster_file.h"

namespace relievo {

double addUnitOfSystem(const LasSystem& named, ScanInfo& info) {
  const std::string system =
      "It names its coordinate system, EPSG:" + std::to_string(named.code) + ", ";
  const auto facts = systemFacts(named.code);
  if (!facts) {
    info.warnings.push_back(system + "which is not known here, and no unit; state it with --unit.");
    return 1;
  }
  if (facts->is_geographic) {
    info.warnings.push_back(system +
                            "whose x and y are degrees, not lengths, so shapes will be wrong. "
                            "Reproject it to metres.");
    return 1;
  }
  const double metres = facts->metres;
  info.unit = unitOfMetres(metres);
  if (!info.unit) {
    info.warnings.push_back(system + "whose unit of " + roundTripText(std::array{metres}) +
                            " m is not known here; state it with --unit.");
  }
  return heightFactor(named, info);
}

}  // namespace relievo
