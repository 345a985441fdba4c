// SPDX-License-Identifier: BSD-3-Clause
#include "ui/language/core_text.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QPushButton>

namespace relievo {
namespace {

// For lupdate; core has no Qt. What is missing here is shown in English.
[[maybe_unused]] constexpr const char* kWords[]{
    // Steps of work.
    QT_TRANSLATE_NOOP("Core", "Checksum"), QT_TRANSLATE_NOOP("Core", "Colours"),
    QT_TRANSLATE_NOOP("Core", "Depth map"), QT_TRANSLATE_NOOP("Core", "Drawing the depth buffer"),
    QT_TRANSLATE_NOOP("Core", "Filling gaps"), QT_TRANSLATE_NOOP("Core", "Filling holes"),
    QT_TRANSLATE_NOOP("Core", "Fetching the map"), QT_TRANSLATE_NOOP("Core", "Heights of cells"),
    QT_TRANSLATE_NOOP("Core", "Looking for gaps"),
    QT_TRANSLATE_NOOP("Core", "Looking through gaps"),
    QT_TRANSLATE_NOOP("Core", "Measuring the scan"), QT_TRANSLATE_NOOP("Core", "Picture"),
    QT_TRANSLATE_NOOP("Core", "Pyramid"), QT_TRANSLATE_NOOP("Core", "Recording"),
    QT_TRANSLATE_NOOP("Core", "Sorting points into tiles"),
    QT_TRANSLATE_NOOP("Core", "Writing levels"), QT_TRANSLATE_NOOP("Core", "checking pages"),
    QT_TRANSLATE_NOOP("Core", "opening"), QT_TRANSLATE_NOOP("Core", "reading mesh"),
    QT_TRANSLATE_NOOP("Core", "reading points"), QT_TRANSLATE_NOOP("Core", "Video"),
    QT_TRANSLATE_NOOP("Core", "reading heights"), QT_TRANSLATE_NOOP("Core", "preparing"),
    QT_TRANSLATE_NOOP("Core", "Writing the scan"), QT_TRANSLATE_NOOP("Core", "Finding the front"),
    QT_TRANSLATE_NOOP("Core", "Laying the scans on each other"),
    QT_TRANSLATE_NOOP("Core", "Looking at colours"),
    QT_TRANSLATE_NOOP("Core", "Looking at the scans"),
    QT_TRANSLATE_NOOP("Core", "Opening the files"), QT_TRANSLATE_NOOP("Core", "Publishing"),
    QT_TRANSLATE_NOOP("Core", "Searching where the scans meet"),
    QT_TRANSLATE_NOOP("Core", "Solving all poses together"),
    QT_TRANSLATE_NOOP("Core", "Sorting colours into tiles"), QT_TRANSLATE_NOOP("Core", "Writing"),
    QT_TRANSLATE_NOOP("Core", "Writing colours"), QT_TRANSLATE_NOOP("Core", "reading pictures"),
    // Rules.
    QT_TRANSLATE_NOOP("Core", "front-most point"),
    QT_TRANSLATE_NOOP("Core", "second point from the front"),
    QT_TRANSLATE_NOOP("Core", "mean of the top layer"),
    QT_TRANSLATE_NOOP("Core", "median of the points"), QT_TRANSLATE_NOOP("Core", "rear-most point"),
    QT_TRANSLATE_NOOP("Core", "mean of the points"), QT_TRANSLATE_NOOP("Core", "bilinear splat"),
    QT_TRANSLATE_NOOP("Core", "local quadratic"),
    // What is measured.
    QT_TRANSLATE_NOOP("Core", "length"), QT_TRANSLATE_NOOP("Core", "height range"),
    QT_TRANSLATE_NOOP("Core", "along the surface"), QT_TRANSLATE_NOOP("Core", "area in the view"),
    QT_TRANSLATE_NOOP("Core", "volume above the plane"),
    QT_TRANSLATE_NOOP("Core", "area of the surface"), QT_TRANSLATE_NOOP("Core", "height"),
    QT_TRANSLATE_NOOP("Core", "distance"), QT_TRANSLATE_NOOP("Core", "depth difference"),
    QT_TRANSLATE_NOOP("Core", "angle"), QT_TRANSLATE_NOOP("Core", "length of the cut"),
    QT_TRANSLATE_NOOP("Core", "length on the map"),
    // Relief images and their colours.
    QT_TRANSLATE_NOOP("Core", "slope"), QT_TRANSLATE_NOOP("Core", "local relief"),
    QT_TRANSLATE_NOOP("Core", "sky-view factor"), QT_TRANSLATE_NOOP("Core", "openness"),
    QT_TRANSLATE_NOOP("Core", "multi-scale deviation"),
    QT_TRANSLATE_NOOP("Core", "multi-scale curvature"),
    QT_TRANSLATE_NOOP("Core", "ambient occlusion"), QT_TRANSLATE_NOOP("Core", "hillshade"),
    QT_TRANSLATE_NOOP("Core", "grey"), QT_TRANSLATE_NOOP("Core", "viridis"),
    QT_TRANSLATE_NOOP("Core", "cividis"), QT_TRANSLATE_NOOP("Core", "batlow"),
    // Buttons.
    QT_TRANSLATE_NOOP("Core", "Close"), QT_TRANSLATE_NOOP("Core", "Cancel"),
    QT_TRANSLATE_NOOP("Core", "Discard"), QT_TRANSLATE_NOOP("Core", "Save"),
    QT_TRANSLATE_NOOP("Core", "OK"), QT_TRANSLATE_NOOP("Core", "hillshade, four lights"),
    QT_TRANSLATE_NOOP("Core", "Figure"), QT_TRANSLATE_NOOP("Core", "Caption"),
    // A key that Qt's own translation leaves as it is.
    QT_TRANSLATE_NOOP("QShortcut", "Return")};

}  // namespace

QString coreText(std::string_view word) {
  return QCoreApplication::translate("Core", std::string(word).c_str());
}

QString coreText(const QString& word) {
  return QCoreApplication::translate("Core", word.toUtf8().constData());
}

void nameButtons(QDialogButtonBox& buttons) {
  struct Name {
    QDialogButtonBox::StandardButton button;
    const char* text;
  };
  for (const Name& name :
       {Name{QDialogButtonBox::Close, "Close"}, Name{QDialogButtonBox::Cancel, "Cancel"},
        Name{QDialogButtonBox::Save, "Save"}, Name{QDialogButtonBox::Discard, "Discard"},
        Name{QDialogButtonBox::Ok, "OK"}}) {
    if (QPushButton* button = buttons.button(name.button)) {
      button->setText(QCoreApplication::translate("Core", name.text));
    }
  }
}

}  // namespace relievo
