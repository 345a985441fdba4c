// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QApplication>
#include <QElapsedTimer>

namespace relievo {

/// The one place where exceptions of event handlers, slots, paints and of workers' ends are caught:
/// each is said once, and the program goes on with what is open. [GUI thread]
class GuardedApplication : public QApplication {
 public:
  using Teller = std::function<void(const QString& sentence)>;

  GuardedApplication(int& argc, char** argv) : QApplication(argc, argv) {}
  /// Who shows the sentence; asked from the event loop, never from within a paint. The terminal
  /// gets it in any case.
  void tellTo(Teller teller) { teller_ = std::move(teller); }

  bool notify(QObject* receiver, QEvent* event) override;

 private:
  void tell(const QString& reason);

  Teller teller_;
  QString last_;         ///< A paint that fails fails again with every frame.
  QElapsedTimer since_;  ///< It was told.
};

}  // namespace relievo
