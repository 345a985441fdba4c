// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace relievo {

/// Who takes the points of a scan while it is read, so that no reader keeps them and whoever they
/// are for need not wait for the last. One thread at a time.
class PointSink {
 public:
  PointSink() = default;
  virtual ~PointSink() = default;
  PointSink(const PointSink&) = delete;
  PointSink& operator=(const PointSink&) = delete;

  /// A hint before the first. @param count  most that will come
  virtual void expect(std::uint64_t count) = 0;
  /// The next points as Scan::points has them. May throw what a reader may throw.
  virtual void take(std::span<const std::array<float, 3>> points) = 0;
};

}  // namespace relievo
