// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/device/foreign/ask_host.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>

#include "core/base/failure.h"
#include "haptics/device/foreign/host_process.h"
#include "haptics/device/foreign/relievo_device.h"
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
Answer ask(const std::vector<std::string>& arguments, double seconds, const Task& task) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) {
    throw failure<MessageId::device_host_not_started>(std::strerror(errno));
  }
  const OwnedFd from(pipe[0]);
  OwnedFd to(pipe[1]);
  HostProcess host;
  host.start({.arguments = arguments, .shared_fd = to.get()});
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

std::vector<std::string> parts(std::string_view text, char separator) {
  std::vector<std::string> all;
  while (true) {
    const std::size_t end = text.find(separator);
    all.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return all;
    text.remove_prefix(end + 1);
  }
}

int numberOf(const std::string& text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
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
  const std::vector<std::string> words = parts(parts(answer.text, '\n').front(), '\t');
  if (words.size() != 2) return {check, Verdict::failed, "its process ended"};
  if (words[0] == "passed") return {check, Verdict::passed, {}};
  return {check, words[0] == "skipped" ? Verdict::skipped : Verdict::failed, words[1]};
}
}  // namespace

Message messageOf(HostTrouble trouble, int number, const std::string& text) {
  switch (trouble) {
    case HostTrouble::not_loaded:
      return said<MessageId::device_plugin_not_loaded>(text);
    case HostTrouble::no_entry:
      return said<MessageId::device_plugin_no_entry>();
    case HostTrouble::version:
      return said<MessageId::device_plugin_version>(number, RELIEVO_DEVICE_ABI_MAJOR);
    case HostTrouble::incomplete:
      return said<MessageId::device_plugin_incomplete>();
    case HostTrouble::no_device:
      return said<MessageId::device_plugin_no_device>();
    case HostTrouble::refuses:
      return said<MessageId::device_plugin_refuses>(text.empty() ? std::to_string(number) : text);
    case HostTrouble::limits:
      return said<MessageId::device_plugin_limits>();
    default:
      break;
  }
  return said<MessageId::device_plugin_not_begun>(number);
}

ScannedPlugin scanPlugin(const std::filesystem::path& file, const Task& task) {
  ScannedPlugin plugin;
  const Answer answer = ask({"scan", file.string()}, kScanS, task);
  if (!answer.in_time) {
    plugin.trouble = said<MessageId::device_host_slow>(static_cast<int>(kScanS));
    return plugin;
  }
  if (answer.signal != 0) {
    plugin.trouble = said<MessageId::device_host_crashed>(answer.signal);
    return plugin;
  }
  bool told = false;
  for (const std::string& line : parts(answer.text, '\n')) {
    const std::vector<std::string> words = parts(line, '\t');
    if (words[0] == "trouble" && words.size() == 4) {
      const int trouble = numberOf(words[1]);
      const bool known = trouble > 0 && trouble < static_cast<int>(HostTrouble::count);
      plugin.trouble = messageOf(known ? static_cast<HostTrouble>(trouble) : HostTrouble::not_begun,
                                 numberOf(words[2]), words[3]);
    } else if (words[0] == "plugin" && words.size() == 5) {
      told = true;
      plugin.name = words[1];
      plugin.version = words[2];
      plugin.maker = words[3];
      plugin.licence = words[4];
    } else if (words[0] == "device" && words.size() == 3) {
      plugin.devices.push_back({words[1], words[2]});
    }
  }
  if (!told && !plugin.trouble) plugin.trouble = said<MessageId::device_host_ended>();
  return plugin;
}

std::vector<CheckResult> checkPlugin(const std::filesystem::path& file, const Conformance& how,
                                     const Task& task) {
  std::vector<CheckResult> results;
  for (const Check& check : kChecks) {
    task.check();
    if (check.with_device && how.device.empty()) {
      results.push_back({check, Verdict::skipped, "no device was named by --device"});
      continue;
    }
    const double limit_s = check.with_device ? kOpenS + 2 * how.seconds : kCheckS;
    const Answer answer = ask({"check", file.string(), std::string(check.code), how.device,
                               textOf(how.newton), textOf(how.seconds)},
                              limit_s, task);
    results.push_back(resultOf(check, answer, limit_s));
  }
  return results;
}

}  // namespace relievo::foreign
