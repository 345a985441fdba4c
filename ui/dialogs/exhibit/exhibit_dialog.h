// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QDialog>

#include "core/exhibit/exhibit.h"

class QBoxLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace relievo {

class ExhibitObjectsPage;
class ExhibitVisitPage;
class ObjectsCheck;

/// "Set up exhibit...": what `relievo --exhibit` shows, made and changed by a curator. What is
/// wrong is said while it is changed, in the sentences of `relievo exhibit check`; it may be saved
/// before all is mended. [GUI thread]
class ExhibitDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param begun  shown at first, in no file yet
  explicit ExhibitDialog(const Exhibit& begun, QWidget* parent = nullptr);

  /// Shows a file; what is wrong in it is said, and stands as its default. What cannot be read is
  /// said, and what was shown stays.
  void openFile(const QString& file);
  /// @return whether it is there now
  bool save(const QString& file);
  /// What is chosen now.
  Exhibit exhibit() const;
  bool isUnsaved() const { return is_unsaved_; }

  void reject() override;
  void done(int result) override;

 private:
  QBoxLayout* faultColumn();
  QBoxLayout* bottomRow();
  void setExhibit(const Exhibit& exhibit, const QString& file);
  void noteChange();
  void check();
  void showFaults(const std::vector<Message>& faults);
  void showRefusals(const std::vector<ExhibitObject>& objects);
  void showState();
  QWidget* fieldOf(const QString& place) const;
  Message inFields(Message fault) const;
  void goTo(const QString& place);
  void chooseFile();
  void saveAsked(bool elsewhere);
  void showProblem(const QString& text);
  void whenNothingIsUnsaved(const std::function<void()>& then);
  QString title() const;

  QString file_;  ///< Empty: none yet.
  bool is_unsaved_ = false;
  QTabWidget* pages_;
  ExhibitObjectsPage* objects_;
  ExhibitVisitPage* visit_;
  ObjectsCheck* looks_;
  QLabel *state_, *problem_;
  QListWidget* faults_;
  QPushButton *open_, *save_, *save_as_;
};

}  // namespace relievo
