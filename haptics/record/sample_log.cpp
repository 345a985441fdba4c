// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/sample_log.h"

#include <algorithm>

#include "haptics/record/hdf5_log.h"
#include "haptics/record/log_writer.h"

namespace relievo {

std::array<double, kLogColumns.size()> logValues(const HapticSample& s, double t_s) {
  return {t_s,
          static_cast<double>(s.tick),
          s.hip_view.x,
          s.hip_view.y,
          s.hip_view.z,
          s.proxy_view.x,
          s.proxy_view.y,
          s.proxy_view.z,
          s.force.x,
          s.force.y,
          s.force.z,
          s.f_cmd_n,
          s.clamped ? 1.0 : 0.0,
          s.contact ? 1.0 : 0.0,
          s.normal.x,
          s.normal.y,
          s.normal.z,
          1000 * s.stiffness_n_per_mm,
          static_cast<double>(s.detail),
          static_cast<double>(s.window_id),
          static_cast<double>(s.origin),
          static_cast<double>(s.buttons),
          s.rate_hz,
          s.hip.x,
          s.hip.y,
          s.hip.z,
          s.proxy.x,
          s.proxy.y,
          s.proxy.z,
          s.age_s};
}

std::string_view headerLine(std::string_view header, std::string_view word) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    const std::string_view line = header.substr(0, end);
    if (line.starts_with(word)) return line.substr(word.size());
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return {};
}

std::unique_ptr<SampleLog> openLog(const std::filesystem::path& file, std::string_view header,
                                   const HapticSpace* surface, LogKind kind) {
  const std::string ending = file.extension().string();
  if (ending == ".h5" || ending == ".hdf5") {
    return std::make_unique<Hdf5Log>(file, header, surface);
  }
  return std::make_unique<LogWriter>(file, header, kind);
}

}  // namespace relievo
