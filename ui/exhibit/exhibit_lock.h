// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QCursor>
#include <QKeyEvent>
#include <QObject>
#include <QPoint>
#include <QPointer>
#include <QString>
#include <utility>
#include <vector>

class QWidget;

namespace relievo {

class MainWindow;

/// Takes from the window everything that a visitor must not reach: menus, tool bar, panels,
/// messages, dialogs, files, and its end. What is left of it is the detail view. [GUI thread]
class ExhibitLock : public QObject {
  Q_OBJECT
 public:
  explicit ExhibitLock(MainWindow& window);
  ~ExhibitLock() override;

  /// Commands that visitors may run, by buttons or by keys that stand for them.
  static bool isAllowed(const QString& command);
  /// From now on the window closes as any other.
  void letClose() { lets_close_ = true; }
  /// What a panel or command that came later must not reach either.
  void lockActions();

  /// Gets each key that goes down. @return true: the detail view gets it, too
  void setKeys(std::function<bool(const QKeyEvent& key)> keys) { keys_ = std::move(keys); }

  bool eventFilter(QObject* watched, QEvent* event) override;

 Q_SIGNALS:
  void closeAsked();  ///< The window manager, Alt+F4 or Ctrl+Q.
  void stirred();     ///< The mouse, or a button of it.

 private:
  bool isOfDetail(const QObject* watched) const;
  bool filterKey(QKeyEvent& key, bool is_override);

  MainWindow& window_;
  std::vector<QPointer<QWidget>> hidden_;
  std::function<bool(const QKeyEvent& key)> keys_;
  QPoint pointer_ = QCursor::pos();  // One that only stands there is nobody.
  bool lets_close_ = false;
};

}  // namespace relievo
