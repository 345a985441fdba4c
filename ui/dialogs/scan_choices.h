// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QComboBox;

namespace relievo {

/// Every unit that a file's coordinates may have, behind what the list has; the data is the
/// LengthUnit as int. [GUI thread]
void addUnits(QComboBox& list);
/// Every view that has a name; the data is its name (kViewNames). [GUI thread]
void addViews(QComboBox& list);

}  // namespace relievo
