// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/loop_session.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <QFile>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/recording/force_curve.h"
#include "core/region/hand.h"
#include "haptics/device_catalog.h"
#include "haptics/loop/device_limits.h"
#include "haptics/proxy/texture.h"
#include "haptics/rt/build_id.h"
#include "plugins/haptics/recording/recording_file.h"

namespace relievo {

namespace {
bool on(EngagePhase phase) {
  return phase != EngagePhase::off;
}

/// How a file is found from a folder; recordings and rasters may be moved together.
std::string foundFrom(const std::filesystem::path& folder, const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::path relative = std::filesystem::relative(file, folder, error);
  return (error || relative.empty() ? file : relative).generic_string();
}
}  // namespace

LoopSession::LoopSession(const std::string& device_id)
    : LoopSession(makeDevice(device_id), device_id) {}

LoopSession::LoopSession(std::unique_ptr<Device> device, const std::string& device_id)
    : flight_(QFile::encodeName(flightFolder()).toStdString(),
              "relievo flight record, schema 1\ndevice " + device_id),
      plot_start_ns_(monotonicNs()) {
  steered_ = dynamic_cast<SteeredDevice*>(device.get());
  falcon_ = dynamic_cast<falcon::FalconDevice*>(device.get());
  foreign_ = dynamic_cast<foreign::ForeignDevice*>(device.get());
  haply_ = dynamic_cast<haply::HaplyDevice*>(device.get());
  loop_ = std::make_unique<HapticLoop>(std::move(device));
  loop_->start();
  recorder_.beginAt(loop_->snapshots(), buildId());
  drain_ = std::make_unique<SampleDrain>(
      loop_->samples(), std::vector<SampleSink>{
                            [this](std::span<const HapticSample> batch) { recorder_.take(batch); },
                            [this](std::span<const HapticSample> batch) { flight_.take(batch); },
                            [this](std::span<const HapticSample> batch) { plotSink(batch); }});
}

LoopSession::~LoopSession() {
  if (filling_.valid()) filling_.wait();  // It writes into the loop's slot.
  loop_->stop();
  drain_.reset();
}

void LoopSession::plotSink(std::span<const HapticSample> batch) {
  for (const HapticSample& sample : batch) {
    if (sample.tick % plot_every_ != 0 || sample.window_id == 0) continue;
    const double t_s = 1e-9 * static_cast<double>(sample.time_ns - plot_start_ns_);
    plot_.push(forcePoint(touchRow(sample, t_s)));
  }
}

void LoopSession::show(RegionWindow window, SurfaceKind kind, SceneMaps maps) {
  waiting_ = Order{std::move(window), kind, std::move(maps), {}, 0};
  hand_since_.reset();
  prepareNext();
}

/// Spline, gradients and checksum of 40 000 heights take longer than a frame should wait.
void LoopSession::prepareNext() {
  if (filling_.valid() || !waiting_) return;
  coming_ = std::exchange(waiting_, std::nullopt);
  const HapticSample& last = loop_->latest().front();
  if (has_window_ && last.contact && !moving_)
    coming_->touched = Anchor{last.proxy_view, last.proxy};
  // The slot is the writer's own until it is published, here, once the worker is done.
  filling_ = std::async(std::launch::async, [&order = *coming_, &space = loop_->spaces().back()] {
    const RegionWindow& window = order.window;
    fill(space, window, {window.levels - window.region.level.value, window.levels}, order.kind,
         order.touched, order.maps.firmness);
    fillTexture(space, order.maps.finer_mm);
    order.checksum = sceneChecksum(space);
  });
}

void LoopSession::takePrepared() {
  if (!filling_.valid() ||
      filling_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
    return;
  }
  Order order = std::move(*std::exchange(coming_, std::nullopt));
  try {
    filling_.get();
  } catch (const Error& error) {
    problem_ = error.what();
    return prepareNext();
  }
  HapticSpace& space = loop_->spaces().back();
  space.scene_id = ++scene_id_;
  RecordedScene scene{scene_id_,         order.window.id, order.window.region,
                      order.window.gain, order.kind,      order.touched};
  scene.textured = space.texture.present;
  scene.checksum = order.checksum;
  keep(std::move(scene), order.maps);
  if (!shown_) shown_ = std::make_unique<HapticSpace>();
  *shown_ = space;
  loop_->spaces().publish();
  mapping_ = mappingOf(order.window, order.touched);
  window_ = std::move(order.window);
  const bool first = !std::exchange(has_window_, true);
  placeHand(loop_->latest().front(), first);
  if (hand_since_) moveHand(*hand_since_);
  prepareNext();
}

/// The hand keeps its place sideways, as far as that is over the window, and its depth.
void LoopSession::placeHand(const HapticSample& last, bool first) {
  if (steered_ == nullptr) return;
  const Region& r = window_.region;
  ViewMm over = mapping_.device_from_view.inverseOfSimilarity()(last.hip);
  if (first) over = {r.centreX(), r.centreY(), 0};
  over.x = std::clamp(over.x, r.x_mm, r.x_mm + r.side_mm);
  over.y = std::clamp(over.y, r.y_mm, r.y_mm + r.side_mm);
  const double depth = norm(last.proxy - last.hip);
  const bool pressing = !first && !hovers_ && last.contact;
  const ViewMm place = handOver(window_, over.x, over.y, pressing, depth);
  sent_ = mapping_.device_from_view(place);
  steered_->placeAt(sent_);
  if (!pressing) hoverAt(place);
}

void LoopSession::hoverAt(ViewMm target) {
  sent_ = mapping_.device_from_view(target);
  steered_->hoverAt(sent_);
  hovers_ = true;
}

void LoopSession::keep(RecordedScene scene, const SceneMaps& maps) {
  if (maps.firmness_from) {
    scene.firmness = maps.firmness_from->sha256;
    firmness_files_[scene.firmness] = maps.firmness_from->file;
  }
  if (!maps.map_state.empty()) {
    const auto known = std::find(map_states_.begin(), map_states_.end(), maps.map_state);
    scene.map = static_cast<std::uint64_t>(known - map_states_.begin()) + 1;
    if (known == map_states_.end()) map_states_.push_back(maps.map_state);
  }
  constexpr std::size_t kScenesInUse = 4;  // Of the loop, its change, the mailbox and this one.
  if (!recorder_.running() && scenes_.size() >= kScenesInUse) scenes_.erase(scenes_.begin());
  scenes_.push_back(std::move(scene));
}

void LoopSession::moveHand(ViewMm target) {
  if (filling_.valid()) {  // Its height is over the surface that comes, in a moment.
    hand_since_ = target;
    return;
  }
  if (!has_window_ || steered_ == nullptr) return;
  const bool presses = target.z < windowHeightMm(window_, target.x, target.y);
  if (!presses) return hoverAt(target);
  if (hovers_) hoverAt(handOver(window_, target.x, target.y, false, 0));
  hovers_ = false;
  sent_ = mapping_.device_from_view(target);
  steered_->moveTo(sent_);
}

void LoopSession::pushHand(DeviceMm by) {
  if (!has_window_ || steered_ == nullptr) return;
  const DeviceMm hip = update().hip;
  const double lead = norm(sent_ - hip);
  // A hand that a surface holds back is not pushed ever harder.
  if (lead > kMostLeadMm) sent_ = hip + (kMostLeadMm / lead) * (sent_ - hip);
  sent_ = sent_ + by;
  hovers_ = false;
  steered_->moveTo(sent_);
}

void LoopSession::setOptions(const HapticOptions& options) {
  HapticOptions named = withinDevice(options, loop_->device());
  named.id = ++options_id_;
  // The loop may still work with the last but one.
  if (!recorder_.running() && options_lines_.size() >= 3) {
    options_lines_.erase(options_lines_.begin());
  }
  options_lines_.push_back(optionsLine(named));
  loop_->options().write(named);
}

void LoopSession::startRecording(const std::string& file, const std::string& header) {
  if (!shown_ && filling_.valid()) {  // The very first: a few milliseconds.
    filling_.wait();
    takePrepared();
  }
  recorder_.start(file, header, shown_.get());
  recording_folder_ = std::filesystem::path(file).parent_path().string();
  loop_->wantSnapshot();
}

void LoopSession::stopRecording(const std::string& footer) {
  std::string lines = footer;
  std::set<std::uint64_t> maps;
  std::set<std::string> rasters;
  for (const RecordedScene& scene : scenes_) {
    lines += sceneLine(scene);
    const bool new_map = scene.map > 0 && maps.insert(scene.map).second;
    if (new_map) lines += mapLine(scene.map, map_states_[scene.map - 1]);
    const bool new_raster = !scene.firmness.empty() && rasters.insert(scene.firmness).second;
    if (!new_raster) continue;
    lines += firmnessLine(scene.firmness,
                          foundFrom(recording_folder_, firmness_files_.at(scene.firmness)));
  }
  for (const std::string& line : options_lines_) lines += line;
  recorder_.stop(lines);
}

const HapticSample& LoopSession::update() {
  loop_->latest().update();
  takePrepared();
  return loop_->latest().front();
}

const LoopStats& LoopSession::stats() {
  loop_->stats().update();
  return loop_->stats().front();
}

const falcon::LinkStatus* LoopSession::falconStatus() {
  return falcon_ == nullptr ? nullptr : &falcon_->status();
}

const haply::LinkStatus* LoopSession::haplyStatus() {
  return haply_ == nullptr ? nullptr : &haply_->status();
}

void LoopSession::retryDevice() {
  const haply::LinkStatus* const status = haplyStatus();
  if (status == nullptr) return;
  const haply::LinkState state = status->state;
  if (state == haply::LinkState::disobeyed || state == haply::LinkState::foreign) haply_->retry();
}

std::vector<ForcePoint> LoopSession::takePlot() {
  std::vector<ForcePoint> samples;
  ForcePoint sample;
  while (plot_.pop(sample)) samples.push_back(sample);
  return samples;
}

std::optional<ButtonEvent> LoopSession::takeButton() {
  ButtonEvent event;
  if (!loop_->buttons().pop(event)) return std::nullopt;
  return event;
}

bool looksTheSame(const Probe& a, const Probe& b) {
  // Text shows hundredths; a pixel is far more than a ten-thousandth of what moves.
  constexpr double kNewton = 1e-3, kPart = 1e-4;
  const double near_mm = kPart * (1e-3 + norm(a.proxy - a.hip));
  return a.window_id == b.window_id && a.touching == b.touching && a.forces_on == b.forces_on &&
         a.origin == b.origin && a.force_limit_n == b.force_limit_n &&
         norm(a.force - b.force) < kNewton && norm(a.proxy - b.proxy) < near_mm &&
         norm(a.hip - b.hip) < near_mm;
}

Probe probeOf(const HapticSample& sample) {
  Probe probe;
  probe.proxy = sample.proxy_view;
  probe.hip = sample.hip_view;
  probe.force = sample.force;
  probe.force_limit_n = sample.limit_n;
  probe.touching = sample.contact;
  probe.forces_on = on(sample.engaged);
  probe.origin = sample.origin;
  probe.window_id = sample.window_id;
  return probe;
}

}  // namespace relievo
