// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "core/message/message.h"
#include "core/prepare/align/align_cloud.h"
#include "core/prepare/align/align_math.h"

/// What two scans say of the pose between them, and what holds it (docs/adr/0093). In the frame of
/// the reference's middle; lengths in file units.
namespace relievo::align {

/// Normals of one place make at least this cosine with each other: 40 degrees.
inline constexpr double kNormalsAgree = 0.766;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// A point of one set and the nearest of the other, where their normals agree.
struct Match {
  Eigen::Vector3d scan, reference;  ///< Places.
  Eigen::Vector3d scan_normal, reference_normal;

  Eigen::Vector3d middle() const { return 0.5 * (scan + reference); }
  /// Of both surfaces: the symmetric objective (Rusinkiewicz 2019).
  Eigen::Vector3d normal() const { return (scan_normal + reference_normal).normalized(); }
  double residual() const { return (reference - scan).dot(normal()); }
};

/// Loose: nearer than `farthest`; tight: nearer than one cell.
struct Matches {
  std::vector<Match> list;  ///< From the scan's points, then from the reference's.
  std::size_t scan_loose = 0, scan_tight = 0;
  std::size_t reference_loose = 0, reference_tight = 0;
};

Matches matchesOf(const OrientedSet& scan, const OrientedSet& reference, const LocalPose& pose,
                  double farthest, const Task& task);

/// Small motions by how firmly the matches hold them (Gelfand et al. 2003). Turns are about
/// `centre` and count by what they move at the mean arm's length.
struct Stability {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double arm = 1;
  Vector6d values = Vector6d::Zero();       ///< Rising; mean square of what a motion of 1 opens.
  Matrix6d vectors = Matrix6d::Identity();  ///< Columns: turn times arm, move.

  double noise = 0;  ///< Values below it may be chance: five standard deviations of a plane's.

  double ratio() const;  ///< Weakest over strongest; [0, 1].
  /// Whether nothing holds the motion of this number.
  bool slides(Eigen::Index motion) const;
};

/// Products of the two scans' normals, not squares of one: what is noise in them is not the same
/// in both, and a smooth plane holds nothing, however rough its points are.
Stability stabilityOf(const std::vector<Match>& matches);

/// What is asked of a pose.
struct Demands {
  double rms_cells = 0.4;  ///< Residuals at most, in cells.
  double tight_of_loose = 0.75;
  double tight_share = 0.15;  ///< Of one of the scans.
  double stability = 0;       ///< Below it is refused.
};
inline constexpr Demands kAutomatic{0.4, 0.75, 0.15, 2e-3};
/// Somebody said where the scan lies: a small overlap is enough, and what slides is kept there.
inline constexpr Demands kStarted{0.4, 0.75, 0.05, 0};

inline constexpr double kLooseCells = 3;
inline constexpr double kHolds = 1e-3;  ///< Ratio of stability that holds in every direction.
/// Below it nothing holds: the start is kept. Planes have 0 to 1e-6, 0.2 mm of relief on 100 mm
/// (noise 0.05 mm) has 3e-5.
inline constexpr double kSlides = 1e-5;
/// However rough the normals are: what holds more than this is no chance.
inline constexpr double kSlidesAtMost = 1e-4;
/// The plain formula was 2 to 4 times too small on made scans: neighbours share their noise.
inline constexpr double kUncertaintyFactor = 4;

enum class Answer { holds, weak, slides, refused };

struct Judgement {
  Answer answer = Answer::refused;
  double rms = 0, share = 0, tight_share = 0, stability = 0;
  Eigen::Vector3d weak_direction = Eigen::Vector3d::Zero();
  bool weak_turn = false;  ///< The weakest motion turns about that direction.
  double weak_motion = 0;  ///< How far along the weakest motion it may lie; 0: no limit known.
  bool slides = false;     ///< Nothing holds the weakest motion.
  bool fits = false;       ///< Surface lies on surface, whether or not anything holds it there.
  std::vector<Message> reason;  ///< One, of a refusal: the rest of a sentence; else none.
};

Judgement judge(const OrientedSet& scan, const OrientedSet& reference, const LocalPose& pose,
                const Demands& demands, const Task& task);

/// For people: "0.021 mm rms over 41 % in common. Weak along x: about 0.2 mm."
Message messageOf(const Judgement& judgement, double mm_per_unit);

}  // namespace relievo::align
