// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPointer>
#include <QWidget>
#include <vector>

#include "core/session/feelable.h"
#include "ui/work/document.h"
#include "ui/work/latest_worker.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace relievo {

/// Windows whose relief a hand feels best, ranked as `relievo suggest` ranks them; choosing one
/// shows it, as a step of the history. [GUI thread]
class SuggestPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SuggestPanel(Document& document, QWidget* parent = nullptr);

  /// Looks for them in the background; found() comes.
  void find();
  /// And says so. @return false: nothing was being looked for
  bool cancel();
  bool busy() const { return worker_.busy(); }
  const std::vector<FeelableWindow>& windows() const { return windows_; }
  /// Of the list; -1: none.
  int current() const;
  /// Whether the overview shows where they are.
  bool overlayWanted() const;

 Q_SIGNALS:
  void busyChanged(bool busy);
  void progressed(const QString& step, double fraction);
  void shownChanged();  ///< Windows, which one is current, or whether they are wanted.
  void said(const QString& text);

 private:
  void showSurface();
  void showFound(const std::vector<FeelableWindow>& windows);
  void go();
  QString rowText(std::size_t place) const;

  Document& document_;
  QPushButton* find_;
  QLabel *method_, *result_;
  QListWidget* list_;
  QCheckBox* overlay_;
  std::shared_ptr<const Surface> surface_;  ///< That `windows_` are of.
  QPointer<QWidget> asked_from_;            ///< Had the focus then.
  double gain_ = 1;                         ///< And with which they were looked for.
  std::vector<FeelableWindow> windows_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
