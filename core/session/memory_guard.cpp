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

/// Where a version of the kernel's control groups keeps what.
struct GroupFiles {
  const char *mount, *limit, *use, *reclaimable;
};
constexpr GroupFiles kVersion2{"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"};
constexpr GroupFiles kVersion1{"sys/fs/cgroup/memory", "memory.limit_in_bytes",
                               "memory.usage_in_bytes", "total_inactive_file"};

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

/// The least that the group and those above it leave. Within a container the path may be that of
/// the machine outside, of which only the end is mounted: then the mount itself is the group.
std::optional<std::uint64_t> freeInGroups(const std::filesystem::path& mount,
                                          const std::string& path, const GroupFiles& files) {
  std::optional<std::uint64_t> least;
  std::filesystem::path group = mount;
  const auto look = [&] {
    const auto left = freeInGroup(group, files);
    if (left) least = std::min(*left, least.value_or(*left));
  };
  look();
  for (const std::filesystem::path& part : std::filesystem::path(path).relative_path()) {
    if (part == "..") break;  // Above what this process can see.
    group /= part;
    look();
  }
  return least;
}

}  // namespace

std::uint64_t surfaceBytes(GridSize size) {
  return kBytesPerCell * size.count();
}

std::optional<std::uint64_t> availableBytes(const std::filesystem::path& root) {
  std::optional<std::uint64_t> least = freeOnMachine(root);
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    // "0::/user.slice/..." of version 2, "7:cpu,memory:/user/..." of version 1.
    const std::size_t list = line.find(':');
    const std::size_t path = list == std::string::npos ? list : line.find(':', list + 1);
    if (path == std::string::npos) continue;
    const std::string controllers = line.substr(list + 1, path - list - 1);
    const bool is_memory = ("," + controllers + ",").find(",memory,") != std::string::npos;
    if (!controllers.empty() && !is_memory) continue;
    const GroupFiles& files = controllers.empty() ? kVersion2 : kVersion1;
    const auto in_groups = freeInGroups(root / files.mount, line.substr(path + 1), files);
    if (in_groups) least = std::min(*in_groups, least.value_or(*in_groups));
  }
  return least;
}

void requireMemory(const GridFrame& frame, std::optional<std::uint64_t> available) {
  if (!available) return;
  const std::uint64_t needed = surfaceBytes(frame.size);
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
