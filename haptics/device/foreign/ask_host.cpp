// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/ask_host.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

#include "core/base/failure.h"
#include "haptics/device/foreign/host_process.h"
#include "haptics/device/foreign/plugin_settings.h"
#include "haptics/device/foreign/push_plugin.h"
#include "haptics/rt/realtime_thread.h"

namespace relievo::foreign {

namespace {
constexpr double kScanS = 5, kCheckS = 10, kOpenS = 60;
constexpr std::size_t kMostAnswer = 65536;

struct Answer {
  std::string text;
  int signal = 0;
  bool in_time = false;
};

bool readSome(int fd, std::string& text) {
  std::array<char, 4096> bytes{};
  const ssize_t got = ::read(fd, bytes.data(), bytes.size());
  if (got <= 0) return got < 0 && (errno == EINTR || errno == EAGAIN);
  if (text.size() < kMostAnswer) text.append(bytes.data(), static_cast<std::size_t>(got));
  return true;
}

/// What the host says until it ends, or its time is over.
Answer ask(const PluginImage& image, const std::vector<std::string>& arguments, double seconds,
           const Task& task) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    throw failure<MessageId::device_host_not_started>(std::strerror(errno));
  }
  const OwnedFd from(pipe[0]);
  OwnedFd to(pipe[1]);
  HostProcess host;
  host.start({.arguments = arguments,
              .variables = variablesFor(image.file),
              .shared_fd = to.get(),
              .plugin_fd = image.bytes.get()});
  to.reset();
  Answer answer;
  const std::int64_t until_ns = monotonicNs() + static_cast<std::int64_t>(1e9 * seconds);
  bool open = true;
  while (monotonicNs() < until_ns) {
    task.check();
    constexpr int kLookMs = 20;
    pollfd source{.fd = from.get(), .events = POLLIN, .revents = 0};
    if (open && ::poll(&source, 1, kLookMs) > 0) open = readSome(from.get(), answer.text);
    if (open || !host.ended(kLookMs)) continue;
    answer.in_time = true;
    answer.signal = host.signal();
    return answer;
  }
  return answer;  // The host goes with its process.
}

std::string textOf(double value) {
  std::array<char, 40> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

CheckResult resultOf(const Check& check, const Answer& answer, double seconds) {
  if (!answer.in_time) {
    return {check, Verdict::failed, "it did not end within " + textOf(seconds) + " s"};
  }
  if (answer.signal != 0) {
    return {check, Verdict::failed,
            "its process crashed (signal " + std::to_string(answer.signal) + ")"};
  }
  return resultOf(check, answer.text);
}
}  // namespace

ScannedPlugin scanPlugin(const PluginImage& image, const Task& task) {
  ScannedPlugin plugin;
  const Answer answer = ask(image, {"scan", image.file.string()}, kScanS, task);
  if (!answer.in_time) {
    plugin.trouble = said<MessageId::device_host_slow>(static_cast<int>(kScanS));
    return plugin;
  }
  if (answer.signal != 0) {
    plugin.trouble = said<MessageId::device_host_crashed>(answer.signal);
    return plugin;
  }
  return pluginOf(answer.text);
}

ScannedPlugin scanPlugin(const std::filesystem::path& file, const Task& task) {
  ScannedPlugin plugin;
  try {
    return scanPlugin(readPlugin(file), task);
  } catch (const FileError& error) {
    plugin.trouble = messageOf(error);
  }
  return plugin;
}

std::vector<CheckResult> checkPlugin(const std::filesystem::path& file, const Conformance& how,
                                     const Task& task) {
  const PluginImage image = readPlugin(file);
  std::vector<CheckResult> results;
  bool failed = false;
  for (const Check& check : kChecks) {
    task.check();
    if (check.with_device && how.device.empty()) {
      results.push_back({check, Verdict::skipped, "no device was named by --device"});
      continue;
    }
    if (check.code == kPushCheck) {
      results.push_back(failed && how.newton > 0
                            ? CheckResult{check, Verdict::skipped, "no force after a failed test"}
                            : pushPlugin(check, image.again(), how, task));
      continue;
    }
    const double limit_s = check.with_device ? kOpenS + 2 * how.seconds : kCheckS;
    const Answer answer = ask(
        image, {"check", file.string(), std::string(check.code), how.device, textOf(how.seconds)},
        limit_s, task);
    results.push_back(resultOf(check, answer, limit_s));
    failed = failed || results.back().verdict == Verdict::failed;
  }
  return results;
}

}  // namespace relievo::foreign
