// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/recorder.h"

#include <utility>

#include "core/base/error.h"

namespace relievo {

namespace {
/// What happened between two samples, for the event column.
std::string eventBetween(const HapticSample& before, const HapticSample& now) {
  std::string event;
  const auto add = [&event](const std::string& text) {
    event += (event.empty() ? "" : "; ") + text;
  };
  if (now.tick != before.tick + 1) {
    add(std::to_string(now.tick - before.tick - 1) + " samples dropped before this one");
  }
  if (now.window_id != before.window_id) add("new window");
  if (now.fault != before.fault) add(std::string(describe(now.fault)));
  return event;
}
}  // namespace

Recorder::~Recorder() {
  LogWriter* writer = nullptr;
  while (commands_.pop(writer)) delete writer;
  RecordingEnd* end = nullptr;
  while (ends_.pop(end)) delete end;
}

void Recorder::start(const std::filesystem::path& file, std::string_view header) {
  if (running_) throw Error("A recording is running already; stop it first.");
  auto writer = std::make_unique<LogWriter>(file, header);
  counts_.update();
  if (!commands_.push(writer.get())) throw Error("The recorder does not answer; try again.");
  [[maybe_unused]] const LogWriter* handed_over = writer.release();
  running_ = true;
}

void Recorder::stop() {
  if (running_) commands_.push(nullptr);
}

std::uint64_t Recorder::samples() noexcept {
  counts_.update();
  return counts_.front();
}

std::optional<RecordingEnd> Recorder::ended() {
  RecordingEnd* pointer = nullptr;
  if (!ends_.pop(pointer)) return std::nullopt;
  const std::unique_ptr<RecordingEnd> end(pointer);
  running_ = false;
  return std::move(*end);
}

void Recorder::take(std::span<const HapticSample> batch) {
  switchOver();
  for (const HapticSample& sample : batch) {
    if (!writer_) return;
    write(sample);
  }
  if (writer_) counts_.write(writer_->rows());
}

void Recorder::switchOver() {
  LogWriter* command = nullptr;
  while (commands_.pop(command)) {
    if (writer_) finish({});
    writer_.reset(command);
    first_ = true;
    counts_.write(0);
  }
}

void Recorder::write(const HapticSample& sample) {
  if (first_) start_ns_ = sample.time_ns;
  const std::string event = first_ ? std::string() : eventBetween(last_, sample);
  first_ = false;
  last_ = sample;
  try {
    writer_->write(sample, static_cast<double>(sample.time_ns - start_ns_) / 1e9, event);
  } catch (const WriteError& error) {
    finish(error.what());
  }
}

void Recorder::finish(std::string error) {
  if (error.empty()) {
    try {
      writer_->close();
    } catch (const WriteError& late) {
      error = late.what();
    }
  }
  auto end = std::make_unique<RecordingEnd>(
      RecordingEnd{writer_->file(), writer_->rows(), std::move(error)});
  writer_.reset();
  if (ends_.push(end.get())) {
    [[maybe_unused]] const RecordingEnd* handed_over = end.release();
  }
}

}  // namespace relievo
