// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/exhibit/exhibit.h"

class QBoxLayout;
class QComboBox;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;
class QTabWidget;

namespace relievo {

/// The playlist of an exhibit: its objects in order, and of the chosen one file, unit, view, and a
/// title and a description in each language. [GUI thread]
class ExhibitObjectsPage : public QWidget {
  Q_OBJECT
 public:
  explicit ExhibitObjectsPage(QWidget* parent = nullptr);

  void setObjects(std::vector<ExhibitObject> objects);
  const std::vector<ExhibitObject>& objects() const { return objects_; }
  /// Those of the exhibit. Texts in others stay, and cannot be changed.
  void setLanguages(const std::vector<std::string>& languages);
  /// Shows an object, and of its texts those of a part, "title.de".
  void choose(int object, const QString& part);
  /// What shows a part of the chosen object; of "" the list of all; null: nothing here.
  QWidget* fieldOf(const QString& part) const;
  void add(const QStringList& files);

 Q_SIGNALS:
  void changed();

 private:
  /// Of one language.
  struct Texts {
    std::string tag;
    QLineEdit* title;
    QPlainTextEdit* description;
  };

  void makeTexts();
  QBoxLayout* listColumn();
  QWidget* objectForm();
  QBoxLayout* fileRow();
  void remove();
  void move(int by);
  void browse();
  void nameRow(int row);
  void showChosen();
  void takeFields();
  ExhibitObject* chosen();

  std::vector<ExhibitObject> objects_;
  bool is_showing_ = false;  ///< Fields are filled, and nobody typed.
  QListWidget* list_;
  QPushButton *add_, *remove_, *up_, *down_;
  QWidget* form_ = nullptr;
  QLineEdit* file_;
  QPushButton* browse_;
  QComboBox *unit_, *view_;
  QTabWidget* texts_;
  std::vector<Texts> languages_;
};

}  // namespace relievo
