// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QKeySequence>
#include <QMainWindow>
#include <span>

#include "core/project/project.h"
#include "core/region/probe.h"
#include "core/replay/video_request.h"
#include "ui/document.h"
#include "ui/icons.h"
#include "ui/palette.h"
#include "ui/picture_turns.h"
#include "ui/replay_control.h"
#include "ui/settings.h"
#include "ui/touch_readout.h"

class QComboBox;
class QLabel;
class QSplitter;
class QStackedWidget;
class QToolBar;

namespace relievo {

class DetailView;
class FirstViewCard;
class MeasurePanel;
class MessageStrip;
class OverviewInset;
class PathPreview;
class PlacesPanel;
class ReferenceView;
class RegionPanel;
class SidePanels;
class StartPage;
class StatusFields;
class StereoPanel;
class SurfacePanel;
class TimePlot;
class VideoControl;
class ViewPanel;
class WorkKeeper;

enum class ImageSource { reference, detail, window };

/// The window: one object, two views, one hand. It shows and asks; what it shows is `document()`.
/// [GUI thread]
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// @param depth_buffer  the OpenGL depth engine
  explicit MainWindow(DepthEngine depth_buffer,
                      Settings::Mode settings = Settings::Mode::remembered);
  ~MainWindow() override;

  Document& document() { return document_; }
  DetailView& detailView() { return *detail_; }
  ReferenceView& referenceView() { return *reference_; }
  Settings& settings() { return settings_; }

  void open(const OpenRequest& request);
  void open(const QString& file);
  /// The present state, as projects and figures keep it.
  Project project();
  /// Brings a state back; `from` is the project or picture it came from.
  void restore(const Project& project, const QString& from);
  void saveProject(const QString& file);
  /// Places, measurements, camera paths or, in a project, settings that no file holds.
  bool hasUnsavedWork();
  /// PNG of a view or the window, exactly `pixels` large.
  /// @throw WriteError, GraphicsError
  void writeImage(ImageSource source, const QSize& pixels, const QString& file);
  /// A sentence above the views.
  void showMessage(const QString& text);
  QString message() const;  ///< Empty while there is none.

  // What a touch module offers and tells; see plugins/api.
  void addPanel(const QString& title, QWidget* panel);
  void addToMenu(const QString& menu, QAction* action);
  void showProbe(const Probe& probe);
  void plot(std::span<const TouchPlotPoint> points);
  void showTouch(const TouchReadout& readout);
  /// Why there is no touch; the status bar says so.
  void showTouchMissing(const QString& reason);
  void announce(const QString& text);
  /// Runs a command by its object name. @return false: unknown or disabled
  bool runCommand(const QString& name);
  /// Who reads recordings; without one there is no replay.
  void setRecordingReader(RecordingReader reader);
  /// Shows a recording on the open map, or offers to open the one it was made on.
  void replay(const QString& file);
  ReplayControl& replayControl() { return *replay_; }
  /// A video of the replay, or of the camera path, in the background.
  /// @param chosen  profile, size and rate; the rest is as the window shows it
  void writeVideo(const VideoRequest& chosen, const QString& file);
  VideoControl& videoControl() { return *video_; }
  QImage videoPicture();  ///< What a video of the view shows now.
  /// Comment lines about input, unit, view and region for the header of a recording in `file`.
  QString recordingHeader(const QString& file) const;

 Q_SIGNALS:
  void windowShown(std::shared_ptr<const relievo::RegionWindow> window);
  void handMoved(relievo::ViewMm position, bool inside);
  void closing();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Command {
    const char* name;
    QString text;
    QList<QKeySequence> keys;
    QString tip;
    std::function<void()> run;
    std::optional<Icon> icon;
    bool checkable = false;
  };
  QAction* make(const Command& command);

  // main_window.cpp
  void layOut();
  QWidget* headed(QWidget* view, QLabel* title, QLabel* note);
  void connectParts();
  void showSurface();
  void showWindow();
  void showBusy(bool busy);
  void showFailure(const QString& message, const QString& code, const QString& file);
  void askUnit();
  void askUnitIfAssumed();
  void chooseUnit(LengthUnit unit);
  void useThisView();

  // main_window_layout.cpp
  void setFullScreenDetail(bool on);
  void focusNextPart(int direction);
  void setTheme(Theme theme);
  void showPreferences();
  void applyPreference(const QString& key);
  void restoreLayout();
  void saveLayout();

  // main_window_menus.cpp
  void makeCommands();
  void makeSurfaceCommands();
  void makeWindowCommands();
  void makeMenus();
  void makeToolBar();
  void makeThemeMenu(QMenu* view);
  void showRecent();
  void showHistory();
  void enableCommands();
  void chooseFile();
  void chooseImage();
  void chooseDepthMap();
  void showKeys();
  void showSteps();
  void showAbout();
  QAction* command(const char* name) const;
  /// The menu with this English name; made with the title if there is none.
  QMenu* menu(const QString& name, const QString& title);

  // main_window_project.cpp
  void chooseFigure();
  void saveProject();
  /// @param then  once it is saved
  void saveProjectAs(const std::function<void()>& then = {});
  void relink(const Project& project, const QString& from);
  void showRestored();
  bool restoreFromFile(const QString& file);
  void showLook(const ReliefLook& look);
  void showStereo(const StereoOptions& stereo);
  void showParallax();

  // main_window_unsaved.cpp
  void noteSaved();
  /// Asks whether to save, if there is something; `then` comes after Save and Discard.
  void whenNothingIsUnsaved(const std::function<void()>& then);
  void restart();

  // main_window_places.cpp
  void makePlaceCommands();
  void connectPlaces();
  void keepWork();
  void namePlace();
  void toggleBeacon();
  void goToPlace(const NamedRegion& place);
  void showView(const ViewState& view);
  void offerLeftWork();

  // main_window_measure.cpp
  void makeMeasureCommands();
  void makeReliefCommands();
  void beginMeasuring(MeasureKind kind);
  void showMeasurements();
  void saveMeasurements();

  // main_window_replay.cpp
  void makeReplayCommands();
  void connectReplay();
  void chooseRecording();
  void showReplaying(bool on);
  void offerRecordedMap(const QString& sentence);
  void openRecordedMap(const QString& file);

  // main_window_video.cpp
  void makeVideoCommands();
  void connectVideo();
  void enableVideo();
  bool hasPath() const;
  void chooseVideo();
  void chooseVideoFile(const VideoRequest& chosen);

  void setLiveVideo(bool on);
  void addKeyView();
  void previewPath();
  void showPathView(const ViewState& view);

  // main_window_touch.cpp
  void drawProbe(const Probe& probe);
  void showPosition(const ViewMm& position, std::optional<Origin> known);
  StepAbout about() const;
  /// What is shown, as one line of JSON without places of this computer.
  std::string carriedState(const QString& file) const;
  bool stopForces();
  QString introduction() const;

  Settings settings_;
  Document document_;
  PictureTurns picture_turns_;  ///< Before the views, which are children and go first.
  MessageStrip* strip_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  FirstViewCard* first_view_ = nullptr;
  StartPage* start_ = nullptr;
  QSplitter* views_ = nullptr;
  QSplitter* rows_ = nullptr;
  QWidget* reference_box_ = nullptr;
  QLabel *reference_title_ = nullptr, *reference_note_ = nullptr;
  QLabel *detail_title_ = nullptr, *detail_note_ = nullptr;
  ReferenceView* reference_ = nullptr;
  DetailView* detail_ = nullptr;
  OverviewInset* inset_ = nullptr;
  SidePanels* panels_ = nullptr;
  SurfacePanel* surface_panel_ = nullptr;
  RegionPanel* region_panel_ = nullptr;
  ViewPanel* view_panel_ = nullptr;
  StereoPanel* stereo_panel_ = nullptr;
  MeasurePanel* measure_panel_ = nullptr;
  PlacesPanel* places_panel_ = nullptr;
  WorkKeeper* keeper_ = nullptr;
  TimePlot* plot_ = nullptr;
  ReplayControl* replay_ = nullptr;
  VideoControl* video_ = nullptr;
  PathPreview* path_preview_ = nullptr;
  StatusFields* status_ = nullptr;
  QToolBar* tools_ = nullptr;
  QComboBox* detail_choice_ = nullptr;
  QMenu* recent_menu_ = nullptr;

  Project project_;                   ///< What of the state no other part holds.
  std::optional<Project> restoring_;  ///< Until its file is open.
  QString project_file_;
  std::string saved_work_;  ///< What a file holds of the work; see hasUnsavedWork.
  bool closes_anyway_ = false;
  QString recovered_copy_;  ///< Of what a crash left, until it is open again.
  std::optional<Probe> probe_;
  TouchReadout touch_;
  bool touch_present_ = false;
  QByteArray layout_before_full_screen_;
};

}  // namespace relievo
