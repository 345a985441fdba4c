// SPDX-License-Identifier: BSD-3-Clause
#include "ui/panels/places_panel.h"

#include <algorithm>
#include <QCheckBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QPushButton>
#include <QScopedValueRollback>

#include "ui/frame/side_panels.h"

namespace relievo {

PlacesPanel::PlacesPanel(Document& document, QWidget* parent)
    : QWidget(parent),
      document_(document),
      list_(new QListWidget),
      with_view_(new QCheckBox(tr("With light and view"))),
      add_(new QPushButton(tr("Add bookmark"))),
      go_(new QPushButton(tr("Go to"))),
      rename_(new QPushButton(tr("Rename"))),
      remove_(new QPushButton(tr("Delete"))) {
  setObjectName(QStringLiteral("places_panel"));
  setProperty(SidePanels::kFoldedAtFirst, true);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 0, 0, 6);
  layout->setSpacing(5);
  list_->setObjectName(QStringLiteral("places_list"));
  list_->setAccessibleName(tr("Bookmarks"));
  list_->setToolTip(tr("Enter goes to a bookmark, F2 renames it, Delete removes it"));
  list_->setEditTriggers(QAbstractItemView::EditKeyPressed);
  list_->setMinimumHeight(70);
  list_->setMaximumHeight(140);
  with_view_->setObjectName(QStringLiteral("places_with_view"));
  with_view_->setAccessibleName(tr("With light and view"));
  with_view_->setToolTip(
      tr("A new bookmark also keeps light, relief image, stereo and the turn of the view"));
  struct Button {
    QPushButton* button;
    const char* name;
    QString tip;
  };
  for (const Button& b :
       {Button{add_, "place_add", tr("Keep the window under a name (Ctrl+N)")},
        Button{go_, "place_go", tr("Move the window to the selected bookmark")},
        Button{rename_, "place_rename", tr("Change the selected bookmark's name (F2)")},
        Button{remove_, "place_delete", tr("Delete the selected bookmark")}}) {
    b.button->setObjectName(QString::fromLatin1(b.name));
    b.button->setAccessibleName(b.button->text());
    b.button->setToolTip(b.tip);
    b.button->setMinimumWidth(40);
  }
  layout->addWidget(list_, 0, 0, 1, 2);
  layout->addWidget(add_, 1, 0, 1, 2);
  layout->addWidget(with_view_, 2, 0, 1, 2);
  layout->addWidget(go_, 3, 0, 1, 2);
  layout->addWidget(rename_, 4, 0);
  layout->addWidget(remove_, 4, 1);
  connect(add_, &QPushButton::clicked, this, &PlacesPanel::addAsked);
  connect(go_, &QPushButton::clicked, this, &PlacesPanel::goToSelected);
  connect(rename_, &QPushButton::clicked, this, [this] {
    list_->setFocus();
    list_->editItem(list_->currentItem());
  });
  connect(remove_, &QPushButton::clicked, this, &PlacesPanel::removeSelected);
  connect(list_, &QListWidget::itemActivated, this, &PlacesPanel::goToSelected);
  connect(list_, &QListWidget::itemChanged, this, &PlacesPanel::rename);
  connect(list_, &QListWidget::currentRowChanged, this, &PlacesPanel::enableButtons);
  connect(&document_, &Document::placesChanged, this, [this] {
    if (!asking_) showList(places().empty() ? -1 : 0);
  });
  enableButtons();
}

bool PlacesPanel::withView() const {
  return with_view_->isChecked();
}

void PlacesPanel::change(const std::function<void(Places&)>& change, int row) {
  {
    const QScopedValueRollback<bool> ours(asking_, true);
    document_.edit(tr("Bookmarks"), [&](Project& p) { change(p.places); });
  }
  showList(row);
}

void PlacesPanel::put(NamedRegion place) {
  const int row = static_cast<int>(places().size());
  change([&](Places& all) { all.push_back(std::move(place)); }, row);
}

void PlacesPanel::add(NamedRegion place) {
  put(std::move(place));
  list_->setFocus();
  list_->editItem(list_->currentItem());
}

QString PlacesPanel::freeName() const {
  for (std::size_t n = places().size() + 1;; ++n) {
    QString name = tr("Bookmark %1").arg(n);
    const auto is = [&](const NamedRegion& p) { return p.name == name.toStdString(); };
    if (std::none_of(places().begin(), places().end(), is)) return name;
  }
}

void PlacesPanel::step(int direction) {
  const int count = list_->count();
  if (count == 0) {
    Q_EMIT said(tr("There is no bookmark yet"));
    return;
  }
  const int now = list_->currentRow();
  list_->setCurrentRow(now < 0 ? 0 : (now + direction + count) % count);
  goToSelected();
}

void PlacesPanel::goToSelected() {
  const int row = list_->currentRow();
  if (row >= 0) Q_EMIT goAsked(NamedRegion(places()[static_cast<std::size_t>(row)]));
}

void PlacesPanel::rename(const QListWidgetItem* item) {
  if (showing_) return;
  const int row = list_->row(item);
  const QString name = item->text().trimmed();
  if (name.isEmpty()) {  // A place without a name could not be chosen by it.
    showList(row);
    return;
  }
  const QScopedValueRollback<bool> ours(asking_, true);  // The list has the name already.
  document_.edit(tr("Bookmarks"), [&](Project& p) {
    p.places[static_cast<std::size_t>(row)].name = name.toStdString();
  });
}

void PlacesPanel::removeSelected() {
  const int row = list_->currentRow();
  if (row < 0) return;
  const QString name = list_->item(row)->text();
  removeAt(static_cast<std::size_t>(row));
  Q_EMIT said(tr("%1 is forgotten").arg(name));
}

void PlacesPanel::removeAt(std::size_t row) {
  const std::size_t left = places().size() - 1;
  change([&](Places& all) { all.erase(all.begin() + static_cast<std::ptrdiff_t>(row)); },
         static_cast<int>(std::min(row + 1, left)) - 1);
}

void PlacesPanel::showList(int row) {
  const QScopedValueRollback<bool> quiet(showing_, true);
  list_->clear();
  for (const NamedRegion& place : places()) {
    auto* item = new QListWidgetItem(QString::fromStdString(place.name), list_);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    item->setToolTip(place.view ? tr("With light and view") : tr("The window alone"));
  }
  list_->setCurrentRow(row);
  enableButtons();
}

void PlacesPanel::enableButtons() {
  for (QPushButton* button : {go_, rename_, remove_}) button->setEnabled(list_->currentRow() >= 0);
}

void PlacesPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete && list_->hasFocus()) {
    removeSelected();
    return;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace relievo
