// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/sample_drain.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>

namespace relievo {

struct SampleDrain::Impl {
  SampleRing& ring;
  std::vector<SampleSink> sinks;
  std::vector<HapticSample> batch;
  std::mutex mutex;  ///< Of the two below; the loop never takes it.
  std::condition_variable changed;
  bool stopping = false, urgent = true;
  std::thread thread;

  Impl(SampleRing& r, std::vector<SampleSink> s) : ring(r), sinks(std::move(s)) {
    constexpr std::size_t kMostPerBatch = 2048;
    batch.reserve(kMostPerBatch);
  }

  /// @return the ring was emptied
  bool deliver() {
    batch.clear();
    HapticSample sample;
    while (batch.size() < batch.capacity() && ring.pop(sample)) batch.push_back(sample);
    for (const SampleSink& sink : sinks) sink(batch);
    return batch.size() < batch.capacity();
  }

  /// Until the next round is due. @return it is the last one, which takes what is left
  bool rest() {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex);
    const bool was_urgent = urgent;
    changed.wait_for(lock, urgent ? 10ms : 125ms,
                     [&] { return stopping || (urgent && !was_urgent); });
    return stopping;
  }

  void run() {
    for (bool last = false;; last = rest()) {
      while (!deliver()) {
      }
      if (last) return;
    }
  }
};

SampleDrain::SampleDrain(SampleRing& from, std::vector<SampleSink> sinks)
    : impl_(std::make_unique<Impl>(from, std::move(sinks))) {
  impl_->thread = std::thread([this] { impl_->run(); });
}

SampleDrain::~SampleDrain() {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->changed.notify_all();
  impl_->thread.join();
}

void SampleDrain::setUrgent(bool urgent) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->urgent = urgent;
  }
  impl_->changed.notify_all();
}

}  // namespace relievo
