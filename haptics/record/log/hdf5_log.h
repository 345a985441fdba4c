// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "haptics/record/sample_log.h"

namespace relievo {

/// A log as HDF5: /log/COLUMN one compressed dataset each with the attributes `unit` and
/// `description`; /events (time_s, tick, text); /surface/depth and /surface/origin; /parameters,
/// /provenance (the header), /relievo:state (what core/provenance tells) and, of a recording, /loop
/// as text; /checksums and the user block as in core/recording/log_checksum.h. Readable by h5py or
/// MATLAB without this program. The library is not used from two threads at once: one log at a
/// time.
class Hdf5Log : public SampleLog {
 public:
  /// @throw WriteError  the file cannot be made
  Hdf5Log(std::filesystem::path file, std::string_view header, const HapticSpace* surface);
  ~Hdf5Log() override;

  void write(const HapticSample& sample, double t_s, std::string_view event = {}) override;
  void keep(std::string_view lines) override;
  void close(std::string_view footer = {}) override;
  std::uint64_t rows() const noexcept override;
  const std::filesystem::path& file() const noexcept override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace relievo
