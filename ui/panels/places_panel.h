// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <vector>

#include "core/project/project.h"
#include "ui/work/document.h"

class QCheckBox;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace relievo {

/// The document's places that have names: gone to by Enter or a double click, renamed by F2,
/// deleted by Delete. What is shown now comes from whoever answers addAsked. [GUI thread]
class PlacesPanel : public QWidget {
  Q_OBJECT
 public:
  explicit PlacesPanel(Document& document, QWidget* parent = nullptr);

  const std::vector<NamedRegion>& places() const { return document_.project().places; }
  /// Adds one after the others, selects it, and lets its name be typed.
  void add(NamedRegion place);
  /// Adds one and selects it; its name is final, the keyboard stays where it is.
  void put(NamedRegion place);
  /// Forgets the one of this row.
  void removeAt(std::size_t row);
  /// "Place 3": a name that is not taken.
  QString freeName() const;
  /// Goes to the one after (or before) the selected one, round and round.
  void step(int direction);
  /// Should a new place also keep light, relief image, stereo and turn?
  bool withView() const;

 Q_SIGNALS:
  void addAsked();
  void goAsked(const relievo::NamedRegion& place);
  void said(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  using Places = std::vector<NamedRegion>;
  /// Asks for the edit, and shows the list with this row selected.
  void change(const std::function<void(Places&)>& change, int row);
  void showList(int row);
  void rename(const QListWidgetItem* item);
  void goToSelected();
  void removeSelected();
  void enableButtons();

  Document& document_;
  QListWidget* list_;
  QCheckBox* with_view_;
  QPushButton *add_, *go_, *rename_, *remove_;
  bool showing_ = false, asking_ = false;
};

}  // namespace relievo
