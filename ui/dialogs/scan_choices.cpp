// SPDX-License-Identifier: BSD-3-Clause
#include "ui/dialogs/scan_choices.h"

#include <QComboBox>

#include "core/base/unit.h"
#include "core/depth/view.h"
#include "ui/style/text.h"

namespace relievo {

void addUnits(QComboBox& list) {
  for (const LengthUnitFact& u : kLengthUnits) {
    list.addItem(capital(unitText(u.unit)), static_cast<int>(u.unit));
  }
}

void addViews(QComboBox& list) {
  for (const std::string_view name : kViewNames) {
    const QString word = QString::fromLatin1(name.data(), static_cast<int>(name.size()));
    list.addItem(viewText(word), word);
  }
}

}  // namespace relievo
