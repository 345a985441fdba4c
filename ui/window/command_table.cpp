// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/command_table.h"

#include <QAction>
#include <QActionGroup>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

namespace relievo {
namespace {

QList<QKeySequence> keysOf(const CommandRow& row) {
  QList<QKeySequence> keys;
  for (const QString& key : QString::fromLatin1(row.keys).split('|', Qt::SkipEmptyParts)) {
    keys << QKeySequence(key);
  }
  return keys;
}

bool has(const CommandRow& row, unsigned flag) {
  return (row.flags & flag) != 0;
}

std::size_t placeOf(Menu menu) {
  return static_cast<std::size_t>(menu);
}

struct MenuRow {
  Menu menu;
  Menu in;           ///< Itself: it stands in the bar.
  const char* name;  ///< Of the object; null: none.
  const char* title;
  const char* tip = nullptr;
  bool begins_group = false;
};

}  // namespace

CommandTable::CommandTable(QMainWindow& window) : QObject(&window), window_(window) {
  std::array<QActionGroup*, kMenuCount> groups{};
  for (const CommandRow& row : rows()) {
    QAction* action = make(row);
    actions_[static_cast<std::size_t>(row.command)] = action;
    if (!has(row, CommandRow::kOneOfMenu)) continue;
    QActionGroup*& group = groups[placeOf(row.menu)];
    if (group == nullptr) group = new QActionGroup(&window_);
    group->addAction(action);
  }
}

QAction* CommandTable::make(const CommandRow& row) {
  const QList<QKeySequence> keys = keysOf(row);
  const QString tip = tr(row.tip);
  auto* action = new QAction(tr(row.text), &window_);
  action->setObjectName(QString::fromLatin1(row.name));
  action->setShortcuts(keys);
  action->setToolTip(keys.isEmpty() ? tip
                                    : QStringLiteral("%1 (%2)").arg(
                                          tip, keys.front().toString(QKeySequence::NativeText)));
  action->setWhatsThis(tip);
  action->setCheckable(has(row, CommandRow::kCheckable));
  action->setAutoRepeat(!has(row, CommandRow::kNoRepeat));
  if (row.icon) action->setIcon(icon(*row.icon));
  if (row.short_text != nullptr) action->setIconText(tr(row.short_text));
  window_.addAction(action);
  return action;
}

QAction& CommandTable::operator[](Command command) const {
  return *actions_[static_cast<std::size_t>(command)];
}

void CommandTable::on(Command command, const QObject* context, std::function<void()> run) const {
  connect(&(*this)[command], &QAction::triggered, context, [run = std::move(run)] { run(); });
}

void CommandTable::onToggled(Command command, const QObject* context,
                             std::function<void(bool on)> run) const {
  connect(&(*this)[command], &QAction::toggled, context,
          [run = std::move(run)](bool on) { run(on); });
}

QAction* CommandTable::named(const QString& name) const {
  return window_.findChild<QAction*>(name, Qt::FindDirectChildrenOnly);
}

bool CommandTable::run(const QString& name) const {
  QAction* action = named(name);
  if (action == nullptr || !action->isEnabled()) return false;
  action->trigger();
  return true;
}

QMenu& CommandTable::menuOfBar(const QString& name, const QString& title) {
  const QString object = QLatin1String("menu_") + QString(name).remove('&').toLower();
  if (auto* known = window_.findChild<QMenu*>(object)) return *known;
  auto* made = window_.menuBar()->addMenu(title);
  made->setObjectName(object);
  made->setToolTipsVisible(true);
  return *made;
}

QMenu& CommandTable::menu(Menu which) const {
  return *menus_[placeOf(which)];
}

void CommandTable::makeMenus() {
  static constexpr std::array<MenuRow, kMenuCount> kMenus{{
      {Menu::file, Menu::file, "file", QT_TR_NOOP("&File")},
      {Menu::edit, Menu::edit, "edit", QT_TR_NOOP("&Edit")},
      {Menu::view, Menu::view, "view", QT_TR_NOOP("&View")},
      {Menu::detail_view, Menu::view, nullptr, QT_TR_NOOP("&Detail view"),
       QT_TR_NOOP("What the left button does, and turning by keys"), true},
      {Menu::relief, Menu::view, nullptr, QT_TR_NOOP("Relief ima&ge"),
       QT_TR_NOOP("How heights are painted")},
      {Menu::colours, Menu::view, nullptr, QT_TR_NOOP("R&elief colours"),
       QT_TR_NOOP("Colours of heights, slopes and other values")},
      {Menu::light, Menu::view, nullptr, QT_TR_NOOP("Ke&y light"),
       QT_TR_NOOP("From where the light shines; low light brings out detail")},
      {Menu::theme, Menu::view, nullptr, QT_TR_NOOP("Lig&ht or dark"),
       QT_TR_NOOP("Colours of the window")},
      {Menu::surface, Menu::surface, "surface", QT_TR_NOOP("&Surface")},
      {Menu::engine, Menu::surface, nullptr, QT_TR_NOOP("Depth m&ethod"),
       QT_TR_NOOP("How the depth map is made")},
      {Menu::measure, Menu::measure, "measure", QT_TR_NOOP("&Measure")},
      {Menu::touch, Menu::touch, "touch", QT_TR_NOOP("&Touch")},
      {Menu::record, Menu::record, "record", QT_TR_NOOP("Re&cord")},
      {Menu::record_as, Menu::record, "record_as", QT_TR_NOOP("Record &as"),
       QT_TR_NOOP("Kind of file of the next recording")},
      {Menu::help, Menu::help, "help", QT_TR_NOOP("&Help")},
  }};
  const auto make_menu = [this](const MenuRow& row) {
    QMenu*& made = menus_[placeOf(row.menu)];
    if (made != nullptr) return;
    const QString name = QString::fromLatin1(row.name);
    if (row.in == row.menu) {
      made = &menuOfBar(name, tr(row.title));
      return;
    }
    QMenu& around = menu(row.in);
    if (row.begins_group) around.addSeparator();
    made = around.addMenu(tr(row.title));
    if (row.name != nullptr) made->setObjectName(name);
    made->menuAction()->setToolTip(tr(row.tip));
    made->setToolTipsVisible(true);
  };
  // A menu within another one stands where its first command does.
  std::size_t next = 0;
  for (const CommandRow& row : rows()) {
    for (; next <= placeOf(row.menu); ++next) make_menu(kMenus[next]);
    QMenu& to = menu(row.menu);
    if (has(row, CommandRow::kGroup)) to.addSeparator();
    to.addAction(&(*this)[row.command]);
  }
}

void CommandTable::enable(bool is_open, bool is_scan, bool in_replay) const {
  for (const CommandRow& row : rows()) {
    QAction& action = (*this)[row.command];
    if (row.needs == Needs::map) action.setEnabled(is_open);
    if (row.needs == Needs::scan) action.setEnabled(is_open && is_scan);
    if (is_open && in_replay && has(row, CommandRow::kNotInReplay)) action.setEnabled(false);
  }
}

}  // namespace relievo
