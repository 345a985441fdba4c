// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/control_group.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <thread>

namespace relievo {
namespace {

/// Cores' worth of time that a group pays for; nothing where it has no limit.
std::optional<double> coresOf(const ControlGroup& group) {
  double quota = 0;
  double period = 0;
  if (group.is_second) {
    std::ifstream(group.folder / "cpu.max") >> quota >> period;  // "max 100000": no number.
  } else {
    std::ifstream(group.folder / "cpu.cfs_quota_us") >> quota;  // -1: no limit.
    std::ifstream(group.folder / "cpu.cfs_period_us") >> period;
  }
  if (!(quota > 0 && period > 0)) return std::nullopt;
  return quota / period;
}

int coresBoundTo() {
  cpu_set_t set;
  CPU_ZERO(&set);
  const bool known = ::sched_getaffinity(0, sizeof(set), &set) == 0;  // Not where there are > 1024.
  const int cores = known ? CPU_COUNT(&set) : static_cast<int>(std::thread::hardware_concurrency());
  return std::max(cores, 1);
}

}  // namespace

void forEachControlGroup(const std::filesystem::path& root, std::string_view controller,
                         const std::function<void(const ControlGroup&)>& look) {
  std::ifstream groups(root / "proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    // "0::/user.slice/..." of version 2, "7:cpu,memory:/user/..." of version 1.
    const std::size_t list = line.find(':');
    const std::size_t path = list == std::string::npos ? list : line.find(':', list + 1);
    if (path == std::string::npos) continue;
    const std::string controllers = "," + line.substr(list + 1, path - list - 1) + ",";
    const bool is_second = controllers == ",,";
    const std::string wanted = "," + std::string(controller) + ",";
    if (!is_second && controllers.find(wanted) == std::string::npos) continue;
    ControlGroup group{root / "sys/fs/cgroup", is_second};
    if (!is_second) group.folder /= controller;
    look(group);
    const std::filesystem::path below = line.substr(path + 1);
    for (const std::filesystem::path& part : below.relative_path()) {
      if (part == "..") break;  // Above what this process can see.
      group.folder /= part;
      look(group);
    }
  }
}

int usableCores(const std::filesystem::path& root) {
  double cores = coresBoundTo();
  forEachControlGroup(root, "cpu", [&](const ControlGroup& group) {
    if (const auto paid = coresOf(group)) cores = std::min(cores, std::ceil(*paid));
  });
  return std::max(static_cast<int>(cores), 1);
}

}  // namespace relievo
