// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <type_traits>

#include "haptics/loop/core_snapshot.h"

namespace relievo {

/// Every member of what a replay starts from and is set by, with its name in recordings, so that
/// another build reads it. A test counts the bytes: a member that is not listed here is missing.
struct NamedFields {
  template <class T, class Struct>
  static constexpr bool kIs = std::same_as<std::remove_const_t<T>, Struct>;

  /// Calls `visit(name, member)` for each member of `s`, in order; const where `s` is.
  template <class Visit, class T>
  static void visit(Visit& visit, T& s) {
    // clang-format off
    if constexpr (kIs<T, HapticOptions>) {
      visit("proxy", s.proxy); visit("force", s.force); visit("fields", s.fields);
      visit("stiffness_by_detail", s.stiffness_by_detail); visit("detail_stiffness", s.detail_stiffness);
      visit("frame", s.frame); visit("cushion", s.cushion); visit("workspace", s.workspace); visit("id", s.id);
      visit("gate", s.detent); visit("guide", s.guide); visit("beacon", s.beacon); visit("taps", s.taps); visit("stop", s.stop); visit("bound_by_rate", s.bound_by_rate);
      visit("holds_grip", s.holds_grip); visit("timing", s.timing); visit("grip", s.grip);
    } else if constexpr (kIs<T, ProxyOptions>) {
      visit("kind", s.kind); visit("step_mm", s.step_mm); visit("updates_per_tick", s.updates_per_tick);
      visit("static_friction", s.static_friction); visit("dynamic_friction", s.dynamic_friction);
    } else if constexpr (kIs<T, ForceOptions>) {
      visit("stiffness_n_per_mm", s.stiffness_n_per_mm); visit("damping_n_s_per_mm", s.damping_n_s_per_mm);
      visit("strength", s.strength); visit("lift_n", s.lift_n); visit("lift_out", s.lift_out); visit("limit_n", s.limit_n);
      visit("engage_slew_n_per_s", s.engage_slew_n_per_s); visit("contact_slew_n_per_s", s.contact_slew_n_per_s);
      visit("rise_s", s.rise_s); visit("stale_after_s", s.stale_after_s); visit("stale_zero_s", s.stale_zero_s);
      visit("quiet_n", s.quiet_n); visit("quiet_ticks", s.quiet_ticks); visit("transient", s.transient);
      visit("passivity", s.passivity); visit("oscillation", s.oscillation); visit("forces_on", s.forces_on);
    } else if constexpr (kIs<T, TransientOptions>) {
      visit("contact_n", s.contact_n); visit("contact_n_s_per_mm", s.contact_n_s_per_mm);
      visit("crossing_n", s.crossing_n); visit("most_mj", s.most_mj);
    } else if constexpr (kIs<T, PassivityOptions>) {
      visit("on", s.on); visit("most_damping_n_s_per_mm", s.most_damping_n_s_per_mm);
      visit("reserve_mj", s.reserve_mj); visit("most_debt_mj", s.most_debt_mj);
      visit("position_step_mm", s.position_step_mm); visit("force_delay_ticks", s.force_delay_ticks);
    } else if constexpr (kIs<T, OscillationOptions>) {
      visit("on", s.on); visit("peak_to_peak_n", s.peak_to_peak_n);
      visit("per_speed_n_s_per_mm", s.per_speed_n_s_per_mm); visit("least_factor", s.least_factor);
    } else if constexpr (kIs<T, FieldOptions>) {
      visit("softest_part", s.softest_part); visit("texture_mm", s.texture_mm);
      visit("magnet_n", s.magnet_n); visit("magnet_reach_mm", s.magnet_reach_mm);
    } else if constexpr (kIs<T, Workspace>) {
      visit("half_extent", s.half_extent);
    } else if constexpr (kIs<T, MoveDetent>) {
      visit("on", s.on); visit("centre", s.centre); visit("blocked", s.blocked);
    } else if constexpr (kIs<T, GuideOptions>) {
      visit("path", s.path);
    } else if constexpr (kIs<T, BeaconOptions>) {
      visit("id", s.id); visit("place", s.place); visit("scene_id", s.scene_id);
    } else if constexpr (kIs<T, TapOptions>) {
      visit("id", s.id); visit("pattern", s.pattern);
    } else if constexpr (kIs<T, TapState>) {
      visit("id", s.id); visit("left", s.left); visit("since_s", s.since_s); visit("waited_s", s.waited_s);
      visit("from_mm", s.from_mm); visit("force_n", s.force_n);
    } else if constexpr (kIs<T, BeaconState>) {
      visit("id", s.id); visit("end", s.end); visit("place", s.place); visit("weight", s.weight);
      visit("since_s", s.since_s); visit("away_s", s.away_s); visit("fast_s", s.fast_s);
      visit("buttons", s.buttons); visit("pulls", s.pulls);
    } else if constexpr (kIs<T, GuideState>) {
      visit("path", s.path); visit("phase", s.phase); visit("end", s.end); visit("from", s.from); visit("to", s.to);
      visit("path_mm", s.path_mm); visit("target_mm", s.target_mm); visit("hand_mm", s.hand_mm);
      visit("speed_mm_per_s", s.speed_mm_per_s); visit("pause_s", s.pause_s); visit("since_s", s.since_s);
      visit("against_s", s.against_s); visit("fast_s", s.fast_s); visit("buttons", s.buttons);
    } else if constexpr (kIs<T, ForceStopOptions>) {
      visit("buttons", s.buttons); visit("window_silence_s", s.window_silence_s);
      visit("window_silent", s.window_silent);
    } else if constexpr (kIs<T, DeviceTiming>) {
      visit("rate_hz", s.rate_hz); visit("delay_ticks", s.delay_ticks); visit("position_step_mm", s.position_step_mm);
    } else if constexpr (kIs<T, CoreSnapshot>) {
      visit("tick", s.tick); visit("core", s.core); visit("scene_id", s.scene_id);
      visit("previous_scene_id", s.previous_scene_id); visit("gradual", s.gradual);
    } else if constexpr (kIs<T, HapticCore>) {
      visit("proxy", s.proxy_); visit("chain", s.chain_); visit("change", s.change_); visit("settings", s.settings_);
      visit("rate", s.rate_); visit("slow", s.slow_); visit("felt_now", s.felt_now_); visit("frame", s.frame_);
      visit("hand", s.hand_); visit("soft", s.soft_); visit("force", s.force_); visit("stop", s.stop_); visit("guide", s.guide_); visit("beacon", s.cues_.beacon);
      visit("taps", s.cues_.taps);
      visit("audit", s.audit_); visit("places", s.speed_.places_); visit("oldest", s.speed_.oldest_);
      visit("places_seen", s.speed_.seen_); visit("hip", s.hip_); visit("fault", s.fault_); visit("tick", s.tick_);
      visit("window_id", s.felt_.window_id); visit("scene_id", s.felt_.scene_id); visit("surface", s.felt_.surface);
      visit("last_ns", s.last_ns_); visit("grip", s.felt_.grip); visit("gated", s.in_detent_); visit("guided", s.guided_); visit("placed", s.placed_); visit("resume", s.resume_);
    } else if constexpr (kIs<T, HandSpeed::Place>) {
      visit("position", s.position); visit("time_ns", s.time_ns);
    } else if constexpr (kIs<T, ProxyState>) {
      visit("position", s.position); visit("hip", s.hip); visit("contact", s.contact); visit("slides", s.slides);
      visit("still", s.still); visit("trail_x", s.trail_x); visit("trail_y", s.trail_y);
    } else if constexpr (kIs<T, SceneChange>) {
      visit("running", s.running_); visit("lets_go", s.lets_go_); visit("creep_ticks", s.creep_ticks_); visit("weight", s.weight_);
      visit("spring", s.spring_);
    } else if constexpr (kIs<T, SpringChange>) {
      visit("was_n_per_mm", s.was_n_per_mm); visit("now_n_per_mm", s.now_n_per_mm);
      visit("softest_part", s.softest_part);
    } else if constexpr (kIs<T, SettingsBlend>) {
      visit("started", s.started_); visit("felt", s.felt_);
    } else if constexpr (kIs<T, FeltSettings>) {
      visit("strength", s.strength); visit("stiffness_n_per_mm", s.stiffness_n_per_mm);
      visit("damping_n_s_per_mm", s.damping_n_s_per_mm); visit("lift_n", s.lift_n);
      visit("static_friction", s.static_friction); visit("dynamic_friction", s.dynamic_friction);
      visit("fields", s.fields);
    } else if constexpr (kIs<T, RateWatch>) {
      visit("started", s.started_); visit("now_ns", s.now_ns_); visit("passed_ns", s.passed_ns_);
      visit("reading_ns", s.reading_ns_); visit("ticks", s.ticks_); visit("readings", s.readings_);
      visit("slow_hz", s.slow_hz_); visit("slow_ns", s.slow_ns_);
    } else if constexpr (kIs<T, SlowRate>) {
      visit("rate_hz", s.rate_hz); visit("asked_n_per_mm", s.asked_n_per_mm); visit("held_n_per_mm", s.held_n_per_mm);
    } else if constexpr (kIs<T, FeltNow>) {
      visit("detail", s.detail); visit("depth_mm", s.depth_mm); visit("speed_mm_per_s", s.speed_mm_per_s);
      visit("rise", s.rise);
    } else if constexpr (kIs<T, SceneFrame>) {
      visit("pushing_ticks", s.pushing_ticks_);
    } else if constexpr (kIs<T, FramedHand>) {
      visit("place", s.place); visit("along_x", s.along_x); visit("along_y", s.along_y);
    } else if constexpr (kIs<T, SoftSpring>) {
      visit("share", s.share); visit("last", s.last); visit("watched", s.watched);
    } else if constexpr (kIs<T, SoftPull>) {
      visit("energy_mm2", s.energy_mm2); visit("pull", s.pull); visit("hand", s.hand);
      visit("least_share", s.least_share);
    } else if constexpr (kIs<T, ForceState>) {
      visit("last", s.last); visit("phase", s.phase); visit("rise", s.rise); visit("quiet", s.quiet);
      visit("transient", s.transient); visit("passivity", s.passivity); visit("oscillation", s.oscillation);
    } else if constexpr (kIs<T, TransientState>) {
      visit("normal", s.normal); visit("size_n", s.size_n); visit("last_n", s.last_n);
      visit("given_mj", s.given_mj); visit("age", s.age); visit("contact", s.contact); visit("measured", s.measured);
    } else if constexpr (kIs<T, PassivityState>) {
      visit("sent", s.sent); visit("margin_mj", s.margin_mj); visit("stored_mj", s.stored_mj);
      visit("started", s.started);
    } else if constexpr (kIs<T, OscillationState>) {
      visit("axes", s.axes); visit("block_start", s.block_start); visit("ticks", s.ticks); visit("owed", s.owed);
      visit("swinging_blocks", s.swinging_blocks); visit("softened", s.softened); visit("factor", s.factor);
      visit("started", s.started);
    } else if constexpr (kIs<T, OscillationState::Axis>) {
      visit("mean", s.mean); visit("band", s.band); visit("low", s.low); visit("high", s.high);
      visit("crossings", s.crossings); visit("above", s.above);
    } else if constexpr (kIs<T, ForceStop>) {
      visit("reason", s.reason_); visit("down", s.down_); visit("counts", s.counts_); visit("down_ns", s.down_ns_);
      visit("silent_ns", s.silent_ns_);
    } else {
      static_assert(kIs<T, ForceAudit>, "a struct whose members have no names here");
      visit("ticks", s.ticks); visit("zero_demanded", s.zero_demanded); visit("zero_violations", s.zero_violations);
      visit("limit_violations", s.limit_violations); visit("step_violations", s.step_violations);
      visit("largest_n", s.largest_n); visit("fast_falls", s.fast_falls); visit("largest_step_n", s.largest_step_n);
      visit("guided_ticks", s.guided_ticks); visit("guide_violations", s.guide_violations);
      visit("largest_guide_n", s.largest_guide_n); visit("largest_fed_mw", s.largest_fed_mw);
    }
    // clang-format on
  }
};

}  // namespace relievo
