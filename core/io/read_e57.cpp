// SPDX-License-Identifier: BSD-3-Clause
// E57: the points of all scans, moved to the file's common axes. Pictures are left aside.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

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

std::uint64_t sumOfRecords(const std::vector<E57Scan>& scans) {
  std::uint64_t sum = 0;
  for (const E57Scan& scan : scans) {
    sum = scan.records > ~sum ? ~std::uint64_t{0} : sum + scan.records;
  }
  return sum;
}

/// Range, azimuth and elevation, in metres and radians.
std::array<double, 3> cartesian(const std::array<double, 3>& s) {
  return {s[0] * std::cos(s[2]) * std::cos(s[1]), s[0] * std::cos(s[2]) * std::sin(s[1]),
          s[0] * std::sin(s[2])};
}

class E57Reader {
 public:
  explicit E57Reader(const ReadJob& job)
      : job_(job), pages_(job), builder_(job.file, job.options.max_points) {}

  Scan read() {
    builder_.info().format = "E57";
    builder_.info().unit = LengthUnit::m;  // The standard allows no other.
    const std::vector<E57Scan> scans = listE57Scans(pages_.xml(), job_);
    promised_ = sumOfRecords(scans);
    // Refused here, because points that are all the same need no bytes in the file.
    if (promised_ > job_.options.max_points) {
      refuseScan(job_.file, "it promises " + grouped(promised_) +
                                " points, more than the limit of " +
                                grouped(job_.options.max_points) +
                                ". Thin it out or cut it into parts first.");
    }
    for (const E57Scan& scan : scans) {
      if (scan.records > 0) readScan(scan);
    }
    const std::uint64_t found = builder_.pointCount();
    if (found < promised_) {
      handleShortfall({"points", promised_, found, found}, job_, builder_.info());
    }
    return builder_.finish();
  }

 private:
  /// A scan that ends early leaves the next ones as they are.
  void readScan(const E57Scan& scan) {
    const bool is_cartesian = scan.find("cartesianX").has_value();
    const E57Section section = openE57Section(scan, pages_, job_);
    const auto stream = [&](std::string_view name) {
      const auto found = scan.find(name);
      if (!found) {
        refuseScan(job_.file, "a scan of it has no " + std::string(name) + ". Export it again.");
      }
      return E57Stream(pages_, job_, section, scan.fields[*found], *found);
    };
    std::array streams{stream(is_cartesian ? "cartesianX" : "sphericalRange"),
                       stream(is_cartesian ? "cartesianY" : "sphericalAzimuth"),
                       stream(is_cartesian ? "cartesianZ" : "sphericalElevation")};
    const std::string_view invalid =
        is_cartesian ? "cartesianInvalidState" : "sphericalInvalidState";
    std::optional<E57Stream> state;
    if (scan.find(invalid)) state.emplace(stream(invalid));
    for (std::uint64_t i = 0; i < scan.records; ++i) {
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
      p = scan.pose(is_cartesian ? p : cartesian(p));
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
  return E57Reader(job).read();
}

}  // namespace relievo
