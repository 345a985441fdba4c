// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/work/pictures/relief_picture.h"

class QBoxLayout;
class QListWidget;

namespace relievo {

/// What the window shows before a file is open: "Open...", samples, recent files. [GUI thread]
class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  void setRecent(const QStringList& files);

 protected:
  void showEvent(QShowEvent* event) override;

 Q_SIGNALS:
  void openAsked();
  void fileChosen(const QString& file);

 private:
  void addBeginning(QBoxLayout* column);
  void addLists(QBoxLayout* column);
  void showPicture(const QString& file, const QImage& picture);

  QListWidget *samples_, *recent_;
  QWidget* recent_box_;
  QTimer later_;
  ReliefPictures pictures_;
};

/// Samples that came with the program: scans in $RELIEVO_DATA_PATH and beside the program.
QStringList sampleFiles();
/// File name patterns of everything that opens, for dialogs and folders.
QStringList scanPatterns();

}  // namespace relievo
