// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <QTimer>
#include <QWidget>

#include "core/depth/view.h"
#include "core/session/map_facts.h"
#include "core/session/surface.h"
#include "ui/work/latest_worker.h"

class QLabel;
class QPushButton;

namespace relievo {

class CloudView;
class Document;

/// The scan behind the relief in space: its points or its mesh, turned freely by mouse and keys;
/// the window on the relief as a box, and an arrow along which the relief is seen. A relief can be
/// made from where it is looked at. What is drawn is made in a worker, and only while this is
/// shown. Keys beyond those of CloudView: Enter makes the relief, Escape leaves. [GUI thread]
class ScanView : public QWidget {
  Q_OBJECT
 public:
  explicit ScanView(Document& document, QWidget* parent = nullptr);
  ~ScanView() override;

  /// Null until this was shown for the first time.
  CloudView* cloud() { return cloud_; }
  bool isReady() const;  ///< The scan of the document is drawn.
  /// From where it is looked at: rows right, up and toward the viewer; file axes.
  Rotation rotation() const;
  /// Between how it is looked at and how the relief sees it, degrees: 0 to 180.
  double turnedDeg() const;
  void lookAsRelief();
  void takeColours();

 Q_SIGNALS:
  void reliefAsked();
  void turnedChanged();
  void left();  ///< By Escape.
  /// For people who do not see it.
  void said(const QString& text);

 protected:
  void showEvent(QShowEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  /// What a picture is made of; another one makes another picture.
  struct Drawn {
    std::shared_ptr<const Scan> scan;
    StrayRule strays = StrayRule::drop;
    std::optional<double> missing_height;
    friend bool operator==(const Drawn&, const Drawn&) = default;
  };

  void makeCloud();
  void refresh();
  std::optional<Drawn> wanted() const;
  void showRelief();  ///< Its box and arrow.
  void showTurned();  ///< In words.
  QString turnedText() const;

  Document& document_;
  CloudView* cloud_ = nullptr;  ///< Child; owned by Qt.
  QLabel* text_;
  QPushButton *make_, *straighten_;
  std::optional<Drawn> drawn_, in_work_;
  QString count_text_;
  std::shared_ptr<const Surface> heights_of_;
  HeightRange heights_;
  bool looked_ = false;  ///< Since the scan is another one.
  QTimer rest_;          ///< Since it was turned last: then it is said.
  LatestWorker worker_;  ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
