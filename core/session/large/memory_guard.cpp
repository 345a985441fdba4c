// SPDX-License-Identifier: BSD-3-Clause
#include "core/session/large/memory_guard.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>

#include "core/base/control_group.h"
#include "core/base/failure.h"

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

NumberArgument gigabytes(double bytes) {
  return {.value = bytes / kGigabyte, .digits = 1, .unit = MessageUnit::gigabyte};
}

NumberArgument millimetres(double mm) {
  return {.value = mm,
          .digits = 3,
          .form = NumberArgument::Form::significant,
          .unit = MessageUnit::millimetre};
}

std::optional<std::uint64_t> freeOnMachine(const std::filesystem::path& root) {
  std::ifstream memory(root / "proc/meminfo");
  std::string key;
  std::string rest;
  std::uint64_t kilobytes = 0;
  while (memory >> key >> kilobytes && std::getline(memory, rest)) {
    if (key == "MemAvailable:") return 1024 * kilobytes;
  }
  return std::nullopt;
}

/// How a version of the kernel's control groups calls what.
struct GroupFiles {
  const char *limit, *use, *reclaimable;
};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file"};

/// The number in a file; nothing if there is none, as where the limit is "max".
std::optional<std::uint64_t> numberIn(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::uint64_t number = 0;
  if (!(in >> number)) return std::nullopt;
  return number;
}

/// What a group can still take; nothing if it has no limit.
std::optional<std::uint64_t> freeInGroup(const std::filesystem::path& group,
                                         const GroupFiles& files) {
  const auto limit = numberIn(group / files.limit);
  auto use = numberIn(group / files.use);
  if (!limit || !use) return std::nullopt;
  std::ifstream facts(group / "memory.stat");
  std::string key;
  std::uint64_t bytes = 0;
  while (facts >> key >> bytes) {
    if (key == files.reclaimable) *use -= std::min(*use, bytes);
  }
  return *limit - std::min(*limit, *use);
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

std::optional<std::uint64_t> availableBytes(const std::filesystem::path& root) {
  std::optional<std::uint64_t> least = freeOnMachine(root);
  forEachControlGroup(root, "memory", [&](const ControlGroup& group) {
    const auto left = freeInGroup(group.folder, group.is_second ? kVersion2 : kVersion1);
    if (left) least = std::min(*left, least.value_or(*left));
  });
  return least;
}

void requireMemory(const GridFrame& frame, std::optional<std::uint64_t> available,
                   std::uint64_t colour_bytes) {
  if (!available) return;
  const std::uint64_t needed = surfaceBytes(frame.size) + colour_bytes;
  if (needed <= *available) return;
  // Two thirds of what is free leaves room for the pictures.
  const auto usable = 2.0 / 3 * static_cast<double>(*available);
  const double coarser = frame.spacing_mm * std::sqrt(static_cast<double>(needed) / usable);
  throw failure<MessageId::memory_needed>(gigabytes(static_cast<double>(needed)),
                                          gigabytes(static_cast<double>(*available)),
                                          millimetres(coarser), gigabytes(usable));
}

}  // namespace relievo
