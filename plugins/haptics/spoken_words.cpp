// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/spoken_words.h"

#include <array>
#include <QCoreApplication>
#include <string>

namespace relievo {
namespace {

constexpr const char* kContext = "relievo::SpokenWords";

// For lupdate; a test compares it with what haptics says.
[[maybe_unused]] constexpr std::array kWords{
    // Commands of buttons.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Finer detail"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Coarser detail"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Whole object"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Detail and scale"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Where am I"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Where am I, in full"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Forces on or off"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Forces off"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Move mode"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Moved"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Back to the old window"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Left"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Right"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Up"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Down"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Next place"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Previous place"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Beacon"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Help"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Introduction"),
    // What the buttons do now.
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Plus: finer; long: detail and scale. Minus: coarser; long: whole object. "
                      "Forward: move; long: beacon. Centre: where am I; long: forces off or on. "
                      "Plus and Minus for two seconds: help; for five: introduction."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Move mode. Push the grip to a side to go there. Plus: next place. Minus: "
                      "previous place. Forward: done. Centre: back; long: forces off or on. Plus "
                      "and Minus for two seconds: help; for five: introduction."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "One button. Press: I offer where am I, finer, coarser, move, forces. Press "
                      "again to take what I said last. Hold for a second and a half: forces off."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Move mode. Push the grip to a side to go there. Press: I offer done, next "
                      "place, previous place, back, forces. Press again to take it. Hold for a "
                      "second and a half: forces off."),
    // Faults.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the device did not answer in time"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the device was unplugged"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the device sent something unreadable"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the device is too hot"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the device reported an impossible position"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the device is not ready yet"),
    // Where a height comes from.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "interpolated"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "base plane"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "steep"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "outside"),
    // The Falcon, in a dozen words.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The Falcon is not in use."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "No Falcon is plugged in."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Falcon unplugged. Forces are off."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Falcon found, but not allowed. Ask staff."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The Falcon is busy."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The Falcon could not be opened."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Falcon found."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The Falcon needs its firmware file."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Starting the Falcon."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Still starting."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "The Falcon did not start. You can continue with the mouse."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Please pull the grip fully out, then push it fully in."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Straight out, straight in; do not twist the grip."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Pull the grip fully out."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Falcon ready."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The Falcon does not answer. Forces are off."),
};

}  // namespace

QString spokenText(std::string_view words) {
  return QCoreApplication::translate(kContext, std::string(words).c_str());
}

}  // namespace relievo
