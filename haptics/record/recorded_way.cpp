// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/recorded_way.h"

#include <fstream>
#include <string>

#include "core/recording/log_table.h"
#include "haptics/record/stroke.h"

namespace relievo {

namespace {
/// A stroke of four columns begins with its header; a recording with lines that say what it is.
bool isRecording(const std::filesystem::path& file) {
  if (isHdf5Name(file)) return true;
  std::ifstream in(file);
  std::string line;
  return std::getline(in, line) && line.find("# relievo ") != std::string::npos;
}
}  // namespace

std::vector<WayPoint> readWay(const std::filesystem::path& file, const Task& task) {
  std::vector<WayPoint> way;
  if (isRecording(file)) {
    for (const TouchRow& row : readLog(file, LogUse::plot, task).rows) {
      way.push_back({row.t_s, row.proxy});
    }
    return way;
  }
  for (const StrokePoint& p : readStroke(file).points) {
    way.push_back({p.t_s, {p.x_mm, p.y_mm, p.z_mm}});
  }
  return way;
}

}  // namespace relievo
