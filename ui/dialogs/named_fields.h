// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPushButton>
#include <QString>

#include "ui/style/mnemonic.h"

namespace relievo {

/// A field with the name that tests and screen readers know it by. [GUI thread]
template <class Field>
Field* namedField(Field* field, const char* name, const QString& title, const QString& tip) {
  field->setObjectName(QString::fromLatin1(name));
  field->setAccessibleName(title);
  field->setToolTip(tip);
  return field;
}

/// A button that Return does not press.
inline QPushButton* namedButton(const QString& text, const char* name, const QString& tip) {
  auto* made =
      namedField(new QPushButton(text), name, withoutMnemonic(text).remove(u'\u2026'), tip);
  made->setAutoDefault(false);
  return made;
}

}  // namespace relievo
