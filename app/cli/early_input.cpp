// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/early_input.h"

#include <utility>

#include "core/io/raster/raster_file.h"

namespace relievo::batch {

EarlyInput::EarlyInput(const std::filesystem::path& file, const std::filesystem::path& out,
                       const Task& task)
    : stopped_with_verb_(task.stop, Stop{&stop_}) {
  const std::filesystem::path folder = out.parent_path();
  Task own;  // Without a report: that of the reading is shown.
  own.stop = stop_.get_token();
  made_ = std::async(std::launch::async,
                     [file, from = folder.empty() ? std::filesystem::path(".") : folder,
                      own = std::move(own)] { return inputFile(file, from, own); });
  ready_ = std::async(std::launch::async, prepareRasterFiles);
}

EarlyInput::~EarlyInput() {
  stop_.request_stop();
  if (made_.valid()) made_.wait();
}

}  // namespace relievo::batch
