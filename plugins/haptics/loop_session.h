// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/region/probe.h"
#include "core/region/window.h"
#include "core/session/firmness.h"
#include "haptics/device/device.h"
#include "haptics/device/falcon/falcon_device.h"
#include "haptics/device/foreign/foreign_device.h"
#include "haptics/device/haply/haply_device.h"
#include "haptics/loop/haptic_loop.h"
#include "haptics/record/flight_record.h"
#include "haptics/record/recorded_loop.h"
#include "haptics/record/recorder.h"
#include "haptics/record/sample_drain.h"
#include "plugins/api/plugin.h"
#include "plugins/haptics/recording/replay_notes.h"
#include "plugins/haptics/steered_hand.h"

namespace relievo {

/// The running loop with one device, and the threads around it. All calls: GUI thread.
class LoopSession {
 public:
  /// Opens the device of that id (device_catalog.h) and starts the loop. @throw DeviceError, Error
  /// @param also  gets every sample, too
  explicit LoopSession(const std::string& device_id, const SampleSink& also = {});
  /// The same of one that may be open already.
  LoopSession(std::unique_ptr<Device> device, const std::string& device_id,
              const SampleSink& also = {});
  ~LoopSession();  ///< Zero force; all threads are joined on return.
  LoopSession(const LoopSession&) = delete;
  LoopSession& operator=(const LoopSession&) = delete;

  /// A new surface, which a worker prepares; one of the next update() hands it to the loop. The
  /// hand keeps its place sideways and its depth, so that a change of detail while touching goes on
  /// touching; so does another kind of surface of the same window. A newer one replaces one that
  /// waits. While forces are off and nothing is recorded, one that follows another at once waits
  /// for a moment: whoever drags the window feels none of those on the way.
  void show(RegionWindow window, SurfaceKind kind, SceneMaps maps = {});
  /// There is a surface, or one is being prepared.
  bool hasWindow() const noexcept { return has_window_ || isPreparing(); }
  bool isPreparing() const noexcept { return filling_.valid() || waiting_; }
  /// False while the hand rests and nothing is felt or recorded; see SampleDrain and
  /// HapticLoop::rest().
  void setUrgent(bool urgent);
  /// How long after another one a surface that nobody feels is prepared.
  void setUnfeltEvery(std::chrono::milliseconds time) { pace_.unfelt_every = time; }
  /// Why a surface could not be prepared, once; empty: nothing went wrong.
  std::string takeProblem() { return std::exchange(problem_, {}); }
  /// Where the pointer wants the hand, view mm of the shown window. Above the surface a mouse's
  /// hand hovers and touches nothing on its way; a target below it presses in at that place and,
  /// with those that follow, touches what lies between. A device that a person holds does not care.
  void moveHand(ViewMm target);
  /// Carries the hand on from where it was last sent, not from where it is: pushes that come faster
  /// than the hand follows add up. It never runs ahead by more than `kMostLeadMm`.
  void pushHand(DeviceMm by);
  static constexpr double kMostLeadMm = SteeredHand::kMostLeadMm;
  /// Mouse and keys say where the hand is, and no person who holds the device.
  bool isSteered() const noexcept { return hand_.isSteered(); }
  void setOptions(const HapticOptions& options);
  /// Begins with one of the next ticks; HDF5 gets the surface that is touched now.
  /// @throw as Recorder::start
  void startRecording(const std::string& file, const std::string& header);
  /// @param footer  lines that end the file, with what a replay needs after them
  void stopRecording(const std::string& footer);
  /// What the hand can be led along from now on, on the newest surface: GuideOptions name it.
  /// @return its id
  std::uint64_t lead(GuidePath path);
  /// A simulated hand that is led gives way, as an arm does: what was requested follows it. Once a
  /// frame; a device that a person holds does not care.
  void giveWay(const HapticSample& sample) { hand_.giveWay(sample.hip); }
  /// How the newest surface lies under the hand.
  const HandMapping& mapping() const noexcept { return hand_.mapping(); }
  const DeviceInfo& device() const noexcept { return loop_->device(); }
  /// In Move mode the window goes on below the hand: what is touched does not come along.
  void setMoving(bool moving) { moving_ = moving; }

  const HapticSample& update();  ///< The newest sample. Takes what the worker has prepared.
  const LoopStats& stats();
  std::vector<ForcePoint> takePlot();  ///< Since the last call, every fifth sample.
  std::optional<ButtonEvent> takeButton();
  /// How the Falcon is doing; null: the device is none.
  const falcon::LinkStatus* falconStatus();
  /// The device of a plug-in; null: it is none.
  const foreign::ForeignDevice* foreign() const noexcept { return foreign_; }
  /// After a fault that does not heal by itself; F5 asks for it.
  void retryDevice();
  const haply::LinkStatus* haplyStatus();  ///< The same of a device of Haply.
  Recorder& recorder() noexcept { return recorder_; }
  FlightRecord& flight() noexcept { return flight_; }
  HapticLoop& loop() noexcept { return *loop_; }

 private:
  /// A surface that was asked for.
  struct Order {
    RegionWindow window;
    SurfaceKind kind = SurfaceKind::crease_aware;
    SceneMaps maps;
    std::optional<Anchor> touched;  // Stays under the hand.
    std::uint64_t checksum = 0;     // Once it is prepared.
  };
  /// Of what the loop was given last.
  struct Ids {
    std::uint64_t scene = 0, options = 0, guide = 0;
  };
  struct Pace {
    std::chrono::milliseconds unfelt_every{150};
    std::chrono::steady_clock::time_point begun;  // When the worker last began to prepare one.
    bool forces_asked = false;
  };
  void prepareNext();
  bool canWait();  // What was asked for: nobody feels it, and the next one may replace it.
  void takePrepared();
  void plotSink(std::span<const HapticSample> batch);  // [drain thread]

  // In this order: the drain goes first and still finds the recorder and the loop's ring.
  Recorder recorder_;
  FlightRecord flight_;
  SpscRing<ForcePoint, 4096> plot_;
  std::int64_t plot_start_ns_ = 0;
  std::unique_ptr<HapticLoop> loop_;
  SteeredHand hand_{nullptr};
  falcon::FalconDevice* falcon_ = nullptr;     // Owned by the loop. Null: it is no Falcon.
  foreign::ForeignDevice* foreign_ = nullptr;  // Null: no plug-in drives it.
  haply::HaplyDevice* haply_ = nullptr;        // Likewise.
  std::unique_ptr<SampleDrain> drain_;
  Ids newest_;
  ReplayNotes notes_;
  std::filesystem::path recording_folder_;
  bool has_window_ = false, moving_ = false;
  RegionWindow window_;                 // The loop's newest; has_window_: there is one.
  std::unique_ptr<HapticSpace> shown_;  // The loop's newest; the loop's own cannot be read here.
  std::optional<Order> waiting_;        // The newest that was asked for.
  std::optional<Order> coming_;         // The worker prepares it, in the loop's back slot.
  Pace pace_;
  std::future<void> filling_;         // Last, so that it is waited for first.
  std::optional<ViewMm> hand_since_;  // Where the pointer wants it since the last show().
  std::string problem_;
};

/// Would a picture of the two differ? A hand at rest costs no frames.
bool looksTheSame(const Probe& a, const Probe& b);

/// For drawing and text.
Probe probeOf(const HapticSample& sample);

}  // namespace relievo
