// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/unit.h"
#include "core/exhibit/staff_pin.h"
#include "core/message/message.h"

namespace relievo {

/// One text per language, by its tag ("de").
using ExhibitTexts = std::map<std::string, std::string>;

/// Something to touch: a scan, a height map or a project.
struct ExhibitObject {
  std::string id;              ///< For counts and logs: the file's name without its ending.
  std::filesystem::path file;  ///< Absolute, or from the folder of the program.
  std::optional<LengthUnit> unit;
  std::optional<std::string> view;  ///< Of kViewNames.
  ExhibitTexts title;               ///< Spoken and shown; at most kMostTitleWords words.
  ExhibitTexts description;         ///< Spoken after it; empty, or in every language.
};

/// How long a visit waits for its visitor, in seconds.
struct ExhibitTimes {
  double still_there_s = 60;  ///< Without input, until the visitor is asked; 10 to 600.
  double goodbye_s = 15;      ///< After the question, until all begins anew; 5 to 120.
  double chime_s = 45;        ///< Between chimes while nobody is there; 10 to 3600, or 0: none.
};

/// Of the voice. The volume goes back to `volume_percent` after each visitor (EN 301 549,
/// 5.1.3.13), and no button raises it above `loudest_percent`.
struct ExhibitSpeech {
  int volume_percent = 70;    ///< 10 to loudest_percent.
  int loudest_percent = 100;  ///< 10 to 100: the largest that ears bear, by headphones, too.
  /// The largest on a loudspeaker, which a volume falls to where headphones are pulled out; 10 to
  /// loudest_percent. Nothing: the same.
  std::optional<int> room_loudest_percent = {};
  int words_per_minute = 160;  ///< 100 to 449.
};

struct ExhibitTouch {
  std::string device = "mouse";  ///< As the panel Touch keeps it: "falcon".
  int strength_percent = 40;     ///< 1 to 100 of every force.
  double limit_n = 4;            ///< No force is larger; 0.5 to 6.
  bool introduction = true;      ///< Each visitor's first object begins with it.
  bool guide = true;             ///< The hand is offered to be led, if the device can.
  int sounds_percent = 50;       ///< Volume of the sounds of touch; 0: none.
  bool felt_patterns = false;    ///< Taps say what sounds say; where no voice speaks always.
  bool one_button = false;       ///< All by one button of a device or switch, which scans.
};

/// What a museum sets up: a playlist of objects in several languages, for a visitor who is alone
/// and may not see (docs/user/exhibit.md).
struct Exhibit {
  std::filesystem::path file;          ///< It was read from.
  std::vector<std::string> languages;  ///< Tags, the first is that of a new visitor.
  std::vector<ExhibitObject> objects;  ///< 1 to kMostExhibitObjects.
  ExhibitTimes times;
  ExhibitSpeech speech;
  ExhibitTouch touch;
  StaffPin pin;
  std::filesystem::path records;  ///< Folder of counts and logs; empty: that of the account.
};

inline constexpr std::size_t kMostExhibitObjects = 50;
inline constexpr int kMostTitleWords = 12, kMostDescriptionWords = 120;

/// An exhibit, or everything that is wrong with its file, a sentence each.
struct ExhibitCheck {
  Exhibit exhibit;
  std::vector<Message> faults;  ///< Not empty: `exhibit` is not to be used.
};

/// Reads it, and looks whether its files are there. Names in it are from the file's folder.
/// @param known_languages  tags that the program speaks
/// @throw FileError  it cannot be read, is not JSON, or is no exhibit of this version
ExhibitCheck checkExhibit(const std::filesystem::path& file,
                          std::span<const std::string> known_languages);
/// The same for a text that stands in no file yet. @param file  where it would stand
ExhibitCheck checkExhibitText(const std::string& text, const std::filesystem::path& file,
                              std::span<const std::string> known_languages);

/// What its file holds: all of it, what is wrong, too, so that a check finds it. Texts of other
/// languages than its own are left out, and so is a PIN without a salt. A name that lies in the
/// file's folder, or in the one above it, is written from there, so that both can be moved
/// together. [any thread] @pre `exhibit.file` has a name
std::string exhibitText(const Exhibit& exhibit);
/// Puts that in its place, at once. @throw WriteError
void writeExhibit(const Exhibit& exhibit);

/// @throw FileError  as above, or with all of its faults
Exhibit readExhibit(const std::filesystem::path& file,
                    std::span<const std::string> known_languages);

/// Where counts and logs go: what the exhibit says, else `relievo/exhibit` in the account's state
/// folder ($XDG_STATE_HOME, else ~/.local/state).
std::filesystem::path recordsFolder(const Exhibit& exhibit);

}  // namespace relievo
