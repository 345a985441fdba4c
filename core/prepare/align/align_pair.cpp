// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_pair.h"

#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_rejection_surface_normal.h>
#include <pcl/registration/icp.h>

#include <cmath>
#include <functional>

namespace relievo::align {
namespace {

using OrientedCloud = pcl::PointCloud<pcl::PointNormal>;
using Icp = pcl::IterativeClosestPointWithNormals<pcl::PointNormal, pcl::PointNormal, double>;

constexpr int kIterations = 30;
/// PCL holds it against the squared translation and a cosine; smaller ones never end (clouds.md).
constexpr double kStill = 1e-8;

OrientedCloud::Ptr pclCloud(const OrientedSet& set) {
  auto cloud = pcl::make_shared<OrientedCloud>();
  cloud->reserve(set.points.size());
  for (std::size_t i = 0; i < set.points.size(); ++i) {
    pcl::PointNormal p;
    p.x = set.points[i][0];
    p.y = set.points[i][1];
    p.z = set.points[i][2];
    p.normal_x = set.normals[i][0];
    p.normal_y = set.normals[i][1];
    p.normal_z = set.normals[i][2];
    cloud->push_back(p);
  }
  return cloud;
}

}  // namespace

LocalPose closestPoints(const OrientedSet& scan, const OrientedSet& reference,
                        const LocalPose& start, std::span<const double> distances,
                        const Task& task) {
  // "Not enough correspondences" goes to stderr; the judge counts them.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const OrientedCloud::Ptr source = pclCloud(scan);
  Icp icp;
  icp.setInputTarget(pclCloud(reference));
  icp.setInputSource(source);
  icp.setUseSymmetricObjective(true);
  const auto rejector = pcl::make_shared<pcl::registration::CorrespondenceRejectorSurfaceNormal>();
  rejector->setThreshold(kNormalsAgree);
  icp.addCorrespondenceRejector(rejector);
  icp.setMaximumIterations(kIterations);
  icp.setTransformationEpsilon(kStill);
  // Called after every iteration; the only place where PCL can be left.
  std::function<Icp::UpdateVisualizerCallbackSignature> leave =
      [&task](const OrientedCloud&, const pcl::Indices&, const OrientedCloud&,
              const pcl::Indices&) { task.check(); };
  icp.registerVisualizationCallback(leave);
  LocalPose pose = start;
  OrientedCloud moved;
  for (const double distance : distances) {
    icp.setMaxCorrespondenceDistance(distance);
    icp.align(moved, pose.matrix());
    const Eigen::Matrix4d found = icp.getFinalTransformation();
    if (!found.allFinite()) return start;
    pose.matrix() = found;
    pose = exactlyRigid(pose);
  }
  return pose;
}

LocalPose settle(const OrientedSet& scan, const OrientedSet& reference, const LocalPose& start,
                 double farthest, bool keep_sliding, const Task& task) {
  constexpr int kRounds = 8;
  constexpr double kStillCells = 1e-6;
  LocalPose pose = start;
  for (int round = 0; round < kRounds; ++round) {
    task.check();
    const std::vector<Match> matches = matchesOf(scan, reference, pose, farthest, task).list;
    if (matches.size() < 6) return start;
    const Stability stability = stabilityOf(matches);
    // Columns of held motions come last: the values rise.
    Eigen::Index kept = 0;
    while (keep_sliding && kept < 6 && stability.slides(kept)) ++kept;
    const Eigen::Matrix<double, 6, Eigen::Dynamic> held = stability.vectors.rightCols(6 - kept);
    Matrix6d squares = Matrix6d::Zero();
    Vector6d pull = Vector6d::Zero();
    for (const Match& m : matches) {
      const Eigen::Vector3d normal = m.normal();
      Vector6d row;
      row << ((m.middle() - stability.centre) / stability.arm).cross(normal), normal;
      squares += row * row.transpose();
      pull += row * m.residual();
    }
    const Eigen::MatrixXd reduced = held.transpose() * squares * held;
    const Vector6d motion = held * reduced.ldlt().solve(held.transpose() * pull);
    if (!motion.allFinite()) return start;
    pose = motionAbout(stability.centre, motion.head<3>() / stability.arm, motion.tail<3>()) * pose;
    if (motion.norm() < kStillCells * scan.cell) break;
  }
  return exactlyRigid(pose);
}

void agreeOnSides(Cloud& scan, const Cloud& reference, const LocalPose& pose, const Scale& scale,
                  const Task& task) {
  if (!scan.side_guessed) return;
  constexpr double kRough = 0.08;
  std::vector<Point3f> queries;
  for (const Point3f& p : scan.coarse.points) {
    const Eigen::Vector3d q = pose * vector(p);
    queries.push_back(
        {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(q.z())});
  }
  const std::vector<std::uint32_t> nearest =
      reference.coarse.nearest(queries, kRough * scale.diagonal, task);
  double along = 0;
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] == OrientedSet::kNobody) continue;
    along += (pose.linear() * vector(scan.coarse.normals[i]))
                 .dot(vector(reference.coarse.normals[nearest[i]]));
  }
  if (along < 0) turnOver(scan);
}

namespace {

/// What holds weakly needs all points: thinned to 2.5 spacings, a relief of 1 mm was turned by 0.16
/// degrees where its noise allows 0.04; at 1.5 spacings it comes to that.
void sharpen(const Cloud& scan, const Cloud& reference, const Scale& scale, PairFit& fit,
             const Task& task) {
  const OrientedSet finest = finestOf(scan, scale, task);
  const LocalPose pose =
      settle(finest, finestOf(reference, scale, task), fit.pose, scale.fine, false, task);
  const Judgement again = judge(scan.fine, reference.fine, pose, kStarted, task);
  if (again.answer == Answer::weak || again.answer == Answer::holds) {
    fit.pose = pose;
    fit.judgement = again;
  }
}

}  // namespace

PairFit fitFromStart(const Cloud& scan, const Cloud& reference, const LocalPose& start,
                     const Scale& scale, const Task& task) {
  const std::array<double, 3> far{0.08 * scale.diagonal, 0.04 * scale.diagonal,
                                  0.02 * scale.diagonal};
  // The last distance is what makes it exact: without it some hundredths of a millimetre remain.
  const std::array<double, 2> near{kLooseCells * scale.fine, scale.fine};
  PairFit fit;
  fit.start = start;
  fit.pose = closestPoints(scan.mid, reference.mid, start, far, task);
  fit.pose = closestPoints(scan.fine, reference.fine, fit.pose, near, task);
  fit.pose = settle(scan.fine, reference.fine, fit.pose, scale.fine, false, task);
  fit.judgement = judge(scan.fine, reference.fine, fit.pose, kStarted, task);
  if (fit.judgement.answer == Answer::weak) sharpen(scan, reference, scale, fit, task);
  if (fit.judgement.answer == Answer::holds || fit.judgement.answer == Answer::weak ||
      !fit.judgement.slides) {
    return fit;
  }
  // What slides was carried away by noise. Once more, without the motions that nothing holds.
  LocalPose kept = start;
  for (const double distance : far) {
    kept = settle(scan.mid, reference.mid, kept, distance, true, task);
  }
  for (const double distance : near) {
    kept = settle(scan.fine, reference.fine, kept, distance, true, task);
  }
  const Judgement again = judge(scan.fine, reference.fine, kept, kStarted, task);
  if (again.answer != Answer::refused) fit = {kept, start, again};
  return fit;
}

}  // namespace relievo::align
