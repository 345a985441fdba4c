// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/force_curve.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace relievo {
namespace {

/// Fields of a line; commas inside quotes do not separate.
std::vector<std::string_view> fieldsOf(std::string_view line) {
  std::vector<std::string_view> fields;
  bool quoted = false;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    if (i < line.size() && line[i] == '"') quoted = !quoted;
    if (i == line.size() || (line[i] == ',' && !quoted)) {
      fields.push_back(line.substr(start, i - start));
      start = i + 1;
    }
  }
  return fields;
}

constexpr std::array<std::string_view, 6> kColumns{"t_s",   "hip_z_mm", "proxy_z_mm",
                                                   "f_x_N", "f_y_N",    "f_z_N"};

}  // namespace

std::vector<ForceCurveRow> readForceCurve(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::string name = file.filename().string();
  if (!in) throw FileError("The recording '" + name + "' cannot be read. Choose another file.");
  std::array<std::size_t, kColumns.size()> places{};
  bool has_header = false;
  std::vector<ForceCurveRow> rows;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line.empty() || line.front() == '#') continue;
    const std::vector<std::string_view> fields = fieldsOf(line);
    if (!has_header) {
      for (std::size_t i = 0; i < kColumns.size(); ++i) {
        const auto found = std::find(fields.begin(), fields.end(), kColumns[i]);
        if (found == fields.end()) {
          throw FileError("'" + name + "' is no recording: it has no column '" +
                          std::string(kColumns[i]) + "'. Choose another file.");
        }
        places[i] = static_cast<std::size_t>(found - fields.begin());
      }
      has_header = true;
      continue;
    }
    std::array<double, kColumns.size()> v{};
    for (std::size_t i = 0; i < v.size(); ++i) {
      const std::string_view text = places[i] < fields.size() ? fields[places[i]] : "";
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), v[i]);
      if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(v[i])) {
        throw FileError("'" + name + "', line " + std::to_string(number) + ": '" +
                        std::string(text) + "' is not a number.");
      }
    }
    rows.push_back({.t_s = v[0],
                    .hip_z_mm = v[1],
                    .proxy_z_mm = v[2],
                    .force_n = std::hypot(v[3], v[4], v[5])});
  }
  if (rows.empty()) throw FileError("'" + name + "' has no rows to plot. Choose another file.");
  return rows;
}

}  // namespace relievo
