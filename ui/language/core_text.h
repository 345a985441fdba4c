// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <string_view>

class QDialogButtonBox;

namespace relievo {

/// A word that core says - a step of work, a rule, what is measured - in the window's language;
/// words that are not known stay as they are.
QString coreText(std::string_view word);
QString coreText(const QString& word);

/// Qt's own button texts come from a package that need not be there; ours are always.
void nameButtons(QDialogButtonBox& buttons);

}  // namespace relievo
