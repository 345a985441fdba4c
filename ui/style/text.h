// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <optional>
#include <QString>

#include "core/base/unit.h"

namespace relievo {

/// A length for people: "12.50 mm", "3.25 m"; the decimals follow the size.
QString lengthText(double mm);
/// Several lengths with one unit: "300.0 × 200.0 × 30.0 mm".
QString sizeText(std::initializer_list<double> mm);
/// A plain number as the user's locale writes it, without group separators.
QString numberText(double value, int decimals);
/// The number alone, in millimetres, with decimals that follow `step_mm`.
QString mmText(double mm, double step_mm);
/// Which unit sizeText and lengthText use; nothing: millimetres, and metres above 10 m. [GUI
/// thread]
void setSizeUnit(std::optional<LengthUnit> unit);
/// "millimetres", "US survey feet".
QString unitText(LengthUnit unit);
/// "top" -> "Top", "free" -> "Free view".
QString viewText(const QString& name);
/// The same with a capital letter at its beginning.
QString capital(QString text);

}  // namespace relievo
