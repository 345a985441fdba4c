// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "ui/frame/message_strip.h"
#include "ui/frame/status_fields.h"

namespace relievo {

/// What the window says and asks, and the long work that it tells of: in the strip above the views,
/// in the status bar, to the screen reader, and by a voice. [GUI thread]
class WindowMessages : public QObject {
  Q_OBJECT
 public:
  WindowMessages(MessageStrip& strip, StatusFields& status);

  /// In the status bar, and heard.
  void announce(const QString& text);
  /// The same; the screen reader hears it when what appears at that moment was read, unless
  /// another message came.
  void announceWhenCalm(const QString& text);
  /// To whoever does not look: by who speaks, else by the screen reader.
  void tell(const QString& text);
  /// @param spoken  for the screen reader; empty: it was heard already
  void announceAs(const QString& text, const QString& spoken);
  /// Who is asked first to speak what is announced, and says whether it does.
  void setSpeaker(std::function<bool(const QString& text)> speaker);

  /// A sentence above the views, with its answers.
  void show(const QString& text, const std::vector<MessageStrip::Button>& buttons = {});
  /// The same of an error, with its code and what can be done.
  void showError(const QString& text, const QString& code);
  void close();
  /// Says that a file is saved, or why not.
  void tellWritten(const QString& file, const std::function<void()>& write);
  QString shown() const;  ///< Empty while there is none.
  /// A field of the status bar.
  void set(StatusField field, const QString& text, const QString& tip = {});

  /// Tells of the progress of what has signals busyChanged and progressed.
  template <class Work>
  void follow(const Work& work) {
    connect(&work, &Work::busyChanged, this, &WindowMessages::showBusy);
    connect(&work, &Work::progressed, this, &WindowMessages::showWork);
  }

  /// There is long work, or no longer.
  void showBusy(bool busy);

 Q_SIGNALS:
  void workBegan();
  void cancelAsked();  ///< By the button beside the progress.
  void dismissed();    ///< The strip was closed without an answer.
  void errorShown();   ///< By showError.

 private:
  void showWork(const QString& step, double fraction);

  MessageStrip& strip_;
  StatusFields& status_;
  std::function<bool(const QString& text)> speaker_;
};

}  // namespace relievo
