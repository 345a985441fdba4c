// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <map>
#include <QAction>
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

void MainWindow::makeDetailChoice() {
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
  const auto show = [](QAction& action, const QString& verb, const QString& what, bool can,
                       const QString& key) {
    action.setEnabled(can);
    action.setText(what.isEmpty() ? verb : tr("%1 %2", "undo, step").arg(verb, what));
    action.setToolTip(QStringLiteral("%1 (%2)").arg(withoutMnemonic(action.text()), key));
  };
  show(commands_[Command::undo], tr("&Undo"), history.undoText(), history.canUndo(),
       QStringLiteral("Ctrl+Z"));
  show(commands_[Command::redo], tr("&Redo"), history.redoText(), history.canRedo(),
       QStringLiteral("Ctrl+Y"));
}

void MainWindow::enableCommands() {
  enableVideo();
  const bool is_open = document_.isOpen();
  const bool is_scan = is_open && !document_.surface()->is_raster;
  const bool in_replay = replay_->showing();
  commands_.enable(is_open, is_scan, in_replay);
  commands_[Command::use_view].setEnabled(is_scan && detail_->isTurned());
  for (const ReliefKind kind : {ReliefKind::natural, ReliefKind::intensity}) {
    QAction& look = commands_[commandAfter(Command::relief_lit, static_cast<std::size_t>(kind))];
    look.setEnabled(is_open && canShow(*document_.surface(), kind));
  }
  if (!is_open || in_replay) return;
  const Region& region = document_.project().region;
  const DetailLadder& ladder = document_.surface()->ladder;
  const StepAbout centre = document_.aboutCentre();
  commands_[Command::finer].setEnabled(finer(ladder, region, centre).has_value());
  commands_[Command::coarser].setEnabled(coarser(ladder, region, centre).has_value());
  commands_[Command::whole].setEnabled(!(region == wholeRegion(ladder)));
  const std::string& engine = document_.surface()->engine;
  commands_[Command::engine_cpu].setChecked(engine == "cpu");
  commands_[Command::engine_depthbuffer].setChecked(engine == "depthbuffer");
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
  auto* sheet = new KeysSheet(findChildren<QAction*>(), this);
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
