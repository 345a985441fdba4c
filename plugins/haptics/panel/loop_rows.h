// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPointer>
#include <span>

#include "plugins/haptics/panel/loop_health.h"
#include "plugins/haptics/panel/scope.h"

class QFormLayout;
class QLabel;
class QPushButton;
class QWidget;

namespace relievo {

/// The rows of the panel Touch that tell of the running loop, and the dialogs that tell more.
/// [GUI thread]
class LoopRows : public QObject {
  Q_OBJECT
 public:
  /// @param panel  the dialogs stand before it; owns this
  explicit LoopRows(QWidget* panel);
  void addDepth(QFormLayout* form);
  void addHealth(QFormLayout* form);

  void show(const LoopReport& report);             ///< A few times a second.
  void plot(std::span<const ForcePoint> samples);  ///< For the scope, if it is open.

 private:
  void showHealth();
  void showDetails();
  void showScope();

  QWidget* panel_;
  QLabel* depth_;
  QLabel* health_;
  QPushButton* details_;
  QPushButton* scope_;
  QPointer<LoopDetailsDialog> open_details_;
  QPointer<ScopeDialog> open_scope_;
  LoopReport report_;     // The last one shown.
  int health_shows_ = 0;  // Since the health line was written.
  bool health_at_rest_ = false;
  double health_rate_hz_ = 0;  // As the line says; 0: not known yet.
};

}  // namespace relievo
