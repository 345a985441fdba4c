// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/raster/raster_rows.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "core/io/read_scan.h"
#include "core/message/catalogue.h"

namespace relievo {
namespace {

[[noreturn]] void refuseRows(const RasterHead& head) {
  throwReadError(head.info.file, said<MessageId::refused_heights_not_kept>());
}

}  // namespace

RasterRows::RasterRows(RasterHead head, OwnedFd file, std::uint64_t heights_at,
                       std::optional<std::uint64_t> origins_at)
    : head_(std::move(head)),
      file_(std::move(file)),
      heights_at_(heights_at),
      origins_at_(origins_at) {}

void RasterRows::read(int first_row, int rows, float* heights, CellStatus* origins) const {
  const std::size_t start = head_.size.index({.col = 0, .row = first_row});
  const std::size_t count =
      static_cast<std::size_t>(rows) * static_cast<std::size_t>(head_.size.cols);
  const auto fetch = [&](std::uint64_t at, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t got = ::pread(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) refuseRows(head_);
      at += static_cast<std::uint64_t>(got);
      bytes = bytes.subspan(static_cast<std::size_t>(got));
    }
  };
  fetch(heights_at_ + start * sizeof(float), std::as_writable_bytes(std::span(heights, count)));
  const auto lowest = static_cast<float>(head_.info.bounds->min.z);
  const auto highest = static_cast<float>(head_.info.bounds->max.z);
  const bool sound = std::all_of(heights, heights + count, [&](float height) {
    return std::isnan(height) || (height >= lowest && height <= highest);
  });
  if (!sound) refuseRows(head_);
  if (origins == nullptr || !origins_at_) return;
  static_assert(sizeof(CellStatus) == 1);
  fetch(*origins_at_ + start, std::as_writable_bytes(std::span(origins, count)));
  if (std::any_of(origins, origins + count,
                  [](CellStatus o) { return static_cast<std::size_t>(o) >= kOriginCount; })) {
    refuseRows(head_);
  }
}

}  // namespace relievo
