// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

class QToolBar;

namespace relievo {

/// Shows a tool bar's icons without their words where both are wider than the bar, so that no
/// command hides behind its end. Words stay in tooltips and accessible names; buttons without an
/// icon keep them.
class ToolBarFitter : public QObject {
 public:
  explicit ToolBarFitter(QToolBar& bar);  ///< A child of the bar.

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();

  QToolBar& bar_;
  bool waiting_ = false;
};

}  // namespace relievo
