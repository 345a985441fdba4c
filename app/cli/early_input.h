// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <future>
#include <stop_token>

#include "app/cli/arguments.h"
#include "core/base/task.h"
#include "core/provenance/provenance.h"

namespace relievo::batch {

/// What a verb that writes a map can do while its input is read: the checksum that says where the
/// map comes from, and getting ready what writes it. Ends its work when it goes, whoever needs it
/// no more.
class EarlyInput {
 public:
  /// @param out  what is written: the input is named as it is found from there
  EarlyInput(const std::filesystem::path& file, const std::filesystem::path& out, const Task& task);
  ~EarlyInput();
  EarlyInput(const EarlyInput&) = delete;
  EarlyInput& operator=(const EarlyInput&) = delete;

  /// Once. @throw FileError, Cancelled
  InputFile take() { return made_.get(); }

 private:
  struct Stop {
    std::stop_source* source;
    void operator()() const { source->request_stop(); }
  };
  std::stop_source stop_;
  std::stop_callback<Stop> stopped_with_verb_;
  std::future<InputFile> made_;
  std::future<void> ready_;  ///< Whoever writes says what went wrong.
};

/// As that of app/cli/state.h, with an input that is known.
Provenance provenanceOfVerb(const MapArguments& arguments, const Surface& surface, InputFile input);

}  // namespace relievo::batch
