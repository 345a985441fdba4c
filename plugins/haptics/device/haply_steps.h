// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <QGroupBox>

#include "haptics/device/haply/link_status.h"

class QLabel;

namespace relievo {

/// Set-up of a device of Haply: which steps are done, where the hand is, and what is pressed.
/// [GUI thread]
class HaplySteps : public QGroupBox {
  Q_OBJECT
 public:
  HaplySteps();

  void showStatus(const haply::LinkStatus& status);

  static constexpr std::size_t kSteps = 6;
  /// How many steps are done, from the first on, before the one that this state waits for.
  static std::size_t stepsDone(haply::LinkState state) noexcept;

 private:
  std::array<QLabel*, kSteps> steps_{};
  QLabel *hand_, *buttons_;
};

}  // namespace relievo
