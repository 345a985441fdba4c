// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "core/recording/touch_row.h"

namespace relievo {

/// What a column's values are; CSV writes integers without a point or an exponent.
enum class ColumnType : std::uint8_t { real, integer, text };

/// For what a recording is read. Each use needs all columns that the ones before it need; `nothing`
/// is no use: its columns came later, and whoever reads a recording does without them.
enum class LogUse : std::uint8_t { plot, show, replay, nothing };

/// One column of a recording: what files call it, and which member of TouchRow it holds.
struct LogColumn {
  std::string_view name, unit, description;
  ColumnType type = ColumnType::text;
  LogUse needed_by = LogUse::replay;
  bool is_recomputed = false;  ///< By a replay; else a replay is given it.
  // Null of text, which no row has. Every number is exact in a double.
  double (*value)(const TouchRow&) = nullptr;
  /// @return false: the member cannot have this value
  bool (*set_value)(TouchRow&, double) = nullptr;
};

// How the table below is made from members.
namespace columns {

/// A member, or one axis of a member that is a Vec3.
template <auto Member, auto Axis, class Row>
constexpr auto& memberOf(Row& row) {
  if constexpr (std::is_null_pointer_v<decltype(Axis)>) {
    return row.*Member;
  } else {
    return (row.*Member).*Axis;
  }
}

template <class Number>
bool take(Number& to, double value) {
  if constexpr (std::is_same_v<Number, double>) {
    to = value;
    return true;
  } else {
    constexpr bool kIsOrigin = std::is_same_v<Number, CellStatus>;
    constexpr double kMostExact = 9007199254740992.0;  // 2^53
    using Limits = std::numeric_limits<std::conditional_t<kIsOrigin, std::uint8_t, Number>>;
    constexpr double kMost = kIsOrigin             ? kOriginCount - 1
                             : Limits::digits > 53 ? kMostExact
                                                   : static_cast<double>(Limits::max());
    constexpr auto kLeast = static_cast<double>(Limits::min());
    const bool fits = value >= kLeast && value <= kMost && value == std::floor(value);
    if (fits) to = static_cast<Number>(value);
    return fits;
  }
}

enum class From : bool { device, arithmetic };

template <auto Member, auto Axis = nullptr>
constexpr LogColumn of(LogUse needed_by, From from, std::string_view name, std::string_view unit,
                       std::string_view description) {
  using Number = std::remove_cvref_t<decltype(memberOf<Member, Axis>(std::declval<TouchRow&>()))>;
  return {
      .name = name,
      .unit = unit,
      .description = description,
      .type = std::is_same_v<Number, double> ? ColumnType::real : ColumnType::integer,
      .needed_by = needed_by,
      .is_recomputed = from == From::arithmetic,
      .value = [](const TouchRow& row) { return static_cast<double>(memberOf<Member, Axis>(row)); },
      .set_value = [](TouchRow& row,
                      double value) { return take(memberOf<Member, Axis>(row), value); }};
}

}  // namespace columns

/// All columns in their order. From this list the CSV and HDF5 files are written and read, replays
/// compare, and a test checks docs/user/reference.md.
inline constexpr auto kLogColumns = [] {
  using columns::of;
  using enum columns::From;
  using enum LogUse;
  using R = TouchRow;
  using View = ViewMm;
  using Hand = DeviceMm;
  // clang-format off
  return std::to_array<LogColumn>({
      of<&R::t_s>(plot, device, "t_s", "s", "time since the start of the log, or the stroke's"),
      of<&R::tick>(show, arithmetic, "tick", "1", "number of the loop's tick; a gap was dropped"),
      of<&R::hip, &View::x>(show, arithmetic, "hip_x_mm", "mm", "hand, on the object"),
      of<&R::hip, &View::y>(show, arithmetic, "hip_y_mm", "mm", "hand, on the object"),
      of<&R::hip, &View::z>(plot, arithmetic, "hip_z_mm", "mm", "hand, on the object"),
      of<&R::proxy, &View::x>(show, arithmetic, "proxy_x_mm", "mm", "proxy, on the object"),
      of<&R::proxy, &View::y>(show, arithmetic, "proxy_y_mm", "mm", "proxy, on the object"),
      of<&R::proxy, &View::z>(plot, arithmetic, "proxy_z_mm", "mm", "proxy, on the object"),
      of<&R::force, &DeviceN::x>(plot, arithmetic, "f_x_N", "N", "force on the hand, after all stages"),
      of<&R::force, &DeviceN::y>(plot, arithmetic, "f_y_N", "N", "force on the hand, after all stages"),
      of<&R::force, &DeviceN::z>(plot, arithmetic, "f_z_N", "N", "force on the hand, after all stages"),
      of<&R::unlimited_n>(replay, arithmetic, "f_cmd_N", "N", "size of the force before limits"),
      of<&R::clamped>(replay, arithmetic, "clamp", "1", "1: a limit changed the force"),
      of<&R::contact>(show, arithmetic, "contact", "1", "1: the proxy touches"),
      of<&R::normal, &View::x>(replay, arithmetic, "nx", "1", "surface normal at the proxy"),
      of<&R::normal, &View::y>(replay, arithmetic, "ny", "1", "surface normal at the proxy"),
      of<&R::normal, &View::z>(replay, arithmetic, "nz", "1", "surface normal at the proxy"),
      of<&R::stiffness_n_per_m>(replay, arithmetic, "k_Npm", "N/m", "stiffness, per metre of hand"),
      of<&R::detail>(show, arithmetic, "detail", "1", "resolution of the window; 1 is the whole"),
      of<&R::window_id>(show, arithmetic, "region_id", "1", "number of the window"),
      of<&R::origin>(show, arithmetic, "origin", "1", "0 measured, 1 interpolated, 2 base, 3 steep, 4 outside"),
      of<&R::buttons>(replay, device, "buttons", "1", "bit i: button i is down; bit 4: the hand hovers"),
      of<&R::rate_hz>(replay, device, "rate_Hz", "Hz", "measured rate of the loop"),
      LogColumn{.name = "event", .unit = "", .description = "what happened; also notes, as note at tick N: TEXT"},
      of<&R::hand_hip, &Hand::x>(replay, device, "dev_hip_x_mm", "mm", "hand, in its workspace"),
      of<&R::hand_hip, &Hand::y>(replay, device, "dev_hip_y_mm", "mm", "hand, in its workspace"),
      of<&R::hand_hip, &Hand::z>(replay, device, "dev_hip_z_mm", "mm", "hand, in its workspace"),
      of<&R::hand_proxy, &Hand::x>(replay, arithmetic, "dev_proxy_x_mm", "mm", "proxy, in the hand's workspace"),
      of<&R::hand_proxy, &Hand::y>(replay, arithmetic, "dev_proxy_y_mm", "mm", "proxy, in the hand's workspace"),
      of<&R::hand_proxy, &Hand::z>(replay, arithmetic, "dev_proxy_z_mm", "mm", "proxy, in the hand's workspace"),
      of<&R::age_s>(replay, device, "age_s", "s", "age of the position")});
  // clang-format on
}();

/// Those that are numbers; HDF5 keeps events apart.
inline constexpr std::array<LogColumn, kLogColumns.size() - 1> kNumberColumns = [] {
  std::array<LogColumn, kLogColumns.size() - 1> numbers{};
  std::copy_if(kLogColumns.begin(), kLogColumns.end(), numbers.begin(),
               [](const LogColumn& column) { return column.type != ColumnType::text; });
  return numbers;
}();

/// Their names as the line of a CSV log, without a line end.
std::string logColumns();

}  // namespace relievo
