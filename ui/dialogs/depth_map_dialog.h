// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>

#include "ui/dialogs/depth_map_preview.h"
#include "ui/work/document.h"

class QBoxLayout;
class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QScrollArea;
class QTimer;

namespace relievo {

class DepthMapForm;

/// "Depth map...": every choice between a scan and its surface, with a live preview that is the
/// result itself: OK takes the surface that is on show. Edits the same record as
/// `relievo depthmap`. [GUI thread]
class DepthMapDialog : public QDialog {
  Q_OBJECT
 public:
  /// @param document  open; must outlive the dialog
  explicit DepthMapDialog(Document& document, QWidget* parent = nullptr);
  ~DepthMapDialog() override;

  bool isStale() const { return stale_; }
  QString summary() const;  ///< The sentences on show.
  void done(int result) override;

 Q_SIGNALS:
  void unitChosen(relievo::LengthUnit unit);

 private:
  struct Made;

  void nameControls();
  QScrollArea* wordArea();
  QBoxLayout* columns();
  QBoxLayout* bottomRow();
  void layOut();
  void choicesChanged();
  void compute();
  void showMade(const Made& made);
  void showBusy(bool busy);
  void take();

  Document& document_;
  DepthMapForm* form_;
  DepthMapPreview* preview_;
  HeightHistogram* histogram_;
  QLabel *shares_, *details_, *problem_;
  QCheckBox *live_, *mask_;
  QPushButton *recompute_, *cancel_work_, *ok_ = nullptr;
  QProgressBar* bar_;
  QLabel* step_;
  QTimer* delay_;
  bool stale_ = true;
  bool take_when_made_ = false;
  std::shared_ptr<const Made> made_;
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
