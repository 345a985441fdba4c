// SPDX-License-Identifier: BSD-3-Clause
// The window's commands: every one is an action with a name, found by keys, menus and plugins.
#include <array>
#include <QAction>
#include <QDesktopServices>
#include <QDoubleSpinBox>

#include "ui/frame/message_strip.h"
#include "ui/frame/side_panels.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plots/time_plot.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/window/command_search.h"
#include "ui/window/main_window.h"
#include "ui/window/manual.h"

namespace relievo {
namespace {

constexpr double kMoveStep = 0.25;  // Of the window's side.
constexpr double kTurnStepDeg = 15;

QString withKey(const QString& tip, const QList<QKeySequence>& keys) {
  if (keys.isEmpty()) return tip;
  return QStringLiteral("%1 (%2)").arg(tip, keys.front().toString(QKeySequence::NativeText));
}

}  // namespace

QAction* MainWindow::make(const Command& c) {
  auto* action = new QAction(c.text, this);
  action->setObjectName(QString::fromLatin1(c.name));
  action->setShortcuts(c.keys);
  action->setToolTip(withKey(c.tip, c.keys));
  action->setWhatsThis(c.tip);
  action->setCheckable(c.checkable);
  if (c.icon) action->setIcon(icon(*c.icon));
  addAction(action);
  if (c.run) connect(action, &QAction::triggered, this, [run = c.run] { run(); });
  return action;
}

QAction* MainWindow::command(const char* name) const {
  return findChild<QAction*>(QString::fromLatin1(name), Qt::FindDirectChildrenOnly);
}

void MainWindow::makeCommands() {
  make({"open",
        tr("&Open\u2026"),
        {QKeySequence("Ctrl+O")},
        tr("Open a scan or a height map"),
        [this] { chooseFile(); },
        Icon::open});
  make({"save_project",
        tr("&Save project"),
        {QKeySequence("Ctrl+S")},
        tr("Keep this state: file, depth map, window, measurements"),
        [this] { saveProject(); },
        {}});
  make({"save_project_as",
        tr("Save project &as\u2026"),
        {QKeySequence("Ctrl+Shift+S")},
        tr("Keep this state in another file"),
        [this] { saveProjectAs(); },
        {}});
  make({"figure",
        tr("&Figure\u2026"),
        {QKeySequence("Ctrl+E")},
        tr("A figure for print, with scale bar, legend and caption"),
        [this] { chooseFigure(); },
        Icon::camera});
  make({"image",
        tr("&Image\u2026"),
        {QKeySequence("Ctrl+Shift+E")},
        tr("Save a picture of a view or of the window"),
        [this] { chooseImage(); },
        {}});
  make({"close",
        tr("&Close"),
        {QKeySequence("Ctrl+W")},
        tr("Close the scan and go back to the start page"),
        [this] { closeDocument(); },
        {}});
  make({"quit",
        tr("&Quit"),
        {QKeySequence("Ctrl+Q")},
        tr("Close relievo"),
        [this] { close(); },
        {}});
  make({"undo",
        tr("&Undo"),
        {QKeySequence("Ctrl+Z")},
        tr("Undo"),
        [this] {
          const QString step = document_.history().undoText();
          document_.history().undo();
          announce(tr("Undone: %1").arg(step));  // What was said of the step holds no more.
        },
        {}});
  make({"redo",
        tr("&Redo"),
        {QKeySequence("Ctrl+Y"), QKeySequence("Ctrl+Shift+Z")},
        tr("Redo"),
        [this] {
          const QString step = document_.history().redoText();
          document_.history().redo();
          announce(tr("Done again: %1").arg(step));
        },
        {}});
  make({"answer",
        tr("&Answer the message"),
        {QKeySequence("Ctrl+Return"), QKeySequence("Ctrl+Enter")},
        tr("Press the first button of the message above the views"),
        [this] { strip_->takeOffer(); },
        {}});
  make({"keys",
        tr("&Keys"),
        {QKeySequence("F1")},
        tr("All keys on one sheet"),
        [this] { showKeys(); },
        {}});
  make({"history",
        tr("&History\u2026"),
        {},
        tr("Every step so far; choose one to go back to it"),
        [this] { showSteps(); },
        {}});
  make({"preferences",
        tr("&Preferences\u2026"),
        {QKeySequence("Ctrl+,")},
        tr("Colours, text size, language, units, stereo, device"),
        [this] { showPreferences(); },
        {}});
  make({"search_commands",
        tr("&Search commands\u2026"),
        {QKeySequence("Ctrl+K")},
        tr("Find a command by its words and run it"),
        [this] {
          auto* search = new CommandSearch(findChildren<QAction*>(), this);
          search->setAttribute(Qt::WA_DeleteOnClose);
          search->show();
        },
        {}});
  // At the page about what the keyboard is in.
  const auto show_manual = [this](const QWidget* about) {
    const ManualOpening manual =
        openManual(manualTopic(about), manualFolders(), &QDesktopServices::openUrl);
    if (manual.opened) {
      announce(manual.sentence);
    } else {
      strip_->show(manual.sentence);
    }
  };
  make({"manual",
        tr("&Manual"),
        {QKeySequence(ManualKey::kKey)},
        tr("Help in the browser, at the page for what has the keyboard; guide, documentation"),
        [this, show_manual] { show_manual(this->focusWidget()); },
        {}});
  new ManualKey(show_manual, this);
  make({"introduction",
        tr("&Introduction"),
        {},
        tr("Say what is open and how it is touched"),
        [this] { strip_->show(introduction()); },  // Longer than a line of the status bar.
        {}});
  make({"about", tr("&About relievo"), {}, tr("Version and licence"), [this] { showAbout(); }, {}});
  makeSurfaceCommands();
  makeWindowCommands();
  makeReliefCommands();
  makeMeasureCommands();
  makePointerCommands();
  makeSuggestCommand();
  makeProfileCommands();
  makeLightCommands();
  makePlaceCommands();
  makePackageCommand();
  makeExportCommand();
  makePrepareCommands();
  makeReplayCommands();
  makeVideoCommands();
}

void MainWindow::makeSurfaceCommands() {
  const auto step = [this](bool finer) {
    const bool done = finer ? document_.finer(about()) : document_.coarser(about());
    if (done) {
      announce(tr("Detail %1 of %2").arg(document_.detail()).arg(document_.details()));
    } else {
      announce(finer ? tr("This is the finest detail") : tr("This is the whole object"));
    }
  };
  make({"finer",
        tr("&Finer"),
        {QKeySequence("Ctrl++"), QKeySequence("Ctrl+=")},
        tr("Finer detail: a smaller window"),
        [step] { step(true); },
        Icon::finer});
  make({"coarser",
        tr("&Coarser"),
        {QKeySequence("Ctrl+-")},
        tr("Coarser detail: a larger window"),
        [step] { step(false); },
        Icon::coarser});
  make({"whole",
        tr("&Whole object"),
        {QKeySequence("Ctrl+0")},
        tr("The whole object in the window"),
        [this] {
          if (document_.whole()) announce(tr("Whole object"));
        },
        Icon::whole});
  struct Move {
    const char* name;
    QString text, keys, moved;
    double dx, dy;
  };
  const std::array<Move, 4> moves{{
      {"move_left", tr("Move &left"), "Ctrl+Left", tr("Left"), -kMoveStep, 0},
      {"move_right", tr("Move &right"), "Ctrl+Right", tr("Right"), kMoveStep, 0},
      {"move_up", tr("Move &up"), "Ctrl+Up", tr("Up"), 0, kMoveStep},
      {"move_down", tr("Move &down"), "Ctrl+Down", tr("Down"), 0, -kMoveStep},
  }};
  for (const Move& m : moves) {
    make({m.name,
          m.text,
          {QKeySequence(m.keys)},
          tr("Move the window by a quarter of its side"),
          [this, dx = m.dx, dy = m.dy, moved = m.moved] {
            if (!document_.move(dx, dy)) {
              announce(tr("Edge"));
              return;
            }
            const Region& region = document_.project().region;
            announce(tr("%1. Window at %2, %3 mm")
                         .arg(moved)
                         .arg(region.x_mm, 0, 'f', 1)
                         .arg(region.y_mm, 0, 'f', 1));
          },
          {}});
  }
  make({"type_window",
        tr("&Type window\u2026"),
        {QKeySequence("Ctrl+G")},
        tr("Type the window's place and size in millimetres"),
        [this] {
          command("show_panels")->setChecked(true);
          auto* x = region_panel_->findChild<QDoubleSpinBox*>(QStringLiteral("region_x"));
          x->setFocus();
          x->selectAll();
        },
        {}});
  make({"depth_map",
        tr("Depth ma&p\u2026"),
        {QKeySequence("Ctrl+D")},
        tr("Everything between the scan and its depth map, with a preview"),
        [this] { chooseDepthMap(); },
        {}});
  make({"units",
        tr("U&nits\u2026"),
        {},
        tr("Say which length unit the file's coordinates have; kept for its folder"),
        [this] { askUnit(); },
        {}});
  struct View {
    const char* name;
    QString text;
  };
  const std::array<View, 6> six{{{"front", tr("&Front")},
                                 {"back", tr("&Back")},
                                 {"left", tr("&Left")},
                                 {"right", tr("&Right")},
                                 {"top", tr("&Top")},
                                 {"bottom", tr("Botto&m")}}};
  for (std::size_t i = 0; i < six.size(); ++i) {
    const QString view = QString::fromLatin1(six[i].name);
    make({six[i].name,
          six[i].text,
          {QKeySequence(QStringLiteral("Alt+%1").arg(i + 1))},
          tr("Look from this side and make the relief anew"),
          [this, view] {
            document_.setView({view.toStdString(), {}});
          },
          {}});
  }
  make({"auto",
        tr("&Automatic"),
        {},
        tr("Look from the side that shows most"),
        [this] {
          document_.setView({"auto", {}});
        },
        {}});
  struct Turn {
    const char* name;
    QString text, keys;
    double azimuth_deg, elevation_deg;
  };
  // Named after where the near side goes, as under a middle drag.
  const std::array<Turn, 4> turns{{
      {"turn_left", tr("Turn &left"), "Ctrl+Shift+Left", kTurnStepDeg, 0},
      {"turn_right", tr("Turn &right"), "Ctrl+Shift+Right", -kTurnStepDeg, 0},
      {"turn_up", tr("Turn &up"), "Ctrl+Shift+Up", 0, -kTurnStepDeg},
      {"turn_down", tr("Turn &down"), "Ctrl+Shift+Down", 0, kTurnStepDeg},
  }};
  for (const Turn& t : turns) {
    make({t.name,
          t.text,
          {QKeySequence(t.keys)},
          tr("Turn the detail view by 15 degrees"),
          [this, azimuth_deg = t.azimuth_deg, elevation_deg = t.elevation_deg] {
            detail_->turnBy(azimuth_deg, elevation_deg);
          },
          {}});
  }
  make({"use_view",
        tr("&Use this view"),
        {},
        tr("Make the relief anew from where the turned detail view looks"),
        [this] { useThisView(); },
        {}});
  make({"engine_cpu",
        tr("&CPU"),
        {},
        tr("Make the depth map on the processor"),
        [this] { document_.setEngine(QStringLiteral("cpu")); },
        {},
        true});
  make({"engine_depthbuffer",
        tr("&OpenGL"),
        {},
        tr("Make the depth map by the graphics card's depth buffer"),
        [this] { document_.setEngine(QStringLiteral("depthbuffer")); },
        {},
        true});
}

void MainWindow::makeWindowCommands() {
  make({"fit",
        tr("F&it"),
        {},
        tr("Look straight down on the relief, fitted to the view"),
        [this] { detail_->straighten(); },
        Icon::fit});
  auto* stereo = make({"stereo",
                       tr("&Stereo (red/cyan)"),
                       {QKeySequence("Ctrl+3")},
                       tr("Anaglyph for red and cyan glasses"),
                       {},
                       Icon::stereo,
                       true});
  connect(stereo, &QAction::toggled, this, [this](bool on) { stereo_panel_->setOn(on); });
  auto* panels = make(
      {"show_panels", tr("Side pa&nels"), {}, tr("Show or hide the side panels"), {}, {}, true});
  panels->setChecked(true);
  connect(panels, &QAction::toggled, panels_, &QWidget::setVisible);
  auto* reference = make(
      {"show_reference", tr("Over&view"), {}, tr("Show or hide the whole object"), {}, {}, true});
  reference->setChecked(true);
  connect(reference, &QAction::toggled, reference_box_, &QWidget::setVisible);
  auto* plots = make({"show_plots",
                      tr("Pl&ots"),
                      {},
                      tr("Show or hide the plots of height and force"),
                      {},
                      {},
                      true});
  connect(plots, &QAction::toggled, this, [this](bool) { showPlots(); });
  make({"full_screen",
        tr("Full s&creen detail"),
        {QKeySequence("F11")},
        tr("The detail view alone on the whole screen"),
        [this] { setFullScreenDetail(!isFullScreen()); },
        {},
        true});
  make({"swap_views",
        tr("Other vie&w"),
        {QKeySequence("Ctrl+L")},
        tr("Move the focus between the overview and the detail view"),
        [this] {
          QWidget* to = detail_->hasFocus() ? static_cast<QWidget*>(reference_) : detail_;
          to->setFocus(Qt::ShortcutFocusReason);
        },
        {}});
  auto* next = make({"next_part",
                     tr("Ne&xt part"),
                     {QKeySequence("F6")},
                     tr("Move the focus to the next part of the window"),
                     [this] { focusNextPart(1); },
                     {}});
  auto* previous = make({"previous_part",
                         tr("&Previous part"),
                         {QKeySequence("Shift+F6")},
                         tr("Move the focus to the part before"),
                         [this] { focusNextPart(-1); },
                         {}});
  next->setAutoRepeat(false);
  previous->setAutoRepeat(false);
}

}  // namespace relievo
