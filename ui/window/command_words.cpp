// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/command_words.h"

#include <array>
#include <QCoreApplication>

namespace relievo {
namespace {

struct OtherWords {
  const char* command;
  const char* words;
};

constexpr std::array<OtherWords, 48> kWords{
    {{"open", QT_TRANSLATE_NOOP("relievo::CommandWords", "load import file read")},
     {"open_folder", QT_TRANSLATE_NOOP("relievo::CommandWords", "load import directory images")},
     {"open_address", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                        "internet network URL link online server remote https")},
     {"tiled_map",
      QT_TRANSLATE_NOOP("relievo::CommandWords",
                        "large huge out of core memory build pyramid survey site LAS")},
     {"exhibit_setup",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "museum kiosk playlist visitors exhibition PIN")},
     {"save_project", QT_TRANSLATE_NOOP("relievo::CommandWords", "store keep session")},
     {"figure", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                  "export publish print paper PDF SVG TIFF screenshot")},
     {"image", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                 "export screenshot snapshot picture photo PNG capture")},
     {"export", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                  "save as convert STL PLY OBJ glTF GeoTIFF mesh 3D print "
                                  "section profile")},
     {"package", QT_TRANSLATE_NOOP("relievo::CommandWords", "export archive zip share cite")},
     {"close", QT_TRANSLATE_NOOP("relievo::CommandWords", "end unload")},
     {"quit", QT_TRANSLATE_NOOP("relievo::CommandWords", "exit end")},
     {"prepare", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                   "clean crop cut trim align register merge join thin decimate "
                                   "outliers noise edit cloud")},
     {"depth_map", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                     "align rotate orient resolution grid holes fill rasterize "
                                     "crop clean")},
     {"units", QT_TRANSLATE_NOOP("relievo::CommandWords", "scale millimetres metres inches")},
     {"finer", QT_TRANSLATE_NOOP("relievo::CommandWords", "zoom in closer magnify level detail")},
     {"coarser", QT_TRANSLATE_NOOP("relievo::CommandWords", "zoom out farther level detail")},
     {"whole", QT_TRANSLATE_NOOP("relievo::CommandWords", "zoom all overview reset fit")},
     {"fit", QT_TRANSLATE_NOOP("relievo::CommandWords", "zoom reset home straighten camera")},
     {"type_window",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "crop region coordinates selection go to")},
     {"name_place",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "place name save position favourite")},
     {"next_place", QT_TRANSLATE_NOOP("relievo::CommandWords", "place position favourite")},
     {"previous_place", QT_TRANSLATE_NOOP("relievo::CommandWords", "place position favourite")},
     {"suggest_windows",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "best feel where find interesting places")},
     {"keep_view",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "compare same camera series next scan lock")},
     {"study",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "experiment participant trial blind randomize")},
     {"turn_left", QT_TRANSLATE_NOOP("relievo::CommandWords", "rotate orbit spin")},
     {"turn_right", QT_TRANSLATE_NOOP("relievo::CommandWords", "rotate orbit spin")},
     {"turn_up", QT_TRANSLATE_NOOP("relievo::CommandWords", "rotate orbit tilt")},
     {"turn_down", QT_TRANSLATE_NOOP("relievo::CommandWords", "rotate orbit tilt")},
     {"use_view", QT_TRANSLATE_NOOP("relievo::CommandWords", "align rotate orient plane")},
     {"turn_relief", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                       "rotate orbit object under the hand while touching live")},
     {"show_scan", QT_TRANSLATE_NOOP("relievo::CommandWords",
                                     "point cloud mesh raw 3D turn rotate orbit object arrow")},
     {"relief_from_scan",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "align rotate orient projection view direction")},
     {"auto", QT_TRANSLATE_NOOP("relievo::CommandWords", "align rotate orient level")},
     {"pointer_look", QT_TRANSLATE_NOOP("relievo::CommandWords", "rotate orbit mouse navigate")},
     {"pointer_touch", QT_TRANSLATE_NOOP("relievo::CommandWords", "feel press mouse haptic")},
     {"pointer_feel",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "pseudo-haptic cursor slow bumps holes touch")},
     {"pointer_switch", QT_TRANSLATE_NOOP("relievo::CommandWords", "mouse button mode tool")},
     {"light_rake_left",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "light shadow oblique grazing")},
     {"light_lower", QT_TRANSLATE_NOOP("relievo::CommandWords", "light shadow oblique grazing")},
     {"light_usual", QT_TRANSLATE_NOOP("relievo::CommandWords", "light lamp reset")},
     {"measure_profile",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "cross section cut line height curve")},
     {"profile_save", QT_TRANSLATE_NOOP("relievo::CommandWords", "export curve plot SVG CSV")},
     {"measure_save_list",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "export table spreadsheet CSV")},
     {"manual", QT_TRANSLATE_NOOP("relievo::CommandWords", "help guide documentation handbook")},
     {"keys", QT_TRANSLATE_NOOP("relievo::CommandWords", "help shortcuts hotkeys keyboard mouse")},
     {"preferences",
      QT_TRANSLATE_NOOP("relievo::CommandWords", "settings options configure language theme")}}};

}  // namespace

QStringList commandsWithOtherWords() {
  QStringList commands;
  for (const OtherWords& known : kWords) commands << QString::fromLatin1(known.command);
  return commands;
}

QString otherWords(const QString& command) {
  for (const OtherWords& known : kWords) {
    if (command != QLatin1String(known.command)) continue;
    return QCoreApplication::translate("relievo::CommandWords", known.words) + ' ' +
           QString::fromLatin1(known.words);
  }
  return {};
}

}  // namespace relievo
