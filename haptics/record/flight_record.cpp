// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/flight_record.h"

#include <algorithm>
#include <memory>
#include <system_error>
#include <utility>

#include "core/base/error.h"
#include "haptics/record/events.h"
#include "haptics/record/log/log_writer.h"

namespace relievo {

FlightRecord::FlightRecord(std::filesystem::path folder, std::string header)
    : folder_(std::move(folder)), header_(std::move(header)) {
  kept_.reserve(kTicks);
}

FlightRecord::~FlightRecord() {
  RecordingEnd* end = nullptr;
  while (ends_.pop(end)) delete end;
}

std::optional<RecordingEnd> FlightRecord::written() {
  RecordingEnd* pointer = nullptr;
  if (!ends_.pop(pointer)) return std::nullopt;
  const std::unique_ptr<RecordingEnd> end(pointer);
  return std::move(*end);
}

void FlightRecord::take(std::span<const HapticSample> batch) {
  for (const HapticSample& sample : batch) {
    if (kept_.size() < kTicks) {
      kept_.push_back(sample);
    } else {
      kept_[next_] = sample;
      next_ = (next_ + 1) % kTicks;
    }
    const bool fresh = sample.fault != DeviceFault::none && fault_ == DeviceFault::none;
    fault_ = sample.fault;
    if (fresh && files_ < kMostFiles) save();
  }
}

/// Leaves what is not its own alone. What cannot be removed stays; nobody has to know.
void FlightRecord::prune() {
  struct Old {
    std::filesystem::file_time_type written;
    std::filesystem::path file;
  };
  std::vector<Old> files;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder_, error), end; !error && at != end;
       at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (!name.starts_with("flight-") || !name.ends_with(".csv")) continue;
    std::error_code gone;
    const auto written = at->last_write_time(gone);
    if (!gone) files.push_back({written, at->path()});
  }
  if (files.size() <= kMostKept) return;
  std::sort(files.begin(), files.end(),
            [](const Old& a, const Old& b) { return a.written < b.written; });
  for (std::size_t i = 0; i + kMostKept < files.size(); ++i) {
    std::filesystem::remove(files[i].file, error);
  }
}

void FlightRecord::save() {
  auto end = std::make_unique<RecordingEnd>();
  try {
    std::error_code ignored;  // What cannot be made cannot be written to, which is told below.
    std::filesystem::create_directories(folder_, ignored);
    ++files_;
    int number = 1;
    do {
      end->file = folder_ / ("flight-" + std::to_string(number++) + ".csv");
    } while (std::filesystem::exists(end->file));
    // In order; the ring goes on from its beginning.
    std::rotate(kept_.begin(), kept_.begin() + static_cast<std::ptrdiff_t>(next_), kept_.end());
    next_ = 0;
    LogWriter log(end->file, header_ + "\n" + sampleLines(kept_));
    const HapticSample* before = nullptr;
    const std::int64_t start_ns = kept_.front().time_ns;
    for (const HapticSample& sample : kept_) {
      const std::string event =
          before == nullptr ? eventAtStart(sample) : eventBetween(*before, sample);
      log.write(sample, 1e-9 * static_cast<double>(sample.time_ns - start_ns), event);
      before = &sample;
    }
    log.close();
    end->samples = log.rows();
    prune();
  } catch (const Error& error) {
    end->error = error.what();
    end->message = error.message;
  }
  if (ends_.push(end.get())) {
    [[maybe_unused]] const RecordingEnd* handed_over = end.release();
  }
}

}  // namespace relievo
