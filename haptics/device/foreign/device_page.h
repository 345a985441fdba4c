// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/file/owned_fd.h"
#include "haptics/device/foreign/shared_block.h"
#include "haptics/device/link/force_ramp.h"
#include "haptics/device/link/heat_budget.h"
#include "haptics/device/link/mailbox.h"

namespace relievo::foreign {

/// How far the host of a plug-in has come.
enum class HostStage : std::uint32_t { starting, ready, failed };

/// Why it failed; what `number` and `text` of its report are.
enum class HostTrouble : std::uint32_t {
  none,
  not_loaded,  ///< `text`: the system's words.
  no_entry,
  version,     ///< `number`: the plug-in's major version.
  incomplete,  ///< A function or a name is missing.
  not_begun,   ///< `number`: init's status; `text`: why, in its words; after its name if a library
               ///< is missing.
  no_device,   ///< It knows no such id.
  refuses,     ///< open's or limits' status in `number`; `text`: last_error.
  limits,      ///< They are impossible.
  threw,       ///< An exception left it.
  count
};

/// A device's limits, as relievo uses them: of relievo_device_limits, bounded.
struct ForeignLimits {
  std::array<double, 3> half_extent_mm{};
  double max_force_n = 0;
  double continuous_force_n = 0;  ///< 0: unknown.
  double max_stiffness_n_per_mm = 0;
  double position_step_mm = 0;
  double force_delay_ms = 0;
  double rate_hz = 1000;
  std::uint8_t own_watchdog = 0;  ///< No bool: another process may write any byte.
};
/// Finite, and such as a hand-held device can have.
bool arePossible(const ForeignLimits& limits) noexcept;

/// Nothing above this is ordered of a plug-in, whatever it says of itself.
inline constexpr double kMostForceN = 6;
/// Nor this where a killed process leaves the last force on.
inline constexpr double kMostForceWithoutWatchdogN = 2;
/// Both processes hold forces to these.
ForceRules rulesOf(const ForeignLimits& limits) noexcept;
/// Where nobody says for what force the motors are made, it is half of the largest.
HeatRules heatRulesOf(const ForeignLimits& limits) noexcept;

/// How warm the motors are. [host's device thread writes, owner reads]
struct HeatReport {
  double used = 0;       ///< 0 .. 1: of what they can take for good (HeatBudget).
  double allowed_n = 0;  ///< Forces are held below this now.
};

/// What the host says of its start.
struct HostReport {
  HostStage stage = HostStage::starting;
  HostTrouble trouble = HostTrouble::none;
  std::int32_t number = 0;
  ForeignLimits limits;
  std::array<char, 200> text{};  ///< Zero-terminated.
};
/// Cut to its place.
void putText(std::string_view text, HostReport& report) noexcept;
/// Without what a terminal would take for commands, and no longer than its place.
std::string textOf(const HostReport& report);

/// Between relievo and the process that runs a plug-in. Neither believes what the other wrote.
struct DevicePage {
  static constexpr std::uint64_t kMagic = 0x31454756'49524c52;
  static constexpr std::uint64_t kVersion = 2;

  std::uint64_t magic = kMagic, version = kVersion;
  /// The watchdog's cuts so far: LinkMailbox::cuts. [relievo writes]
  alignas(64) std::atomic<std::uint32_t> cuts{0};
  alignas(64)
      SharedBlock<ForceCommand> order;  ///< [haptic loop writes, host's device thread reads]
  /// When its device thread last went round, ns. [host writes]
  alignas(64) std::atomic<std::int64_t> beat_ns{0};
  alignas(64) SharedBlock<LinkReading> reading;  ///< [host's device thread writes, loop reads]
  alignas(64) SharedBlock<HostReport> report;    ///< [host's main thread writes, owner reads]
  alignas(64) SharedBlock<HeatReport> heat;
};

/// A page in memory of its own that another process can be given.
class MappedPage {
 public:
  MappedPage() = default;
  ~MappedPage();
  MappedPage(const MappedPage&) = delete;
  MappedPage& operator=(const MappedPage&) = delete;

  /// A new one, whose size nobody can change. @return false: the system refuses; errno says why
  bool create() noexcept;
  /// The one that a descriptor of another process leads to. @return false: it is none
  bool open(int fd) noexcept;
  int fd() const noexcept { return fd_.get(); }
  DevicePage* operator->() const noexcept { return page_; }
  DevicePage& operator*() const noexcept { return *page_; }

 private:
  bool map() noexcept;

  OwnedFd fd_;
  DevicePage* page_ = nullptr;
};

/// Descriptors of the host, besides the usual three.
inline constexpr int kPageFd = 3, kAnswerFd = 3, kLifeFd = 4, kPluginFd = 5;

}  // namespace relievo::foreign
