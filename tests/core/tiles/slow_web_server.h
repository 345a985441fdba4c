// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace relievo::test {

/// A web server on this computer that gives the files of a folder, whole or in part, as late and as
/// slowly as one far away: every answer waits for the delay, and all share one rate.
class SlowWebServer {
 public:
  struct Options {
    std::chrono::milliseconds delay{0};
    double bytes_per_s = 1e12;
    /// An object store's: without a signature by this key nothing is given.
    std::string key = {};
  };
  SlowWebServer(std::filesystem::path folder, Options options)
      : folder_(std::move(folder)), options_(options) {
    start();
  }
  ~SlowWebServer() { stop(); }
  SlowWebServer(const SlowWebServer&) = delete;
  SlowWebServer& operator=(const SlowWebServer&) = delete;

  std::string address() const { return "http://127.0.0.1:" + std::to_string(port_); }
  int requests() const { return requests_; }
  /// From now on a byte of what is given of files whose names hold this is another.
  void damage(const std::string& part_of_name) {
    const std::scoped_lock lock(mutex_);
    damaged_ = part_of_name;
  }
  /// From now on answers wait, until they are let go.
  void hold() {
    const std::scoped_lock lock(mutex_);
    held_ = true;
  }
  void letGo() {
    {
      const std::scoped_lock lock(mutex_);
      held_ = false;
    }
    changed_.notify_all();
  }
  /// Every connection breaks, and nobody listens any more.
  void stop() {
    if (listening_ < 0) return;
    {
      const std::scoped_lock lock(mutex_);
      running_ = false;
      ::shutdown(listening_, SHUT_RDWR);
      for (const int fd : open_) ::shutdown(fd, SHUT_RDWR);
    }
    changed_.notify_all();
    accepting_.join();
    for (std::thread& thread : serving_) thread.join();
    serving_.clear();
    ::close(listening_);
    listening_ = -1;
  }
  /// At the same address as before.
  void start() {
    listening_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    place.sin_port = htons(static_cast<std::uint16_t>(port_));
    socklen_t length = sizeof(place);
    auto* const any = reinterpret_cast<sockaddr*>(&place);
    if (::bind(listening_, any, sizeof(place)) != 0 || ::listen(listening_, 64) != 0 ||
        ::getsockname(listening_, any, &length) != 0) {
      throw std::runtime_error("The test's server finds no port.");
    }
    port_ = ntohs(place.sin_port);
    running_ = true;
    accepting_ = std::thread([this] { accept(); });
  }

 private:
  void accept() {
    for (;;) {
      const int fd = ::accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
      const std::scoped_lock lock(mutex_);
      if (!running_) {
        if (fd >= 0) ::close(fd);
        return;
      }
      if (fd < 0) continue;
      const int on = 1;
      ::setsockopt(fd, IPPROTO_TCP, TCP_NODELAY, &on, sizeof(on));
      open_.insert(fd);
      serving_.emplace_back([this, fd] { serve(fd); });
    }
  }

  void serve(int fd) {
    std::string head;
    for (char c = 0; ::recv(fd, &c, 1, 0) == 1;) {
      head += c;
      if (!head.ends_with("\r\n\r\n")) continue;
      if (!answer(fd, head)) break;
      head.clear();
    }
    const std::scoped_lock lock(mutex_);
    open_.erase(fd);
    ::close(fd);
  }

  bool answer(int fd, const std::string& head) {
    ++requests_;
    const std::size_t name_at = head.find(' ') + 2;
    const std::string name = head.substr(name_at, head.find(' ', name_at) - name_at);
    const bool is_signed = options_.key.empty() ||
                           head.find("Authorization: AWS4-HMAC-SHA256 Credential=" + options_.key +
                                     "/") != std::string::npos;
    if (!is_signed) return refuse(fd, head, "403 Forbidden", "AccessDenied");
    std::error_code unknown;
    const std::filesystem::path file = folder_ / name;
    if (!std::filesystem::is_regular_file(file, unknown)) {
      return refuse(fd, head, "404 Not Found", "NoSuchKey");
    }
    const std::size_t size = std::filesystem::file_size(file);
    std::string status = "200 OK";
    std::string more;
    std::size_t first = 0, count = size;
    if (const std::size_t range = head.find("ange: bytes=");
        range != std::string::npos && size > 0) {
      const std::size_t dash = head.find('-', range);
      std::size_t last = size - 1;
      first = std::stoul(head.substr(range + 12));
      if (std::isdigit(static_cast<unsigned char>(head[dash + 1])) != 0) {
        last = std::min<std::size_t>(last, std::stoul(head.substr(dash + 1)));
      }
      count = first <= last ? last - first + 1 : 0;
      status = "206 Partial Content";
      more = "Content-Range: bytes " + std::to_string(first) + "-" + std::to_string(last) + "/" +
             std::to_string(size) + "\r\n";
    }
    std::string content(count, '\0');
    std::ifstream in(file, std::ios::binary);
    in.seekg(static_cast<std::streamoff>(first));
    in.read(content.data(), static_cast<std::streamsize>(count));
    {
      const std::scoped_lock lock(mutex_);
      const bool hit = !damaged_.empty() && name.find(damaged_) != std::string::npos;
      if (hit && !content.empty()) content[content.size() / 2] ^= 0x20;
    }
    std::string text = "HTTP/1.1 " + status + "\r\nAccept-Ranges: bytes\r\n" + more +
                       "Content-Length: " + std::to_string(content.size()) + "\r\n\r\n";
    if (!head.starts_with("HEAD")) text += content;
    return waitFor(text.size()) && send(fd, text);
  }

  /// As object stores say why; web servers have other words in the same place.
  bool refuse(int fd, const std::string& head, const std::string& status, const std::string& code) {
    const std::string body =
        "<?xml version=\"1.0\"?><Error><Code>" + code + "</Code><Message>No.</Message></Error>";
    std::string text = "HTTP/1.1 " + status + "\r\nContent-Type: application/xml\r\n" +
                       "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n";
    if (!head.starts_with("HEAD")) text += body;
    return waitFor(text.size()) && send(fd, text);
  }

  /// @return  false if the server stops
  bool waitFor(std::size_t bytes) {
    using Clock = std::chrono::steady_clock;
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return !held_ || !running_; });
    const auto begins = std::max(Clock::now() + options_.delay, free_at_);
    const auto takes = std::chrono::duration_cast<Clock::duration>(
        std::chrono::duration<double>(static_cast<double>(bytes) / options_.bytes_per_s));
    free_at_ = begins + takes;
    return !changed_.wait_until(lock, begins + takes, [this] { return !running_; });
  }

  static bool send(int fd, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
      const ssize_t sent = ::send(fd, text.data() + done, text.size() - done, MSG_NOSIGNAL);
      if (sent <= 0) return false;
      done += static_cast<std::size_t>(sent);
    }
    return true;
  }

  std::filesystem::path folder_;
  Options options_;
  int listening_ = -1, port_ = 0;
  std::atomic<int> requests_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool running_ = false, held_ = false;
  std::set<int> open_;
  std::string damaged_;
  std::chrono::steady_clock::time_point free_at_;
  std::vector<std::thread> serving_;
  std::thread accepting_;
};

}  // namespace relievo::test
