// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_joint.h"

#include <algorithm>
#include <array>
#include <Eigen/Cholesky>

namespace relievo::align {
namespace {

constexpr std::array<double, 3> kDistances{3, 1.5, 1};  ///< Cells.
constexpr int kRounds = 5;                              ///< At each of them, at most.
constexpr double kStillCells = 1e-4;

// Below it scans hold each other so loosely that every point counts (docs/adr/0112).
constexpr double kLooseStability = 0.03;

constexpr Eigen::Index kFixed = -1;

/// One linear step of all poses. Turns are about the origin and count at `arm`.
class Normals {
 public:
  Normals(std::vector<Eigen::Index> columns, Eigen::Index count, double arm)
      : columns_(std::move(columns)), arm_(arm) {
    squares_ = Eigen::MatrixXd::Zero(6 * count, 6 * count);
    pull_ = Eigen::VectorXd::Zero(6 * count);
  }

  /// All matches of a pair, given in the common frame: the scan is to move toward the other.
  void add(std::size_t scan, std::size_t onto, const std::vector<Match>& matches,
           const LocalPose& common) {
    Matrix6d square = Matrix6d::Zero();
    Vector6d sum = Vector6d::Zero();
    for (const Match& m : matches) {
      const Eigen::Vector3d normal = common.linear() * m.normal();
      Vector6d row;
      row << (common * m.middle() / arm_).cross(normal), normal;
      square += row * row.transpose();
      sum += row * m.residual();
    }
    const Eigen::Index a = columns_[scan];
    const Eigen::Index b = columns_[onto];
    if (a != kFixed) {
      squares_.block<6, 6>(6 * a, 6 * a) += square;
      pull_.segment<6>(6 * a) += sum;
    }
    if (b != kFixed) {
      squares_.block<6, 6>(6 * b, 6 * b) += square;
      pull_.segment<6>(6 * b) -= sum;
    }
    if (a != kFixed && b != kFixed) {
      squares_.block<6, 6>(6 * a, 6 * b) -= square;
      squares_.block<6, 6>(6 * b, 6 * a) -= square;
    }
  }

  Eigen::VectorXd solve() const { return squares_.ldlt().solve(pull_); }

 private:
  std::vector<Eigen::Index> columns_;
  double arm_;
  Eigen::MatrixXd squares_;
  Eigen::VectorXd pull_;
};

/// All poses at once, by matches no farther than each of some distances, one after the other.
class Together {
 public:
  Together(std::span<const Link> links, const std::vector<bool>& fixed, const Scale& scale,
           std::vector<LocalPose>& poses, const Task& task)
      : links_(links), fixed_(fixed), scale_(scale), poses_(poses), task_(task) {
    for (const bool is_fixed : fixed) columns_.push_back(is_fixed ? kFixed : count_++);
  }

  bool hasFree() const { return count_ > 0; }

  /// @param set_of  the points of a scan by its number @return false: there is no solution
  template <class SetOf>
  bool solve(const SetOf& set_of, double farthest) {
    const double arm = 0.5 * scale_.diagonal;
    for (int round = 0; round < kRounds; ++round) {
      Normals normals(columns_, count_, arm);
      for (const Link& link : links_) {
        if (fixed_[link.scan] && fixed_[link.onto]) continue;
        task_.check();
        const LocalPose between = poses_[link.onto].inverse(Eigen::Isometry) * poses_[link.scan];
        const Matches matches =
            matchesOf(set_of(link.scan), set_of(link.onto), between, farthest, task_);
        normals.add(link.scan, link.onto, matches.list, poses_[link.onto]);
      }
      const Eigen::VectorXd motion = normals.solve();
      if (!motion.allFinite()) return false;
      for (std::size_t s = 0; s < poses_.size(); ++s) {
        if (columns_[s] == kFixed) continue;
        const Vector6d m = motion.segment<6>(6 * columns_[s]);
        poses_[s] = exactlyRigid(
            motionAbout(Eigen::Vector3d::Zero(), m.head<3>() / arm, m.tail<3>()) * poses_[s]);
      }
      if (motion.cwiseAbs().maxCoeff() < kStillCells * scale_.fine) break;
    }
    return true;
  }

 private:
  std::span<const Link> links_;
  const std::vector<bool>& fixed_;
  const Scale& scale_;
  std::vector<LocalPose>& poses_;
  const Task& task_;
  std::vector<Eigen::Index> columns_;
  Eigen::Index count_ = 0;
};

/// Whether a pair holds so loosely that all points have to be used.
bool isLoose(const Link& link) {
  return link.fit.judgement.stability < kLooseStability;
}

}  // namespace

void solveTogether(std::span<const Cloud> clouds, std::span<const Link> links,
                   const std::vector<bool>& fixed, const Scale& scale,
                   std::vector<LocalPose>& poses, const Task& task) {
  Together together(links, fixed, scale, poses, task);
  if (!together.hasFree()) return;
  const auto fine = [&](std::size_t s) -> const OrientedSet& { return clouds[s].fine; };
  for (const double cells : kDistances) {
    if (!together.solve(fine, cells * scale.fine)) return;
  }
  if (std::none_of(links.begin(), links.end(), isLoose)) return;
  std::vector<OrientedSet> finest;
  for (const Cloud& cloud : clouds) finest.push_back(finestOf(cloud, scale, task));
  together.solve([&](std::size_t s) -> const OrientedSet& { return finest[s]; }, scale.fine);
}

}  // namespace relievo::align
