// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <type_traits>

#include "haptics/device/device.h"
#include "haptics/force/force_audit.h"
#include "haptics/force/force_model.h"
#include "haptics/force/move_detent.h"
#include "haptics/guide/beacon_pull.h"
#include "haptics/guide/felt_taps.h"
#include "haptics/guide/guide.h"
#include "haptics/loop/force_stop.h"
#include "haptics/loop/hand_speed.h"
#include "haptics/loop/rate_watch.h"
#include "haptics/loop/scene_change.h"
#include "haptics/loop/scene_frame.h"
#include "haptics/loop/settings_blend.h"
#include "haptics/loop/soft_spring.h"
#include "haptics/loop/stable_stiffness.h"
#include "haptics/loop/surface_fields.h"
#include "haptics/proxy/proxy.h"
#include "haptics/rt/realtime.h"
#include "haptics/space/grip_position.h"
#include "haptics/space/haptic_space.h"

namespace relievo {

/// What stands between the spring and the device. `bare`: nothing, bareForce(); for strokes and
/// simulated hands alone, chosen when the core is made and not by options that change while it
/// runs.
enum class ForceChain : std::uint8_t { whole, bare };

struct HapticOptions {
  ProxyOptions proxy;
  ForceOptions force;
  FieldOptions fields;
  bool stiffness_by_detail =
      true;  ///< k from the window's detail; false: force.stiffness_n_per_mm.
  DetailStiffness detail_stiffness = kDetailStiffness;
  /// Keeps the proxy over the window and asks the hand back gently; false: beyond its outermost
  /// samples the surface goes on as a constant.
  bool frame = false;
  /// A cushion at the workspace's edge; with a frame always. withinDevice() asks for it where a
  /// person holds a device that pushes.
  bool cushion = false;
  Workspace workspace;   ///< The device's, as the hand has it.
  std::uint64_t id = 0;  ///< Given by whoever sets them; names these very values in recordings.
  MoveDetent detent;     ///< While on, felt in place of the surface.
  GuideOptions guide;    ///< Likewise, while it leads.
  BeaconOptions beacon;  ///< Felt with the surface.
  TapOptions taps;       ///< Likewise.
  ForceStopOptions stop;
  /// Below RateWatch::kLeastHz no surface is stiffer than what `timing` allows at the rate that is
  /// left (E306). Without a `timing`, which withinDevice() knows of a device that pushes, none
  /// holds.
  bool bound_by_rate = true;
  bool holds_grip = true;  ///< Against the grip's weight, where it is known and not held already.
  DeviceTiming timing{.rate_hz = 0};  ///< The device's; rate 0: not known.
  /// How the device stands: readings and forces of the core are the hand's, whatever it is. Another
  /// one begins as the first tick does, without force.
  GripPosition grip = GripPosition::upright;
};
static_assert(std::is_trivially_copyable_v<HapticOptions>);

/// A loop or a device that is too slow for what was asked for (E306).
struct SlowRate {
  double rate_hz = 0;  ///< 0: fast enough, or nothing had to be softened.
  // Stiffness of firm ground at this level, N per mm of hand.
  double asked_n_per_mm = 0, held_n_per_mm = 0;
};

/// Everything one tick saw and did. Goes to the view, the plots, the recorder and the tests.
struct HapticSample {
  std::uint64_t tick = 0;    ///< From 0, without gaps at the source: a missing number was dropped.
  std::int64_t time_ns = 0;  ///< Monotonic, of the tick.
  std::uint64_t window_id = 0;
  std::uint64_t scene_id = 0, options_id = 0;  ///< As HapticSpace and HapticOptions name them.
  DeviceMm hip, proxy;                         ///< Hand mm.
  ViewMm hip_view, proxy_view;
  GridPoint normal{0, 0, 1};  ///< Unit normal of the surface at the proxy.
  DeviceN force;              ///< On the hand, after all stages.
  double f_cmd_n = 0;         ///< Its norm before limits.
  double limit_n = 0;         ///< The cap that held.
  double damped_n = 0;        ///< Of f_cmd_n: the passivity controller's share, before strength.
  double margin_mj = 0;       ///< What the surface may still give; < 0: it owes.
  double stiffness_n_per_mm = 0;       ///< At the proxy.
  double firm_stiffness_n_per_mm = 0;  ///< Where the ground is firm.
  double rate_hz = 0;  ///< Measured rate of the loop; 1000 on the deterministic clock.
  double age_s = 0;    ///< Of the position.
  std::uint32_t buttons = 0;
  std::uint8_t softened = 0;  ///< How often an oscillation halved the stiffness.
  std::int32_t detail = 1;
  std::int32_t tick_ns = 0;  ///< Time spent computing, without the device.
  DeviceFault fault = DeviceFault::none;
  CellStatus origin = CellStatus::outside;  ///< Of the sample under the proxy.
  EngagePhase engaged = EngagePhase::off;
  StopReason stopped = StopReason::none;  ///< Asked for, and the loop itself ended them.
  GuidePhase guide = GuidePhase::off;
  GuideEnd guide_end = GuideEnd::none;  ///< Of the last run.
  std::uint64_t guide_path = 0;         ///< GuidePath::id of the last run; 0: there was none.
  GuideEnd beacon_end = GuideEnd::none;
  std::uint64_t beacon = 0;  ///< BeaconOptions::id of the last pull; 0: there was none.
  std::uint64_t taps = 0;    ///< TapOptions::id of the last pattern; 0: there was none.
  SlowRate slow;
  double change = 1;  ///< How much of a new surface is there; 1: all of it, none is coming.
  bool contact = false;
  bool pulled_back = false;  ///< By a beacon.
  bool tapped = false;       ///< A pattern is being felt, or waits.
  bool clamped = false;      ///< A limit changed the force.
  std::uint8_t frame = 0;    ///< Sides of the window that the hand pushes over: pan that way.
  bool late = false;         ///< This tick came more than half a period late.
  bool resumed = false;      ///< No tick came for longer than kPauseNs; the force starts from zero.
};
static_assert(std::is_trivially_copyable_v<HapticSample>);

/// What names the surface of a tick, and how the device stood to it.
struct FeltSurface {
  std::uint64_t window_id = 0, scene_id = 0;
  SurfaceKind surface = SurfaceKind::crease_aware;
  GripPosition grip = GripPosition::upright;
};

/// The loop without a thread, a clock or a device: the loop's thread, tests and `touch` drive it.
class HapticCore {
 public:
  HapticCore() RELIEVO_REALTIME = default;
  explicit HapticCore(ForceChain chain) RELIEVO_REALTIME : chain_(chain) {}
  /// Given where the hand is, what should it feel? `now_ns` is the time of this tick on the clock
  /// of the readings. A hand that hovers (kHoverBit) is above the surface, wherever it comes from,
  /// and touches from there once it is put down. A window with a new id keeps the hand, places the
  /// proxy on or above the new surface and fades the force in. A fault, or a hand that is no finite
  /// place, gives zero force until forces_on was false for a tick.
  /// @param path  that the options name (GuideOptions); null: there is none
  HapticSample tick(const HapticSpace& space, const HapticOptions& options,
                    const DeviceReading& reading, std::int64_t now_ns,
                    const GuidePath* path = nullptr) RELIEVO_REALTIME;
  /// The same, with the surface that lay under the hand before: a new one then comes gradually, in
  /// contact and out of it. Both must stay as they are while changing().
  HapticSample tick(const HapticSpace& space, const HapticSpace& previous,
                    const HapticOptions& options, const DeviceReading& reading, std::int64_t now_ns,
                    const GuidePath* path = nullptr) RELIEVO_REALTIME;
  bool changing() const RELIEVO_REALTIME { return change_.running(); }
  /// Would the next tick on this surface look at the one before, too?
  bool looksBackFrom(const HapticSpace& space) const RELIEVO_REALTIME {
    return changing() || (placed_ && !isFelt(space));
  }

  /// No tick came for so long before `now_ns` that the force must start from zero: what is handed
  /// to the device first is zero, too.
  bool pausedUntil(std::int64_t now_ns) const RELIEVO_REALTIME;
  static constexpr std::int64_t kPauseNs = 20'000'000;
  /// The next tick counts as the first after a pause, as when a watchdog cut the force.
  void resume() RELIEVO_REALTIME { resume_ = true; }

  /// Ticks so far; the next one has this number.
  std::uint64_t ticks() const RELIEVO_REALTIME { return tick_; }
  /// What was sent against what may be sent, since the core was made.
  const ForceAudit& audit() const RELIEVO_REALTIME { return audit_; }

  /// Next tick starts as the first one did; the tick count goes on.
  void reset() RELIEVO_REALTIME;

 private:
  friend struct NamedFields;  // Recordings hold every member by its name.
  /// Is it the surface of the last tick? The same window is filled anew with another firmness.
  bool isFelt(const HapticSpace& space) const RELIEVO_REALTIME {
    return space.window_id == felt_.window_id && space.surface == felt_.surface &&
           space.scene_id == felt_.scene_id;
  }
  void check(const ForceOptions& options, const ForceInput& input, bool paused, DeviceN before,
             DeviceN sent) RELIEVO_REALTIME;
  /// The same with what people set on its way.
  HapticOptions settled(HapticOptions asked, int detail) RELIEVO_REALTIME;
  void keepSteady(const HapticOptions& asked, int detail, DetailStiffness& k) RELIEVO_REALTIME;
  FeltSpring feltSpring(const HapticOptions& options) const RELIEVO_REALTIME;
  DeviceFault latch(const HapticOptions& options, const DeviceReading& reading) RELIEVO_REALTIME;
  SurfaceLift follow(const HapticSpace& space, const HapticSpace* previous,
                     const HapticOptions& options, bool hovers) RELIEVO_REALTIME;
  /// Where the hand is in the window, brought to a stop at its frame.
  void placeHand(const HapticSpace& space, const HapticOptions& options) RELIEVO_REALTIME;
  /// Carries the hand up to where nothing is touched, if it is not there.
  void liftHand(const HapticSpace& space, const HapticOptions& options) RELIEVO_REALTIME;
  double stiffness(const HapticSpace& space, const HapticOptions& options) const RELIEVO_REALTIME;
  Fields fields(const HapticSpace& space, const HapticSpace* previous, GridPoint held, double k,
                const HapticOptions& options) const RELIEVO_REALTIME;
  /// The same with only so much of soft ground's spring as the hand paid for.
  Fields yielding(const HapticSpace& space, Fields felt, GridPoint held, double k,
                  const HapticOptions& options) RELIEVO_REALTIME;
  HapticSample tickOn(const HapticSpace& space, const HapticSpace* previous,
                      const HapticOptions& asked, const DeviceReading& reading, std::int64_t now_ns,
                      const GuidePath* path) RELIEVO_REALTIME;
  /// What the frame leaves of spring and fields at this hand, with the cushions.
  void throughFrame(const HapticSpace& space, const HapticOptions& options, Fields& felt,
                    ForceInput& input) const RELIEVO_REALTIME;
  ForceInput throughDetent(const MoveDetent& detent, const ForceInput& input,
                           ForceOptions& options) const RELIEVO_REALTIME;
  /// Leads the hand, if it is to be led: from there on as by the pull of Move mode.
  GuideStep lead(const HapticOptions& options, const GuidePath* path,
                 const GuideInput& guide) RELIEVO_REALTIME;
  /// What leads and pulls the hand must know of it.
  GuideInput guideInput(const HapticOptions& options, const ForceInput& input,
                        std::uint32_t buttons, const ForceOptions& force) const RELIEVO_REALTIME;
  /// Adds a beacon's pull to what is felt of the surface.
  void pullBack(const HapticOptions& options, GuideInput guide, double strength,
                ForceInput& input) RELIEVO_REALTIME;
  /// Likewise a felt pattern.
  void tapHand(const HapticOptions& options, GuideInput guide, double strength,
               ForceInput& input) RELIEVO_REALTIME;
  ForceInput throughGuide(const GuideStep& step, const ForceInput& input,
                          ForceOptions& options) const RELIEVO_REALTIME;
  void checkGuide(const GuideStep& step, const ForceOptions& options,
                  DeviceN sent) RELIEVO_REALTIME;
  HapticSample describeTick(const HapticSpace& space,
                            const HapticSpace* previous) const RELIEVO_REALTIME;

  ProxyState proxy_;
  ForceChain chain_ = ForceChain::whole;
  SceneChange change_;
  SettingsBlend settings_;
  RateWatch rate_;
  SlowRate slow_;
  FeltNow felt_now_;  // Of the last tick.
  SceneFrame frame_;
  FramedHand hand_;  // Of this tick.
  SoftSpring soft_;
  ForceState force_;
  ForceStop stop_;
  GuideState guide_;
  /// What is felt with the surface.
  struct Cues {
    BeaconState beacon;
    TapState taps;
  };
  Cues cues_;
  ForceAudit audit_;

  HandSpeed speed_;
  DeviceMm hip_;  // The last hand that was a place.
  DeviceFault fault_ = DeviceFault::none;
  std::uint64_t tick_ = 0;
  FeltSurface felt_;          // In the last tick.
  std::int64_t last_ns_ = 0;  // Of the last tick.
  bool in_detent_ = false;    // In the last tick.
  bool guided_ = false;       // Likewise.
  bool placed_ = false;
  bool resume_ = false;
};

static_assert(std::is_trivially_copyable_v<HapticCore>);

}  // namespace relievo
