// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QFrame>
#include <vector>

class QHBoxLayout;
class QLabel;

namespace relievo {

/// A sentence above the views with buttons; never modal. One message at a time. [GUI thread]
class MessageStrip : public QFrame {
  Q_OBJECT
 public:
  struct Button {
    QString text;
    std::function<void()> action;  ///< Runs after the strip closed.
  };

  explicit MessageStrip(QWidget* parent = nullptr);
  /// Shows a message in place of the one before; assistive technology is alerted.
  void show(const QString& text, const std::vector<Button>& buttons = {});
  QString text() const;
  void close();

 private:
  QLabel* label_;
  QHBoxLayout* buttons_;
};

}  // namespace relievo
