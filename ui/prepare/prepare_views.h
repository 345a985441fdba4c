// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QWidget>

#include "ui/prepare/prepare_work.h"
#include "ui/views/cloud_view.h"
#include "ui/work/latest_worker.h"

class QBoxLayout;
class QComboBox;
class QLabel;

namespace relievo {

/// The views of the dialog Prepare: what a result gave, or, while pairs are picked, one scan beside
/// the reference; and how they are looked at. [GUI thread]
class PrepareViews : public QWidget {
  Q_OBJECT
 public:
  /// @param below  shown under the views; becomes a child
  explicit PrepareViews(QWidget* below);
  ~PrepareViews() override;

  CloudView& scan() { return *scan_; }
  CloudView& reference() { return *reference_; }
  bool isBusy() const { return painter_.busy(); }
  CloudColour colour() const;

  void look(const Rotation& view);  ///< From this side.
  /// Made in a worker; then pictureShown(). Nothing while two scans are shown.
  void showResult(const std::shared_ptr<const PrepareResult>& result);
  void cancel() { painter_.cancel(); }
  /// Both with a tool that chooses a point.
  void showBeside(const QString& scan_title, const ReadScan& scan, const QString& reference_title,
                  const ReadScan& reference);
  void endBeside();

 Q_SIGNALS:
  void looksChanged();  ///< Another result's picture is wanted.
  void pictureShown();
  void pointChosen(bool on_reference, const relievo::FilePoint& point);
  void outlineDrawn(const relievo::CloudView::Outline& outline);
  void toolLeft();
  void said(const QString& text);

 private:
  QBoxLayout* lookRow();
  QWidget* makeViews();
  void connectViews();
  void lookFromSide(int side);

  CloudView *scan_ = nullptr, *reference_ = nullptr;
  QLabel *scan_title_ = nullptr, *reference_title_ = nullptr;
  QWidget* reference_box_ = nullptr;
  QComboBox *side_ = nullptr, *stage_ = nullptr, *colour_ = nullptr;
  bool beside_ = false;
  LatestWorker painter_;
};

}  // namespace relievo
