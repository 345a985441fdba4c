// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QTimer>
#include <QWidget>

namespace relievo {

/// Tells a screen reader what happened. Qt 5 sends alerts to nobody on Linux, so this is a child
/// that is never drawn, whose role is that of a notification and whose name is the text: it is
/// shown anew with each text, and so also with the same text twice (docs/adr/0167). [GUI thread]
class Announcer : public QWidget {
  Q_OBJECT
 public:
  explicit Announcer(QWidget* parent);
  /// At once; again, when a screen reader listens, if the keyboard comes back to this window from
  /// another at that moment.
  void say(const QString& text);
  /// By the announcer of any window of this program: to say what a dialog without one has to say.
  static void sayAnywhere(const QString& text);
  /// What was said last.
  const QString& text() const { return text_; }

 Q_SIGNALS:
  void told();  ///< Whoever listens, if anybody does.

 private:
  void tell();
  void onFocus(const QWidget* before, const QWidget* now);

  QString text_;
  QElapsedTimer said_, came_back_;  ///< Since then; the keyboard came back to this window.
  QTimer again_;
};

}  // namespace relievo
