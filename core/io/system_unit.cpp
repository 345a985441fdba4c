// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/system_unit.h"

#include <array>

#include "core/io/formats/number_text.h"
#include "core/io/formats/unit_text.h"
#include "core/io/raster/raster_file.h"
#include "core/message/catalogue.h"

namespace relievo {

double addUnitOfSystem(const LasSystem& named, ScanInfo& info) {
  const auto facts = systemFacts(named.code);
  if (!facts) {
    info.warnings.push_back(said<MessageId::system_unknown>(named.code));
    return 1;
  }
  if (facts->is_geographic) {
    info.warnings.push_back(said<MessageId::system_in_degrees>(named.code));
    return 1;
  }
  info.unit = unitOfMetres(facts->metres);
  if (!info.unit) {
    info.warnings.push_back(
        said<MessageId::system_unit_unknown>(named.code, roundTripText(std::array{facts->metres})));
  }
  return heightFactor(named, info);
}

}  // namespace relievo
