// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/stroke.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

#include "core/base/failure.h"
#include "haptics/loop/device_limits.h"

namespace relievo {

namespace {
constexpr std::string_view kHeader = "t_s,x_mm,y_mm,z_mm";

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

/// The numbers of one row, or what is wrong with it.
std::string parseRow(std::string_view line, StrokePoint& point) {
  const std::array<double*, 4> fields{&point.t_s, &point.x_mm, &point.y_mm, &point.z_mm};
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool last = i + 1 == fields.size();
    const std::size_t comma = line.find(',');
    if (last != (comma == std::string_view::npos)) return "does not have 4 values";
    const std::string_view text = trimmed(line.substr(0, comma));
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), *fields[i]);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(*fields[i])) {
      return "has \"" + std::string(text) + "\" where a finite number is expected";
    }
    if (!last) line.remove_prefix(comma + 1);
  }
  return {};
}

/// Follows a stroke; times are asked for in increasing order.
class StrokeCursor {
 public:
  explicit StrokeCursor(const Stroke& stroke) : points_(stroke.points) {}
  std::array<double, 3> at(double t_s) {
    while (next_ < points_.size() && points_[next_].t_s <= t_s) ++next_;
    if (next_ == points_.size()) return {last().x_mm, last().y_mm, last().z_mm};
    if (next_ == 0) return {points_[0].x_mm, points_[0].y_mm, points_[0].z_mm};
    const StrokePoint& a = points_[next_ - 1];
    const StrokePoint& b = points_[next_];
    const double part = (t_s - a.t_s) / (b.t_s - a.t_s);
    return {a.x_mm + part * (b.x_mm - a.x_mm), a.y_mm + part * (b.y_mm - a.y_mm),
            a.z_mm + part * (b.z_mm - a.z_mm)};
  }

 private:
  const StrokePoint& last() const { return points_.back(); }
  const std::vector<StrokePoint>& points_;
  std::size_t next_ = 0;
};
}  // namespace

HapticOptions strokeHapticOptions(const StrokeOptions& options) {
  HapticOptions core;
  core.proxy = options.proxy;
  core.stiffness_by_detail = options.stiffness_by_detail;
  core.detail_stiffness = options.detail_stiffness;
  core.fields = options.fields;
  core.force.transient = options.transient;
  core.force.stiffness_n_per_mm = options.stiffness_n_per_mm;
  core.force.damping_n_s_per_mm = options.damping_n_s_per_mm;
  core.force.strength = options.strength;
  core.force.forces_on = true;
  return options.device != nullptr ? withinDevice(core, options.device->info()) : core;
}

Stroke readStroke(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!in || std::filesystem::is_directory(file)) throw failure<MessageId::stroke_unreadable>(file);
  Stroke stroke;
  bool have_header = false;
  std::size_t row = 0;
  while (std::getline(in, line)) {
    std::string_view text = line;
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    text = trimmed(text);
    if (text.empty() || text.front() == '#') continue;
    if (!have_header) {
      if (text != kHeader) {
        throw failure<MessageId::stroke_without_header>(file, kHeader);
      }
      have_header = true;
      continue;
    }
    ++row;
    StrokePoint point;
    const std::string wrong = parseRow(text, point);
    if (!wrong.empty()) throw failure<MessageId::stroke_row_wrong>(file, row, wrong);
    if (!stroke.points.empty() && !(point.t_s > stroke.points.back().t_s)) {
      throw failure<MessageId::stroke_row_not_later>(file, row);
    }
    stroke.points.push_back(point);
  }
  if (in.bad()) throw failure<MessageId::stroke_cut>(file);
  if (stroke.points.empty()) throw failure<MessageId::stroke_without_rows>(file);
  return stroke;
}

ViewMm strokePlaceAt(const Stroke& stroke, double t_s) {
  const auto next =
      std::upper_bound(stroke.points.begin(), stroke.points.end(), t_s,
                       [](double t, const StrokePoint& point) { return t < point.t_s; });
  const auto place = [](const StrokePoint& p) { return ViewMm{p.x_mm, p.y_mm, p.z_mm}; };
  if (next == stroke.points.begin()) return place(stroke.points.front());
  if (next == stroke.points.end()) return place(stroke.points.back());
  const ViewMm a = place(*(next - 1)), b = place(*next);
  return a + ((t_s - (next - 1)->t_s) / (next->t_s - (next - 1)->t_s)) * (b - a);
}

std::uint64_t strokeTicks(const Stroke& stroke) {
  if (stroke.points.empty()) return 0;
  const double seconds = stroke.points.back().t_s - stroke.points.front().t_s;
  constexpr double kLongestSeconds = 1e7;  // Four months; beyond, a time is in the wrong unit.
  if (!(seconds <= kLongestSeconds)) {
    throw failure<MessageId::stroke_too_long>(NumberArgument{.value = seconds, .digits = 6});
  }
  return static_cast<std::uint64_t>(std::floor(seconds / 0.001 + 1e-6)) + 1;
}

std::uint64_t runStroke(const HapticSpace& space, const StrokeOptions& options,
                        const Stroke& stroke,
                        const std::function<void(const HapticSample&, double t_s)>& each,
                        const Task& task) {
  if (stroke.points.empty()) throw failure<MessageId::stroke_without_points>();
  if (!(options.stiffness_n_per_mm > 0) || !std::isfinite(options.stiffness_n_per_mm)) {
    throw failure<MessageId::stroke_stiffness>();
  }
  if (!(options.damping_n_s_per_mm >= 0) || !std::isfinite(options.damping_n_s_per_mm)) {
    throw failure<MessageId::stroke_damping>();
  }
  const HapticOptions core_options = strokeHapticOptions(options);
  const double start_s = stroke.points.front().t_s;
  const std::uint64_t ticks = strokeTicks(stroke);
  StrokeCursor cursor(stroke);
  HapticCore core(options.chain);
  for (std::uint64_t n = 0; n < ticks; ++n) {
    constexpr std::uint64_t kTicksPerCheck = 1024;
    if (n % kTicksPerCheck == 0) task.check();
    const double t_s = start_s + static_cast<double>(n) / 1000;
    const auto [x, y, z] = cursor.at(t_s);
    const auto now_ns = static_cast<std::int64_t>(n) * 1'000'000;
    const DeviceMm aim =
        options.frame == StrokeFrame::device ? DeviceMm{x, y, z} : space.deviceFromView({x, y, z});
    DeviceReading reading{aim, 0, now_ns, DeviceFault::none};
    if (options.device != nullptr) {
      n == 0 ? options.device->placeAt(aim) : options.device->moveTo(aim);
      reading = options.device->read(now_ns);
    }
    HapticSample sample = core.tick(space, core_options, reading, now_ns);
    if (options.device != nullptr) options.device->send(sample.force, now_ns);
    sample.rate_hz = 1000;
    each(sample, t_s);
  }
  return ticks;
}

}  // namespace relievo
