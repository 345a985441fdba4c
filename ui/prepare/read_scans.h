// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QString>
#include <utility>
#include <vector>

#include "ui/prepare/prepare_state.h"
#include "ui/prepare/prepare_work.h"

namespace relievo {

/// The scans that the dialog Prepare has read so far, and what is known of an input by them.
/// [GUI thread]
class ReadScans {
 public:
  void add(const PrepareInput& input, std::shared_ptr<const ReadScan> scan);
  /// Null: the input was not read yet, or other parts of its file were.
  std::shared_ptr<const ReadScan> held(const PrepareInput& input) const;
  const ReadScan* find(const PrepareInput& input) const { return held(input).get(); }
  /// As chosen or as its file says; mm if nobody does.
  LengthUnit unitOf(const PrepareInput& input) const;
  /// The file, and which of its scans if it is one of several.
  QString nameOf(const PrepareInput& input) const;

 private:
  std::vector<std::pair<PrepareInput, std::shared_ptr<const ReadScan>>> scans_;
};

}  // namespace relievo
