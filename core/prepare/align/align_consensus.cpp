// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl/registration/sample_consensus_prerejective.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>

#include "core/prepare/align/align_start.h"

namespace relievo::align {
namespace {

constexpr int kSamples = 3;
constexpr int kIterations = 10000;
constexpr float kSimilarity = 0.9F;      ///< Of the sides of the two triangles of samples.
constexpr std::size_t kKeyPoints = 400;  ///< All of them took 22 s for 2.4 (clouds.md 4.5).

struct PclFeatures {
  pcl::PointCloud<pcl::PointXYZ>::Ptr points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  pcl::PointCloud<pcl::FPFHSignature33>::Ptr features =
      pcl::make_shared<pcl::PointCloud<pcl::FPFHSignature33>>();

  void add(const Features& from, std::size_t i) {
    points->push_back({from.points[i][0], from.points[i][1], from.points[i][2]});
    pcl::FPFHSignature33 feature;
    std::copy(from.histograms[i].begin(), from.histograms[i].end(),
              static_cast<float*>(feature.histogram));
    features->push_back(feature);
  }
};

/// Some of them, the same ones for the same seed with every standard library.
std::vector<std::size_t> keyPoints(std::size_t count, unsigned seed) {
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  const std::size_t wanted = std::min(count, kKeyPoints);
  std::mt19937 engine(seed);
  for (std::size_t i = 0; i < wanted; ++i) std::swap(all[i], all[i + engine() % (count - i)]);
  all.resize(wanted);
  return all;
}

}  // namespace

std::optional<LocalPose> consensus(const Features& scan, const Features& reference,
                                   const Consensus& how) {
  const std::size_t fewest = static_cast<std::size_t>(std::max(kSamples, how.candidates));
  if (scan.points.size() < fewest || reference.points.size() < fewest) return std::nullopt;
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  PclFeatures source;
  for (const std::size_t i : keyPoints(scan.points.size(), how.seed)) source.add(scan, i);
  PclFeatures target;
  for (std::size_t i = 0; i < reference.points.size(); ++i) target.add(reference, i);
  pcl::SampleConsensusPrerejective<pcl::PointXYZ, pcl::PointXYZ, pcl::FPFHSignature33> search;
  search.setInputSource(source.points);
  search.setSourceFeatures(source.features);
  search.setInputTarget(target.points);
  search.setTargetFeatures(target.features);
  search.setMaximumIterations(kIterations);
  search.setNumberOfSamples(kSamples);
  search.setCorrespondenceRandomness(how.candidates);
  search.setSimilarityThreshold(kSimilarity);
  search.setMaxCorrespondenceDistance(how.distance);
  search.setInlierFraction(static_cast<float>(how.inlier_share));
  std::srand(how.seed);
  pcl::PointCloud<pcl::PointXYZ> moved;
  search.align(moved);
  if (!search.hasConverged() || !search.getFinalTransformation().allFinite()) return std::nullopt;
  LocalPose pose = LocalPose::Identity();
  pose.matrix() = search.getFinalTransformation().cast<double>();
  if (pose.linear().determinant() <= 0) return std::nullopt;
  return exactlyRigid(pose);
}

}  // namespace relievo::align
