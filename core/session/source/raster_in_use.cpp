// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/source/raster_in_use.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/session/source/missing_height.h"
#include "core/session/strays.h"

namespace relievo {

RasterInUse::RasterInUse(const RasterRows& raster, const std::optional<NodataChoice>& nodata,
                         const Task& task)
    : raster_(raster),
      lowest_(raster.head().info.bounds->min.z),
      highest_(raster.head().info.bounds->max.z) {
  const FileBounds& box = *raster.head().info.bounds;
  std::optional<SuspectHeight> suspect;
  if (!nodata && (isUsualNodata(box.min.z) || isUsualNodata(box.max.z))) {
    suspect = suspectAmong(heights(task));
  }
  if (suspect) messages_.push_back(suspectWords(*suspect));
  value_ = missingHeight(nodata, suspect);
  if (!value_) return;
  lowest_ = std::numeric_limits<double>::infinity();
  highest_ = -lowest_;
  heights(task)([this](double z) {
    if (isHeight(z, *value_, 0)) {
      ++missing_;
    } else {
      lowest_ = std::min(lowest_, z);
      highest_ = std::max(highest_, z);
    }
  });
  if (!std::isfinite(lowest_)) {
    throw failure<MessageId::every_height_is_none>(shownName(raster.head().info.file));
  }
  if (missing_ > 0 && !suspect) messages_.push_back(missingWords(missing_, *value_));
}

Heights RasterInUse::heights(const Task& task) const {
  return [this, &task](const std::function<void(double)>& take) {
    const GridSize size = raster_.head().size;
    std::vector<float> row(static_cast<std::size_t>(size.cols));
    for (int r = 0; r < size.rows; ++r) {
      if (r % 64 == 0) task.check();
      raster_.read(r, 1, row.data(), nullptr);
      for (const float z : row) {
        if (!std::isnan(z)) take(static_cast<double>(z));
      }
    }
  };
}

RowsOf RasterInUse::depths(double mm, double value) const {
  return [this, mm, value](int first, int rows, float* out) {
    raster_.read(first, rows, out, nullptr);
    const float* const end =
        out + static_cast<std::size_t>(rows) * static_cast<std::size_t>(raster_.head().size.cols);
    // What is no height stays none.
    for (; out != end; ++out) {
      const auto z = static_cast<double>(*out);
      const bool is_none = value_ && isHeight(z, *value_, 0);
      *out =
          is_none ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>((z - value) * mm);
    }
  };
}

}  // namespace relievo
