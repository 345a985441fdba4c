// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/task.h"
#include "core/cloud/scan.h"
#include "core/io/import.h"
#include "core/io/point_files.h"
#include "core/io/point_values.h"
#include "core/message/message.h"
#include "core/tiles/points/point_source.h"

namespace relievo {

/// Colours and intensities of a cloud that is read in blocks, as importScan would settle them for
/// the whole: what the numbers mean is said by all of them. Immutable after construction.
class StreamedValues {
 public:
  /// Looks at the files' points until it is known what their numbers mean; often that is soon.
  /// @param threads  0: as many as there are cores, at most 4 [worker] @throw FileError, Cancelled
  StreamedValues(const std::vector<std::filesystem::path>& files, const ImportOptions& options,
                 int threads, const Task& task);

  bool hasColours() const noexcept { return has_colours_; }
  bool hasIntensities() const noexcept { return has_intensities_; }
  bool any() const noexcept { return has_colours_ || has_intensities_; }
  /// As ScanInfo has them; the number of points with a colour is not known.
  std::optional<ColourFact> colourFact() const;
  std::optional<IntensityRange> intensityRange() const;
  const std::vector<Message>& warnings() const noexcept { return warnings_; }

  /// All points and what they say, those left out as three NaN. [any thread]
  /// @param keeps  which of the points take part; null: all
  ValueSource source(std::function<bool(const FilePoint&)> keeps) const;

 private:
  struct Seen {
    ColourScale colour;
    IntensityScale intensity;
    float most_intensity = 0;
  };
  template <class Look>
  void lookAtAll(int threads, const Task& task, const Look& look) const;
  bool isDecided(const Seen& seen) const;
  void findMiddle(int threads, const Task& task);

  std::shared_ptr<const PointFiles> stream_;
  ColourScale colour_;
  IntensityScale intensity_;
  bool has_colours_ = false, has_intensities_ = false;
  std::vector<Message> warnings_;
};

}  // namespace relievo
