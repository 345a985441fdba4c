// SPDX-License-Identifier: BSD-3-Clause
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>
#include <QUndoView>
#include <QVBoxLayout>

#include "core/session/colours/surface_colours.h"
#include "ui/dialogs/depth_map_dialog.h"
#include "ui/dialogs/keys_sheet.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/start_page.h"
#include "ui/frame/tool_bar_fitter.h"
#include "ui/language/spoken_error.h"
#include "ui/style/mnemonic.h"
#include "ui/views/detail_view.h"
#include "ui/window/main_window.h"
#include "ui/work/file_names.h"

namespace relievo {

QMenu* MainWindow::menu(const QString& name, const QString& title) {
  const QString object = QLatin1String("menu_") + QString(name).remove('&').toLower();
  if (auto* known = findChild<QMenu*>(object)) return known;
  auto* made = menuBar()->addMenu(title);
  made->setObjectName(object);
  made->setToolTipsVisible(true);
  return made;
}

void MainWindow::makeMenus() {
  const auto add = [this](QMenu* to, std::initializer_list<const char*> names) {
    for (const char* name : names) {
      if (*name == '-') {
        to->addSeparator();
      } else {
        to->addAction(command(name));
      }
    }
  };
  QMenu* file = menu(QStringLiteral("file"), tr("&File"));
  add(file, {"open", "open_folder"});
  recent_menu_ = file->addMenu(tr("Open &recent"));
  recent_menu_->menuAction()->setToolTip(tr("Files opened before"));
  recent_menu_->setToolTipsVisible(true);
  add(file, {"save_project", "save_project_as", "-", "figure", "image", "export", "-", "package",
             "-", "close", "quit"});
  add(menu(QStringLiteral("edit"), tr("&Edit")), {"undo", "redo", "history", "-", "copy_view",
                                                  "paste_view", "-", "answer", "-", "preferences"});
  QMenu* view = menu(QStringLiteral("view"), tr("&View"));
  add(view, {"front", "back", "left", "right", "top", "bottom", "auto", "-"});
  QMenu* turn = view->addMenu(tr("&Detail view"));
  turn->menuAction()->setToolTip(tr("What the left button does, and turning by keys"));
  turn->setToolTipsVisible(true);
  add(turn, {"pointer_look", "pointer_touch", "pointer_switch", "-", "turn_left", "turn_right",
             "turn_up", "turn_down"});
  add(view, {"use_view", "fit", "-", "stereo", "-", "show_reference", "show_panels", "show_plots"});
  QMenu* relief = view->addMenu(tr("Relief ima&ge"));
  relief->menuAction()->setToolTip(tr("How heights are painted"));
  relief->setToolTipsVisible(true);
  for (const std::string_view name : kReliefKindNames) {
    relief->addAction(command(("relief_" + std::string(name)).c_str()));
  }
  QMenu* colours = view->addMenu(tr("R&elief colours"));
  colours->menuAction()->setToolTip(tr("Colours of heights, slopes and other values"));
  colours->setToolTipsVisible(true);
  for (const std::string_view name : kColourMapNames) {
    colours->addAction(command(("colours_" + std::string(name)).c_str()));
  }
  QMenu* light = view->addMenu(tr("Ke&y light"));
  light->menuAction()->setToolTip(tr("From where the light shines; low light brings out detail"));
  light->setToolTipsVisible(true);
  add(light,
      {"light_usual", "light_rake_left", "light_rake_right", "light_rake_above", "light_rake_below",
       "-", "light_counterclockwise", "light_clockwise", "light_higher", "light_lower"});
  add(view, {"show_unmeasured"});
  makeThemeMenu(view);
  add(view, {"full_screen", "-", "swap_views", "next_part", "previous_part"});
  command("show_plots")->setVisible(false);
  QMenu* surface = menu(QStringLiteral("surface"), tr("&Surface"));
  add(surface, {"finer", "coarser", "whole", "-", "move_left", "move_right", "move_up", "move_down",
                "type_window", "suggest_windows", "-", "name_place", "next_place", "previous_place",
                "beacon", "-", "prepare", "depth_map", "units"});
  QMenu* engine = surface->addMenu(tr("Depth m&ethod"));
  engine->menuAction()->setToolTip(tr("How the depth map is made"));
  add(engine, {"engine_cpu", "engine_depthbuffer"});
  add(menu(QStringLiteral("measure"), tr("&Measure")),
      {"measure_point", "measure_distance", "measure_depth", "measure_angle", "measure_profile",
       "measure_area", "measure_section", "measure_touch", "-", "show_profile", "profile_save",
       "measure_save_list"});
  // Present from the start so that the order is fixed; shown once somebody adds an entry.
  menu(QStringLiteral("touch"), tr("&Touch"))->menuAction()->setVisible(false);
  add(menu(QStringLiteral("record"), tr("Re&cord")),
      {"recording_folder", "replay", "replay_play", "replay_next_event", "replay_previous_event",
       "replay_close", "-", "video", "video_live", "-", "key_view", "path_play", "path_clear"});
  makeRecordingKinds();
  add(menu(QStringLiteral("help"), tr("&Help")),
      {"manual", "search_commands", "keys", "introduction", "about"});
}

void MainWindow::makeThemeMenu(QMenu* view) {
  QMenu* themes = view->addMenu(tr("Lig&ht or dark"));
  themes->menuAction()->setToolTip(tr("Colours of the window"));
  auto* group = new QActionGroup(this);
  struct Entry {
    Theme theme;
    const char* name;
    QString text;
  };
  const std::array<Entry, 4> entries{{{Theme::system, "theme_system", tr("As the &system")},
                                      {Theme::light, "theme_light", tr("&Light")},
                                      {Theme::dark, "theme_dark", tr("&Dark")},
                                      {Theme::contrast, "theme_contrast", tr("&High contrast")}}};
  const int chosen = settings_.choice(QStringLiteral("theme"), 0).toInt();
  for (const Entry& e : entries) {
    QAction* action = make({e.name,
                            e.text,
                            {},
                            tr("Colours of the window"),
                            [this, theme = e.theme] { setTheme(theme); },
                            {},
                            true});
    action->setChecked(static_cast<int>(e.theme) == chosen);
    group->addAction(action);
    themes->addAction(action);
  }
}

void MainWindow::makeToolBar() {
  tools_ = addToolBar(tr("Tools"));
  tools_->setObjectName(QStringLiteral("tools"));
  tools_->setAccessibleName(tr("Tools"));
  tools_->setMovable(false);
  tools_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  tools_->setContextMenuPolicy(Qt::PreventContextMenu);
  tools_->addAction(command("open"));
  tools_->addSeparator();
  auto* views = new QToolButton;
  views->setObjectName(QStringLiteral("view_button"));
  views->setText(tr("View"));
  views->setIcon(icon(Icon::view));
  views->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  views->setPopupMode(QToolButton::InstantPopup);
  views->setToolTip(tr("From which side the object is seen (Alt+1 to Alt+6)"));
  views->setAccessibleName(tr("View"));
  views->setFocusPolicy(Qt::StrongFocus);
  auto* sides = new QMenu(views);
  sides->setToolTipsVisible(true);
  for (const char* name : {"front", "back", "left", "right", "top", "bottom", "auto", "use_view"}) {
    sides->addAction(command(name));
  }
  views->setMenu(sides);
  tools_->addWidget(views);
  tools_->addAction(command("fit"));
  tools_->addSeparator();
  tools_->addAction(command("pointer_look"));
  tools_->addAction(command("pointer_touch"));
  tools_->addSeparator();
  tools_->addAction(command("coarser"));
  detail_choice_ = new QComboBox;
  // It is filled later; nothing beside it jumps then.
  detail_choice_->setMinimumContentsLength(tr("Detail %1 of %2").arg(9).arg(9).size() - 2);
  detail_choice_->setObjectName(QStringLiteral("detail_choice"));
  detail_choice_->setAccessibleName(tr("Detail"));
  detail_choice_->setToolTip(tr("Which detail feeds the window"));
  connect(detail_choice_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    document_.setLevel({document_.details() - 1 - index});
    detail_choice_->setCurrentIndex(document_.detail() - 1);
  });
  tools_->addWidget(detail_choice_);
  tools_->addAction(command("finer"));
  tools_->addAction(command("whole"));
  tools_->addSeparator();
  tools_->addAction(command("stereo"));
  tools_->addAction(command("figure"));
  command("whole")->setIconText(tr("Whole"));
  command("stereo")->setIconText(tr("Stereo"));
  for (QToolButton* button : tools_->findChildren<QToolButton*>()) {
    button->setFocusPolicy(Qt::StrongFocus);
    if (button->defaultAction() == nullptr) continue;
    button->setAccessibleName(withoutMnemonic(button->defaultAction()->text()).remove(u'\u2026'));
  }
  for (const char* name : {"coarser", "finer"}) {
    auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(command(name)));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
  new ToolBarFitter(*tools_);
}

void MainWindow::showRecent() {
  recent_menu_->clear();
  const QStringList files = settings_.recentFiles();
  start_->setRecent(files);
  recent_menu_->menuAction()->setVisible(!files.isEmpty());
  int number = 1;
  for (const QString& file : files) {
    const QString name = shownInMenu(file);
    QAction* entry =
        recent_menu_->addAction(QStringLiteral("&%1 %2").arg(number++ % kRecentFiles).arg(name),
                                this, [this, file] { open(file); });
    entry->setToolTip(shownAsTip(file));
  }
  recent_menu_->addSeparator();
  QAction* clear = recent_menu_->addAction(tr("&Clear this list"), this, [this] {
    settings_.clearRecentFiles();
    showRecent();
  });
  clear->setToolTip(tr("Forget these files"));
}

void MainWindow::showHistory() {
  const QUndoStack& history = document_.history();
  const auto show = [](QAction* action, const QString& verb, const QString& what, bool can,
                       const QString& key) {
    action->setEnabled(can);
    action->setText(what.isEmpty() ? verb : tr("%1 %2", "undo, step").arg(verb, what));
    action->setToolTip(QStringLiteral("%1 (%2)").arg(withoutMnemonic(action->text()), key));
  };
  show(command("undo"), tr("&Undo"), history.undoText(), history.canUndo(),
       QStringLiteral("Ctrl+Z"));
  show(command("redo"), tr("&Redo"), history.redoText(), history.canRedo(),
       QStringLiteral("Ctrl+Y"));
}

void MainWindow::enableCommands() {
  enableVideo();
  const bool is_open = document_.isOpen();
  const bool is_raster = is_open && document_.surface()->is_raster;
  for (const char* name : {"close",
                           "suggest_windows",
                           "image",
                           "export",
                           "package",
                           "copy_view",
                           "paste_view",
                           "finer",
                           "coarser",
                           "whole",
                           "move_left",
                           "move_right",
                           "move_up",
                           "move_down",
                           "turn_left",
                           "turn_right",
                           "turn_up",
                           "turn_down",
                           "type_window",
                           "fit",
                           "stereo",
                           "full_screen",
                           "depth_map",
                           "units",
                           "name_place",
                           "next_place",
                           "previous_place",
                           "beacon",
                           "light_usual",
                           "light_rake_left",
                           "light_rake_right",
                           "light_rake_above",
                           "light_rake_below",
                           "light_counterclockwise",
                           "light_clockwise",
                           "light_higher",
                           "light_lower"}) {
    command(name)->setEnabled(is_open);
  }
  for (const char* name : {"front", "back", "left", "right", "top", "bottom", "auto", "engine_cpu",
                           "engine_depthbuffer", "prepare"}) {
    command(name)->setEnabled(is_open && !is_raster);
  }
  command("use_view")->setEnabled(is_open && !is_raster && detail_->isTurned());
  for (const ReliefKind kind : {ReliefKind::natural, ReliefKind::intensity}) {
    QAction* const look = command(("relief_" + std::string(name(kind))).c_str());
    look->setEnabled(is_open && canShow(*document_.surface(), kind));
  }
  if (!is_open) return;
  if (replay_->showing()) {  // The recording chooses the window.
    for (const char* name :
         {"finer", "coarser", "whole", "move_left", "move_right", "move_up", "move_down",
          "type_window", "suggest_windows", "paste_view", "prepare", "depth_map", "units"}) {
      command(name)->setEnabled(false);
    }
    return;
  }
  const Region& region = document_.project().region;
  const DetailLadder& ladder = document_.surface()->ladder;
  const StepAbout centre = document_.aboutCentre();
  command("finer")->setEnabled(finer(ladder, region, centre).has_value());
  command("coarser")->setEnabled(coarser(ladder, region, centre).has_value());
  command("whole")->setEnabled(!(region == wholeRegion(ladder)));
  command("engine_cpu")->setChecked(document_.surface()->engine == "cpu");
  command("engine_depthbuffer")->setChecked(document_.surface()->engine == "depthbuffer");
}

void MainWindow::chooseFile() {
  auto* dialog = new QFileDialog(this, tr("Open"));
  dialog->setObjectName(QStringLiteral("open_dialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFiles);
  dialog->setNameFilters(
      {tr("Scans, height maps, projects and figures (%1)")
           .arg((scanPatterns() << QStringLiteral("*.json") << QStringLiteral("*.png")
                                << QStringLiteral("*.pdf") << QStringLiteral("*.svg")
                                << QStringLiteral("*.zip"))
                    .join(' ')),
       tr("All files (*)")});
  const QString folder = settings_.layout(QStringLiteral("folder")).toString();
  if (!folder.isEmpty()) dialog->setDirectory(folder);
  connect(dialog, &QFileDialog::filesSelected, this, [this](const QStringList& files) {
    settings_.setLayout(QStringLiteral("folder"), QFileInfo(files.front()).absolutePath());
    openTogether(files);
  });
  dialog->open();
}

void MainWindow::chooseDepthMap() {
  if (document_.busy() || !document_.canRemake()) return;
  auto* dialog = new DepthMapDialog(document_, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &DepthMapDialog::unitChosen, this, [this](LengthUnit unit) {
    settings_.rememberUnit(document_.file(), unit);
    strip_->close();
  });
  dialog->setModal(true);  // The document must not change below a preview of it.
  dialog->show();
}

void MainWindow::showSteps() {
  auto* dialog = new QDialog(this);
  dialog->setObjectName(QStringLiteral("history_dialog"));
  dialog->setWindowTitle(tr("History"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  auto* steps = new QUndoView(&document_.history());
  steps->setObjectName(QStringLiteral("history_steps"));
  steps->setAccessibleName(tr("Steps"));
  steps->setEmptyLabel(tr("As opened"));
  auto* column = new QVBoxLayout(dialog);
  column->addWidget(steps);
  dialog->resize(320, 400);
  dialog->show();
}

void MainWindow::showKeys() {
  auto* sheet = new KeysSheet(findChildren<QAction*>(), pointerBindings(), this);
  sheet->setAttribute(Qt::WA_DeleteOnClose);
  sheet->show();
}

void MainWindow::showAbout() {
  auto* box =
      new QMessageBox(QMessageBox::NoIcon, tr("About relievo"),
                      tr("<b>relievo %1</b><br>See and touch scans of reliefs: a depth map, its "
                         "pyramid, and a window "
                         "on it that is shown in stereo and felt.<br><br>BSD-3-Clause licence.")
                          .arg(QStringLiteral(RELIEVO_VERSION_STRING)),
                      QMessageBox::Close, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace relievo
