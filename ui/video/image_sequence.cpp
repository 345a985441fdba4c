// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>
#include <system_error>

#include "core/base/failure.h"
#include "ui/video/video_file.h"
#include "ui/video/video_formats.h"
#include "ui/vtk/files/picture_file.h"

namespace relievo {
namespace {

namespace fs = std::filesystem;

fs::path frameName(const fs::path& folder, std::uint64_t number) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame_%06llu.png",
                static_cast<unsigned long long>(number));
  return folder / name.data();
}

/// Each frame a file of its own.
class ImageSequence : public VideoFile {
 public:
  ImageSequence(fs::path folder, const VideoFormat& format) : folder_(std::move(folder)) {
    std::error_code error;
    made_ = fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_, error)) {
      throw failure<MessageId::video_folder_not_made>(folder_);
    }
    if (fs::exists(frameName(folder_, 1), error)) {
      throw failure<MessageId::video_folder_taken>(folder_);
    }
    text_ = {{"Title", format.title},
             {"Software", std::string("relievo ") + RELIEVO_VERSION_STRING},
             {kStateEntry, format.state}};
  }
  ~ImageSequence() override {
    if (finished_) return;
    std::error_code ignored;
    for (std::uint64_t i = 1; i <= frames_; ++i) fs::remove(frameName(folder_, i), ignored);
    if (made_) fs::remove(folder_, ignored);  // Only if nothing else is in it.
  }

  void add(const RgbaImage& frame, const Task& task) override {
    task.check();
    try {
      writePng(frameName(folder_, frames_ + 1), frame, kScreenDpi, text_);
      ++frames_;
    } catch (const WriteError& error) {
      finished_ = true;  // What is there is whole.
      throw failure<MessageId::frames_stopped>(messageOf(error), frames_, folder_);
    }
  }
  void finish(const Task&) override { finished_ = true; }
  std::uint64_t frames() const noexcept override { return frames_; }
  bool isPartKept() const noexcept override { return finished_ && frames_ > 0; }

 private:
  fs::path folder_;
  PictureText text_;
  std::uint64_t frames_ = 0;
  bool made_ = false, finished_ = false;
};

}  // namespace

std::unique_ptr<VideoFile> openImageSequence(const fs::path& folder, const VideoFormat& format) {
  return std::make_unique<ImageSequence>(folder, format);
}

}  // namespace relievo
