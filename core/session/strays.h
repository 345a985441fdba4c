// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/message/message.h"
#include "core/tiles/points/point_source.h"

namespace relievo {

/// What becomes of strays: few points so far away that they stretch the box around a scan to
/// several times the object (docs/adr/0100-strays.md).
enum class StrayRule {
  drop,        ///< Strays go; groups, which may be what somebody scanned, stay and are told.
  keep,        ///< Both stay.
  drop_groups  ///< Both go.
};

/// What was found. Of a mesh its vertices; of those that no face uses all that lie beyond the rest.
struct Strays {
  std::uint64_t points = 0;  ///< Strays; 0: none.
  std::uint64_t all = 0;     ///< Points looked at.
  double share_of_box = 0;   ///< Of the box's side that they stretch most: how much is theirs.
  bool kept = false;         ///< They are part of the surface.
  std::uint64_t unused = 0;  ///< Of `points`, the vertices that no face uses.

  std::uint64_t grouped = 0;        ///< Points of groups; 0: none.
  double share_of_box_grouped = 0;  ///< As share_of_box, of the box without strays.
  bool groups_kept = false;         ///< They are part of the surface.
};

/// "12 of 20 000 points lie 99 % of the box away from all others; they were left out." Then, of a
/// mesh: "2 vertices belong to no face and lie outside of the object; they were left out." Then:
/// "150 of 20 000 points lie together 90 % of the box away from all others; they were kept, as they
/// may belong to the object." Empty: none.
std::vector<Message> strayWords(const Strays& strays);
/// The same of a file that is only looked at: what surfaces of it are made without.
/// @param strays  what StrayRule::drop finds
std::vector<Message> strayWordsOfFile(const Strays& strays);

/// The strays of a scan, along the file's axes. [worker]
Strays straysOf(const Scan& scan, const Task& task = {});

/// The part of a scan that a surface is made from.
class ScanInUse {
 public:
  /// Leaves out, if `missing_height` says so, points whose height (file z) stands for none, then
  /// strays along the file's axes unless they are to be kept. [worker]
  /// @throw FileError  nothing is left; Cancelled
  ScanInUse(const Scan& whole, StrayRule rule, std::optional<double> missing_height,
            const Task& task);
  /// Also strays along the axes (rows) of a view, where they are not the file's. [worker]
  void dropAlong(const std::array<double, 9>& axes, const Task& task);

  const Scan& scan() const { return part_ ? *part_ : whole_; }
  const Strays& strays() const { return strays_; }
  std::uint64_t missing() const { return missing_; }

 private:
  const Scan& whole_;
  StrayRule rule_;
  std::optional<Scan> part_;  ///< Nothing: all of it.
  Strays strays_;
  std::uint64_t missing_ = 0;
};

/// How like numbers name the same height: files keep it in float or as text.
bool isHeight(double z, double value, double origin_z) noexcept;

}  // namespace relievo
