// SPDX-License-Identifier: BSD-3-Clause
#include "core/io/web/web_worker.h"
#include "core/file/whole_bytes.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <clocale>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <exception>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

#include "core/io/web/published_map.h"
#include "core/io/worker/answer_text.h"
#include "core/io/worker/worker_child.h"
#include "core/io/worker/worker_process.h"
#include "core/io/worker/worker_sandbox.h"

namespace relievo {
namespace {

constexpr std::uint64_t kMostManifest = std::uint64_t{16} << 20U;

struct Asked {
  WebRequest request;
  std::string name;
};

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text));
}

/// What is asked for, of the bytes that were fetched.
FetchedBytes made(const Asked& asked) {
  const WebRequest& request = asked.request;
  FetchedBytes got = fetched(asked.name, request.first, request.count);
  if (got.end != WebEnd::good) return got;
  const FetchedBytes other{.end = WebEnd::damaged, .bytes = {}, .why = "it is something else"};
  if (request.ask == WebAsk::tile) {
    if (request.part >= kTileParts) return other;
    auto tile = unpackedTile(got.bytes, static_cast<TilePart>(request.part));
    if (!tile) return other;
    got.bytes = std::move(*tile);
  } else if (request.ask == WebAsk::published) {
    if (got.bytes.size() > kMostManifest) return other;
    const std::string text(reinterpret_cast<const char*>(got.bytes.data()), got.bytes.size());
    const auto map = readPublishedMap(text);
    if (!map) return other;
    Packer packer;
    packer.put(text);
    packer.put(packed(*map));
    const auto answer = bytesOf(packer.bytes());
    got.bytes.assign(answer.begin(), answer.end());
  }
  return got;
}

class Service {
 public:
  void run() {
    for (int i = 0; i < kWebConnections; ++i) {
      threads_.emplace_back([this](const std::stop_token& stop) { work(stop); });
    }
    for (Asked asked; readWhole(kInputFd, &asked.request, sizeof(asked.request));) {
      if (asked.request.name_bytes > kMostWebName) break;
      asked.name.resize(asked.request.name_bytes);
      if (!readWhole(kInputFd, asked.name.data(), asked.name.size())) break;
      const std::scoped_lock lock(mutex_);
      queue_.push_back(std::move(asked));
      changed_.notify_one();
    }
    // Nobody is left to answer to, and a server may keep others waiting for long.
    std::_Exit(0);
  }

 private:
  void work(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, stop, [this] { return !queue_.empty(); })) {
      const Asked asked = std::move(queue_.front());
      queue_.pop_front();
      lock.unlock();
      FetchedBytes got;
      try {
        got = made(asked);
      } catch (const std::exception& error) {
        got = {.end = WebEnd::damaged, .bytes = {}, .why = error.what()};
      }
      answer(asked.request.id, got);
      lock.lock();
    }
  }

  void answer(std::uint64_t id, const FetchedBytes& got) {
    const auto content = got.end == WebEnd::good ? std::span(got.bytes) : bytesOf(got.why);
    const WebReply reply{
        .id = id, .end = got.end, .bytes = static_cast<std::uint32_t>(content.size())};
    const std::scoped_lock lock(answering_);
    send(&reply, sizeof(reply));
    send(content.data(), content.size());
  }

  static void send(const void* from, std::size_t bytes) {
    const auto* at = static_cast<const char*>(from);
    while (bytes > 0) {
      const ssize_t sent = ::write(kInputFd, at, bytes);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) std::_Exit(0);
      at += sent;
      bytes -= static_cast<std::size_t>(sent);
    }
  }

  std::mutex mutex_, answering_;
  std::condition_variable_any changed_;
  std::deque<Asked> queue_;
  std::vector<std::jthread> threads_;
};

}  // namespace

int runWebWorker(int argc, char** argv) {
  const bool called = argc == 2 && std::string_view(argv[1]) == kWorkerArgument;
  if (!called || !hasWorkersPlace({kAnswerFd})) {
    std::fputs("The program that fetches maps is started by relievo of the same version.\n",
               stderr);
    return 1;
  }
  if (!dieWithParent()) return 1;
  std::setlocale(LC_ALL, "C");
  prepareFetching();
  constexpr ChildLimits kLimits{.allocated_bytes = std::uint64_t{4} << 30U,
                                .mapped_bytes = 0,
                                .answer_bytes = std::nullopt,
                                .cpu_s = 1e6};
  setChildLimits(kLimits);
  enterWorkerSandbox(kInputFd, SandboxNetwork::open);
  Service().run();
  return 0;
}

}  // namespace relievo
