// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <QObject>
#include <QSocketNotifier>
#include <QTimer>

#include "core/message/message.h"
#include "plugins/voice/ssip.h"

namespace relievo {

/// Where Speech Dispatcher listens: $SPEECHD_ADDRESS, else below $XDG_RUNTIME_DIR. Empty: nowhere.
std::filesystem::path speechSocket();

/// A client of Speech Dispatcher over its Unix socket. It never waits: whatever the server does, or
/// leaves, no call lasts. Not its library, which waits for ever for a server that is silent.
/// [GUI thread]
class SsipClient : public QObject {
  Q_OBJECT
 public:
  /// A server that leaves a command unanswered for this long is given up.
  static constexpr int kAnswerMs = 2000;

  /// Connects; `failed` comes later, never from here.
  explicit SsipClient(std::filesystem::path socket, int answer_ms = kAnswerMs,
                      QObject* parent = nullptr);
  ~SsipClient() override;

  void speak(const QString& text, const SpeechStyle& style);
  void cancel();
  /// Since a speak() until its end, its cancel or a refusal.
  bool isSpeaking() const { return speaking_; }

 Q_SIGNALS:
  /// It answered: something lives there.
  void answered();
  void begun();
  void ended();
  /// Once; nothing is heard of this client any more.
  void failed(const relievo::Message& why);

 private:
  void read();
  /// @return false: there is no more for now
  bool readBlock();
  void write();
  /// As much as goes without waiting. @return false: it will never go
  bool sendOut();
  void takeEvents();
  void fail(const Message& why);
  /// Says good-bye as far as that needs no waiting.
  void close();

  std::filesystem::path path_;
  int socket_ = -1;
  bool speaking_ = false, has_failed_ = false;
  SsipProtocol protocol_;
  std::string out_;
  std::unique_ptr<QSocketNotifier> readable_, writable_;
  QTimer answer_due_;
};

}  // namespace relievo
