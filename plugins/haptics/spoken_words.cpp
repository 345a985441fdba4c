// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/haptics/spoken_words.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <string>

namespace relievo {
namespace {

constexpr const char* kContext = "relievo::SpokenWords";

// A test compares both lists with what haptics says, and with the translations.
constexpr std::array kWords{
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
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The chosen Falcon is not plugged in."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Several Falcons are plugged in. Choose one."),
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
    // What the Falcon's buttons, arms and directions are called in lists.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "top"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "right"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "left"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "plus"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "forward"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "centre"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "minus"),
    // The Falcon, for the screen.
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Falcon unplugged. Forces off. View and recording go on. Plug it in again, "
                      "or choose the mouse as the device."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "No Falcon is plugged in. Plug in its power supply, then its USB cable."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "A Falcon is plugged in but this account may not use it. Install the rule "
                      "that the device set-up shows and 'relievo devices rule' prints, once (needs "
                      "an administrator), then replug."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Another program is using the Falcon. Close it, then try again."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "USB cannot be used"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Asking the Falcon whether it is ready."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "its boot loader did not answer"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "it did not lock on to the baud rate"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "it did not run after loading"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "All three arms have found their place. Pull the grip fully out once more."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "The Falcon does not answer. Forces are off; trying to wake it."),
    // Its self test.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Measuring how evenly the Falcon answers."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Watch the lights: red, green, blue."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Hold the grip loosely: six small nudges of half a newton."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Move the grip all round and press each of the four buttons."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The self test passed."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The self test found something wrong."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Lights: red, green and blue were shown one after the other."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Buttons: all four work."),
    // Its calibration.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The weight must be 20 to 300 grams."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Take your hand off the grip. The Falcon holds it in place."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "Hang the weight on the grip, let it come to rest, then press Continue."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "Holding the weight. Do not touch it."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "The force is calibrated."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the grip did not come to rest"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "the Falcon or this computer was interrupted too often to measure a force"),
    // Its firmware.
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "the setting Falcon firmware (Preferences > Device)"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords",
                      "The hash of the firmware could not be computed. Nothing was loaded. Check "
                      "that OpenSSL's library is whole and allows SHA-256."),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "its length is odd"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "it does not begin with AA 08"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "what has this name is no regular file"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "it is read-only"),
    QT_TRANSLATE_NOOP("relievo::SpokenWords", "its symbolic links lead in a circle"),
};

/// A sentence with its parts as %1, %2, ...
struct Form {
  const char* english;
  const char* said_parts = "";  ///< The numbers of those that are words of these lists themselves.
};
constexpr std::array kForms{
    // The Falcon, for the screen.
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The Falcon could not be opened: %1. Replug it, or try another port."),
         "1"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "USB cannot be used: %1.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "The Falcon's thread could not be started: %1")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "\"%1\" names no Falcon. Write falcon:SERIAL, falcon:SERIAL@PORT or "
                           "falcon:@PORT as 'relievo devices' lists them, or falcon for the only "
                           "one.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Falcon unplugged. Forces off. View and recording go on. Plug it in "
                           "again. There is also %1, which is not used in its place unless you "
                           "choose it.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "%1 was chosen and is not plugged in. Plug in its power supply, then "
                           "its USB cable.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "%1 was chosen and is not plugged in. There is %2, which is not used in "
                           "its place unless you choose it.")},
    Form{QT_TRANSLATE_NOOP(
        "relievo::SpokenWords",
        "Several Falcons are plugged in: %1. None is used until you choose one.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Starting the Falcon – attempt %1 of %2. This is normal.")},
    Form{QT_TRANSLATE_NOOP(
        "relievo::SpokenWords",
        "The Falcon did not start after %1 attempts; it is left alone now. Check its power supply "
        "and plug it straight into the computer, or choose Touch > Device set-up > Retry.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The Falcon did not start after %1 attempts; it is left alone now. "
                           "Check its power supply and plug it straight into the computer, or "
                           "choose Touch > Device set-up > Retry. (%2)"),
         "2"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "it echoed wrongly after byte %1 of %2")},
    Form{QT_TRANSLATE_NOOP(
             "relievo::SpokenWords",
             "Please pull the grip fully out, then push it fully in. Still missing: %1."),
         "1"},
    Form{QT_TRANSLATE_NOOP(
             "relievo::SpokenWords",
             "Please pull the grip fully out, then push it fully in. Still missing: %1. It takes "
             "long: pull straight out, push straight in, as far as it goes; do not twist."),
         "1"},
    // Its self test.
    Form{QT_TRANSLATE_NOOP(
             "relievo::SpokenWords",
             "Move the grip all round and press each of the four buttons. Still missing: %1."),
         "1"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "The test ended early: %1. %2"), "12"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "Rate: %1 answers per second (%2 are needed).")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Line: %1 damaged answers, %2 stalls, %3 overruns.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Times from answer to answer: up to 0.8 ms %1, up to 1.0 ms %2, up to "
                           "1.2 ms %3, up to 2.0 ms %4, up to 5.0 ms %5, up to 20.0 ms %6, up to "
                           "100.0 ms %7, above 100.0 ms %8; the longest %9 ms.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "From question to answer: %1 ms on average, %2 ms at worst.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, "
                           "down %4 mm, out %5 mm, in %6 mm.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, "
                           "down %4 mm, out %5 mm, in %6 mm; a hand that holds on moves less.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "Nudges of 0.5 N moved the hand by right %1 mm, left %2 mm, up %3 mm, "
                           "down %4 mm, out %5 mm, in %6 mm; the motors moved nothing. Check the "
                           "Falcon's power supply, hold the grip loosely or let go of it, and test "
                           "again.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The connection to the Falcon failed %1 times, although it is plugged "
                           "in. Forces are off; it is tried again every 10 seconds. Plug it "
                           "straight into the computer, if you can with another cable, or choose "
                           "Touch > Device set-up > Retry.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The connection to the Falcon fails, although it is plugged in. Forces "
                           "are off; it is opened anew \u2013 %1 of %2.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "Buttons that were not pressed: %1."), "1"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "Encoder of the %1 arm: moved by %2 counts."),
         "1"},
    // Its calibration.
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The calibration ended: %1. The old setting is kept."),
         "1"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "the weight seemed to be %1 g, which no Falcon's motors explain (is it "
                           "the right one, and hanging free?)")},
    // Its firmware.
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "%1 (recommended)")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "There is no file \"%1\". Nothing was loaded. Check its name.")},
    Form{QT_TRANSLATE_NOOP(
        "relievo::SpokenWords",
        "\"%1\" cannot be read: %2. Nothing was loaded. Check its permissions and its folder's.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "\"%1\" is not a regular file; it was not read as Falcon firmware. Name "
                           "the file itself, such as nvent_firmware.bin.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "\"%1\" is no Falcon firmware: it has more than %2 bytes. Nothing was "
                           "loaded. Choose another file.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "\"%1\" could not be read to its end. Nothing was loaded. Copy it to "
                           "another disk, or choose another file.")},
    Form{QT_TRANSLATE_NOOP(
             "relievo::SpokenWords",
             "\"%1\" is no Falcon firmware: %2. Nothing was loaded. Choose another file."),
         "2"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "it has %1 bytes; 2048 to 65536 are possible")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "it ends in block %1")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords", "%1 bytes follow its last block")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The Falcon firmware \"%1\" that %2 names does not exist. Nothing was "
                           "loaded. Correct %2, or clear it to search the usual places."),
         "2"},
    Form{QT_TRANSLATE_NOOP(
             "relievo::SpokenWords",
             "The folder \"%1\" that %2 names has no Falcon firmware (such as nvent_firmware.bin). "
             "Nothing was loaded. Correct %2, or clear it to search the usual places."),
         "2"},
    Form{QT_TRANSLATE_NOOP(
             "relievo::SpokenWords",
             "%1 It is what %2 names. Correct %2, or clear it to search the usual places."),
         "12"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The Falcon is connected but has no firmware loaded. relievo cannot "
                           "include Novint's firmware. Run 'relievo devices firmware FILE' with "
                           "the file nvent_firmware.bin (8492 bytes) from your Novint software or "
                           "libnifalcon, or set RELIEVO_FALCON_FIRMWARE. Places searched: %1.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The Falcon firmware \"%1\" has the form of a boot image, but nobody "
                           "knows this one (sha256 %2); it was not loaded. If you trust it, run "
                           "'relievo devices firmware FILE --accept' once.")},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The firmware could not be copied to \"%1\": %2. Nothing was changed. "
                           "Check the folder and the disk's room."),
         "2"},
    Form{QT_TRANSLATE_NOOP("relievo::SpokenWords",
                           "The Falcon's settings could not be written to \"%1\". They hold until "
                           "the program ends. Check the folder's permissions.")},
};

/// A part that the sentence has twice is the same both times.
QRegularExpression patternOf(const Form& form) {
  QString pattern = QRegularExpression::escape(QString::fromUtf8(form.english));
  for (int i = 1; i <= 9; ++i) {
    const QString place = QStringLiteral("\\%%1").arg(i);
    const auto at = pattern.indexOf(place);
    if (at < 0) break;
    pattern.replace(at, place.size(), QStringLiteral("(.*?)"));
    pattern.replace(place, QStringLiteral("\\%1").arg(i));
  }
  return QRegularExpression(QRegularExpression::anchoredPattern(pattern),
                            QRegularExpression::DotMatchesEverythingOption);
}

struct Match {
  const Form* form = nullptr;
  QStringList parts;  ///< The whole first.
};

/// Of two forms the one with more words of its own: "it has more than %2 bytes" before "%2".
std::optional<Match> matchOf(const QString& english) {
  static const auto kPatterns = [] {
    std::array<QRegularExpression, kForms.size()> patterns;
    std::transform(kForms.begin(), kForms.end(), patterns.begin(), patternOf);
    return patterns;
  }();
  std::optional<Match> best;
  int least = 0;
  for (std::size_t i = 0; i < kForms.size(); ++i) {
    const QRegularExpressionMatch match = kPatterns[i].match(english);
    if (!match.hasMatch()) continue;
    const QStringList parts = match.capturedTexts();
    const int size = std::accumulate(parts.begin() + 1, parts.end(), 0,
                                     [](int sum, const QString& p) { return sum + p.size(); });
    if (best && size >= least) continue;
    best = Match{&kForms[i], parts};
    least = size;
  }
  return best;
}

/// All parts at once: one may itself contain "%1".
QString filled(const QString& sentence, const QStringList& parts) {
  QString text;
  for (int i = 0; i < sentence.size(); ++i) {
    const int number = i + 1 < sentence.size() ? sentence[i + 1].digitValue() : -1;
    const bool is_place = sentence[i] == '%' && number >= 1 && number < parts.size();
    text += is_place ? parts[number] : QString(sentence[i]);
    if (is_place) ++i;
  }
  return text;
}

std::optional<QString> translated(const QString& english);

/// A part that is words: a sentence, or a list of them.
QString saidPart(const QString& english) {
  if (const auto whole = translated(english)) return *whole;
  QStringList list = english.split(QStringLiteral(", "));
  for (QString& word : list) {
    const auto known = translated(word);
    if (!known) return english;
    word = *known;
  }
  return list.join(QStringLiteral(", "));
}

std::optional<QString> translated(const QString& english) {
  const std::string words = english.toStdString();
  const auto known = std::find(kWords.begin(), kWords.end(), words);
  if (known != kWords.end()) return QCoreApplication::translate(kContext, *known);
  std::optional<Match> match = matchOf(english);
  if (!match) return std::nullopt;
  for (const char* number = match->form->said_parts; *number != '\0'; ++number) {
    QString& part = match->parts[*number - '0'];
    part = saidPart(part);
  }
  return filled(QCoreApplication::translate(kContext, match->form->english), match->parts);
}

}  // namespace

QString spokenText(std::string_view words) {
  const QString english = QString::fromUtf8(words.data(), static_cast<int>(words.size()));
  return translated(english).value_or(english);
}

}  // namespace relievo
