// SPDX-License-Identifier: BSD-3-Clause
// E57: the points of all scans, moved to the file's common axes. Pictures are left aside.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/e57_pages.h"
#include "core/io/e57_scans.h"
#include "core/io/e57_stream.h"
#include "core/io/file_check.h"
#include "core/io/read_scan.h"
#include "core/io/scan_builder.h"

namespace relievo {
namespace {

constexpr std::uint64_t kReportEvery = 1 << 14;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Range, azimuth and elevation, in metres and radians.
std::array<double, 3> cartesian(const std::array<double, 3>& s) {
  return {s[0] * std::cos(s[2]) * std::cos(s[1]), s[0] * std::cos(s[2]) * std::sin(s[1]),
          s[0] * std::sin(s[2])};
}

/// A scan whose packets were looked at, and which of its fields make a point.
struct SoundScan {
  E57Scan scan;
  E57Section section;
  bool is_cartesian = true;
  std::array<std::size_t, 3> axes{};
  std::optional<std::size_t> invalid;
};

/// @throw E57Fault, Cancelled
SoundScan checkedScan(E57Scan scan, E57Pages& pages) {
  if (!scan.fault.empty()) throw E57Fault(scan.fault);
  SoundScan sound;
  sound.is_cartesian = scan.find("cartesianX").has_value();
  constexpr std::array<std::string_view, 3> kCartesian{"cartesianX", "cartesianY", "cartesianZ"};
  constexpr std::array<std::string_view, 3> kSpherical{"sphericalRange", "sphericalAzimuth",
                                                       "sphericalElevation"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string_view name = sound.is_cartesian ? kCartesian[axis] : kSpherical[axis];
    const auto found = scan.find(name);
    if (!found) throw E57Fault("it has no " + std::string(name));
    sound.axes[axis] = *found;
  }
  sound.invalid = scan.find(sound.is_cartesian ? "cartesianInvalidState" : "sphericalInvalidState");
  if (scan.records > 0) sound.section = openE57Section(scan, pages);
  sound.scan = std::move(scan);
  return sound;
}

/// "1 of 3 scans was left out: scan 2 "Tower" (a packet of its points makes no sense)."
class LeftOut {
 public:
  void add(std::size_t number, const std::string& name, const std::string& fault) {
    constexpr std::size_t kNamed = 3;
    if (++count_ == 1) first_fault_ = fault;
    if (count_ > kNamed) return;
    if (count_ > 1) list_ += ", ";
    list_ += "scan " + std::to_string(number);
    if (!name.empty()) list_ += " \"" + printable(name.substr(0, 60)) + "\"";
    list_ += " (" + printable(fault) + ")";
  }
  std::size_t count() const noexcept { return count_; }
  const std::string& firstFault() const noexcept { return first_fault_; }
  std::string sentence(std::size_t all) const {
    return std::to_string(count_) + " of " + std::to_string(all) + " scans " +
           (count_ == 1 ? "was" : "were") + " left out: " + list_ +
           (count_ > 3 ? " and others." : ".");
  }

 private:
  std::size_t count_ = 0;
  std::string list_, first_fault_;
};

class E57Reader {
 public:
  explicit E57Reader(const ReadJob& job)
      : job_(job), pages_(job), builder_(job.file, job.options.max_points) {}

  Scan read() {
    builder_.info().format = "E57";
    builder_.info().unit = LengthUnit::m;  // The standard allows no other.
    const std::vector<SoundScan> scans = soundScans();
    for (const SoundScan& sound : scans) {
      promised_ =
          sound.scan.records > ~promised_ ? ~std::uint64_t{0} : promised_ + sound.scan.records;
    }
    // Refused here, because points that are all the same need no bytes in the file.
    if (promised_ > job_.options.max_points) {
      refuseScan(job_.file, "it promises " + grouped(promised_) +
                                " points, more than the limit of " +
                                grouped(job_.options.max_points) +
                                ". Thin it out or cut it into parts first.");
    }
    for (const SoundScan& sound : scans) readScan(sound);
    const std::uint64_t found = builder_.pointCount();
    if (found < promised_) {
      handleShortfall({"points", promised_, found, found}, job_, builder_.info());
    }
    return builder_.finish();
  }

 private:
  /// Those that can be read; a warning names the others.
  std::vector<SoundScan> soundScans() {
    std::vector<E57Scan> all = listE57Scans(pages_.xml());
    std::vector<SoundScan> sound;
    LeftOut left_out;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::string name = all[i].name;
      try {
        sound.push_back(checkedScan(std::move(all[i]), pages_));
      } catch (const E57Fault& fault) {
        left_out.add(i + 1, name, fault.what());
      }
    }
    if (sound.empty()) throw E57Fault(left_out.firstFault());
    if (left_out.count() > 0) {
      builder_.info().warnings.push_back(left_out.sentence(all.size()));
    }
    return sound;
  }

  /// A scan that ends early leaves the next ones as they are.
  void readScan(const SoundScan& sound) {
    const auto stream = [&](std::size_t field) {
      return E57Stream(pages_, sound.section, sound.scan.fields[field], field);
    };
    std::array streams{stream(sound.axes[0]), stream(sound.axes[1]), stream(sound.axes[2])};
    std::optional<E57Stream> state;
    if (sound.invalid) state.emplace(stream(*sound.invalid));
    for (std::uint64_t i = 0; i < sound.scan.records; ++i) {
      if (i % kReportEvery == 0) report();
      std::array<double, 3> p{};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto value = streams[axis].next();
        if (!value) return;
        p[axis] = *value;
      }
      if (state) {
        const auto value = state->next();
        if (!value) return;
        if (*value != 0) p = {kNaN, kNaN, kNaN};
      }
      p = sound.scan.pose(sound.is_cartesian ? p : cartesian(p));
      builder_.addPoint(p[0], p[1], p[2]);
    }
  }

  void report() const {
    job_.task.check();
    job_.task.report("reading points",
                     static_cast<double>(builder_.pointCount()) / static_cast<double>(promised_));
  }

  const ReadJob& job_;
  E57Pages pages_;
  ScanBuilder builder_;
  std::uint64_t promised_ = 0;
};

}  // namespace

Scan readE57(const ReadJob& job) {
  try {
    return E57Reader(job).read();
  } catch (const E57Fault& fault) {
    refuseScan(job.file, std::string(fault.what()) + ". The file is damaged; export it again.");
  }
}

}  // namespace relievo
