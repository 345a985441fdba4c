// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

namespace relievo::test {

/// What listens and does nothing; or what ends each connection.
class StrangeServer {
 public:
  explicit StrangeServer(const std::string& path) : socket_(socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(socket_, 4), 0);
  }
  ~StrangeServer() { close(socket_); }
  /// Waits for a connection.
  int accepted() const { return accept(socket_, nullptr, nullptr); }
  void acceptAndEnd() const { close(accepted()); }
  /// -1: nobody connects now.
  int acceptedNow() const {
    fd_set set;
    FD_ZERO(&set);
    FD_SET(socket_, &set);
    timeval now{};
    return select(socket_ + 1, &set, nullptr, nullptr, &now) == 1 ? accepted() : -1;
  }

 private:
  int socket_;
};

/// Sends the same without end, as fast as it is read, until its client goes.
class FloodingServer {
 public:
  FloodingServer(const std::string& path, std::string_view piece) : server_(path) {
    while (flood_.size() < 65536) flood_ += piece;
  }
  ~FloodingServer() {
    if (thread_.joinable()) thread_.join();
  }
  /// Takes the one connection.
  void begin() {
    thread_ = std::thread([this, fd = server_.accepted()] {
      while (send(fd, flood_.data(), flood_.size(), MSG_NOSIGNAL) > 0) {
      }
      ::close(fd);
    });
  }

 private:
  StrangeServer server_;
  std::string flood_;
  std::thread thread_;
};

/// Answers as Speech Dispatcher does, whenever it is asked to look; it never says that a text
/// ended.
class AnsweringServer {
 public:
  explicit AnsweringServer(const std::string& path) : server_(path) {}
  ~AnsweringServer() {
    if (fd_ >= 0) ::close(fd_);
  }
  /// All that has come from the one client.
  const std::string& heard() {
    if (fd_ < 0) fd_ = server_.acceptedNow();
    std::array<char, 4096> bytes{};
    while (fd_ >= 0) {
      const ssize_t got = recv(fd_, bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (got <= 0) break;
      heard_.append(bytes.data(), static_cast<std::size_t>(got));
      answer();
    }
    return heard_;
  }
  /// Tells that the only text began and ended, and goes.
  void endAndGo() {
    sendAll("701-1\r\n701-1\r\n701 BEGIN\r\n702-1\r\n702-1\r\n702 END\r\n");
    ::close(std::exchange(fd_, -1));
  }
  bool hasText() const { return heard_.find("\r\n.\r\n") != std::string::npos; }
  bool answers_texts = true;

 private:
  void answer() {
    for (std::size_t end = 0; (end = heard_.find("\r\n", answered_)) != std::string::npos;) {
      const std::string line = heard_.substr(answered_, end - answered_);
      answered_ = end + 2;
      if (in_text_ && line != ".") continue;
      const bool is_text = std::exchange(in_text_, line == "SPEAK");
      if (in_text_ && !answers_texts) return;
      sendAll(in_text_  ? "230 OK RECEIVING DATA\r\n"
              : is_text ? "225-1\r\n225 OK MESSAGE QUEUED\r\n"
                        : "200 OK\r\n");
    }
  }
  void sendAll(const std::string& bytes) const {
    send(fd_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  }

  StrangeServer server_;
  int fd_ = -1;
  std::string heard_;
  std::size_t answered_ = 0;
  bool in_text_ = false;
};

}  // namespace relievo::test
