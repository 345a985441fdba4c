// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/guarded_application.h"

#include <exception>
#include <iostream>
#include <new>

#include "core/base/error.h"
#include "ui/language/error_text.h"

namespace relievo {
namespace {

constexpr qint64 kSilenceMs = 5000;

QString text(const char* sentence) {
  return QCoreApplication::translate("relievo", sentence);
}

}  // namespace

bool GuardedApplication::notify(QObject* receiver, QEvent* event) {
  try {
    return QApplication::notify(receiver, event);
  } catch (const Cancelled&) {  // What was asked to stop has stopped.
  } catch (const std::bad_alloc&) {
    tell(
        text("There is not enough memory for this. Nothing was changed. Close other programs "
             "or choose a smaller file."));
  } catch (const std::exception& error) {
    tell(text("This failed unexpectedly: %1. Nothing was changed.").arg(spokenError(error)));
  } catch (...) {
    tell(text("This failed unexpectedly: %1. Nothing was changed.").arg(QStringLiteral("?")));
  }
  return true;
}

void GuardedApplication::tell(const QString& reason) {
  if (reason == last_ && since_.isValid() && since_.elapsed() < kSilenceMs) return;
  last_ = reason;
  since_.start();
  std::cerr << "relievo: " << reason.toStdString() << '\n';
  QMetaObject::invokeMethod(
      this,
      [this, reason] {
        if (teller_) teller_(reason);
      },
      Qt::QueuedConnection);
}

}  // namespace relievo
