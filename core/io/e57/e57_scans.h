// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/message/message.h"

namespace relievo {

/// One number of every record, stored in a byte stream of its own.
struct E57Field {
  enum class Kind : std::uint8_t { f32, f64, whole, other };
  std::string name;
  Kind kind = Kind::other;
  unsigned bits = 0;         ///< Of each number; 0: all records have the minimum.
  std::int64_t minimum = 0;  ///< Added to the stored bits.
  double scale = 1, offset = 0;
  std::optional<std::array<double, 2>> limits = {};  ///< Smallest and largest value, if stated.
};

/// From the scanner's axes to those of the file.
struct E57Pose {
  std::array<double, 9> rotation{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< Row-major.
  std::array<double, 3> translation{};

  std::array<double, 3> operator()(const std::array<double, 3>& p) const noexcept {
    std::array<double, 3> moved = translation;
    for (std::size_t row = 0; row < 3; ++row) {
      moved[row] = rotation[3 * row] * p[0] + rotation[3 * row + 1] * p[1] +
                   rotation[3 * row + 2] * p[2] + translation[row];
    }
    return moved;
  }
};

struct E57Scan {
  std::string name;              ///< As the file has it; may be empty.
  std::optional<Message> fault;  ///< What makes it unreadable; then the rest is not filled.
  std::uint64_t records = 0;
  std::uint64_t section_at = 0;  ///< Physical place of its binary section.
  std::vector<E57Field> fields;  ///< In the order of their byte streams.
  E57Pose pose;
  bool has_pose = false;
  /// Of red, green and blue, if stated beside the points' own list of fields.
  std::array<std::optional<std::array<double, 2>>, 3> colour_limits;

  std::optional<std::size_t> find(std::string_view field_name) const noexcept;
};

/// The scans that the file's XML lists, in its order, at least one. @throw E57Fault
std::vector<E57Scan> listE57Scans(const std::string& xml);

}  // namespace relievo
