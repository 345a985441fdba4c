// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/depth/fill/band_fill.h"
#include "core/io/raster/raster_rows.h"
#include "core/message/message.h"
#include "core/session/nodata.h"

namespace relievo {

/// The heights of a foreign raster that a map by tiles is made from, as options say of those that
/// stand for none. Looks at all rows only where it is said or suspected that there are some.
class RasterInUse {
 public:
  /// @param raster  outlives this  @throw FileError  no height is left; Cancelled  [worker]
  RasterInUse(const RasterRows& raster, const std::optional<NodataChoice>& nodata,
              const Task& task);

  double lowest() const { return lowest_; }  ///< File unit.
  double highest() const { return highest_; }
  std::uint64_t missing() const { return missing_; }
  /// What to say of heights that stand for none.
  const std::vector<Message>& messages() const { return messages_; }
  /// In millimetres above `value`; NaN: none. @param mm  in a step of the file's heights
  RowsOf depths(double mm, double value) const;

 private:
  Heights heights(const Task& task) const;

  const RasterRows& raster_;
  std::optional<double> value_;  ///< Stands for none.
  double lowest_ = 0, highest_ = 0;
  std::uint64_t missing_ = 0;
  std::vector<Message> messages_;
};

}  // namespace relievo
