// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/window_messages.h"

#include <QTimer>
#include <utility>

#include "core/base/error.h"
#include "ui/language/error_text.h"
#include "ui/language/spoken_text.h"
#include "ui/work/file_names.h"

namespace relievo {

WindowMessages::WindowMessages(MessageStrip& strip, StatusFields& status)
    : strip_(strip), status_(status) {
  connect(&status_, &StatusFields::cancelAsked, this, &WindowMessages::cancelAsked);
  connect(&strip_, &MessageStrip::dismissed, this, [this] {
    tell(tr("The message is closed."));  // Before the next one, if there is one.
    Q_EMIT dismissed();
  });
  connect(&strip_, &MessageStrip::shown, this, &WindowMessages::tell);
}

void WindowMessages::announce(const QString& text) {
  status_.set(StatusField::message, text);
  tell(text);
}

void WindowMessages::announceWhenCalm(const QString& text) {
  status_.set(StatusField::message, text);
  const QString spoken = forEars(text);
  if (speaker_ && speaker_(spoken)) return;
  constexpr int kCalmMs = 1200;
  QTimer::singleShot(kCalmMs, this, [this, text, spoken] {
    if (status_.text(StatusField::message) == text) status_.tell(spoken);
  });
}

void WindowMessages::tell(const QString& text) {
  const QString spoken = forEars(text);
  if (!speaker_ || !speaker_(spoken)) status_.tell(spoken);
}

void WindowMessages::announceAs(const QString& text, const QString& spoken) {
  status_.set(StatusField::message, text);
  if (!spoken.isEmpty()) status_.tell(forEars(spoken));
}

void WindowMessages::setSpeaker(std::function<bool(const QString& text)> speaker) {
  speaker_ = std::move(speaker);
}

void WindowMessages::show(const QString& text, const std::vector<MessageStrip::Button>& buttons) {
  strip_.show(text, buttons);
}

void WindowMessages::showError(const QString& text, const QString& code) {
  strip_.show(shownError(text, code));
  Q_EMIT errorShown();
}

void WindowMessages::tellWritten(const QString& file, const std::function<void()>& write) {
  try {
    write();
    announce(tr("%1 is saved").arg(shownName(file)));
  } catch (const Error& error) {
    show(spokenError(error));
  }
}

void WindowMessages::close() {
  strip_.close();
}

QString WindowMessages::shown() const {
  return strip_.text();
}

void WindowMessages::set(StatusField field, const QString& text, const QString& tip) {
  status_.set(field, text, tip);
}

void WindowMessages::showBusy(bool busy) {
  if (!busy) {
    status_.endWork();
    return;
  }
  status_.beginWork();
  Q_EMIT workBegan();
}

void WindowMessages::showWork(const QString& step, double fraction) {
  status_.showWork(step, fraction);
}

}  // namespace relievo
