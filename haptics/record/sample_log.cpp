// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/sample_log.h"

#include <utility>

#include "core/base/error.h"
#include "core/recording/log_table.h"
#include "haptics/record/log/hdf5_log.h"
#include "haptics/record/log/log_place.h"
#include "haptics/record/log/log_writer.h"

namespace relievo {

TouchRow touchRow(const HapticSample& s, double t_s) {
  return {.t_s = t_s,
          .tick = s.tick,
          .hip = s.hip_view,
          .proxy = s.proxy_view,
          .force = s.force,
          .unlimited_n = s.f_cmd_n,
          .clamped = s.clamped,
          .origin = s.origin,
          .contact = s.contact,
          .normal = {s.normal.x, s.normal.y, s.normal.z},
          .stiffness_n_per_m = 1000 * s.stiffness_n_per_mm,
          .window_id = s.window_id,
          .detail = s.detail,
          .buttons = s.buttons,
          .rate_hz = s.rate_hz,
          .hand_hip = s.hip,
          .hand_proxy = s.proxy,
          .age_s = s.age_s};
}

namespace {

/// A log that takes its name once it is whole.
class PlacedLog : public SampleLog {
 public:
  PlacedLog(const std::filesystem::path& file, std::string_view header, const HapticSpace* surface,
            LogKind kind)
      : place_(file), kind_(kind) {
    const std::filesystem::path& to = place_.writtenTo();
    try {
      if (isHdf5Name(to)) {
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
