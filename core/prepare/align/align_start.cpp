// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_start.h"

#include "core/message/catalogue.h"

namespace relievo::align {
namespace {

constexpr unsigned kSeeds = 6;
/// So many places where surface lies on surface and nothing holds it: it slides everywhere.
constexpr int kSlidingFits = 3;
/// The consensus of least error above a share of inliers wins, not the one of most inliers: so that
/// share comes down from what few scans reach.
constexpr std::array<double, 4> kInlierShares{0.6, 0.45, 0.3, 0.2};

}  // namespace

PairFit fitAutomatically(const Cloud& scan, const Cloud& reference, const Scale& scale,
                         unsigned seed, const Task& task) {
  const std::array<double, 3> far{0.08 * scale.diagonal, 0.04 * scale.diagonal,
                                  0.02 * scale.diagonal};
  const std::array<double, 2> near{kLooseCells * scale.fine, scale.fine};
  const Features scan_features = featuresOf(scan.coarse);
  task.check();
  const Features reference_features = featuresOf(reference.coarse);
  PairFit best;
  best.judgement.reason = {said<MessageId::pose_found_nowhere>()};
  int sliding = 0;
  for (unsigned n = 0; n < kSeeds; ++n) {
    const bool strict = n % 2 == 1;
    for (unsigned share = 0; share < kInlierShares.size(); ++share) {
      task.check();
      const std::optional<LocalPose> start =
          consensus(scan_features, reference_features,
                    {seed * 1009 + n * 31 + share, kInlierShares[share], strict ? 10 : 5,
                     (strict ? 0.75 : 1.5) * scale.coarse});
      if (!start) continue;
      LocalPose pose = closestPoints(scan.mid, reference.mid, *start, far, task);
      Judgement judgement = judge(scan.mid, reference.mid, pose, kAutomatic, task);
      if (judgement.answer != Answer::refused) {
        pose = closestPoints(scan.fine, reference.fine, pose, near, task);
        pose = settle(scan.fine, reference.fine, pose, scale.fine, false, task);
        judgement = judge(scan.fine, reference.fine, pose, kAutomatic, task);
        if (judgement.answer != Answer::refused) return {pose, *start, judgement};
      }
      // What came nearest says best why it was refused.
      if (judgement.tight_share > best.judgement.tight_share) best = {pose, *start, judgement};
      if (judgement.fits && ++sliding == kSlidingFits) return best;
    }
  }
  return best;
}

}  // namespace relievo::align
