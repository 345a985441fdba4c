// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>

#include "ui/video/video_file.h"

namespace relievo {

// What openVideo chooses between. @throw as openVideo
std::unique_ptr<VideoFile> openMp4(const OutputFile& file, const VideoFormat& format);
std::unique_ptr<VideoFile> openImageSequence(const std::filesystem::path& folder,
                                             const VideoFormat& format);

}  // namespace relievo
