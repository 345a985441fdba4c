// SPDX-License-Identifier: BSD-3-Clause
// Menus, tool bar, and what plugins add to them.
#include <functional>
#include <map>
#include <QAction>
#include <QComboBox>
#include <QDesktopServices>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>

#include "core/session/colours/surface_colours.h"
#include "ui/dialogs/keys_sheet.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/frame/start_page.h"
#include "ui/frame/tool_bar_fitter.h"
#include "ui/panels/surface_panel.h"
#include "ui/style/mnemonic.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/views/scan_view.h"
#include "ui/window/command_search.h"
#include "ui/window/main_window.h"
#include "ui/window/manual.h"
#include "ui/window/work_area.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

void showManual(const QWidget* about, WindowMessages& messages) {
  const ManualOpening manual =
      openManual(manualTopic(about), manualFolders(), &QDesktopServices::openUrl);
  if (manual.opened) {
    messages.announce(manual.sentence);
  } else {
    messages.show(manual.sentence);
  }
}

void showAbout(QWidget* window) {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, MainWindow::tr("About relievo"),
      MainWindow::tr("<b>relievo %1</b><br>See and touch scans of reliefs: a depth map, its "
                     "pyramid, and a window "
                     "on it that is shown in stereo and felt.<br><br>BSD-3-Clause licence.")
          .arg(QStringLiteral(RELIEVO_VERSION_STRING)),
      QMessageBox::Close, window);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace

void MainWindow::makeCommands() {
  commands_.on(Command::close, this, [this] { closeDocument(messages_->shown()); });
  commands_.on(Command::quit, this, [this] { close(); });
  commands_.on(Command::answer, this, [this] { strip_->triggerDefaultAction(); });
  commands_.on(Command::keys, this, [this] {
    auto* sheet = new KeysSheet(findChildren<QAction*>(), controllers_->pointer.bindings(), this);
    sheet->setAttribute(Qt::WA_DeleteOnClose);
    sheet->show();
  });
  commands_.on(Command::preferences, this, [this] { showPreferences(); });
  commands_.on(Command::search_commands, this, [this] {
    auto* search = new CommandSearch(findChildren<QAction*>(), this);
    search->setAttribute(Qt::WA_DeleteOnClose);
    search->show();
  });
  // At the page about what the keyboard is in.
  commands_.on(Command::manual, this, [this] { showManual(focusWidget(), *messages_); });
  new ManualKey([this](const QWidget* about) { showManual(about, *messages_); }, this);
  commands_.on(Command::about, this, [this] { showAbout(this); });
  constexpr std::size_t kThemes = 4;
  const int chosen = settings_.choice(QStringLiteral("theme"), 0).toInt();
  for (std::size_t i = 0; i < kThemes; ++i) {
    const Command command = commandAfter(Command::theme_system, i);
    commands_.on(command, this, [this, i] { setTheme(static_cast<Theme>(i)); });
    commands_[command].setChecked(static_cast<int>(i) == chosen);
  }
  commands_.on(Command::type_window, this, [this] {
    commands_[Command::show_panels].setChecked(true);
    auto* x = area_->panels().region->findChild<QDoubleSpinBox*>(QStringLiteral("region_x"));
    x->setFocus();
    x->selectAll();
  });
  for (const Command shown :
       {Command::show_panels, Command::show_reference, Command::show_profile}) {
    commands_[shown].setChecked(true);
  }
  commands_.onToggled(Command::show_panels, this,
                      [this](bool on) { area_->panels().all->setVisible(on); });
  commands_.onToggled(Command::show_reference, this, [this](bool on) { area_->showReference(on); });
  commands_.onToggled(Command::show_scan, this, [this](bool on) { showScan(on); });
  commands_.onToggled(Command::show_profile, this, [this](bool) { showPlots(); });
  commands_[Command::show_plots].setVisible(false);
  commands_.onToggled(Command::show_plots, this, [this](bool) { showPlots(); });
  commands_.on(Command::full_screen, this, [this] { setFullScreenDetail(!isFullScreen()); });
  commands_.on(Command::swap_views, this, [this] {
    QWidget* to = &area_->detail();
    if (to->hasFocus()) to = &area_->besideDetail();
    to->setFocus(Qt::ShortcutFocusReason);
  });
  commands_.on(Command::next_part, this, [this] { focusNextPart(1); });
  commands_.on(Command::previous_part, this, [this] { focusNextPart(-1); });
}

void MainWindow::makeMenus() {
  commands_.makeMenus();
  QMenu& file = commands_.menu(Menu::file);
  recent_menu_ = new QMenu(tr("Open &recent"), &file);
  file.insertMenu(&commands_[Command::save_project], recent_menu_);
  recent_menu_->menuAction()->setToolTip(tr("Files opened before"));
  recent_menu_->setToolTipsVisible(true);
  // Shown once somebody adds an entry.
  commands_.menu(Menu::touch).menuAction()->setVisible(false);
}

void MainWindow::makeToolBar() {
  tools_ = addToolBar(tr("Tools"));
  tools_->setObjectName(QStringLiteral("tools"));
  tools_->setAccessibleName(tr("Tools"));
  tools_->setMovable(false);
  tools_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  tools_->setContextMenuPolicy(Qt::PreventContextMenu);
  constexpr int kGroup = 10, kViewButton = 20, kDetailChoice = 41;
  const std::map<int, std::function<void()>> widgets{
      {kViewButton, [this] { makeViewButton(); }}, {kDetailChoice, [this] { makeDetailChoice(); }}};
  std::map<int, std::function<void()>> tools = widgets;
  for (const CommandRow& row : CommandTable::rows()) {
    if (row.tool == 0) continue;
    tools[row.tool] = [this, command = row.command] { tools_->addAction(&commands_[command]); };
  }
  int group = kGroup;
  for (const auto& [place, add] : tools) {
    if (place >= group + kGroup) tools_->addSeparator();
    group = place - place % kGroup;
    add();
  }
  for (QToolButton* button : tools_->findChildren<QToolButton*>()) {
    button->setFocusPolicy(Qt::StrongFocus);
    if (button->defaultAction() == nullptr) continue;
    button->setAccessibleName(withoutMnemonic(button->defaultAction()->text()).remove(u'\u2026'));
  }
  for (const CommandRow& row : CommandTable::rows()) {
    if ((row.flags & CommandRow::kIconOnly) == 0) continue;
    auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(&commands_[row.command]));
    button->setToolButtonStyle(Qt::ToolButtonIconOnly);
  }
  new ToolBarFitter(*tools_);
  makeScanSwitch();
}

void MainWindow::makeViewButton() {
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
  for (const Command side :
       {Command::front, Command::back, Command::left, Command::right, Command::top, Command::bottom,
        Command::automatic, Command::use_view}) {
    sides->addAction(&commands_[side]);
  }
  views->setMenu(sides);
  tools_->addWidget(views);
}

void MainWindow::makeScanSwitch() {
  auto* scan = new QToolButton;
  scan->setObjectName(QStringLiteral("scan_switch"));
  scan->setDefaultAction(&commands_[Command::show_scan]);
  scan->setToolButtonStyle(Qt::ToolButtonTextOnly);
  scan->setAutoRaise(true);
  scan->setFocusPolicy(Qt::StrongFocus);
  scan->setAccessibleName(withoutMnemonic(commands_[Command::show_scan].text()));
  area_->addSwitch(scan);
}

void MainWindow::makeDetailChoice() {
  detail_choice_ = new QComboBox;
  // It is filled later; nothing beside it jumps then.
  detail_choice_->setMinimumContentsLength(tr("Resolution %1 of %2").arg(9).arg(9).size() - 2);
  detail_choice_->setObjectName(QStringLiteral("detail_choice"));
  detail_choice_->setAccessibleName(tr("Resolution"));
  detail_choice_->setToolTip(tr("Which level of the pyramid feeds the window"));
  connect(detail_choice_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    document_.region().setLevel({document_.details() - 1 - index});
    detail_choice_->setCurrentIndex(document_.detail() - 1);
  });
  tools_->addWidget(detail_choice_);
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

void MainWindow::enableCommands() {
  controllers_->videos.enable();
  const bool is_open = document_.isOpen();
  const bool is_scan = is_open && !document_.surface()->is_raster;
  const bool in_replay = area_->replay().showing();
  commands_.enable(is_open, is_scan, in_replay);
  commands_[Command::use_view].setEnabled(is_scan && area_->detail().isTurned());
  if (!is_scan) commands_[Command::show_scan].setChecked(false);
  if (area_->scan().turnedDeg() == 0) commands_[Command::relief_from_scan].setEnabled(false);
  for (const ReliefKind kind : {ReliefKind::natural, ReliefKind::intensity}) {
    QAction& look = commands_[commandAfter(Command::relief_lit, static_cast<std::size_t>(kind))];
    look.setEnabled(is_open && canShow(*document_.surface(), kind));
  }
  if (!is_open || in_replay) return;
  const Region& region = document_.project().region;
  const DetailLadder& ladder = document_.surface()->ladder;
  const StepAbout centre = document_.region().aboutCentre();
  commands_[Command::finer].setEnabled(finer(ladder, region, centre).has_value());
  commands_[Command::coarser].setEnabled(coarser(ladder, region, centre).has_value());
  commands_[Command::whole].setEnabled(!(region == wholeRegion(ladder)));
  const std::string& engine = document_.surface()->engine;
  commands_[Command::engine_cpu].setChecked(engine == "cpu");
  commands_[Command::engine_depthbuffer].setChecked(engine == "depthbuffer");
}

void MainWindow::addPanel(const QString& title, QWidget* panel) {
  area_->panels().all->addAtPlace(title, panel);
}

void MainWindow::removePanel(QWidget* panel) {
  area_->panels().all->remove(panel);
}

void MainWindow::addToMenu(const QString& title, QAction* action) {
  action->setParent(this);
  addAction(action);
  const QList<QKeySequence> keys = action->shortcuts();
  if (!keys.isEmpty()) {
    const QString key = keys.front().toString(QKeySequence::NativeText);
    if (!action->toolTip().contains(key)) {
      action->setToolTip(QStringLiteral("%1 (%2)").arg(action->toolTip(), key));
    }
  }
  QMenu* to = &commands_.menuOfBar(title, title);
  // A recording and its notes stand before what is made of them.
  const QStringList first{QStringLiteral("record"), QStringLiteral("addNote")};
  const int place = static_cast<int>(first.indexOf(action->objectName()));
  to->insertAction(place < 0 ? nullptr : to->actions().value(place), action);
  to->menuAction()->setVisible(true);
  const bool forces = action->objectName() == QLatin1String("forces");
  PointerController* pointer = &controllers_->pointer;
  if (forces) {
    connect(action, &QAction::toggled, pointer, &PointerController::touchWhileForcesAreOn);
  }
  if (action->objectName() == QLatin1String("forcesOff")) {
    connect(action, &QAction::triggered, pointer,
            [pointer] { pointer->touchWhileForcesAreOn(false); });
  }
  if (!forces && action->objectName() != QLatin1String("record")) return;
  if (action->icon().isNull()) action->setIcon(icon(forces ? Icon::forces : Icon::record));
  if (forces) tools_->insertAction(&commands_[Command::stereo], action);
  if (!forces) tools_->insertAction(nullptr, action);
  if (auto* button = qobject_cast<QToolButton*>(tools_->widgetForAction(action))) {
    button->setFocusPolicy(Qt::StrongFocus);
    button->setAccessibleName(withoutMnemonic(action->text()));
  }
}

}  // namespace relievo
