// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QFrame>
#include <QIcon>
#include <QKeySequence>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace relievo {

/// A sentence above the views with buttons; never modal, and takes no focus: the hand may be at
/// work below it. One message at a time. [GUI thread]
class MessageStrip : public QFrame {
  Q_OBJECT
 public:
  struct Button {
    QString text;
    std::function<void()> action;  ///< Runs after the strip closed.
    QIcon picture = {};            ///< In place of the text, which then is its name.
  };

  explicit MessageStrip(QWidget* parent = nullptr);
  /// Shows a message in place of the one before.
  void show(const QString& text, const std::vector<Button>& buttons = {});
  QString text() const;
  void close();
  /// The key that presses the first button; shown beside it.
  void setOfferKey(const QKeySequence& key);
  bool hasOffer() const { return offer_ != nullptr; }
  /// As if the first button were pressed. @return false: there is none
  bool triggerDefaultAction();
  /// Where the keyboard goes in here: the first button, or what closes the message.
  QWidget* firstControl() const;

 Q_SIGNALS:
  /// What is shown, with the button that a key presses: whoever does not look is to be told.
  void shown(const QString& words);
  void offerChanged(bool has_offer);
  void dismissed();  ///< Closed by the user without an answer.

 private:
  void showOfferKey();

  QLabel *label_, *key_;
  QToolButton* closer_;
  QPushButton* offer_ = nullptr;  ///< First of buttons_.
  QHBoxLayout* buttons_;
};

}  // namespace relievo
