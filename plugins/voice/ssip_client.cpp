// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/ssip_client.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "core/message/catalogue.h"

namespace relievo {
namespace {

/// Connected, or -1. A Unix socket's connect never waits if it must not.
int connectedTo(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string& name = path.native();
  if (name.empty() || name.size() >= sizeof address.sun_path) return -1;
  std::memcpy(address.sun_path, name.data(), name.size());
  const int fd = socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (fd < 0) return -1;
  if (connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return fd;
  ::close(fd);
  return -1;
}

}  // namespace

std::filesystem::path speechSocket() {
  const QByteArray address = qgetenv("SPEECHD_ADDRESS");
  const QByteArray unix_socket("unix_socket:");
  if (address.startsWith(unix_socket)) return address.mid(unix_socket.size()).toStdString();
  const QByteArray runtime = qgetenv("XDG_RUNTIME_DIR");
  if (runtime.isEmpty()) return {};
  return std::filesystem::path(runtime.toStdString()) / "speech-dispatcher" / "speechd.sock";
}

SsipClient::SsipClient(std::filesystem::path socket, int answer_ms, QObject* parent)
    : QObject(parent), path_(std::move(socket)), socket_(connectedTo(path_)) {
  answer_due_.setSingleShot(true);
  answer_due_.setInterval(answer_ms);
  connect(&answer_due_, &QTimer::timeout, this,
          [this] { fail(said<MessageId::voice_no_answer>()); });
  if (socket_ < 0) {
    QTimer::singleShot(0, this, [this] { fail(said<MessageId::voice_no_socket>(path_)); });
    return;
  }
  readable_ = std::make_unique<QSocketNotifier>(socket_, QSocketNotifier::Read);
  connect(readable_.get(), &QSocketNotifier::activated, this, &SsipClient::read);
  writable_ = std::make_unique<QSocketNotifier>(socket_, QSocketNotifier::Write);
  connect(writable_.get(), &QSocketNotifier::activated, this, &SsipClient::write);
}

SsipClient::~SsipClient() {
  close();
}

void SsipClient::speak(const QString& text, const SpeechStyle& style) {
  if (has_failed_) return;
  speaking_ = true;
  protocol_.speak(text.toStdString(), style);
  write();
}

void SsipClient::cancel() {
  if (has_failed_) return;
  speaking_ = false;
  protocol_.cancel();
  write();
}

void SsipClient::write() {
  if (socket_ < 0) return;
  const bool was_awaiting = protocol_.isAwaiting();
  out_ += protocol_.takeBytes();
  if (protocol_.isAwaiting() && !was_awaiting) answer_due_.start();
  if (!sendOut()) {
    fail(said<MessageId::voice_ended>());
    return;
  }
  writable_->setEnabled(!out_.empty());
}

bool SsipClient::sendOut() {
  while (!out_.empty()) {
    const ssize_t sent = send(socket_, out_.data(), out_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return errno == EAGAIN || errno == EWOULDBLOCK;
    out_.erase(0, static_cast<std::size_t>(sent));
  }
  return true;
}

void SsipClient::read() {
  // Of a server that sends without end, the rest comes with the next activation.
  constexpr int kMostBlocks = 16;
  for (int i = 0; i < kMostBlocks && socket_ >= 0 && readBlock(); ++i) {
  }
}

bool SsipClient::readBlock() {
  std::array<char, 4096> bytes{};
  const ssize_t got = recv(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (got < 0 && errno == EINTR) return true;
  if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) return false;
  if (got <= 0) {
    fail(said<MessageId::voice_ended>());
    return false;
  }
  const bool was_awaiting = protocol_.isAwaiting();
  protocol_.receive({bytes.data(), static_cast<std::size_t>(got)});
  const bool is_answer = was_awaiting && !protocol_.isAwaiting();
  if (is_answer) answer_due_.stop();
  // Before anything else may fail: what was heard is not said by another again.
  takeEvents();
  if (protocol_.isFlooded()) fail(said<MessageId::voice_no_answer>());
  if (is_answer && !has_failed_) Q_EMIT answered();
  write();
  return true;
}

void SsipClient::takeEvents() {
  for (const SsipProtocol::Event event : protocol_.takeEvents()) {
    using enum SsipProtocol::Event;
    if (event == begun) {
      Q_EMIT this->begun();
    } else if (event == refused) {
      fail(said<MessageId::voice_refused>(protocol_.refusal()));
      return;
    } else {
      speaking_ = false;
      Q_EMIT this->ended();
    }
  }
}

void SsipClient::fail(const Message& why) {
  if (std::exchange(has_failed_, true)) return;
  speaking_ = false;
  close();
  Q_EMIT failed(why);
}

void SsipClient::close() {
  answer_due_.stop();
  // A notifier that is being activated is not deleted in its own call.
  for (auto* notifier : {&readable_, &writable_}) {
    if (!*notifier) continue;
    (*notifier)->setEnabled(false);
    notifier->release()->deleteLater();
  }
  if (socket_ < 0) return;
  // A server goes on with what it has when its client is gone.
  out_ += std::string(protocol_.isTextDue() ? "\r\n.\r\n" : "") + "CANCEL SELF\r\nQUIT\r\n";
  sendOut();
  ::close(std::exchange(socket_, -1));
}

}  // namespace relievo
