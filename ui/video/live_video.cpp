// SPDX-License-Identifier: BSD-3-Clause
#include "ui/video/live_video.h"

#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/background.h"
#include "core/base/error.h"

namespace relievo {

struct LiveVideo::Impl {
  struct Picture {
    std::uint64_t frame;
    std::function<RgbaImage()> make;
  };

  std::unique_ptr<VideoFile> file;  // [thread] once it runs.
  double fps = 15;
  std::int64_t last_offered = -1;  // [owner]

  mutable std::mutex mutex;  // Guards what follows; held for moves only.
  std::condition_variable_any came;
  std::deque<Picture> waiting;
  bool closed = false;
  Report report;

  std::jthread thread;

  void run(const std::stop_token& stop) {
    const Task task{stop, {}};
    std::string error, code;
    std::shared_ptr<const Message> message;
    try {
      pack(task);
    } catch (const Cancelled&) {
      error = "Cancelled.";
    } catch (const Error& failure) {
      error = failure.what();
      code = failure.code;
      message = failure.message;
    }
    file.reset();  // Whatever is left of it goes or stays before the end is told.
    const std::lock_guard lock(mutex);
    report.ended = true;
    report.error = std::move(error);
    report.code = std::move(code);
    report.message = std::move(message);
  }

  void pack(const Task& task) {
    RgbaImage shown;
    std::uint64_t next = 0;
    for (;;) {
      std::unique_lock lock(mutex);
      came.wait(lock, task.stop, [this] { return closed || !waiting.empty(); });
      task.check();
      if (waiting.empty()) break;
      Picture picture = std::move(waiting.front());
      waiting.pop_front();
      lock.unlock();
      RgbaImage made = picture.make();
      if (next == 0) shown = made;
      for (; next < picture.frame; ++next) add(shown, task);
      shown = std::move(made);
      add(shown, task);
      ++next;
    }
    file->finish(task);
  }

  void add(const RgbaImage& image, const Task& task) {
    file->add(image, task);
    const std::lock_guard lock(mutex);
    report.frames = file->frames();
  }
};

LiveVideo::LiveVideo(const std::filesystem::path& file, const VideoFormat& format)
    : impl_(std::make_unique<Impl>()) {
  impl_->fps = format.fps;
  std::promise<void> opened;
  std::future<void> is_open = opened.get_future();
  impl_->thread = std::jthread(
      [this, &file, &format, opened = std::move(opened)](const std::stop_token& stop) mutable {
        workInBackground();  // Before the encoder starts, which inherits it.
        try {
          impl_->file = openVideo(file, format);
        } catch (...) {
          opened.set_exception(std::current_exception());
          return;
        }
        opened.set_value();
        impl_->run(stop);
      });
  is_open.get();
}

LiveVideo::~LiveVideo() = default;

void LiveVideo::offer(RgbaImage picture, double t_s) {
  const auto kept = std::make_shared<RgbaImage>(std::move(picture));
  offer([kept] { return std::move(*kept); }, t_s);
}

void LiveVideo::offer(std::function<RgbaImage()> make, double t_s) {
  const auto frame = static_cast<std::int64_t>(std::floor(t_s * impl_->fps + 1e-6));
  if (frame <= impl_->last_offered) return;
  const std::lock_guard lock(impl_->mutex);
  if (impl_->closed || impl_->report.ended) return;
  impl_->last_offered = frame;
  if (impl_->waiting.size() >= kMostWaiting) {
    ++impl_->report.dropped;
    return;
  }
  impl_->waiting.push_back({static_cast<std::uint64_t>(frame), std::move(make)});
  impl_->came.notify_one();
}

void LiveVideo::finish() {
  const std::lock_guard lock(impl_->mutex);
  impl_->closed = true;
  impl_->came.notify_one();
}

LiveVideo::Report LiveVideo::report() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->report;
}

}  // namespace relievo
