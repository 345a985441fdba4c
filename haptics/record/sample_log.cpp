// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/sample_log.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "haptics/record/hdf5_log.h"
#include "haptics/record/log_place.h"
#include "haptics/record/log_writer.h"

namespace relievo {

std::array<double, kLogColumns.size()> logValues(const HapticSample& s, double t_s) {
  return {t_s,
          static_cast<double>(s.tick),
          s.hip_view.x,
          s.hip_view.y,
          s.hip_view.z,
          s.proxy_view.x,
          s.proxy_view.y,
          s.proxy_view.z,
          s.force.x,
          s.force.y,
          s.force.z,
          s.f_cmd_n,
          s.clamped ? 1.0 : 0.0,
          s.contact ? 1.0 : 0.0,
          s.normal.x,
          s.normal.y,
          s.normal.z,
          1000 * s.stiffness_n_per_mm,
          static_cast<double>(s.detail),
          static_cast<double>(s.window_id),
          static_cast<double>(s.origin),
          static_cast<double>(s.buttons),
          s.rate_hz,
          s.hip.x,
          s.hip.y,
          s.hip.z,
          s.proxy.x,
          s.proxy.y,
          s.proxy.z,
          s.age_s};
}

std::string_view headerLine(std::string_view header, std::string_view word) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    const std::string_view line = header.substr(0, end);
    if (line.starts_with(word)) return line.substr(word.size());
    header.remove_prefix(std::min(end + 1, header.size()));
  }
  return {};
}

namespace {

/// A log that takes its name once it is whole.
class PlacedLog : public SampleLog {
 public:
  PlacedLog(const std::filesystem::path& file, std::string_view header, const HapticSpace* surface,
            LogKind kind)
      : place_(file), kind_(kind) {
    const std::filesystem::path& to = place_.writtenTo();
    const std::string ending = to.extension().string();
    try {
      if (ending == ".h5" || ending == ".hdf5") {
        log_ = std::make_unique<Hdf5Log>(to, header, surface);
      } else {
        log_ = std::make_unique<LogWriter>(to, header, kind);
      }
    } catch (...) {
      place_.drop();
      throw;
    }
  }
  /// What was not closed was cancelled, or never began: a stroke can be run again, the rows of a
  /// recording cannot be had again.
  ~PlacedLog() override {
    if (is_closed_) return;
    const bool is_of_use = kind_ == LogKind::recording && log_->rows() > 0;
    log_.reset();
    if (!is_of_use) place_.drop();
  }

  void write(const HapticSample& sample, double t_s, std::string_view event) override {
    orStop([&] { log_->write(sample, t_s, event); });
  }
  void keep(std::string_view lines) override {
    orStop([&] { log_->keep(lines); });
  }
  void close(std::string_view footer) override {
    if (std::exchange(is_closed_, true)) return;
    orStop([&] { log_->close(footer); });
    place_.keep();
  }
  std::uint64_t rows() const noexcept override { return log_->rows(); }
  const std::filesystem::path& file() const noexcept override { return place_.target(); }

 private:
  /// What stops a log leaves it where it is, with the rows that were saved.
  template <class Work>
  void orStop(const Work& work) {
    try {
      work();
    } catch (const WriteError&) {
      is_closed_ = true;
      place_.release();
      throw;
    }
  }

  LogPlace place_;
  LogKind kind_;
  std::unique_ptr<SampleLog> log_;
  bool is_closed_ = false;
};

}  // namespace

std::unique_ptr<SampleLog> openLog(const std::filesystem::path& file, std::string_view header,
                                   const HapticSpace* surface, LogKind kind) {
  return std::make_unique<PlacedLog>(file, header, surface, kind);
}

}  // namespace relievo
