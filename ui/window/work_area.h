// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>
#include <QWidget>

class QBoxLayout;
class QLabel;
class QSplitter;
class QStackedWidget;

namespace relievo {

class DetailView;
class Document;
class MeasurePanel;
class OverviewInset;
class PlacesPanel;
class ProfileStrip;
class RenderScheduler;
class ReferenceView;
class RegionPanel;
class ReplayControl;
class ScanView;
class Settings;
class SidePanels;
class StereoPanel;
class SuggestPanel;
class SurfacePanel;
class TimePlot;
class ViewPanel;

/// What is shown of an open map: both views with their headers, the plots below them, and the
/// panels beside them. [GUI thread]
class WorkArea : public QWidget {
  Q_DECLARE_TR_FUNCTIONS(relievo::WorkArea)
 public:
  WorkArea(Document& document, RenderScheduler& turns, QWidget* parent);

  DetailView& detail() { return *detail_; }
  ReferenceView& reference() { return *reference_; }
  ScanView& scan() { return *scan_; }
  /// Which of the two stands beside the detail view.
  QWidget& besideDetail();
  TimePlot& plot() { return *plot_; }
  ProfileStrip& profile() { return *profile_; }
  ReplayControl& replay() { return *replay_; }
  struct Panels {
    SidePanels* all;
    SurfacePanel* surface;
    RegionPanel* region;
    ViewPanel* view;
    StereoPanel* stereo;
    MeasurePanel* measure;
    PlacesPanel* places;
    SuggestPanel* suggestions;
  };
  const Panels& panels() const { return panels_; }
  /// Views and plots, one below the other: another height may be room for other plots.
  const QObject* rows() const;

  /// Turns what is beside the detail view; it takes the place at the end of its header.
  void addSwitch(QWidget* widget);
  void showMapTitle();     ///< And its size, above the reference view.
  void showWindowTitle();  ///< Which detail, how large it is and under the hand.
  /// Views have the room that they need, and plots the rest: the curve first, which was asked for.
  void showPlots(bool curve_wanted, bool plots_wanted);
  void showReference(bool on);
  void showScan(bool on);  ///< The scan in 3-D in the place of the reference view.
  void showInset(bool on);
  void takeColours();
  void saveTo(Settings& settings) const;
  void restoreFrom(const Settings& settings);

 private:
  void layOutViews(Document& document, RenderScheduler& turns);
  void makePanels(Document& document);

  Document& document_;
  QLabel *reference_title_, *reference_note_, *detail_title_, *detail_note_;
  ReferenceView* reference_;
  ScanView* scan_;
  QStackedWidget* beside_;  ///< The two above.
  QBoxLayout* reference_header_;
  DetailView* detail_;
  OverviewInset* inset_;
  QWidget* reference_box_;
  QSplitter *views_, *rows_;
  TimePlot* plot_;
  ReplayControl* replay_;
  ProfileStrip* profile_;
  Panels panels_{};
};

}  // namespace relievo
