// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/loop_session.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <QFile>
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
constexpr std::uint64_t kPlotEvery = 5;

bool on(EngagePhase phase) {
  return phase != EngagePhase::off;
}
}  // namespace

LoopSession::LoopSession(const std::string& device_id, const SampleSink& also)
    : LoopSession(makeDevice(device_id), device_id, also) {}

LoopSession::LoopSession(std::unique_ptr<Device> device, const std::string& device_id,
                         const SampleSink& also)
    : flight_(QFile::encodeName(flightFolder()).toStdString(),
              "relievo flight record, schema 1\ndevice " + device_id),
      plot_start_ns_(monotonicNs()) {
  hand_ = SteeredHand(dynamic_cast<SteeredDevice*>(device.get()));
  falcon_ = dynamic_cast<falcon::FalconDevice*>(device.get());
  foreign_ = dynamic_cast<foreign::ForeignDevice*>(device.get());
  haply_ = dynamic_cast<haply::HaplyDevice*>(device.get());
  loop_ = std::make_unique<HapticLoop>(std::move(device));
  loop_->start();
  recorder_.beginAt(loop_->snapshots(), buildId());
  std::vector<SampleSink> sinks{
      [this](std::span<const HapticSample> batch) { recorder_.take(batch); },
      [this](std::span<const HapticSample> batch) { flight_.take(batch); },
      [this](std::span<const HapticSample> batch) { plotSink(batch); }};
  if (also) sinks.push_back(also);
  drain_ = std::make_unique<SampleDrain>(loop_->samples(), std::move(sinks));
}

LoopSession::~LoopSession() {
  if (filling_.valid()) filling_.wait();  // It writes into the loop's slot.
  loop_->stop();
  drain_.reset();
}

void LoopSession::plotSink(std::span<const HapticSample> batch) {
  for (const HapticSample& sample : batch) {
    if (sample.tick % kPlotEvery != 0 || sample.window_id == 0) continue;
    const double t_s = 1e-9 * static_cast<double>(sample.time_ns - plot_start_ns_);
    plot_.push(forcePoint(touchRow(sample, t_s)));
  }
}

void LoopSession::show(RegionWindow window, SurfaceKind kind, SceneMaps maps) {
  waiting_ = Order{std::move(window), kind, std::move(maps), {}, 0};
  hand_since_.reset();
  prepareNext();
}

bool LoopSession::canWait() {
  return !pace_.forces_asked && !on(loop_->latest().front().engaged) && !recorder_.running() &&
         std::chrono::steady_clock::now() - pace_.begun < pace_.unfelt_every;
}

/// Spline, gradients and checksum of 40 000 heights take longer than a frame should wait.
void LoopSession::prepareNext() {
  if (filling_.valid() || !waiting_ || canWait()) return;
  pace_.begun = std::chrono::steady_clock::now();
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
  if (!filling_.valid()) return prepareNext();
  if (filling_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
  Order order = std::move(*std::exchange(coming_, std::nullopt));
  try {
    filling_.get();
  } catch (const Error& error) {
    problem_ = error.what();
    return prepareNext();
  }
  HapticSpace& space = loop_->spaces().back();
  space.scene_id = ++newest_.scene;
  RecordedScene scene{newest_.scene,     order.window.id, order.window.region,
                      order.window.gain, order.kind,      order.touched};
  scene.textured = space.texture.present;
  scene.checksum = order.checksum;
  notes_.addScene(std::move(scene), order.maps, recorder_.running());
  if (!shown_) shown_ = std::make_unique<HapticSpace>();
  *shown_ = space;
  loop_->spaces().publish();
  const HandMapping mapping = mappingOf(order.window, order.touched);
  window_ = std::move(order.window);
  const bool first = !std::exchange(has_window_, true);
  hand_.takeSurface(window_, mapping, loop_->latest().front(), first);
  if (hand_since_) moveHand(*hand_since_);
  prepareNext();
}

void LoopSession::moveHand(ViewMm target) {
  if (isPreparing()) {  // Its height is over the surface that comes, in a moment.
    hand_since_ = target;
    return;
  }
  if (has_window_) hand_.moveTo(window_, target);
}

void LoopSession::pushHand(DeviceMm by) {
  if (has_window_ && hand_.isSteered()) hand_.push(by, update().hip);
}

void LoopSession::setOptions(const HapticOptions& options) {
  HapticOptions named = withinDevice(options, loop_->device());
  named.id = ++newest_.options;
  notes_.addOptions(optionsLine(named), recorder_.running());
  loop_->options().write(named);
  pace_.forces_asked = options.force.forces_on;
  prepareNext();
}

std::uint64_t LoopSession::lead(GuidePath path) {
  path.id = ++newest_.guide;
  path.scene_id = newest_.scene;
  notes_.addPath(guideLine(path), recorder_.running());
  loop_->paths().write(path);
  return path.id;
}

void LoopSession::setUrgent(bool urgent) {
  loop_->rest(!urgent);
  drain_->setUrgent(urgent);
}

void LoopSession::startRecording(const std::string& file, const std::string& header) {
  if (!shown_ && filling_.valid()) {  // The very first: a few milliseconds.
    filling_.wait();
    takePrepared();
  }
  setUrgent(true);  // What waits was before the recording.
  recorder_.start(file, header, shown_.get());
  recording_folder_ = std::filesystem::path(file).parent_path();
  prepareNext();
  loop_->wantSnapshot();
}

void LoopSession::stopRecording(const std::string& footer) {
  recorder_.stop(footer + notes_.lines(recording_folder_));
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
