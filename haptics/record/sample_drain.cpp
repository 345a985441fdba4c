// SPDX-License-Identifier: BSD-3-Clause
#include "haptics/record/sample_drain.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

namespace relievo {

struct SampleDrain::Impl {
  SampleRing& ring;
  std::vector<SampleSink> sinks;
  std::vector<HapticSample> batch;
  std::atomic<bool> stopping{false};
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

  void run() {
    using namespace std::chrono_literals;
    for (bool last = false; !last;) {
      last = stopping.load(std::memory_order_acquire);  // Then one more round takes what is left.
      while (!deliver()) {
      }
      if (!last) std::this_thread::sleep_for(10ms);
    }
  }
};

SampleDrain::SampleDrain(SampleRing& from, std::vector<SampleSink> sinks)
    : impl_(std::make_unique<Impl>(from, std::move(sinks))) {
  impl_->thread = std::thread([this] { impl_->run(); });
}

SampleDrain::~SampleDrain() {
  impl_->stopping.store(true, std::memory_order_release);
  impl_->thread.join();
}

}  // namespace relievo
