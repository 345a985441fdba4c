// SPDX-License-Identifier: BSD-3-Clause
#include "ui/language/error_text.h"

#include "core/base/failure.h"
#include "ui/message/message_text.h"

namespace relievo {

QString spokenError(const std::exception& error) {
  return messageText(messageOf(error));
}

QString shownError(const QString& text, const QString& code) {
  if (code.isEmpty() || text.contains(code)) return text;
  return QStringLiteral("%1 (%2)").arg(text, code);
}

QString shownError(const std::exception& error) {
  const auto* ours = dynamic_cast<const Error*>(&error);
  return shownError(spokenError(error),
                    ours != nullptr ? QString::fromStdString(ours->code) : QString());
}

}  // namespace relievo
