// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/touch_actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeySequence>

#include "plugins/api/plugin.h"

namespace relievo {

namespace {
QString text(const char* source) {
  return QCoreApplication::translate("relievo::TouchActions", source);
}

struct Words {
  const char* name;
  const char* label;
  const char* tip;
  const char* whats_this;
};

QAction* made(const Words& words, const QList<QKeySequence>& keys, bool checkable) {
  auto* action = new QAction(text(words.label));
  action->setObjectName(QString::fromLatin1(words.name));
  action->setShortcuts(keys);
  action->setCheckable(checkable);
  action->setToolTip(text(words.tip));
  action->setStatusTip(text(words.tip));
  action->setWhatsThis(text(words.whats_this));
  return action;
}

// What the buttons of a device ask for, for keys and menus.

void makeMoveActions(TouchActions& actions) {
  actions.use_mouse = made(
      {"useMouse", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Use the mouse"),
       QT_TRANSLATE_NOOP("relievo::TouchActions", "Let the mouse be the hand"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "Lets go of a Falcon, whether it is ready or still starting or homing.")},
      {}, false);
  actions.move_mode =
      made({"moveMode", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Move mode"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Begin Move mode, or confirm and leave it (Ctrl+Shift+M)"),
            QT_TRANSLATE_NOOP(
                "relievo::TouchActions",
                "Pushing the grip to a side moves the window there, one click per quarter.")},
           {QKeySequence(QStringLiteral("Ctrl+Shift+M"))}, true);
  actions.move_back = made(
      {"moveBack", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Back to the old window"),
       QT_TRANSLATE_NOOP("relievo::TouchActions", "Leave Move mode and go back to where it began"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "The device's button Centre does the same in Move mode.")},
      {}, false);
  actions.move_back->setEnabled(false);
}

void makePlaceActions(TouchActions& actions) {
  actions.where_am_i =
      made({"whereAmI", QT_TRANSLATE_NOOP("relievo::TouchActions", "Where am &I"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Say where the hand is (Ctrl+I)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Place and height under the hand, and whether it was measured.")},
           {QKeySequence(QStringLiteral("Ctrl+I"))}, false);
  actions.where_am_i_long = made(
      {"whereAmILong", QT_TRANSLATE_NOOP("relievo::TouchActions", "Wh&ere am I, in full"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "Say where the hand is, with edges, resolution and scale (Ctrl+Alt+I)"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "Also the distances from the object's edges, and how fine the shown "
                         "samples are.")},
      {QKeySequence(QStringLiteral("Ctrl+Alt+I"))}, false);
  actions.say_detail =
      made({"sayDetail", QT_TRANSLATE_NOOP("relievo::TouchActions", "Resolution an&d scale"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Say resolution, window and hand scale (Ctrl+Shift+I)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "How large the window is and what one millimetre of hand is.")},
           {QKeySequence(QStringLiteral("Ctrl+Shift+I"))}, false);
}

void makeGuideActions(TouchActions& actions) {
  actions.guide =
      made({"guide", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Guide along the outline"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Lead the hand along the nearest outline, or let go (Ctrl+Alt+G)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Of a raised or sunken area, or of the object; with 2 N at most. "
                              "Push against it or press any button, and it lets go.")},
           {QKeySequence(QStringLiteral("Ctrl+Alt+G"))}, true);
  actions.guide_along =
      made({"guideAlong", QT_TRANSLATE_NOOP("relievo::TouchActions", "Guide along a re&cording…"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Lead the hand as somebody's hand went in a recording or stroke"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "At that hand's own speed, 15 to 60 mm/s, and with its rests.")},
           {}, false);
  actions.training = made(
      {"touchIntroduction", QT_TRANSLATE_NOOP("relievo::TouchActions", "I&ntroduction to touch"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "Five shapes to find under the hand, in two minutes (Ctrl+Alt+U)"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "A plate, a bump, a step, waves and a groove take the place of the "
                         "relief; each task is said, and each can be passed over.")},
      {QKeySequence(QStringLiteral("Ctrl+Alt+U"))}, true);
  actions.next_shape =
      made({"nextShape", QT_TRANSLATE_NOOP("relievo::TouchActions", "Ne&xt shape"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Go on to the introduction's next shape (Ctrl+Alt+N)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "The device's button Forward does the same in the introduction.")},
           {QKeySequence(QStringLiteral("Ctrl+Alt+N"))}, false);
  actions.next_shape->setEnabled(false);
}

void makeDeviceActions(TouchActions& actions) {
  actions.rumble =
      made({"rumble", QT_TRANSLATE_NOOP("relievo::TouchActions", "G&amepads rumble"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Let gamepads rumble at contact and edge: a cue, no force"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "A knock when the hand meets the surface, and a soft hum at the edge "
                              "of the window. The panel Buttons has the same switch.")},
           {}, true);
  actions.button_help =
      made({"buttonHelp", QT_TRANSLATE_NOOP("relievo::TouchActions", "Button &help"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Say what the device's buttons do now"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "It differs in Move mode and while scanning with one button.")},
           {}, false);
}

void makeSoundActions(TouchActions& actions) {
  actions.sound =
      made({"touchSounds", QT_TRANSLATE_NOOP("relievo::TouchActions", "Pla&y sounds of touch"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Hear what the hand meets, while it touches (Ctrl+Alt+A)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "A click at contact, a rustle while sliding, a tone that is higher "
                              "where the surface is; the edge and filled ground. The tone ends "
                              "after two minutes.")},
           {QKeySequence(QStringLiteral("Ctrl+Alt+A"))}, true);
  actions.louder =
      made({"soundsLouder", QT_TRANSLATE_NOOP("relievo::TouchActions", "Ma&ke sounds louder"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Make the sounds of touch louder (Ctrl+Alt+Page Up)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Speech has a volume of its own.")},
           {QKeySequence(Qt::CTRL + Qt::ALT + Qt::Key_PageUp)}, false);
  actions.quieter =
      made({"soundsQuieter", QT_TRANSLATE_NOOP("relievo::TouchActions", "Sounds &quieter"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Make the sounds of touch quieter (Ctrl+Alt+Page Down)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Speech has a volume of its own.")},
           {QKeySequence(Qt::CTRL + Qt::ALT + Qt::Key_PageDown)}, false);
  actions.felt =
      made({"feltPatterns", QT_TRANSLATE_NOOP("relievo::TouchActions", "Felt &patterns"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Taps of the grip say what sounds say, for who does not hear them"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "One tap: yes. Two: not measured. Three: the edge. Only while forces "
                              "are on.")},
           {}, true);
}

void makeForceActions(TouchActions& actions) {
  actions.forces =
      made({"forces", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Forces on"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Switch forces on or off (F5)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Forces come on gently, once the hand is clear of the surface.")},
           {QKeySequence(QStringLiteral("F5")), QKeySequence(QStringLiteral("Ctrl+T"))}, true);
  actions.forces_off =
      made({"forcesOff", QT_TRANSLATE_NOOP("relievo::TouchActions", "Forces &off now"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Switch forces off (Esc)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Escape always stops the forces first.")},
           {}, false);
  actions.forces_off->setEnabled(false);
  actions.take_back = made(
      {"takeForcesBack", QT_TRANSLATE_NOOP("relievo::TouchActions", "Ta&ke the forces back"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "Open a device again that took its forces away (Shift+F5)"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "The device is closed and opened; its forces rise from zero once the hand "
                         "is clear of the surface.")},
      {QKeySequence(QStringLiteral("Shift+F5"))}, false);
  actions.take_back->setEnabled(false);
  actions.stronger =
      made({"stronger", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Stronger"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Raise the strength of all forces by 10 %"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Strength multiplies every force; the limit stays.")},
           {}, false);
  actions.weaker =
      made({"weaker", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Weaker"),
            QT_TRANSLATE_NOOP("relievo::TouchActions", "Lower the strength of all forces by 10 %"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Strength multiplies every force; the limit stays.")},
           {}, false);
  actions.strength_preset =
      made({"strengthPreset", QT_TRANSLATE_NOOP("relievo::TouchActions", "Next strength &preset"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Gentle, medium and full strength, one after another "
                              "(Ctrl+Alt+F)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "The panel Touch has the same choice, and every strength between.")},
           {QKeySequence(QStringLiteral("Ctrl+Alt+F"))}, false);
  actions.grip_position =
      made({"gripPosition", QT_TRANSLATE_NOOP("relievo::TouchActions", "Next grip posi&tion"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "How the device stands: upright, flat, at the left or the right, one "
                              "after another (Ctrl+Alt+H)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Which way the grip is pushed to press into the relief. Forces go "
                              "off first.")},
           {QKeySequence(QStringLiteral("Ctrl+Alt+H"))}, false);
  actions.setup =
      made({"deviceSetup", QT_TRANSLATE_NOOP("relievo::TouchActions", "De&vice set-up…"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Set up a Falcon or a Haply device, step by step"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "From plug to touch. A Falcon: access, firmware, homing, self test, "
                              "force by a known weight, left or right hand. Haply: service, power, "
                              "calibration, buttons.")},
           {}, false);
}

void makeRecordActions(TouchActions& actions) {
  actions.record = made(
      {"record", QT_TRANSLATE_NOOP("relievo::TouchActions", "&Record"),
       QT_TRANSLATE_NOOP("relievo::TouchActions", "Start or stop recording every sample (Ctrl+R)"),
       QT_TRANSLATE_NOOP("relievo::TouchActions",
                         "Writes hand, proxy and force, 1000 times a second, to a table in your "
                         "documents folder.")},
      {QKeySequence(QStringLiteral("Ctrl+R"))}, true);
  actions.note =
      made({"addNote", QT_TRANSLATE_NOOP("relievo::TouchActions", "Add &note…"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "Write a note into the running recording (Ctrl+Shift+N)"),
            QT_TRANSLATE_NOOP("relievo::TouchActions",
                              "It belongs to the moment at which this is chosen; the recording "
                              "goes on while you write.")},
           {QKeySequence(QStringLiteral("Ctrl+Shift+N"))}, false);
  actions.note->setEnabled(false);
}
}  // namespace

TouchActions addTouchActions(Host& host) {
  const QString touch = QStringLiteral("Touch"), record = QStringLiteral("Record");
  TouchActions actions;
  makeForceActions(actions);
  makeRecordActions(actions);
  makeMoveActions(actions);
  makePlaceActions(actions);
  makeGuideActions(actions);
  makeDeviceActions(actions);
  makeSoundActions(actions);
  for (QAction* action : {actions.forces,          actions.forces_off, actions.take_back,
                          actions.stronger,        actions.weaker,     actions.strength_preset,
                          actions.grip_position,   actions.setup,      actions.use_mouse,
                          actions.move_mode,       actions.move_back,  actions.where_am_i,
                          actions.where_am_i_long, actions.say_detail, actions.guide,
                          actions.guide_along,     actions.training,   actions.next_shape,
                          actions.button_help,     actions.rumble,     actions.sound,
                          actions.louder,          actions.quieter,    actions.felt}) {
    host.controls.addAction(touch, action);
  }
  host.controls.addAction(record, actions.record);
  host.controls.addAction(record, actions.note);
  return actions;
}

}  // namespace relievo
