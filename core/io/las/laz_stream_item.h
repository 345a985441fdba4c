// SPDX-License-Identifier: BSD-3-Clause
// Fields of point formats 0 to 5, in two versions: inside core/io only.
#pragma once

#include <memory>

#include "core/io/las/laz_chunk.h"

namespace relievo {

/// What one item of a record needs from point to point.
class StreamItem {
 public:
  virtual ~StreamItem() = default;
  /// Writes the next point's bytes of this item.
  virtual void decode(ArithmeticDecoder& decoder, char* item) = 0;
};

/// An item of version 1, of LASzip 1 (2010 and 2011). @param first  its bytes of the first point
/// @throw LazDamage  fields that no such file has
std::unique_ptr<StreamItem> firstVersionItem(const LazItem& item, const char* first);

}  // namespace relievo
