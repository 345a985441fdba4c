// SPDX-License-Identifier: BSD-3-Clause
#include "tests/emulator/falcon_emulator.h"

#include <algorithm>
#include <utility>

namespace relievo::emulator {

namespace {
constexpr int kHelloDivisor = 0x4138, kUploadDivisor = 0x0015, kRunDivisor = 0x0002;
constexpr std::int64_t kMs = 1'000'000;
constexpr std::size_t kPayload = 62;
constexpr std::size_t kChipBuffer = 256;  // The FT232R's, toward the host.
constexpr std::size_t kMostCommands = 200'000;

/// Length of a whole boot stream, or nothing while it goes on.
std::optional<std::size_t> streamLength(const std::vector<std::uint8_t>& bytes) {
  const auto word = [&bytes](std::size_t at) { return bytes[at] + 256U * bytes[at + 1]; };
  std::size_t at = 22;  // Key, eight reserved words, entry point.
  while (at + 2 <= bytes.size()) {
    const unsigned count = word(at);
    if (count == 0) return at + 2;
    at += 6 + std::size_t{2} * count;
  }
  return std::nullopt;
}
}  // namespace

FalconEmulator::FalconEmulator(EmulatorOptions options)
    : options_(options), mode_(options.firmware_loaded ? Mode::running : Mode::boot) {
  if (options.homed) body.beHomed();
}

void FalconEmulator::powerCycle() {
  mode_ = Mode::boot;
  to_host_.clear();
  recent_.clear();
  frame_.clear();
  body.forgetHoming();
  body.drive({});
  latency_ms_ = 16;
  dtr_ = false;
}

std::vector<std::uint8_t> FalconEmulator::deviceDescriptor() {
  return {0x12, 0x01, 0x00, 0x02, 0x00, 0x00, 0x00, 0x08, 0x03,
          0x04, 0x48, 0xcb, 0x00, 0x06, 0x01, 0x02, 0x03, 0x01};
}

std::vector<std::uint8_t> FalconEmulator::configurationDescriptor() {
  return {0x09, 0x02, 0x20, 0x00, 0x01, 0x01, 0x00, 0xa0, 0x2d, 0x09, 0x04,
          0x00, 0x00, 0x02, 0xff, 0xff, 0xff, 0x02, 0x07, 0x05, 0x81, 0x02,
          0x40, 0x00, 0x00, 0x07, 0x05, 0x02, 0x02, 0x40, 0x00, 0x00};
}

double FalconEmulator::byteNs() const {
  if (baud_divisor_ == kHelloDivisor) return 10e9 / 9600;
  if (baud_divisor_ == kUploadDivisor) return 10e9 / 142'857;
  return 10e9 / 1.5e6;
}

std::optional<std::size_t> FalconEmulator::control(const std::array<std::uint8_t, 8>& setup,
                                                   std::span<std::uint8_t> answer,
                                                   std::int64_t now) {
  advance(now);
  const int request = setup[1];
  const int value = setup[2] | setup[3] << 8;
  if (setup[0] == 0xc0 && request == 5 && answer.size() >= 2) {
    answer[0] = 0x01;
    answer[1] = 0x60;
    return 2;
  }
  if (setup[0] == 0xc0 && request == 10 && !answer.empty()) {
    answer[0] = static_cast<std::uint8_t>(latency_ms_);
    return 1;
  }
  if (setup[0] != 0x40) return std::nullopt;
  if (requests_.size() < kMostCommands) {
    requests_.push_back({now, request, value, setup[4] | setup[5] << 8});
  }
  switch (request) {
    case 0:
      // 2 empties what waits for the host; 1 the other side, which this model keeps empty.
      if (value == 2 || value == 0) to_host_.clear();
      if (value == 1 || value == 2) purged_[static_cast<std::size_t>(value) - 1] = true;
      return 0;
    case 1: {
      const bool dtr = (value & 0x0100) != 0 ? (value & 1) != 0 : dtr_;
      if (dtr && !dtr_ && mode_ != Mode::running) {  // Back into the boot loader.
        mode_ = Mode::boot;
        recent_.clear();
      } else if (dtr && !dtr_ && baud_divisor_ == kHelloDivisor) {
        powerCycle();  // A running processor is reset as well, and loses its zeros.
        baud_divisor_ = kHelloDivisor;
      }
      dtr_ = dtr;
      return 0;
    }
    case 3:
      baud_divisor_ = value;
      if (value == kUploadDivisor) clear_to_send_at_ = now + options_.clear_to_send_delay_ns;
      return 0;
    case 9:
      latency_ms_ = std::max(1, value & 0xff);
      return 0;
    case 2:
    case 4:
    case 6:
      return 0;
    default:
      return std::nullopt;
  }
}

bool FalconEmulator::bulkOut(std::span<const std::uint8_t> bytes, std::int64_t now) {
  advance(now);
  if (troubles.clogged) return false;
  double at = static_cast<double>(now);
  for (const std::uint8_t byte : bytes) {
    at += byteNs();
    if (troubles.lose_command_bytes > 0) {
      --troubles.lose_command_bytes;
      continue;
    }
    receive(byte, static_cast<std::int64_t>(at));
  }
  return true;
}

void FalconEmulator::advance(std::int64_t now) {
  if (mode_ == Mode::starting && now >= starts_at_) mode_ = Mode::running;
  if (body_time_ == 0) body_time_ = now;
  if (now > body_time_) {
    body.advance(1e-9 * static_cast<double>(now - body_time_));
    body_time_ = now;
  }
}

void FalconEmulator::send(std::uint8_t byte, std::int64_t now) {
  if (troubles.lose_answer_bytes > 0) {
    --troubles.lose_answer_bytes;
    return;
  }
  if (to_host_.size() >= kChipBuffer) return;
  wire_free_ = std::max(wire_free_, now) + static_cast<std::int64_t>(byteNs());
  to_host_.push_back({(options_.latency_timer ? wire_free_ : now) + hold_answers_ns, byte});
}

void FalconEmulator::receive(std::uint8_t byte, std::int64_t now) {
  if (troubles.silent && mode_ != Mode::running) return;
  switch (mode_) {
    case Mode::boot:
      if (baud_divisor_ == kHelloDivisor) bootByte(byte, now);
      return;
    case Mode::hello_done:
      if (baud_divisor_ == kUploadDivisor && byte == 'A' && now >= clear_to_send_at_) {
        if (!purged_[0] || !purged_[1]) ++unpurged_uploads_;
        send('A', now);
        mode_ = Mode::loading;
        image_.clear();
      } else if (baud_divisor_ == kHelloDivisor) {
        bootByte(byte, now);
      }
      return;
    case Mode::loading:
      if (baud_divisor_ == kUploadDivisor) loadByte(byte, now);
      return;
    case Mode::starting:
      return;
    case Mode::running:
      if (baud_divisor_ == kRunDivisor) frameByte(byte, now);
      return;
  }
}

void FalconEmulator::bootByte(std::uint8_t byte, std::int64_t now) {
  recent_.push_back(byte);
  const std::vector<std::uint8_t> hello{0x0a, 0x43, 0x0d};
  if (recent_.size() < hello.size()) return;
  if (!std::equal(hello.begin(), hello.end(), recent_.end() - 3)) return;
  recent_.clear();
  if (troubles.deaf_hellos > 0) {
    --troubles.deaf_hellos;
    return;
  }
  if (troubles.late_hellos > 0) {
    --troubles.late_hellos;
    ++owed_hellos_;
    return;
  }
  for (; owed_hellos_ >= 0; --owed_hellos_) {
    if (options_.leading_zero) send(0x00, now);
    for (const int answer : {0x0a, 0x44, 0x2c, 0x0d}) send(static_cast<std::uint8_t>(answer), now);
  }
  owed_hellos_ = 0;
  mode_ = Mode::hello_done;
  purged_ = {};
}

void FalconEmulator::loadByte(std::uint8_t byte, std::int64_t now) {
  image_.push_back(byte);
  const bool wrong = troubles.wrong_echoes > 0 &&
                     image_.size() == static_cast<std::size_t>(troubles.wrong_echo_at);
  if (wrong) --troubles.wrong_echoes;
  send(wrong ? static_cast<std::uint8_t>(byte ^ 0x55U) : byte, now);
  const bool keyed = image_.size() < 2 || (image_[0] == 0xaa && image_[1] == 0x08);
  if (!keyed) {
    mode_ = Mode::boot;
    return;
  }
  if (streamLength(image_) == image_.size()) {
    ++uploads_;
    mode_ = Mode::starting;
    starts_at_ = now + options_.start_delay_ns;
    body.forgetHoming();
  }
}

void FalconEmulator::frameByte(std::uint8_t byte, std::int64_t now) {
  if (byte == '<') {
    if (!frame_.empty()) ++bad_commands_;
    frame_.clear();
  }
  frame_.push_back(static_cast<char>(byte));
  if (frame_.front() != '<') {
    frame_.clear();
    return;
  }
  if (byte != '>' && frame_.size() < 16) return;
  if (byte == '>' && frame_.size() == 16) {
    answerCommand(now);
  } else {
    ++bad_commands_;
  }
  frame_.clear();
}

void FalconEmulator::answerCommand(std::int64_t now) {
  SeenCommand command;
  command.time_ns = now;
  for (std::size_t motor = 0; motor < 3; ++motor) {
    int value = 0;
    for (std::size_t nibble = 0; nibble < 4; ++nibble) {
      value += (frame_[1 + 4 * motor + nibble] - 'A') << (4 * nibble);
    }
    command.motors[motor] = value >= 32768 ? value - 65536 : value;
  }
  const int control = frame_[13] - 'A';
  command.homing = (control & 1) != 0;
  command.lights = control & 14;
  std::vector<SeenCommand>& seen = troubles.silent ? unheeded_ : commands_;
  if (seen.size() < kMostCommands) seen.push_back(command);
  if (troubles.silent) return;
  ++command_count_;
  homing_on_ = command.homing;
  body.drive(command.motors);

  if (!troubles.frozen_encoders) frozen_ = body.encoders();
  constexpr std::array<int, 3> kImpossible{-9000, -7000, 0};
  std::string answer = "<";
  for (const int encoder : troubles.impossible_encoders ? kImpossible : frozen_) {
    for (int nibble = 0; nibble < 4; ++nibble) {
      answer.push_back(static_cast<char>('A' + ((encoder >> (4 * nibble)) & 15)));
    }
  }
  const int homed = homing_on_ ? body.homed() : 0;
  answer.push_back(static_cast<char>('A' + homed * 16 + buttons));
  answer += "A>";
  if (troubles.altered_nibbles > 0) alterNibble(answer);
  if (troubles.short_answers > 0) {
    --troubles.short_answers;
    answer.erase(5, 2);
  }
  if (troubles.noisy_answers > 0) {
    --troubles.noisy_answers;
    answer.insert(0, "<BA");
  }
  for (const char c : answer) send(static_cast<std::uint8_t>(c), now);
}

void FalconEmulator::alterNibble(std::string& answer) {
  --troubles.altered_nibbles;
  random_ = random_ * 1664525U + 1013904223U;
  const std::size_t at = 1 + (random_ >> 8U) % 12;
  const int other = 1 + static_cast<int>((random_ >> 20U) % 15);
  answer[at] = static_cast<char>('A' + ((answer[at] - 'A') ^ other));
}

/// Within the alphabet: only the status tells that it is not what was sent.
void FalconEmulator::damage(std::vector<std::uint8_t>& packet) {
  constexpr std::uint8_t kOverrun = 0x02, kParity = 0x04, kFraming = 0x08;
  if (troubles.overruns > 0) {
    --troubles.overruns;
    packet[1] |= kOverrun;
    packet.erase(packet.begin() + 4);
  }
  for (auto* const count : {&troubles.framing_errors, &troubles.parity_errors}) {
    if (*count <= 0) continue;
    --*count;
    packet[1] |= count == &troubles.framing_errors ? kFraming : kParity;
    packet[5] = static_cast<std::uint8_t>('A' + ((packet[5] - 'A') ^ 2));
  }
}

std::size_t FalconEmulator::readyBytes(std::int64_t now) const {
  const auto later = std::find_if(to_host_.begin(), to_host_.end(),
                                  [now](const Pending& p) { return p.at > now; });
  return static_cast<std::size_t>(later - to_host_.begin());
}

bool FalconEmulator::failsToRead() {
  if (troubles.failed_reads <= 0) return false;
  --troubles.failed_reads;
  return true;
}

std::optional<std::vector<std::uint8_t>> FalconEmulator::bulkIn(std::int64_t now) {
  advance(now);
  const std::size_t ready = readyBytes(now);
  const bool full = ready >= kPayload;
  const bool timer = now - last_packet_ >= latency_ms_ * kMs;
  const bool at_once = !options_.latency_timer && ready > 0;
  if (!full && !timer && !at_once) return std::nullopt;
  last_packet_ = now;
  const bool cts = options_.clear_to_send && mode_ == Mode::hello_done &&
                   baud_divisor_ == kUploadDivisor && now >= clear_to_send_at_;
  std::vector<std::uint8_t> packet{static_cast<std::uint8_t>(cts ? 0x11 : 0x01), 0x60};
  for (std::size_t i = 0; i < std::min(ready, kPayload); ++i) {
    packet.push_back(to_host_.front().byte);
    to_host_.pop_front();
  }
  if (packet.size() > 6) damage(packet);
  return packet;
}

std::int64_t FalconEmulator::nextIn(std::int64_t now) const {
  std::int64_t next = last_packet_ + latency_ms_ * kMs;
  if (to_host_.size() >= kPayload) next = std::min(next, to_host_[kPayload - 1].at);
  if (!options_.latency_timer && !to_host_.empty()) next = now;
  return std::max(next, now);
}

}  // namespace relievo::emulator
