// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/align/align_scans.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/failure.h"
#include "core/prepare/align/align_joint.h"
#include "core/prepare/align/align_picks.h"
#include "core/prepare/align/align_start.h"

namespace relievo {
namespace {

using align::Answer;
using align::Cloud;
using align::Judgement;
using align::Link;
using align::LocalPose;
using align::OrientedSet;

/// A loop that misses by more than so many times its uncertainty has a wrong pair in it.
constexpr double kLoopUncertainties = 5;
/// Of what picks leave after they are fitted: three pairs have only three numbers to spare.
constexpr double kPickUncertainty = 2;
/// Scans that are thought to meet: this share of one's coarse points lies near the other.
constexpr double kMeet = 0.05;

class Aligner {
 public:
  Aligner(const Align& how, std::span<const AlignScan> scans, const Task& task)
      : how_(how), scans_(scans), task_(task), reference_(how.reference) {
    checkScans();
    task_.report("Looking at the scans", 0);
    scale_ = align::scaleOf(scans, task);
    for (const AlignScan& scan : scans) clouds_.push_back(cloudOf(scan, scale_, task));
    starts_.resize(scans.size());
    placed_.resize(scans.size());
    parents_.resize(scans.size(), kNone);
    pick_errors_.resize(scans.size());
  }

  AlignAnswer run() {
    if (how_.method == AlignMethod::automatic) {
      growAutomatically();
    } else {
      startAsGiven();
    }
    linkTheRest();
    spanTree();
    AlignAnswer answer;
    closeLoops(answer);
    if (scans_.size() > 2) solve();
    for (std::size_t s = 0; s < scans_.size(); ++s) answer.scans.push_back(verdictOf(s));
    return answer;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void checkScans() const {
    if (scans_.size() < 2 || reference_ >= scans_.size()) {
      throw failure<MessageId::align_needs_two_scans>();
    }
    for (const PickedPair& pair : how_.pairs) {
      if (pair.scan < scans_.size() && pair.scan != reference_) continue;
      if (pair.scan == reference_) {
        throw failure<MessageId::pair_names_reference>(pair.scan + 1, scans_.size());
      }
      throw failure<MessageId::pair_names_no_scan>(pair.scan + 1, scans_.size());
    }
    for (const AlignScan& scan : scans_) {
      if (scan.mm_per_unit != scans_[reference_].mm_per_unit) {
        throw failure<MessageId::align_units_differ>(scan.name, scans_[reference_].name);
      }
    }
  }

  double progress() const {
    return static_cast<double>(pairs_done_) /
           static_cast<double>(std::max<std::size_t>(1, scans_.size() * (scans_.size() - 1) / 2));
  }

  void startAsGiven() {
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      Pose given;
      if (how_.method == AlignMethod::points && s != reference_) {
        std::vector<PickedPair> picks;
        for (const PickedPair& pair : how_.pairs) {
          if (pair.scan == s) picks.push_back(pair);
        }
        const align::PickedFit fit = align::fitPicks(picks, scans_[s].name);
        given = fit.pose;
        pick_errors_[s] = fit.error;
      }
      starts_[s] = align::middlesFromFile(given, clouds_[reference_].middle, clouds_[s].middle);
      if (s != reference_) {
        align::agreeOnSides(clouds_[s], clouds_[reference_], *starts_[s], scale_, task_);
      }
      placed_[s] = starts_[s];
    }
  }

  /// From the reference outward: whatever is not placed yet is tried on whatever is.
  void growAutomatically() {
    placed_[reference_] = starts_[reference_] = LocalPose::Identity();
    std::vector<std::size_t> order{reference_};
    for (std::size_t next = 0; next < order.size(); ++next) {
      for (std::size_t s = 0; s < scans_.size(); ++s) {
        if (placed_[s]) continue;
        task_.report("Searching where the scans meet", progress());
        const std::size_t onto = order[next];
        align::PairFit fit = searchedFit(s, onto);
        ++pairs_done_;
        if (fit.judgement.answer == Answer::refused) {
          refusals_.push_back({s, onto, fit});
          continue;
        }
        placed_[s] = *placed_[onto] * fit.pose;
        starts_[s] = *placed_[onto] * fit.start;
        links_.push_back({s, onto, fit});
        order.push_back(s);
      }
    }
  }

  align::PairFit searchedFit(std::size_t s, std::size_t onto) {
    align::PairFit fit = fitAutomatically(clouds_[s], clouds_[onto], scale_, how_.seed, task_);
    if (fit.judgement.answer == Answer::refused && !fit.judgement.fits && clouds_[s].side_guessed) {
      turnOver(clouds_[s]);
      fit = fitAutomatically(clouds_[s], clouds_[onto], scale_, how_.seed, task_);
    }
    return fit;
  }

  bool linked(std::size_t a, std::size_t b) const {
    return std::any_of(links_.begin(), links_.end(), [&](const Link& link) {
      return (link.scan == a && link.onto == b) || (link.scan == b && link.onto == a);
    });
  }

  bool meet(std::size_t a, std::size_t b) const {
    const LocalPose between = placed_[b]->inverse(Eigen::Isometry) * *placed_[a];
    const align::Matches matches =
        matchesOf(clouds_[a].coarse, clouds_[b].coarse, between, scale_.coarse, task_);
    const double least = kMeet * static_cast<double>(std::min(clouds_[a].coarse.points.size(),
                                                              clouds_[b].coarse.points.size()));
    return static_cast<double>(std::max(matches.scan_loose, matches.reference_loose)) >= least;
  }

  /// Pairs that lie on each other by what is known already.
  void linkTheRest() {
    for (std::size_t a = 0; a < scans_.size(); ++a) {
      for (std::size_t b = 0; b < scans_.size(); ++b) {
        // Each pair once; the reference is what others are brought to.
        const bool wanted = b == reference_ ? a != b : a > b && a != reference_;
        if (!wanted || !placed_[a] || !placed_[b] || linked(a, b)) continue;
        // By rough picks they may just not touch: two scans are always tried.
        if (scans_.size() > 2 && !meet(a, b)) continue;
        task_.report("Laying the scans on each other", progress());
        const LocalPose between = placed_[b]->inverse(Eigen::Isometry) * *placed_[a];
        align::PairFit fit = fitFromStart(clouds_[a], clouds_[b], between, scale_, task_);
        ++pairs_done_;
        if (fit.judgement.answer == Answer::refused) {
          refusals_.push_back({a, b, fit});
        } else {
          links_.push_back({a, b, fit});
        }
      }
    }
  }

  /// Of a link: how much of the scans lies tight. What slides says nothing where it slides.
  static double weightOf(const Link& link) {
    return link.fit.judgement.tight_share *
           (link.fit.judgement.answer == Answer::slides ? 1e-3 : 1.0);
  }

  /// The links that carry the poses: from the reference, always the strongest next.
  void spanTree() {
    for (std::optional<LocalPose>& pose : placed_) pose.reset();
    placed_[reference_] = LocalPose::Identity();
    for (;;) {
      const Link* best = nullptr;
      for (const Link& link : links_) {
        if (placed_[link.scan].has_value() == placed_[link.onto].has_value()) continue;
        if (best == nullptr || weightOf(link) > weightOf(*best)) best = &link;
      }
      if (best == nullptr) return;
      const std::size_t index = static_cast<std::size_t>(best - links_.data());
      if (placed_[best->onto]) {
        placed_[best->scan] = *placed_[best->onto] * best->fit.pose;
        parents_[best->scan] = index;
      } else {
        placed_[best->onto] = *placed_[best->scan] * best->fit.pose.inverse(Eigen::Isometry);
        parents_[best->onto] = index;
      }
    }
  }

  std::size_t parentOf(std::size_t s) const {
    const Link& link = links_[parents_[s]];
    return link.scan == s ? link.onto : link.scan;
  }

  /// Scans from `s` up to the reference, both included.
  std::vector<std::size_t> pathOf(std::size_t s) const {
    std::vector<std::size_t> path{s};
    while (parents_[path.back()] != kNone) path.push_back(parentOf(path.back()));
    return path;
  }

  /// From one scan to the other along the tree.
  std::vector<std::uint32_t> wayBetween(std::size_t a, std::size_t b) const {
    std::vector<std::size_t> up = pathOf(a);
    std::vector<std::size_t> down = pathOf(b);
    while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
      up.pop_back();
      down.pop_back();
    }
    down.pop_back();  // Where the two ways meet is in both.
    up.insert(up.end(), down.rbegin(), down.rend());
    return {up.begin(), up.end()};
  }

  /// Every link beside the tree closes a loop: what it found alone, against the way around.
  void closeLoops(AlignAnswer& answer) {
    std::vector<bool> carries(links_.size());
    for (const std::size_t link : parents_) {
      if (link != kNone) carries[link] = true;
    }
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Link& link = links_[i];
      if (carries[i] || !placed_[link.scan] || !placed_[link.onto]) continue;
      const LocalPose around = placed_[link.onto]->inverse(Eigen::Isometry) * *placed_[link.scan];
      AlignLoop loop;
      loop.scans = wayBetween(link.scan, link.onto);
      loop.deg =
          180 / std::numbers::pi * align::turnOf(link.fit.pose.inverse(Eigen::Isometry) * around);
      const double shift = missOf(link, around);
      loop.mm = shift * scans_[reference_].mm_per_unit;
      answer.loops.push_back(loop);
      if (shift > kLoopUncertainties * uncertaintyOf(loop, link)) open_.push_back(i);
    }
  }

  /// Root mean square, over the scan, of where two poses put it.
  double missOf(const Link& link, const LocalPose& around) const {
    double squares = 0;
    const std::vector<Point3f>& points = clouds_[link.scan].coarse.points;
    for (const Point3f& p : points) {
      squares += (link.fit.pose * align::vector(p) - around * align::vector(p)).squaredNorm();
    }
    return std::sqrt(squares / static_cast<double>(points.size()));
  }

  double uncertaintyOf(const AlignLoop& loop, const Link& closing) const {
    double sum = std::pow(motionOf(closing), 2);
    for (std::size_t i = 0; i + 1 < loop.scans.size(); ++i) {
      const std::size_t a = loop.scans[i];
      const std::size_t b = loop.scans[i + 1];
      for (const Link& link : links_) {
        if ((link.scan == a && link.onto == b) || (link.scan == b && link.onto == a)) {
          sum += std::pow(motionOf(link), 2);
        }
      }
    }
    return std::sqrt(sum);
  }

  double motionOf(const Link& link) const {
    const Judgement& judgement = link.fit.judgement;
    return judgement.answer == Answer::slides ? scale_.diagonal : judgement.weak_motion;
  }

  void solve() {
    task_.report("Solving all poses together", 1);
    std::vector<bool> fixed(scans_.size(), true);
    std::vector<LocalPose> poses(scans_.size(), LocalPose::Identity());
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      if (!placed_[s]) continue;
      poses[s] = *placed_[s];
      fixed[s] = s == reference_ || links_[parents_[s]].fit.judgement.answer == Answer::slides;
    }
    std::vector<Link> used;
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Link& link = links_[i];
      const bool open = std::find(open_.begin(), open_.end(), i) != open_.end();
      if (!open && placed_[link.scan] && placed_[link.onto] &&
          link.fit.judgement.answer != Answer::slides) {
        used.push_back({link.scan, link.onto, link.fit});
      }
    }
    solveTogether(clouds_, used, fixed, scale_, poses, task_);
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      if (placed_[s]) placed_[s] = poses[s];
    }
  }

  /// All others that are placed, as one, in the frame of the reference.
  OrientedSet othersThan(std::size_t s) const {
    std::vector<Point3f> points;
    std::vector<Point3f> normals;
    for (std::size_t other = 0; other < scans_.size(); ++other) {
      if (other == s || !placed_[other]) continue;
      const OrientedSet& set = clouds_[other].fine;
      for (std::size_t i = 0; i < set.points.size(); ++i) {
        const Eigen::Vector3f p = (*placed_[other] * align::vector(set.points[i])).cast<float>();
        const Eigen::Vector3f n =
            (placed_[other]->linear() * align::vector(set.normals[i])).cast<float>();
        points.push_back({p.x(), p.y(), p.z()});
        normals.push_back({n.x(), n.y(), n.z()});
      }
    }
    return align::setOf(points, normals, scale_.fine, task_);
  }

  AlignVerdict verdictOf(std::size_t s) {
    AlignVerdict verdict;
    const double mm = scans_[s].mm_per_unit;
    const auto filePose = [&](const LocalPose& pose) {
      return align::fileFromMiddles(pose, clouds_[reference_].middle, clouds_[s].middle);
    };
    if (s == reference_) {
      verdict.share = verdict.tight_share = 1;
      verdict.words = {said<MessageId::pose_of_reference>()};
      return verdict;
    }
    if (starts_[s]) verdict.start = filePose(*starts_[s]);
    Judgement judgement = placed_[s] ? judgementOf(s) : refusalOf(s);
    verdict.holds = judgement.answer != Answer::refused;
    if (verdict.holds) verdict.pose = filePose(*placed_[s]);
    verdict.rms_mm = judgement.rms * mm;
    verdict.share = judgement.share;
    verdict.tight_share = judgement.tight_share;
    verdict.stability = judgement.stability;
    if (judgement.answer != Answer::holds) {
      verdict.weak_direction = {judgement.weak_direction.x(), judgement.weak_direction.y(),
                                judgement.weak_direction.z()};
    }
    // Where nothing holds it, it is as good as the picks.
    verdict.uncertainty_mm =
        (judgement.answer == Answer::slides ? kPickUncertainty * pick_errors_[s]
                                            : judgement.weak_motion) *
        mm;
    verdict.words = {messageOf(judgement, mm)};
    for (const std::size_t other : openLoopsOf(s)) {
      verdict.words.push_back(said<MessageId::pose_differs_alone>(scans_[other].name));
    }
    return verdict;
  }

  Judgement judgementOf(std::size_t s) const {
    const Judgement& pair = links_[parents_[s]].fit.judgement;
    if (scans_.size() == 2 || pair.answer == Answer::slides) return pair;
    return judge(clouds_[s].fine, othersThan(s), *placed_[s], align::kStarted, task_);
  }

  Judgement refusalOf(std::size_t s) const {
    Judgement best;
    best.reason = {said<MessageId::pose_meets_none>()};
    for (const Link& link : refusals_) {
      if (link.scan != s && link.onto != s) continue;
      if (link.fit.judgement.tight_share >= best.tight_share) best = link.fit.judgement;
    }
    return best;
  }

  /// Scans on which it lies elsewhere by itself.
  std::vector<std::size_t> openLoopsOf(std::size_t s) const {
    std::vector<std::size_t> others;
    for (const std::size_t i : open_) {
      const Link& link = links_[i];
      if (link.scan != s && link.onto != s) continue;
      others.push_back(link.scan == s ? link.onto : link.scan);
    }
    return others;
  }

  const Align& how_;
  std::span<const AlignScan> scans_;
  const Task& task_;
  std::size_t reference_;
  align::Scale scale_;
  std::vector<Cloud> clouds_;
  std::vector<std::optional<LocalPose>> starts_, placed_;  ///< Reference from scan, middles.
  std::vector<Link> links_, refusals_;
  std::vector<double> pick_errors_;   ///< Root mean square, file units.
  std::vector<std::size_t> parents_;  ///< Per scan the link that carries its pose.
  std::vector<std::size_t> open_;     ///< Links whose loop does not close.
  std::size_t pairs_done_ = 0;
};

}  // namespace

AlignAnswer alignScans(const Align& how, std::span<const AlignScan> scans, const Task& task) {
  return Aligner(how, scans, task).run();
}

}  // namespace relievo
