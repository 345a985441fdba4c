// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <QDialog>

class QLineEdit;

namespace relievo {

/// Asks for a note about one moment of a running recording, beside the window: the hand goes on
/// meanwhile.
class NoteDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param tick    of the moment
  /// @param time_s  the same since the recording's start, for people
  NoteDialog(std::uint64_t tick, double time_s, QWidget* parent);

  std::uint64_t tick() const { return tick_; }
  double timeS() const { return time_s_; }
  QString text() const;  ///< One line; empty: nothing was written.

 private:
  std::uint64_t tick_;
  double time_s_;
  QLineEdit* text_;
};

}  // namespace relievo
