// SPDX-License-Identifier: BSD-3-Clause
#include "ui/style/mnemonic.h"

#include <QRegularExpression>

namespace relievo {

QString withoutMnemonic(QString text) {
  static const QRegularExpression kLetterBehind(QStringLiteral("\\s*\\(&.\\)"));
  return text.remove(kLetterBehind).remove('&');
}

}  // namespace relievo
