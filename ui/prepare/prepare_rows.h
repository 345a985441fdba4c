// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;

namespace relievo {

/// Where the prepared scan is written to. [GUI thread]
class PreparedFileRow : public QWidget {
  Q_OBJECT
 public:
  PreparedFileRow();

  void suggestBeside(const QString& scan);  ///< A name that is free.
  QString file() const;                     ///< Absolute; always ends in .ply.

 private:
  void choose();

  QLineEdit* file_;
  QLabel* note_;
};

/// The work that the dialog Prepare does, its progress, and what is done with its result.
/// [GUI thread]
class PrepareWorkRow : public QWidget {
  Q_OBJECT
 public:
  PrepareWorkRow();

  bool isLive() const;
  void showBusy(bool busy);
  void showProgress(const QString& step, double fraction);
  void setStale(bool stale);  ///< What is on show is of other choices.
  void setCanTake(bool can);
  void setCanSave(bool recipe, bool command);

 Q_SIGNALS:
  void madeLive();
  void computeAsked();
  void stopAsked();
  void recipeAsked();
  void commandAsked();
  void accepted();
  void rejected();

 private:
  void makeWork(QHBoxLayout* row);
  void makeResult(QHBoxLayout* row);

  QCheckBox* live_ = nullptr;
  QLabel* step_ = nullptr;
  QProgressBar* bar_ = nullptr;
  QPushButton *recompute_ = nullptr, *stop_ = nullptr, *save_recipe_ = nullptr,
              *copy_command_ = nullptr, *ok_ = nullptr;
};

}  // namespace relievo
