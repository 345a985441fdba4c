// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/emulator/falcon_body.h"
#include "tests/emulator/urgent.h"

namespace relievo::emulator {

/// A command that arrived whole.
struct SeenCommand {
  std::int64_t time_ns = 0;
  std::array<int, 3> motors{};
  bool homing = false;
  int lights = 0;  ///< 2 green, 4 blue, 8 red.
  bool neutral() const { return motors == std::array<int, 3>{}; }
};

/// A request to the bridge chip.
struct SeenRequest {
  std::int64_t time_ns = 0;
  int request = 0, value = 0, index = 0;
};

/// What goes wrong from now on; counters count down.
struct Troubles {
  int lose_answer_bytes = 0;   ///< Bytes to the host that vanish.
  int lose_command_bytes = 0;  ///< Bytes from the host that vanish.
  int short_answers = 0;       ///< Answers of fourteen bytes.
  int noisy_answers = 0;       ///< Answers behind three stray bytes.
  int overruns = 0;            ///< Packets that tell of an overrun and lack a byte.
  int framing_errors = 0;      ///< Packets that tell of one and have an altered byte ...
  int parity_errors = 0;       ///< ... likewise.
  int altered_nibbles = 0;     ///< Answers with another value in one nibble of an encoder, drawn.
  int deaf_hellos = 0;         ///< Hellos without an answer.
  int late_hellos = 0;         ///< Hellos that are answered only after the next one.
  int wrong_echoes = 0;        ///< Uploads that echo one byte wrongly ...
  int wrong_echo_at = 1000;    ///< ... this one.
  int failed_reads = 0;        ///< Transfers to the host that break off, whatever they would bring.
  bool silent = false;         ///< The processor hangs; commands arrive and nothing is done.
  bool clogged = false;        ///< The bridge takes no more bytes.
  bool frozen_encoders = false;
  bool impossible_encoders = false;  ///< Angles that no place of the grip has.
};

struct EmulatorOptions {
  bool firmware_loaded = false;
  bool homed = false;
  /// false: answers leave at once, for measuring the host alone.
  bool latency_timer = true;
  std::int64_t start_delay_ns = 200'000'000;  ///< From the end of the upload to the first answer.
  bool leading_zero = false;                  ///< Before the answer to hello.
  /// From the upload's baud rate to CTS; before it the boot loader does not lock.
  std::int64_t clear_to_send_delay_ns = 0;
  bool clear_to_send = true;  ///< false: it never tells CTS, and locks all the same.
};

/// A Falcon as USB sees it: an FT232R, behind it the processor with its boot loader or firmware,
/// behind that the arms and a hand. Time comes from outside, in ns. It is written from the
/// protocol's description and shares no code with the driver.
class FalconEmulator {
 public:
  explicit FalconEmulator(EmulatorOptions options = {});

  // USB.
  /// A control request; a write without data, or a read of at most `answer`'s size.
  /// @return bytes answered; nothing: the chip does not know this request
  std::optional<std::size_t> control(const std::array<std::uint8_t, 8>& setup,
                                     std::span<std::uint8_t> answer, std::int64_t now);
  /// @return false: not taken now
  bool bulkOut(std::span<const std::uint8_t> bytes, std::int64_t now);
  /// A packet of 2 to 64 bytes, if one is due.
  std::optional<std::vector<std::uint8_t>> bulkIn(std::int64_t now);
  /// Does this transfer break off? Ask before each bulkIn().
  bool failsToRead();
  /// When bulkIn may have one next.
  std::int64_t nextIn(std::int64_t now) const;

  static std::vector<std::uint8_t> deviceDescriptor();
  static std::vector<std::uint8_t> configurationDescriptor();

  // The world around it.
  FalconBody body;
  Troubles troubles;
  std::int64_t hold_answers_ns = 0;  ///< Packets with data leave this much later.
  int buttons = 0;                   ///< Bits 0 to 3: plus, forward, centre, minus.
  void powerCycle();
  void unplug() { plugged_ = false; }
  void plugIn() { plugged_ = true; }
  bool plugged() const { return plugged_; }

  // What happened to it.
  const std::vector<SeenCommand>& commands() const { return commands_; }
  std::uint64_t commandCount() const { return command_count_; }
  void forgetCommands() {
    commands_.clear();
    unheeded_.clear();
  }
  /// Those that arrived while the processor hung.
  const std::vector<SeenCommand>& unheeded() const { return unheeded_; }
  const std::vector<SeenRequest>& requests() const { return requests_; }
  void forgetRequests() { requests_.clear(); }
  int uploads() const { return uploads_; }
  /// Uploads that began without both purges since the answer to hello.
  int unpurgedUploads() const { return unpurged_uploads_; }
  int badCommands() const { return bad_commands_; }
  const std::vector<std::uint8_t>& lastImage() const { return image_; }
  int latencyMs() const { return latency_ms_; }
  bool running() const { return mode_ == Mode::running; }

 private:
  enum class Mode { boot, hello_done, loading, starting, running };

  void advance(std::int64_t now);
  void receive(std::uint8_t byte, std::int64_t now);
  void bootByte(std::uint8_t byte, std::int64_t now);
  void loadByte(std::uint8_t byte, std::int64_t now);
  void frameByte(std::uint8_t byte, std::int64_t now);
  void answerCommand(std::int64_t now);
  void alterNibble(std::string& answer);
  void damage(std::vector<std::uint8_t>& packet);
  void send(std::uint8_t byte, std::int64_t now);
  double byteNs() const;
  std::size_t readyBytes(std::int64_t now) const;

  EmulatorOptions options_;
  bool plugged_ = true;

  // Bridge chip.
  int baud_divisor_ = 0;
  int latency_ms_ = 16;
  bool dtr_ = false;
  struct Pending {
    std::int64_t at;
    std::uint8_t byte;
  };
  std::deque<Pending> to_host_;
  std::int64_t wire_free_ = 0;  // When the line to the host has sent everything.
  std::int64_t last_packet_ = 0;

  // Processor.
  Mode mode_;
  std::vector<std::uint8_t> recent_;
  std::vector<std::uint8_t> image_;
  std::string frame_;
  std::int64_t starts_at_ = 0;
  std::int64_t body_time_ = 0;
  int owed_hellos_ = 0;
  bool homing_on_ = false;
  std::array<int, 3> frozen_{};
  std::uint32_t random_ = 1;

  std::vector<SeenCommand> commands_, unheeded_;
  std::vector<SeenRequest> requests_;
  std::uint64_t command_count_ = 0;
  int uploads_ = 0, unpurged_uploads_ = 0;
  std::array<bool, 2> purged_{};  // Since the answer to hello.
  std::int64_t clear_to_send_at_ = 0;
  int bad_commands_ = 0;
};

/// For fronts in other threads than the test's.
class SharedFalcon {
 public:
  explicit SharedFalcon(EmulatorOptions options = {}) : falcon_(options) {}
  template <class Function>
  auto with(Function function) {
    const std::lock_guard lock(mutex_);
    return function(falcon_);
  }

 private:
  UrgentMutex mutex_;
  FalconEmulator falcon_;
};

}  // namespace relievo::emulator
