// SPDX-License-Identifier: BSD-3-Clause
#include "ui/language/unit_doubt.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "core/session/source/unit_guess.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

FilePoint boxOfFile(const Surface& surface) {
  return surface.info.bounds->max - surface.info.bounds->min;
}

}  // namespace

// Rare ones are left out; the panel has every unit. Of map projections there are no small ones.
std::vector<LengthUnit> unitsToOffer(const Surface& surface) {
  using enum LengthUnit;
  if (surface.unit_source == UnitSource::guessed) return {m, ft, us_ft, mm};
  if (surface.unit_source == UnitSource::assumed) return {mm, cm, m};
  return {mm, cm, m, in};
}

QString unitlessSize(const Surface& surface) {
  const FilePoint size = boxOfFile(surface);
  const auto number = [](double v) {
    return QLocale().toString(v, 'g', 4).remove(QLocale().groupSeparator());
  };
  return QCoreApplication::translate("relievo::QuestionController", "%1 \u00d7 %2 \u00d7 %3")
      .arg(number(size.x), number(size.y), number(size.z));
}

QString sizesInUnits(const Surface& surface, const std::vector<LengthUnit>& units) {
  const FilePoint size = boxOfFile(surface);
  QStringList sizes;
  for (const LengthUnit unit : units) {
    const double mm = mmPer(unit);
    sizes << QCoreApplication::translate("relievo::QuestionController", "in %1 %2")
                 .arg(unitText(unit), sizeText({mm * size.x, mm * size.y, mm * size.z}));
  }
  return sizes.join(QStringLiteral("; "));
}

QString unitDoubt(const Surface& surface) {
  const QString words =
      surface.unit_source == UnitSource::guessed
          ? QCoreApplication::translate(
                "relievo::QuestionController",
                "The points carry no unit. %1 \u2013 %2. The coordinates are those of a map "
                "projection; shown as %3 until you say. (E103)")
          : QCoreApplication::translate(
                "relievo::QuestionController",
                "The points carry no unit. %1 \u2013 %2. Most likely %3. Shown as millimetres "
                "until you say. (E103)");
  return words.arg(unitlessSize(surface), sizesInUnits(surface, unitsToOffer(surface)),
                   unitText(guessUnit(surface.info).unit));
}

}  // namespace relievo
