// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measure_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace relievo {
namespace {

std::string numberText(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

/// For people: four significant digits.
std::string shortText(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value == 0 ? 0 : value,
                                     std::chars_format::general, 4)
                           .ptr};
}

std::string comments(std::string_view header) {
  std::string text;
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    text.append("# ").append(header.substr(0, end)).append("\n");
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return text;
}

std::string cellOfCsv(std::string_view name) {
  std::string text = "\"";
  for (const char c : name) {
    if (c == '"') text += '"';
    text += (c == '\n' || c == '\r') ? ' ' : c;
  }
  return text + '"';
}

std::string placesText(const Measurement& m) {
  std::string text;
  for (const PlaceMm& place : m.places) {
    text += (text.empty() ? "" : "; ") + numberText(place.x) + " " + numberText(place.y);
  }
  return text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

// ---- drawing of a profile ------------------------------------------------------------------

constexpr double kWidth = 640, kHeight = 300;
constexpr const char* kSheet =
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 640 300' width='640' height='300' "
    "font-family='sans-serif' font-size='11'>\n<rect width='640' height='300' fill='white'/>\n";
constexpr double kLeft = 64, kRight = 20, kTop = 36, kBottom = 48;

/// 1, 2 or 5 times a power of ten; about four ticks over a range.
double tickStep(double range) {
  const double rough = range / 4;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) return factor * power;
  }
  return 10 * power;
}

struct Axis {
  double low = 0, high = 1;       ///< Millimetres.
  double from_px = 0, to_px = 1;  ///< Of low and of high.
  double px(double mm) const { return from_px + (mm - low) / (high - low) * (to_px - from_px); }
};

std::string textAt(double x, double y, std::string_view anchor, std::string_view text) {
  return "<text x='" + shortText(x) + "' y='" + shortText(y) + "' text-anchor='" +
         std::string(anchor) + "'>" + escaped(text) + "</text>\n";
}

std::string lineFrom(double x0, double y0, double x1, double y1) {
  return "<line x1='" + shortText(x0) + "' y1='" + shortText(y0) + "' x2='" + shortText(x1) +
         "' y2='" + shortText(y1) + "' stroke='#888888'/>\n";
}

std::string ticks(const Axis& along, const Axis& height) {
  std::string svg;
  const double step_x = tickStep(along.high - along.low);
  for (double mm = std::ceil(along.low / step_x) * step_x; mm <= along.high; mm += step_x) {
    svg += lineFrom(along.px(mm), kHeight - kBottom, along.px(mm), kHeight - kBottom + 5);
    svg += textAt(along.px(mm), kHeight - kBottom + 18, "middle", shortText(mm));
  }
  const double step_z = tickStep(height.high - height.low);
  for (double mm = std::ceil(height.low / step_z) * step_z; mm <= height.high; mm += step_z) {
    svg += lineFrom(kLeft - 5, height.px(mm), kLeft, height.px(mm));
    svg += textAt(kLeft - 8, height.px(mm) + 4, "end", shortText(mm));
  }
  return svg;
}

/// Heights with an axis of the same scale as `along`, if the relief is still to be seen then.
Axis heightAxis(const std::vector<ProfileRow>& rows, const Axis& along, bool& same_scale) {
  double low = rows.front().point.at.z;
  double high = low;
  for (const ProfileRow& row : rows) {
    low = std::min(low, row.point.at.z);
    high = std::max(high, row.point.at.z);
  }
  const double px = kHeight - kTop - kBottom;
  const double true_range = (along.high - along.low) * px / (along.to_px - along.from_px);
  const double range = high - low;
  same_scale = range <= true_range && range >= 0.1 * (along.high - along.low);
  const double shown = same_scale ? true_range : std::max(1.1 * range, 1e-9);
  const double middle = 0.5 * (low + high);
  return {.low = middle - 0.5 * shown,
          .high = middle + 0.5 * shown,
          .from_px = kHeight - kBottom,
          .to_px = kTop};
}

std::string curves(const std::vector<ProfileRow>& rows, const Axis& along, const Axis& height) {
  std::string svg;
  const auto measured = [](const ProfileRow& row) {
    return row.point.origin == CellStatus::measured;
  };
  for (std::size_t i = 1; i < rows.size();) {
    if (!rows[i].joined) {
      ++i;  // Between them the line is not on the object.
      continue;
    }
    const bool solid = measured(rows[i]) && measured(rows[i - 1]);
    svg += "<polyline fill='none' stroke='#1f5fd0' stroke-width='1.5'" +
           std::string(solid ? "" : " stroke-dasharray='4 3'") + " points='" +
           shortText(along.px(rows[i - 1].along_mm)) + "," +
           shortText(height.px(rows[i - 1].point.at.z));
    const auto goes_on = [&](std::size_t k) {
      return rows[k].joined && (measured(rows[k]) && measured(rows[k - 1])) == solid;
    };
    for (; i < rows.size() && goes_on(i); ++i) {
      svg += " " + shortText(along.px(rows[i].along_mm)) + "," +
             shortText(height.px(rows[i].point.at.z));
    }
    svg += "'/>\n";
  }
  return svg;
}

// ---- drawing of a section -------------------------------------------------------------------

/// Two directions in a plane at right angles; the second as far upward as it can be.
struct InPlane {
  ViewMm right, up;

  explicit InPlane(const ViewMm& normal) {
    const double across = std::hypot(normal.x, normal.y);
    const double length = norm(normal);
    right =
        across > 1e-9 * length ? ViewMm{-normal.y / across, normal.x / across, 0} : ViewMm{1, 0, 0};
    if (right.x < 0 || (right.x == 0 && right.y < 0)) right = -1.0 * right;
    const ViewMm n = (1 / length) * normal;
    up = {n.y * right.z - n.z * right.y, n.z * right.x - n.x * right.z,
          n.x * right.y - n.y * right.x};
    if (up.z < 0 || (up.z == 0 && up.y < 0)) up = -1.0 * up;
  }
};

/// An axis around `low` ... `high`, `px_per_mm` to scale.
Axis axisAround(double low, double high, double px_per_mm, double from_px, double to_px) {
  const double half = 0.5 * std::abs(to_px - from_px) / px_per_mm;
  const double middle = 0.5 * (low + high);
  return {.low = middle - half, .high = middle + half, .from_px = from_px, .to_px = to_px};
}

bool isLevel(const ViewMm& normal) {
  return std::hypot(normal.x, normal.y) <= 1e-9 * norm(normal);
}

bool isUpright(const ViewMm& normal) {
  return std::abs(normal.z) <= 1e-9 * norm(normal);
}

}  // namespace

std::string planeNumbers(const Measurement& m) {
  if (m.kind == MeasureKind::area) return "0 0 1 " + numberText(m.plane_mm);
  if (m.kind != MeasureKind::section) return {};
  return numberText(m.normal.x) + " " + numberText(m.normal.y) + " " + numberText(m.normal.z) +
         " " + numberText(m.plane_mm);
}

std::string planeText(const Measurement& m, double unit_mm, std::string_view unit) {
  if (!hasPlane(m.kind)) return {};
  const auto length_text = [&](double mm) {
    return shortText(mm / unit_mm) + " " + std::string(unit);
  };
  if (m.kind == MeasureKind::area || isLevel(m.normal)) {
    const double sign = m.kind == MeasureKind::section && m.normal.z < 0 ? -1 : 1;
    return "level at " + length_text(sign * m.plane_mm);
  }
  std::string text = isUpright(m.normal) ? "upright: " : "oblique: ";
  const double length = norm(m.normal);
  std::string between;
  for (const auto& [value, axis] :
       {std::pair{m.normal.x, " x"}, {m.normal.y, " y"}, {m.normal.z, " z"}}) {
    const double part = value / length;
    if (std::abs(part) < 1e-9) continue;
    text += between.empty() ? (part < 0 ? "\u2212" : "") : (part < 0 ? " \u2212 " : " + ");
    text += shortText(std::abs(part)) + axis;
    between = "+";
  }
  return text + " = " + length_text(m.plane_mm);
}

int decimalsFor(double uncertainty) {
  if (!(uncertainty > 0)) return 3;
  const int first_digit = static_cast<int>(std::ceil(-std::log10(uncertainty)));
  return std::clamp(first_digit > 2 ? first_digit : first_digit + 1, 0, 9);
}

std::string sectionSvg(const std::vector<SectionCurve>& curves, const PlaneMm& plane,
                       std::string_view title) {
  std::string svg = kSheet;
  if (curves.empty()) return svg + textAt(kWidth / 2, kHeight / 2, "middle", title) + "</svg>\n";
  const InPlane in(plane.normal);
  const ViewMm first = curves.front().points.front();
  double left = dot(in.right, first);
  double right = left;
  double low = dot(in.up, first);
  double high = low;
  for (const SectionCurve& curve : curves) {
    for (const ViewMm& p : curve.points) {
      left = std::min(left, dot(in.right, p));
      right = std::max(right, dot(in.right, p));
      low = std::min(low, dot(in.up, p));
      high = std::max(high, dot(in.up, p));
    }
  }
  const double px_per_mm = std::min((kWidth - kLeft - kRight) / std::max(right - left, 1e-9),
                                    (kHeight - kTop - kBottom) / std::max(high - low, 1e-9));
  const Axis along = axisAround(left, right, px_per_mm, kLeft, kWidth - kRight);
  const Axis height = axisAround(low, high, px_per_mm, kHeight - kBottom, kTop);
  svg += textAt(kLeft, 20, "start", title) + ticks(along, height);
  svg += lineFrom(kLeft, kTop, kLeft, kHeight - kBottom);
  svg += lineFrom(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom);
  for (const SectionCurve& curve : curves) {
    svg += "<" + std::string(curve.closed ? "polygon" : "polyline") +
           " fill='none' stroke='#1f5fd0' stroke-width='1.2'" +
           (curve.not_measured > 0 ? " stroke-dasharray='4 3'" : "") + " points='";
    for (const ViewMm& p : curve.points) {
      svg +=
          shortText(along.px(dot(in.right, p))) + "," + shortText(height.px(dot(in.up, p))) + " ";
    }
    svg.back() = '\'';
    svg += "/>\n";
  }
  const bool level = isLevel(plane.normal);
  svg += textAt(0.5 * (kLeft + kWidth - kRight), kHeight - 8, "middle",
                level ? "x (mm)" : "along the plane (mm)");
  svg += textAt(kWidth - kRight, 20, "end",
                std::string(level                     ? "y (mm)"
                            : isUpright(plane.normal) ? "height (mm)"
                                                      : "up the plane (mm)") +
                    ", true to scale");
  return svg + "</svg>\n";
}

std::string measurementsCsv(const std::vector<Measured>& list, std::string_view header) {
  std::string text =
      comments(header) + "name,kind,quantity,value,uncertainty,unit,not_measured,plane,places_mm\n";
  for (const auto& [m, reading, problem] : list) {
    if (!reading) {
      text += comments(m.name + ": " + problem);
      continue;
    }
    for (const Quantity& q : reading->quantities) {
      text += cellOfCsv(m.name) + "," + std::string(name(m.kind)) + "," + std::string(q.title) +
              "," + numberText(q.value) + "," + numberText(q.uncertainty) + "," +
              std::string(q.unit) + "," + numberText(reading->not_measured) + "," +
              planeNumbers(m) + "," + placesText(m) + "\n";
    }
  }
  return text;
}

std::string measurementsCsv(const MapCells& map, const std::vector<Measurement>& list,
                            std::string_view header) {
  std::vector<Measured> read_all;
  read_all.reserve(list.size());
  for (const Measurement& m : list) {
    read_all.push_back({.measurement = m, .reading = read(map, m), .problem = {}});
  }
  return measurementsCsv(read_all, header);
}

std::string profileCsv(const std::vector<ProfileRow>& rows, std::string_view header) {
  std::string text = comments(header) + "along_mm,x_mm,y_mm,z_mm,uncertainty_mm,origin\n";
  for (const ProfileRow& row : rows) {
    const SurfacePoint& p = row.point;
    text += numberText(row.along_mm) + "," + numberText(p.at.x) + "," + numberText(p.at.y) + "," +
            numberText(p.at.z) + "," + numberText(p.height_uncertainty_mm) + "," +
            std::to_string(static_cast<int>(p.origin)) + "\n";
  }
  return text;
}

std::string profileSvg(const std::vector<ProfileRow>& rows, std::string_view title) {
  std::string svg = kSheet;
  if (rows.size() < 2) return svg + textAt(kWidth / 2, kHeight / 2, "middle", title) + "</svg>\n";
  const Axis along{.low = rows.front().along_mm,
                   .high = std::max(rows.back().along_mm, rows.front().along_mm + 1e-9),
                   .from_px = kLeft,
                   .to_px = kWidth - kRight};
  bool same_scale = false;
  const Axis height = heightAxis(rows, along, same_scale);
  svg += textAt(kLeft, 20, "start", title);
  svg += ticks(along, height);
  svg += lineFrom(kLeft, kTop, kLeft, kHeight - kBottom);
  svg += lineFrom(kLeft, kHeight - kBottom, kWidth - kRight, kHeight - kBottom);
  svg += curves(rows, along, height);
  svg += textAt(0.5 * (kLeft + kWidth - kRight), kHeight - 8, "middle", "along the line (mm)");
  const double times = (height.from_px - height.to_px) / (height.high - height.low) /
                       ((along.to_px - along.from_px) / (along.high - along.low));
  svg += textAt(kWidth - kRight, 20, "end",
                same_scale ? "height (mm), true to scale"
                           : "height (mm), \u00d7 " + shortText(times) + " of the length's scale");
  return svg + "</svg>\n";
}

std::string sectionCsv(const std::vector<SectionCurve>& curves, std::string_view header) {
  std::string text = comments(header) + "curve,closed,x_mm,y_mm,z_mm\n";
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (const ViewMm& p : curves[i].points) {
      text += std::to_string(i + 1) + (curves[i].closed ? ",1," : ",0,") + numberText(p.x) + "," +
              numberText(p.y) + "," + numberText(p.z) + "\n";
    }
  }
  return text;
}

}  // namespace relievo
