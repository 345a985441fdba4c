// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/recorder.h"

#include <utility>

#include "core/base/error.h"
#include "haptics/record/events.h"
#include "haptics/record/recorded_loop.h"

namespace relievo {

Recorder::~Recorder() {
  SampleLog* writer = nullptr;
  while (commands_.pop(writer)) delete writer;
  RecordingEnd* end = nullptr;
  while (ends_.pop(end)) delete end;
  std::string* footer = nullptr;
  while (footers_.pop(footer)) delete footer;
  while (notes_.pop(footer)) delete footer;
}

void Recorder::start(const std::filesystem::path& file, std::string_view header,
                     const HapticSpace* surface) {
  if (running_) throw Error("A recording is running already; stop it first.");
  std::unique_ptr<SampleLog> writer = openLog(file, header, surface, LogKind::recording);
  counts_.update();
  if (!commands_.push(writer.get())) throw Error("The recorder does not answer; try again.");
  [[maybe_unused]] const SampleLog* handed_over = writer.release();
  running_ = true;
}

void Recorder::stop(const std::string& footer) {
  if (!running_) return;
  auto text = std::make_unique<std::string>(footer);
  if (footers_.push(text.get())) {
    [[maybe_unused]] const std::string* handed_over = text.release();
  }
  commands_.push(nullptr);
}

bool Recorder::note(const std::string& event) {
  if (!running_) return false;
  auto text = std::make_unique<std::string>(event);
  if (!notes_.push(text.get())) return false;
  [[maybe_unused]] const std::string* handed_over = text.release();
  return true;
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

void Recorder::beginAt(SnapshotRing& snapshots, std::string build) {
  snapshots_ = &snapshots;
  build_ = std::move(build);
}

void Recorder::take(std::span<const HapticSample> batch) {
  switchOver();
  if (snapshots_ != nullptr) {
    CoreSnapshot newest;
    while (snapshots_->pop(newest)) {
      if (writer_ && !begins_) begins_ = newest;
    }
  }
  for (const HapticSample& sample : batch) {
    if (!writer_) return;
    const bool waits = snapshots_ != nullptr && (!begins_ || sample.tick < begins_->tick);
    if (!waits) write(sample);
  }
  if (writer_) counts_.write(writer_->rows());
}

void Recorder::switchOver() {
  SampleLog* command = nullptr;
  while (commands_.pop(command)) {
    if (writer_) finish(nullptr);
    writer_.reset(command);
    first_ = true;
    begins_.reset();
    replay_lines_.clear();
    counts_.write(0);
  }
}

void Recorder::write(const HapticSample& sample) {
  if (first_) start_ns_ = sample.time_ns;
  if (begins_) {
    if (first_) replay_lines_ = snapshotLine(*begins_, start_ns_, build_);
    replay_lines_ += changeLine(first_ ? nullptr : &last_, sample);
  }
  std::string event = first_ ? eventAtStart(sample) : eventBetween(last_, sample);
  if (event.empty()) event = takeNote();  // A row of its own: whatever it says, it is read back.
  first_ = false;
  last_ = sample;
  try {
    writer_->write(sample, static_cast<double>(sample.time_ns - start_ns_) / 1e9, event);
  } catch (const WriteError& error) {
    finish(&error);
  }
}

std::string Recorder::takeNote() {
  std::string* note = nullptr;
  if (!notes_.pop(note)) return {};
  const std::unique_ptr<std::string> taken(note);
  return std::move(*taken);
}

void Recorder::finish(const WriteError* stopped) {
  std::string error = stopped == nullptr ? std::string() : stopped->what();
  auto message = stopped == nullptr ? nullptr : stopped->message;
  std::string notes;
  for (std::string note = takeNote(); !note.empty(); note = takeNote()) notes += note + '\n';
  if (error.empty()) {
    try {
      std::string* footer = nullptr;
      std::unique_ptr<std::string> last;
      while (footers_.pop(footer)) last.reset(footer);
      writer_->close((last ? *last : std::string()) + notes + replay_lines_);
    } catch (const WriteError& late) {
      error = late.what();
      message = late.message;
    }
  }
  auto end = std::make_unique<RecordingEnd>(
      RecordingEnd{writer_->file(), writer_->rows(), std::move(error), std::move(message)});
  writer_.reset();
  if (ends_.push(end.get())) {
    [[maybe_unused]] const RecordingEnd* handed_over = end.release();
  }
}

}  // namespace relievo
