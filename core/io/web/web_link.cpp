// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/web/web_link.h"

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "core/base/error.h"
#include "core/file/owned_fd.h"
#include "core/file/whole_bytes.h"
#include "core/io/worker/spawn.h"
#include "core/io/worker/worker_process.h"

namespace relievo {
namespace {

/// Proxies, certificates and the keys of object stores: what whoever fetches needs beyond readers.
constexpr std::array<std::string_view, 12> kForFetching{
    "http_proxy=", "https_proxy=",    "no_proxy=",      "HTTPS_PROXY=",  "NO_PROXY=", "all_proxy=",
    "ALL_PROXY=",  "CURL_CA_BUNDLE=", "SSL_CERT_FILE=", "SSL_CERT_DIR=", "AWS_",      "RESOLV_"};

std::vector<std::string> environmentForFetching() {
  std::vector<std::string> kept;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string_view text = *entry;
    const bool needed =
        std::any_of(kForFetching.begin(), kForFetching.end(),
                    [text](std::string_view name) { return text.starts_with(name); });
    if (needed) kept.emplace_back(text);
  }
  return kept;
}

bool sendWhole(int fd, const void* from, std::size_t bytes) {
  const auto* at = static_cast<const char*>(from);
  while (bytes > 0) {
    const ssize_t sent = ::send(fd, at, bytes, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    bytes -= static_cast<std::size_t>(sent);
  }
  return true;
}

}  // namespace

struct WebLink::Impl {
  Impl() {
    thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~Impl() {
    thread.request_stop();
    const std::scoped_lock lock(mutex);
    if (socket.get() >= 0) ::shutdown(socket.get(), SHUT_RDWR);
  }

  void run(const std::stop_token& stop);
  void serve();
  void failAll();
  bool takeAnswer(int fd);

  std::mutex mutex;
  std::condition_variable_any changed;
  bool wanted = false;             ///< Somebody waits for a process.
  std::exception_ptr not_started;  ///< Why there is none.
  OwnedFd socket;
  std::mutex sending;
  std::uint64_t next_id = 1;
  std::map<std::uint64_t, std::promise<Answer>> open;
  std::jthread thread;  ///< Last: joins before what it uses goes.
};

// A process ends with the thread that started it: this one, which lives as long as the link.
void WebLink::Impl::run(const std::stop_token& stop) {
  std::unique_lock lock(mutex);
  while (changed.wait(lock, stop, [this] { return wanted; })) {
    std::array<int, 2> ends{-1, -1};
    std::optional<WorkerProcess> process;
    try {
      if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        raised(-1);  // Says it.
      }
      const OwnedFd other(ends[1]);
      socket.reset(ends[0]);
      process.emplace(WorkerStart{.program = "relievo-import-web",
                                  .arguments = {kWorkerArgument},
                                  .input = other.get(),
                                  .does = "Maps cannot be fetched:",
                                  .more_environment = environmentForFetching()});
    } catch (const Error&) {
      not_started = std::current_exception();
      socket.reset();
    }
    wanted = false;
    changed.notify_all();
    if (socket.get() < 0) continue;
    const int fd = socket.get();
    lock.unlock();
    while (takeAnswer(fd)) {
    }
    lock.lock();
    socket.reset();
    failAll();
  }
  failAll();
}

bool WebLink::Impl::takeAnswer(int fd) {
  WebReply reply;
  if (!readWhole(fd, &reply, sizeof(reply)) || reply.bytes > kMostWebBytes) return false;
  Answer answer{.end = reply.end, .bytes = {}, .why = {}};
  answer.bytes.resize(reply.bytes);
  if (!readWhole(fd, answer.bytes.data(), answer.bytes.size())) return false;
  if (answer.end != WebEnd::good) {
    answer.why.assign(reinterpret_cast<const char*>(answer.bytes.data()), answer.bytes.size());
    answer.bytes.clear();
  }
  const std::scoped_lock lock(mutex);
  const auto found = open.find(reply.id);
  if (found == open.end()) return false;  // An answer to nothing: it is not ours any more.
  found->second.set_value(std::move(answer));
  open.erase(found);
  return true;
}

/// Under the mutex.
void WebLink::Impl::failAll() {
  for (auto& [id, promise] : open) {
    promise.set_value({.end = WebEnd::ended, .bytes = {}, .why = "the process that fetches ended"});
  }
  open.clear();
}

WebLink::WebLink() : impl_(std::make_unique<Impl>()) {}
WebLink::~WebLink() = default;

std::future<WebLink::Answer> WebLink::ask(WebAsk what, const std::string& name, std::uint64_t first,
                                          std::uint32_t count, TilePart part) {
  Impl& all = *impl_;
  const std::scoped_lock one_by_one(all.sending);
  std::unique_lock lock(all.mutex);
  if (all.socket.get() < 0) {
    all.wanted = true;
    all.not_started = nullptr;
    all.changed.notify_all();
    all.changed.wait(lock, [&all] { return !all.wanted; });
    if (all.not_started) std::rethrow_exception(all.not_started);
  }
  WebRequest request{.id = all.next_id++,
                     .first = first,
                     .ask = what,
                     .count = count,
                     .part = static_cast<std::uint32_t>(part),
                     .name_bytes = static_cast<std::uint32_t>(name.size())};
  std::promise<Answer> promise;
  std::future<Answer> answer = promise.get_future();
  const int fd = all.socket.get();
  if (fd < 0) {
    promise.set_value({.end = WebEnd::ended, .bytes = {}, .why = "the process that fetches ended"});
    return answer;
  }
  all.open.emplace(request.id, std::move(promise));
  std::string message(reinterpret_cast<const char*>(&request), sizeof(request));
  message += name;
  // The process reads at once whatever comes, and so this never waits for the network.
  if (!sendWhole(fd, message.data(), message.size())) ::shutdown(fd, SHUT_RDWR);
  return answer;
}

WebLink::Answer WebLink::wait(std::future<Answer> answer, const Task& task) {
  while (answer.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) task.check();
  return answer.get();
}

bool isWebAddress(const std::string& name) noexcept {
  return name.starts_with("http://") || name.starts_with("https://") || name.starts_with("s3://");
}

std::string fetchName(const std::string& place, const std::string& file) {
  const std::string name = place + (place.ends_with('/') ? "" : "/") + file;
  if (name.starts_with("s3://")) return "/vsis3/" + name.substr(5);
  return isWebAddress(name) ? "/vsicurl/" + name : name;
}

}  // namespace relievo
