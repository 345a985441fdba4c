// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_math.h"

#include <cmath>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace relievo::align {

LocalPose motionAbout(const Eigen::Vector3d& centre, const Eigen::Vector3d& turn,
                      const Eigen::Vector3d& move) {
  LocalPose motion = LocalPose::Identity();
  const double angle = turn.norm();
  if (angle > 0) motion.linear() = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  motion.translation() = centre + move - motion.linear() * centre;
  return motion;
}

LocalPose exactlyRigid(const LocalPose& pose) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(pose.linear(),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  LocalPose rigid = pose;
  rigid.linear() = svd.matrixU() * svd.matrixV().transpose();
  return rigid;
}

double turnOf(const LocalPose& pose) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(pose.linear())).angle();
}

Pose fileFromMiddles(const LocalPose& pose, const FilePoint& reference_middle,
                     const FilePoint& scan_middle) {
  const Eigen::Vector3d shift =
      vector(reference_middle) + pose.translation() - pose.linear() * vector(scan_middle);
  Pose file;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      file.m[static_cast<std::size_t>(4 * i + j)] = pose.linear()(i, j);
    }
    file.m[static_cast<std::size_t>(4 * i + 3)] = shift(i);
  }
  return file;
}

LocalPose middlesFromFile(const Pose& pose, const FilePoint& reference_middle,
                          const FilePoint& scan_middle) {
  LocalPose local = LocalPose::Identity();
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) {
      local.linear()(i, j) = pose.m[static_cast<std::size_t>(4 * i + j)];
    }
  }
  local.translation() = vector(pose(scan_middle) - reference_middle);
  return local;
}

}  // namespace relievo::align
