// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/memory_guard.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>

#include "core/base/error.h"

namespace relievo {
namespace {

// Measured: 23 bytes a cell for maps of 4000 and 8000 cells across; a little for other inputs.
constexpr std::uint64_t kBytesPerCell = 28;
// With the coarser levels, a third of the finest, and with what fills the cells in between.
constexpr std::uint64_t kBytesPerColour = 10;
constexpr std::uint64_t kBytesPerIntensity = 5;
constexpr std::uint64_t kBytesOfSums = 16;  // Of the rows that are worked on.
constexpr std::uint64_t kMostBytesOfSums = std::uint64_t{1} << 28U;
constexpr double kGigabyte = 1e9;

std::string gigabytes(double bytes) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.1f GB", bytes / kGigabyte);
  return text.data();
}

std::string millimetres(double mm) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g mm", mm);
  return text.data();
}

}  // namespace

std::uint64_t surfaceBytes(GridSize size) {
  return kBytesPerCell * size.count();
}

std::uint64_t colourBytes(GridSize size, bool scan_colours, bool scan_intensities) {
  const std::uint64_t cells = size.count();
  std::uint64_t bytes = 0;
  if (scan_colours) bytes += kBytesPerColour * cells;
  if (scan_intensities) bytes += kBytesPerIntensity * cells;
  if (bytes > 0) bytes += std::min(kBytesOfSums * cells, kMostBytesOfSums);
  return bytes;
}

std::optional<std::uint64_t> availableBytes() {
  std::ifstream memory("/proc/meminfo");
  std::string key;
  std::string rest;
  std::uint64_t kilobytes = 0;
  while (memory >> key >> kilobytes && std::getline(memory, rest)) {
    if (key == "MemAvailable:") return 1024 * kilobytes;
  }
  return std::nullopt;
}

void requireMemory(const GridFrame& frame, std::optional<std::uint64_t> available,
                   std::uint64_t colour_bytes) {
  if (!available) return;
  const std::uint64_t needed = surfaceBytes(frame.size) + colour_bytes;
  if (needed <= *available) return;
  // Two thirds of what is free leaves room for the pictures.
  const auto usable = 2.0 / 3 * static_cast<double>(*available);
  const double coarser = frame.spacing_mm * std::sqrt(static_cast<double>(needed) / usable);
  throw ArgumentError("This needs about " + gigabytes(static_cast<double>(needed)) + "; " +
                          gigabytes(static_cast<double>(*available)) +
                          " are free. Nothing was made. Choose cells of at least " +
                          millimetres(coarser) + " (" + gigabytes(usable) +
                          "), or close other programs.",
                      "E102");
}

}  // namespace relievo
