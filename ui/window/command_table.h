// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <bitset>
#include <functional>
#include <optional>
#include <QList>
#include <QObject>
#include <QString>

#include "ui/style/icons.h"

class QAction;
class QMainWindow;
class QMenu;

namespace relievo {

/// Every command of the window, in the order of its menus; command_rows.cpp has a row for each.
enum class Command {
  // File
  open,
  open_folder,
  open_address,
  tiled_map,
  exhibit_setup,
  save_project,
  save_project_as,
  figure,
  image,
  export_map,
  package,
  close,
  quit,
  // Edit
  undo,
  redo,
  history,
  copy_view,
  paste_view,
  answer,
  preferences,
  // View
  front,
  back,
  left,
  right,
  top,
  bottom,
  automatic,
  pointer_look,
  pointer_touch,
  pointer_switch,
  pointer_feel,
  turn_left,
  turn_right,
  turn_up,
  turn_down,
  use_view,
  turn_relief,
  show_scan,
  fit,
  keep_view,
  stereo,
  show_reference,
  show_panels,
  show_plots,
  relief_lit,  // As ReliefKind.
  relief_height,
  relief_hillshade,
  relief_multi,
  relief_slope,
  relief_local,
  relief_skyview,
  relief_openness,
  relief_multiscale,
  relief_curvature,
  relief_occlusion,
  relief_natural,
  relief_intensity,
  colours_grey,  // As ColourMap.
  colours_viridis,
  colours_cividis,
  colours_batlow,
  light_usual,
  light_rake_left,
  light_rake_right,
  light_rake_above,
  light_rake_below,
  light_counterclockwise,
  light_clockwise,
  light_higher,
  light_lower,
  show_unmeasured,
  theme_system,  // As Theme.
  theme_light,
  theme_dark,
  theme_contrast,
  full_screen,
  swap_views,
  next_part,
  previous_part,
  // Surface
  finer,
  coarser,
  whole,
  move_left,
  move_right,
  move_up,
  move_down,
  type_window,
  suggest_windows,
  name_place,
  next_place,
  previous_place,
  beacon,
  prepare,
  depth_map,
  relief_from_scan,
  units,
  engine_cpu,
  engine_depthbuffer,
  // Measure
  measure_point,
  measure_distance,
  measure_depth,
  measure_angle,
  measure_profile,
  measure_area,
  measure_section,
  measure_touch,
  show_profile,
  profile_save,
  measure_save_list,
  // Record
  record_csv,
  record_h5,
  recording_folder,
  replay,
  replay_play,
  replay_next_event,
  replay_previous_event,
  replay_close,
  video,
  video_live,
  key_view,
  path_play,
  path_clear,
  study,
  study_next,
  study_end,
  // Help
  manual,
  search_commands,
  keys,
  introduction,
  about,
};
inline constexpr std::size_t kCommandCount = static_cast<std::size_t>(Command::about) + 1;

/// The command `index` places after `first`, of a run that follows another enumeration.
constexpr Command commandAfter(Command first, std::size_t index) noexcept {
  return static_cast<Command>(static_cast<std::size_t>(first) + index);
}

/// Menus of the bar, and those within them, in the order in which they stand.
enum class Menu {
  file,
  edit,
  view,
  detail_view,
  relief,
  colours,
  light,
  theme,
  surface,
  engine,
  measure,
  touch,
  record,
  record_as,
  help,
};
inline constexpr std::size_t kMenuCount = static_cast<std::size_t>(Menu::help) + 1;

/// What has to be open before a command can do something.
enum class Needs {
  nothing,  ///< Or its controller says when.
  map,
  scan,  ///< And not a raster, which is a map already.
};

/// A row of the table: all that is the same wherever a command is found. How it is found by other
/// words is in command_words.cpp, by its name.
struct CommandRow {
  Command command;
  const char* name;  ///< Of the action: what the device, plugins and tests call it.
  Menu menu;
  const char* text;  ///< With its letter; the button's name, too.
  const char* keys;  ///< With '|' between several.
  const char* tip;   ///< A sentence: tool tip, sheet of keys, search, screen reader.
  Needs needs = Needs::nothing;
  unsigned flags = 0;
  std::optional<Icon> icon = {};
  int tool = 0;                      ///< Place in the tool bar; groups are tens. 0: no button.
  const char* short_text = nullptr;  ///< Of the button.

  static constexpr unsigned kGroup = 1;  ///< A line stands before it in the menu.
  static constexpr unsigned kCheckable = 2;
  static constexpr unsigned kOneOfMenu = 4;    ///< Of those in its menu, one is checked.
  static constexpr unsigned kNotInReplay = 8;  ///< A recording that is shown chooses the window.
  static constexpr unsigned kIconOnly = 16;    ///< Of its button.
  static constexpr unsigned kNoRepeat = 32;    ///< While its key is held.
};

/// The commands of a window as actions, which are its children: keys, menus, tool bar, search,
/// sheet of keys, screen readers, the device and plugins find them there. Controllers say what they
/// do. [GUI thread]
class CommandTable : public QObject {
  Q_OBJECT
 public:
  explicit CommandTable(QMainWindow& window);

  static const std::array<CommandRow, kCommandCount>& rows();

  QAction& operator[](Command command) const;
  /// @param context  ends the connection with its own end
  void on(Command command, const QObject* context, std::function<void()> run);
  void onToggled(Command command, const QObject* context, std::function<void(bool on)> run);
  /// Somebody said what it does.
  bool isDone(Command command) const { return done_.test(static_cast<std::size_t>(command)); }
  /// Also one of a plugin's; null: there is none.
  QAction* named(const QString& name) const;
  /// @return false: unknown or disabled
  bool run(const QString& name) const;

  /// The menus with all commands of the table, in the order of its rows.
  void makeMenus();
  QMenu& menu(Menu which) const;
  /// The menu of the bar with this English name; made with the title if there is none.
  QMenu& menuOfBar(const QString& name, const QString& title);
  /// By the rows alone: for an open map, of a scan or not, while a recording is shown or not.
  void enable(bool is_open, bool is_scan, bool in_replay) const;

 private:
  QAction* make(const CommandRow& row);

  QMainWindow& window_;
  std::array<QAction*, kCommandCount> actions_{};
  std::array<QMenu*, kMenuCount> menus_{};
  std::bitset<kCommandCount> done_;
};

}  // namespace relievo
