// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/ssip.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace relievo {
namespace {

constexpr int kSlowest = 80, kUsual = 170, kFastest = 449;  // Words a minute at -100, 0 and 100.

/// As the protocol carries a text: lines end as in mail, and one that begins with a full stop has
/// another, for a full stop alone ends the text.
std::string dataOf(std::string_view text) {
  std::string data;
  bool at_start = true;
  for (const char c : text) {
    if (c == '\r' || c == '\0') continue;
    if (at_start && c == '.') data += '.';
    at_start = c == '\n';
    if (at_start) data += '\r';
    data += c;
  }
  return data + "\r\n.\r\n";
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

}  // namespace

int ssipRate(int words_per_minute) {
  const int wpm = std::clamp(words_per_minute, kSlowest, kFastest);
  const double part = wpm < kUsual ? static_cast<double>(wpm - kUsual) / (kUsual - kSlowest)
                                   : static_cast<double>(wpm - kUsual) / (kFastest - kUsual);
  return static_cast<int>(std::lround(100 * part));
}

SsipProtocol::SsipProtocol() {
  add("SET SELF CLIENT_NAME user:relievo:touch");
  add("SET SELF NOTIFICATION ALL ON", true);
  // Text interrupts text: newer words of the same rank take the place of older ones.
  add("SET SELF PRIORITY TEXT");
}

void SsipProtocol::add(std::string line, bool is_setting) {
  waiting_.push_back({std::move(line) + "\r\n", {}, is_setting});
}

void SsipProtocol::speak(std::string_view text, const SpeechStyle& style) {
  cancel();
  if (!has_style_ || style.language != style_.language) {
    add("SET SELF LANGUAGE " + style.language, true);
  }
  if (!has_style_ || style.words_per_minute != style_.words_per_minute) {
    add("SET SELF RATE " + std::to_string(ssipRate(style.words_per_minute)), true);
  }
  if (!has_style_ || style.volume_percent != style_.volume_percent) {
    add("SET SELF VOLUME " + std::to_string(2 * std::clamp(style.volume_percent, 0, 100) - 100),
        true);
  }
  style_ = style;
  has_style_ = true;
  waiting_.push_back({"SPEAK\r\n", dataOf(text), false});
}

void SsipProtocol::cancel() {
  const auto isSpeak = [](const Command& c) { return !c.data.empty(); };
  std::erase_if(waiting_, isSpeak);
  message_id_.clear();  // Its end is no news any more.
  if (!speaks_) return;
  speaks_ = false;
  add("CANCEL SELF", true);
}

std::string SsipProtocol::takeBytes() {
  if (!awaiting_ && !waiting_.empty()) {
    Command next = std::move(waiting_.front());
    waiting_.pop_front();
    out_ += next.line;
    data_ = std::move(next.data);
    awaits_setting_ = next.is_setting;
    awaiting_ = true;
    if (!data_.empty()) speaks_ = true;
  }
  return std::exchange(out_, {});
}

void SsipProtocol::receive(std::string_view bytes) {
  constexpr std::size_t kLongestLine = 65536, kMostUnanswered = 1U << 20U;
  unanswered_bytes_ += bytes.size();
  in_ += bytes;
  for (std::size_t end = 0; (end = in_.find('\n')) != std::string::npos;) {
    std::string line = in_.substr(0, end);
    in_.erase(0, end + 1);
    if (line.ends_with('\r')) line.pop_back();
    takeLine(line);
  }
  if (in_.size() > kLongestLine || unanswered_bytes_ > kMostUnanswered) is_flooded_ = true;
  if (is_flooded_) in_.clear();
}

void SsipProtocol::takeLine(std::string_view line) {
  if (line.size() < 4 || !std::all_of(line.begin(), line.begin() + 3, isDigit)) return;
  const int code = 100 * (line[0] - '0') + 10 * (line[1] - '0') + (line[2] - '0');
  const bool is_last = line[3] != '-';
  const std::string_view words = line.substr(4);
  constexpr int kEvents = 700;
  if (code >= kEvents) {
    if (is_last) {
      takeEvent(code, words);
      event_id_.clear();
    } else if (event_id_.empty()) {
      event_id_ = words;
    }
    return;
  }
  constexpr int kQueued = 225;
  if (!is_last) {
    if (code == kQueued) given_id_ = words;
    return;
  }
  takeReply(code, words);
}

void SsipProtocol::takeReply(int code, std::string_view words) {
  if (!awaiting_) return;
  constexpr int kReceiving = 230, kQueued = 225, kErrors = 300;
  if (code == kReceiving) {
    out_ += data_;
    data_.clear();
    return;
  }
  awaiting_ = false;
  unanswered_bytes_ = 0;
  if (code == kQueued && speaks_) message_id_ = given_id_;
  if (code < kErrors || awaits_setting_) return;
  refusal_ = words;
  speaks_ = false;
  events_.push_back(Event::refused);
}

void SsipProtocol::takeEvent(int code, std::string_view /*words*/) {
  constexpr int kBegin = 701, kEnd = 702, kCancelled = 703;
  if (message_id_.empty() || event_id_ != message_id_) return;
  if (code == kBegin) events_.push_back(Event::begun);
  if (code != kEnd && code != kCancelled) return;
  speaks_ = false;
  message_id_.clear();
  events_.push_back(code == kEnd ? Event::ended : Event::cancelled);
}

std::vector<SsipProtocol::Event> SsipProtocol::takeEvents() {
  return std::exchange(events_, {});
}

}  // namespace relievo
