// SPDX-License-Identifier: BSD-3-Clause
// The paper's force figure (fig. 8) for all proxies side by side, as one SVG:
//   force_panels OUT.svg ROW:COLUMN:LOG.csv ...
// Logs of one row share their axes.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "app/cli/verbs/svg.h"

namespace relievo::batch {
namespace {

struct Point {
  double t_s = 0, force_n = 0;
};
using Curve = std::vector<Point>;

/// Times and norms of the force; the log's columns are found by name.
Curve readLog(const std::string& file) {
  std::ifstream in(file);
  std::vector<std::size_t> columns;
  Curve curve;
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields;
    std::istringstream text(line);
    for (std::string field; std::getline(text, field, ',');) fields.push_back(field);
    if (columns.empty()) {
      for (const char* name : {"t_s", "f_x_N", "f_y_N", "f_z_N"}) {
        const auto at = std::find(fields.begin(), fields.end(), name);
        if (at == fields.end()) return {};
        columns.push_back(static_cast<std::size_t>(at - fields.begin()));
      }
      continue;
    }
    const auto number = [&](std::size_t i) { return std::stod(fields.at(columns[i])); };
    curve.push_back({number(0), std::hypot(number(1), number(2), number(3))});
  }
  return curve;
}

/// Largest change of force from tick to tick.
double largestStep(const Curve& curve) {
  double largest = 0;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    largest = std::max(largest, std::abs(curve[i].force_n - curve[i - 1].force_n));
  }
  return largest;
}

constexpr double kPanelWidth = 250, kPanelHeight = 170, kLeft = 56, kTop = 40, kGap = 46;

std::string panel(const Curve& curve, double left, double top, Axis time, Axis force) {
  const auto x = [&](double t) {
    return left + (t - time.low) / (time.high - time.low) * (kPanelWidth - 14);
  };
  const auto y = [&](double n) {
    return top + kPanelHeight * (1 - (n - force.low) / (force.high - force.low));
  };
  std::string svg;
  for (double n = force.low; n <= force.high + 0.5 * force.step; n += force.step) {
    svg += lineAt(left, y(n), left + kPanelWidth - 14, y(n), "#dddddd");
    if (left < kLeft + 1) svg += textAt(left - 6, y(n) + 4, "end", tickText(n, force.step));
  }
  for (double t = time.low; t <= time.high + 0.5 * time.step; t += time.step) {
    svg += lineAt(x(t), top, x(t), top + kPanelHeight, "#dddddd");
    svg += textAt(x(t), top + kPanelHeight + 15, "middle", tickText(t, time.step));
  }
  // Two points per bin keep the chatter's height at a tenth of the points.
  svg += "<polyline fill='none' stroke='#1f4e9c' stroke-width='0.8' points='";
  constexpr std::size_t kBin = 10;
  for (std::size_t i = 0; i < curve.size(); i += kBin) {
    const auto first = curve.begin() + static_cast<std::ptrdiff_t>(i);
    const auto last = curve.begin() + static_cast<std::ptrdiff_t>(std::min(i + kBin, curve.size()));
    auto [low, high] = std::minmax_element(
        first, last, [](const Point& a, const Point& b) { return a.force_n < b.force_n; });
    if (low->t_s > high->t_s) std::swap(low, high);
    for (const Point& p : {*low, *high}) {
      svg += fixedDigits(x(p.t_s), 1) + "," + fixedDigits(y(p.force_n), 1) + " ";
    }
  }
  svg += "'/>\n";
  return svg + textAt(left + kPanelWidth - 18, top + kPanelHeight - 8, "end",
                      "largest step per tick " + fixedDigits(largestStep(curve), 4) + " N");
}

struct Row {
  std::string name;
  std::vector<std::pair<std::string, Curve>> columns;
};

Axis forceAxis(const Row& row) {
  double most = 0;
  for (const auto& [name, curve] : row.columns) {
    for (const Point& p : curve) most = std::max(most, p.force_n);
  }
  return axisFor(0, most);
}

std::string figure(const std::vector<Row>& rows) {
  const double width = kLeft + kPanelWidth * static_cast<double>(rows.front().columns.size());
  const double height = kTop + (kPanelHeight + kGap) * static_cast<double>(rows.size());
  const std::string size =
      "width='" + fixedDigits(width, 0) + "' height='" + fixedDigits(height, 0) + "'";
  std::string svg = "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " +
                    fixedDigits(width, 0) + " " + fixedDigits(height, 0) + "' " + size +
                    " font-family='sans-serif' font-size='11'>\n<rect " + size +
                    " fill='white'/>\n";
  double top = kTop;
  for (const Row& row : rows) {
    const Axis force = forceAxis(row);
    double left = kLeft;
    for (const auto& [name, curve] : row.columns) {
      const Axis time = axisFor(curve.front().t_s, curve.back().t_s);
      svg += panel(curve, left, top, time, force);
      if (top == kTop) svg += textAt(left, 24, "start", escaped(name), " font-size='13'");
      left += kPanelWidth;
    }
    const double middle = top + 0.5 * kPanelHeight;
    svg += textAt(14, middle, "middle", escaped(row.name) + ": force, N",
                  " transform='rotate(-90 14 " + fixedDigits(middle, 1) + ")'");
    svg += textAt(kLeft, top + kPanelHeight + 30, "start", "time, s");
    top += kPanelHeight + kGap;
  }
  return svg + "</svg>\n";
}

int draw(int argc, char** argv) {
  std::vector<Row> rows;
  for (int i = 2; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t first = text.find(':'), second = text.find(':', first + 1);
    const std::string name = text.substr(0, first), file = text.substr(second + 1);
    if (rows.empty() || rows.back().name != name) rows.push_back({name, {}});
    Curve curve = readLog(file);
    if (curve.size() < 2) {
      std::cerr << file << " has no forces.\n";
      return 1;
    }
    rows.back().columns.emplace_back(text.substr(first + 1, second - first - 1), std::move(curve));
  }
  std::ofstream out(argv[1]);
  out << figure(rows);
  out.close();
  return out ? 0 : 1;
}

}  // namespace
}  // namespace relievo::batch

int main(int argc, char** argv) {
  if (argc < 3) {
    std::cerr << "usage: force_panels OUT.svg ROW:COLUMN:LOG.csv ...\n";
    return 1;
  }
  return relievo::batch::draw(argc, argv);
}
