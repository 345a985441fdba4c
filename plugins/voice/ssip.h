// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace relievo {

/// How a voice speaks.
struct SpeechStyle {
  std::string language = "en";  ///< A tag: "de".
  int words_per_minute = 160;   ///< 80 to 449.
  int volume_percent = 100;     ///< 0 to 100.
  friend bool operator==(const SpeechStyle&, const SpeechStyle&) = default;
};

/// Speech Dispatcher's rate, -100 to 100, for espeak-ng's words a minute, which is what its module
/// makes of it; other synthesizers have another scale.
int ssipRate(int words_per_minute);

/// One client's end of the Speech Synthesis Interface Protocol (Speech Dispatcher 0.11, SSIP
/// manual), without a socket and without a clock: bytes in, bytes out. A command goes out when the
/// one before was answered.
class SsipProtocol {
 public:
  enum class Event { begun, ended, cancelled, refused };

  SsipProtocol();

  /// Says a text in place of whatever is being said or waits.
  void speak(std::string_view text, const SpeechStyle& style);
  void cancel();

  /// What to send; empty: nothing for now.
  std::string takeBytes();
  /// What has come, in any portions.
  void receive(std::string_view bytes);
  std::vector<Event> takeEvents();
  /// Of the last refusal, in the server's words.
  const std::string& refusal() const { return refusal_; }
  /// A command was sent and not answered yet.
  bool isAwaiting() const { return awaiting_; }
  /// SPEAK was sent and its text was not: the server may take what comes next for the text.
  bool isTextDue() const { return awaiting_ && !data_.empty(); }
  /// So much came without an answer, or without an end of line, that this is no such server.
  bool isFlooded() const { return is_flooded_; }

 private:
  struct Command {
    std::string line;
    std::string data;         ///< For SPEAK: what follows when the server is ready for it.
    bool is_setting = false;  ///< Refused, it costs its effect alone: a language there is not.
  };
  void add(std::string line, bool is_setting = false);
  void takeLine(std::string_view line);
  void takeReply(int code, std::string_view words);
  void takeEvent(int code, std::string_view words);

  std::deque<Command> waiting_;
  std::string in_, out_, refusal_;
  std::string data_;  ///< Of the SPEAK that was sent.
  SpeechStyle style_;
  std::size_t unanswered_bytes_ = 0;
  bool is_flooded_ = false;
  bool has_style_ = false, awaiting_ = false, awaits_setting_ = false, speaks_ = false;
  std::string event_id_;  ///< The first line of an event of several.
  std::string message_id_, given_id_;
  std::vector<Event> events_;
};

}  // namespace relievo
