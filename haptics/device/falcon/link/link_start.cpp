// SPDX-License-Identifier: BSD-3-Clause
// Starting: hello to the boot loader, then the firmware, every byte echoed.
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <future>
#include <system_error>
#include <utility>

#include "core/base/failure.h"
#include "haptics/device/falcon/link/link.h"

namespace relievo::falcon {

namespace {
constexpr std::int64_t kMs = 1'000'000;
/// Then with longer and longer pauses, 21 s in all: some begin to answer only after a while.
constexpr int kAttemptsAtOnce = 4;
constexpr std::int64_t kLongerPauseNs = 1000 * kMs;
constexpr std::int64_t kLookForFirmwareNs = 1000 * kMs, kUntilAsked = INT64_MAX;

/// Reads in a worker at ordinary priority while this thread waits: files, checksums and the
/// terminal are nothing for a thread that keeps others from running. @throw FileError, as the
/// source does
std::vector<std::uint8_t> readAtEase(const FirmwareSource& source) {
  const auto read = [&source] {
    const sched_param ordinary{};  // A thread begins with the urgency of the one that made it.
    [[maybe_unused]] const int refused =
        pthread_setschedparam(pthread_self(), SCHED_OTHER, &ordinary);  // Less is never refused.
    return source();
  };
  try {
    return std::async(std::launch::async, read).get();
  } catch (const std::system_error&) {
    return source();  // No thread can be had: slower for others is better than not at all.
  }
}
}  // namespace

bool Link::start(const std::stop_token& stop, std::unique_ptr<Port>& port) {
  while (!stop.stop_requested()) {
    std::vector<std::uint8_t> firmware;
    try {
      firmware = readAtEase(firmware_);
    } catch (const FileError& error) {
      setState(LinkState::no_firmware, messageOf(error));
      // Whoever installs it, here or in a terminal, need not say so.
      if (!waitForRetry(stop, kLookForFirmwareNs)) return false;
      continue;
    }
    status_.firmware_bytes = static_cast<std::uint32_t>(firmware.size());
    Upload result = Upload::no_hello;
    for (int attempt = 1; attempt <= limits_.attempts && !stop.stop_requested(); ++attempt) {
      if (attempt > kAttemptsAtOnce &&
          !waitForRetry(stop, (attempt - kAttemptsAtOnce) * kLongerPauseNs)) {
        return false;
      }
      status_.attempt = attempt;
      status_.uploaded_bytes = 0;
      setState(LinkState::starting);
      // A port opened anew sometimes helps where repeating does not.
      if (attempt > 1 && attempt % 3 == 1) {
        close(port, false);
        port = waitForDevice(stop, false);  // Another program may have taken it meanwhile.
        port_ = port.get();
        if (!port) return false;
        setState(LinkState::starting);
      }
      result = uploadOnce(stop, firmware);
      if (result == Upload::done) return true;
      if (result == Upload::gone) return false;
    }
    if (stop.stop_requested()) return false;
    status_.failed_openings = 0;
    setState(LinkState::not_started, whyNotStarted(result));
    if (!waitForRetry(stop, kUntilAsked)) return false;
  }
  return false;
}

Message Link::whyNotStarted(Upload result) const {
  switch (result) {
    case Upload::no_lock:
      return said<MessageId::falcon_no_baud_lock>();
    case Upload::wrong_echo:
      return said<MessageId::falcon_wrong_echo>(status_.uploaded_bytes, status_.firmware_bytes);
    case Upload::no_start:
      return said<MessageId::falcon_not_running>();
    case Upload::done:
    case Upload::gone:
    case Upload::no_hello:
      break;
  }
  return said<MessageId::falcon_boot_loader_silent>();
}

Link::Upload Link::uploadOnce(const std::stop_token& stop,
                              const std::vector<std::uint8_t>& firmware) {
  const auto failed = [this](Upload how) {
    // Asking the chip anything tells whether it is still there.
    request(kPurge1);
    return lost_ == PortResult::ok ? how : Upload::gone;
  };
  runs_ = false;
  if (!requestAll({kPurge1, kPurge2, latencyTimer(16), kHelloBaud, kData8N1, kFlowOff, kRtsLow,
                   kDtrLow, kDtrHigh})) {
    return failed(Upload::no_hello);
  }
  port_->discardInput();
  if (!hello()) return failed(Upload::no_hello);
  // Late answers to earlier hellos must not be taken for the echo.
  if (!requestAll({kDtrLow, kUploadBaud, kPurge1, kPurge2})) return failed(Upload::no_lock);
  port_->discardInput();
  if (!lockBaud()) return failed(Upload::no_lock);
  for (std::size_t at = 0; at < firmware.size(); at += kUploadChunk) {
    if (stop.stop_requested()) return Upload::wrong_echo;
    const std::size_t size = std::min(kUploadChunk, firmware.size() - at);
    if (!echoes(std::span(firmware).subspan(at, size))) return failed(Upload::wrong_echo);
    status_.uploaded_bytes = static_cast<std::uint32_t>(at + size);
    publishStatus();
  }
  if (!prepareToRun()) return failed(Upload::no_start);
  constexpr int kQuestions = 13;  // 40 ms each: the processor may need half a second.
  return answers(kQuestions) ? Upload::done : failed(Upload::no_start);
}

bool Link::hello() {
  constexpr int kTries = 10;
  std::array<std::uint8_t, kPacketBytes> bytes{};
  std::size_t matched = 0;
  for (int i = 0; i < kTries; ++i) {
    if (write(kHello) != PortResult::ok) return false;
    const std::int64_t until = bus_.now() + 150 * kMs;
    while (bus_.now() < until) {
      std::size_t got = 0;
      if (!read(bytes, until, got)) return false;
      for (std::size_t k = 0; k < got; ++k) {
        // Anywhere in the stream: zeros or an answer to an earlier hello may come first.
        if (bytes[k] != kHelloAnswer[matched]) matched = 0;
        if (bytes[k] == kHelloAnswer[matched]) ++matched;
        if (matched == kHelloAnswer.size()) return true;
      }
    }
  }
  return false;
}

bool Link::lockBaud() {
  std::array<std::uint8_t, kPacketBytes> bytes{};
  // Some devices raise CTS when they are ready; none is known to need it.
  const std::int64_t ready_by = bus_.now() + 200 * kMs;
  while (!port_->clearToSend() && bus_.now() < ready_by) {
    std::size_t got = 0;
    if (!read(bytes, std::min(ready_by, bus_.now() + 20 * kMs), got)) return false;
  }
  port_->discardInput();
  if (write(std::array<std::uint8_t, 1>{kAutoBaud}) != PortResult::ok) return false;
  const std::int64_t until = bus_.now() + 300 * kMs;
  while (bus_.now() < until) {
    std::size_t got = 0;
    if (!read(bytes, until, got)) return false;
    for (std::size_t k = 0; k < got; ++k) {
      if (bytes[k] == kAutoBaud) return true;
    }
  }
  return false;
}

bool Link::echoes(std::span<const std::uint8_t> chunk) {
  if (write(chunk) != PortResult::ok) return false;
  std::array<std::uint8_t, kPacketBytes> bytes{};
  std::size_t same = 0;
  const std::int64_t until = bus_.now() + 1000 * kMs;
  while (same < chunk.size()) {
    std::size_t got = 0;
    if (!read(bytes, until, got) || (got == 0 && bus_.now() >= until)) return false;
    if (got > chunk.size() - same) return false;
    const auto expected = chunk.subspan(same, got);
    if (!std::equal(expected.begin(), expected.end(), bytes.begin())) return false;
    same += got;
  }
  return true;
}

}  // namespace relievo::falcon
