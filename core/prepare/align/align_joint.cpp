// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_joint.h"

#include <array>
#include <Eigen/Cholesky>

namespace relievo::align {
namespace {

constexpr std::array<double, 3> kDistances{3, 1.5, 1};  ///< Cells.
constexpr int kRounds = 5;                              ///< At each of them, at most.
constexpr double kStillCells = 1e-4;

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

}  // namespace

void solveTogether(std::span<const Cloud> clouds, std::span<const Link> links,
                   const std::vector<bool>& fixed, const Scale& scale,
                   std::vector<LocalPose>& poses, const Task& task) {
  std::vector<Eigen::Index> columns;
  Eigen::Index count = 0;
  for (const bool is_fixed : fixed) columns.push_back(is_fixed ? kFixed : count++);
  if (count == 0) return;
  for (const double cells : kDistances) {
    for (int round = 0; round < kRounds; ++round) {
      Normals normals(columns, count, 0.5 * scale.diagonal);
      for (const Link& link : links) {
        if (fixed[link.scan] && fixed[link.onto]) continue;
        task.check();
        const LocalPose between = poses[link.onto].inverse(Eigen::Isometry) * poses[link.scan];
        const Matches matches = matchesOf(clouds[link.scan].fine, clouds[link.onto].fine, between,
                                          cells * scale.fine, task);
        normals.add(link.scan, link.onto, matches.list, poses[link.onto]);
      }
      const Eigen::VectorXd motion = normals.solve();
      if (!motion.allFinite()) return;
      for (std::size_t s = 0; s < poses.size(); ++s) {
        if (columns[s] == kFixed) continue;
        const Vector6d m = motion.segment<6>(6 * columns[s]);
        poses[s] = exactlyRigid(motionAbout(Eigen::Vector3d::Zero(),
                                            m.head<3>() / (0.5 * scale.diagonal), m.tail<3>()) *
                                poses[s]);
      }
      if (motion.cwiseAbs().maxCoeff() < kStillCells * scale.fine) break;
    }
  }
}

}  // namespace relievo::align
