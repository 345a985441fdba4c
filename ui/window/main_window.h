// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QKeySequence>
#include <QMainWindow>
#include <span>

#include "core/project/project.h"
#include "core/recording/force_curve.h"
#include "core/region/probe.h"
#include "core/replay/video_request.h"
#include "ui/dialogs/video_control.h"
#include "ui/panels/replay_control.h"
#include "ui/panels/stereo_panel.h"
#include "ui/style/field_manners.h"
#include "ui/style/icons.h"
#include "ui/style/palette.h"
#include "ui/views/picture_file.h"
#include "ui/views/pointer_bindings.h"
#include "ui/views/quiet_turns.h"
#include "ui/views/touch_readout.h"
#include "ui/window/settings.h"
#include "ui/work/document.h"
#include "ui/work/work_queue.h"

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
struct MapExport;
struct OtherExport;
class LightBall;
class OverviewInset;
class PathPreview;
class PlacesPanel;
class ProfileStrip;
class ReferenceView;
class RegionPanel;
class SidePanels;
class StartPage;
class StatusFields;
class SuggestPanel;
class SurfacePanel;
class TimePlot;
class ViewPanel;
class WorkKeeper;

struct PackageChoice;
struct PrepareStart;

enum class ImageSource { reference, detail, window };

/// Which files a recording needs to be repeated, beside its scan. [worker] @param scans  also other
/// scans that were touched
using CompanionsOf = std::function<std::vector<InputFile>(const std::filesystem::path& recording,
                                                          bool scans, const Task& task)>;

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
  /// Several scans of one object: the dialog Prepare joins them into the one that is opened.
  void openTogether(const QStringList& files);
  void openFolder(const QString& folder);
  /// What was dropped or named when the program started: a folder, a file, or several.
  void openPaths(const QStringList& paths);
  /// The present state, as projects and figures keep it.
  Project project() const { return document_.stored(); }
  /// Brings a state back; `from` is the project or picture it came from. Files elsewhere are asked
  /// about before they are read.
  void restore(const Project& project, const QString& from);
  void saveProject(const QString& file);
  /// Places, measurements, camera paths or, in a project, settings that no file holds.
  bool hasUnsavedWork() const { return document_.hasUnsavedWork(); }
  /// PNG of a view or the window, exactly `pixels` large, drawn and written in the background; the
  /// strip says what went wrong.
  void saveImage(ImageSource source, const QSize& pixels, const QString& file);
  bool savingImage() const { return image_work_.busy(); }
  /// Writes a part of the map for other programs in the background; the strip says what went wrong
  /// or had to be left out.
  void exportMap(const MapExport& choice, const QString& file);
  bool exporting() const { return export_work_.busy(); }
  /// Who knows what recordings need; without one packages hold the recordings alone.
  void setCompanions(CompanionsOf companions);
  /// A recording of the open map is on the disk: from now on it belongs to the work.
  void noteRecording(const QString& file);
  /// Writes and checks a package for citation in the background.
  void writePackage(const PackageChoice& choice);
  bool packing() const { return package_work_.busy(); }
  /// The computer or a terminal says that the program must end: without a question and without
  /// waiting for long work. Work that no file holds stays as the automatic copy, a video of the
  /// view and recordings end whole, and what is half written goes.
  void endAtOnce();
  /// A sentence above the views.
  void showMessage(const QString& text);
  /// The same of an error, with its code and what can be done.
  void showError(const QString& text, const QString& code);
  QString message() const;  ///< Empty while there is none.

  // What a touch module offers and tells; see plugins/api.
  void addPanel(const QString& title, QWidget* panel);
  void removePanel(QWidget* panel);  ///< And deletes it.
  void addToMenu(const QString& menu, QAction* action);
  void showProbe(const Probe& probe);
  void plot(std::span<const ForcePoint> points);
  void showTouch(const TouchReadout& readout);
  /// Why there is no touch; the status bar says so.
  void showTouchMissing(const QString& reason);
  void announce(const QString& text);
  /// To whoever does not look: by who speaks, else by the screen reader.
  void tell(const QString& text);
  /// @param spoken  for the screen reader; empty: it was heard already
  void announceAs(const QString& text, const QString& spoken);
  /// Who is asked first to speak what is announced, and says whether it does.
  void setSpeaker(std::function<bool(const QString& text)> speaker);
  /// Runs a command by its object name. @return false: unknown or disabled
  bool runCommand(const QString& name);
  /// Who reads recordings in place of core's readRecording.
  void setRecordingReader(RecordingReader reader);
  /// Shows a recording on the open map, or offers to open the one it was made on.
  void replay(const QString& file);
  ReplayControl& replayControl() { return *replay_; }
  /// A video of the replay, or of the camera path, in the background.
  /// @param chosen  light and relief image are as the view shows them
  void writeVideo(const VideoRequest& chosen, const QString& file);
  VideoControl& videoControl() { return *video_; }
  VideoControl::LiveSource liveSource();  ///< What a video of the view shows.
  QString recordingEnding() const;        ///< Of names of recordings: "csv" or "h5", as chosen.
  /// Where they go: as chosen, else relievo in the documents folder; empty: there is none.
  QString recordingFolder() const;
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
  void useThisView();

  // main_window_questions.cpp
  void connectQuestions();
  /// What was found in an opened file and may be meant otherwise, one strip after the other.
  void askQuestions();
  void askNext();
  void askStrays();
  void askGroups();
  void answerStrays(StrayRule rule);
  void askNodata();
  /// Draws the six faces in a worker and asks for one of them then.
  void drawFaces();
  void askFace(const std::vector<std::pair<std::string, QImage>>& faces);
  void askUnit();
  void chooseUnit(LengthUnit unit);

  // main_window_layout.cpp
  void setFullScreenDetail(bool on);
  /// Where they are wanted and leave the views enough height.
  void showPlots();
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
  void chooseDepthMap();
  void showKeys();
  void showSteps();
  void showAbout();
  QAction* command(const char* name) const;
  /// The menu with this English name; made with the title if there is none.
  QMenu* menu(const QString& name, const QString& title);

  // main_window_image.cpp
  void chooseImage();
  void connectImages();
  PictureOrder pictureOrder(ImageSource source, const QSize& pixels, const QString& file);
  /// Pictures, packages, exports and videos that are being written.
  bool writing() const;
  /// The window has to wait for what is being written, and closes by itself after it.
  bool closesWhenAllIsWritten();
  /// A file is written, or was not: then nobody closes before the sentence was read.
  void closeIfAwaited(bool written);
  /// Nobody waits for the end any more; the next close asks again what it has to ask.
  void stayOpen() { closes_when_saved_ = closes_anyway_ = false; }

  // main_window_export.cpp
  void makeExportCommand();
  void connectExports();
  void chooseExport();
  /// Pictures of the views, profiles and sections.
  std::vector<OtherExport> otherExports();
  /// Says that it is saved, or why not.
  void tellWritten(const QString& file, const std::function<void()>& write);

  // main_window_prepare.cpp
  void makePrepareCommands();
  void chooseFolder();
  void choosePrepare();
  /// @param then  with the file that was prepared
  void showPrepare(const PrepareStart& start, const std::function<void(const QString&)>& then);

  // main_window_foreign.cpp
  /// Gets the files that are not to be read.
  using Withhold = std::function<void(const std::vector<std::filesystem::path>& files)>;
  void connectForeignFiles();
  /// Calls `then`, at once if all that the project names is in the folder of `carrier`; else after
  /// its checksums were compared, and after somebody was asked where they differ.
  void whenFilesMayBeRead(const Project& project, const QString& carrier, const Withhold& then);
  void askForForeignFiles(const std::vector<std::filesystem::path>& files, const QString& carrier,
                          const Withhold& then);
  bool isWithheld(const std::string& file) const;
  void tellInputWithheld(const Project& project, const QString& carrier);
  void askAboutWithheld();  ///< Not a question, but one at a time with them.

  // main_window_package.cpp
  void makePackageCommand();
  void connectPackages();
  /// Unpacks and opens, if the file is a zip. @param into  empty: the folder that it lies in
  bool openPackage(const QString& file, const QString& into = {});
  void choosePackageFolder(const QString& package);
  void noteFigure(const QString& file);
  void choosePackage();

  // main_window_project.cpp
  void chooseFigure();
  void saveProject();
  /// @param then  once it is saved
  void saveProjectAs(const std::function<void()>& then = {});
  void relink(const Project& project, const QString& from);
  /// As restore(), of a state in which the user chose the scan: all else is asked about as ever.
  void restoreOnChosen(const Project& project, const QString& from);
  void restoreNow(const Project& project, const QString& from);
  void showRestored();
  bool restoreFromFile(const QString& file);
  void showDamaged(const QString& text);
  Project keptWork() const;  ///< For an automatic copy.
  void showTitle();          ///< Which project or scan, and whether a file holds all of the work.
  void showLook();
  void tellLookRefused(ReliefKind wanted);
  /// One step that changes how the relief is painted.
  void chooseLook(const QString& name, const std::function<void(ReliefLook&)>& change,
                  int merge_id = -1);
  /// Of steps that merge while a slider is dragged; the document's own ids are below.
  static constexpr int kMergeStereo = 101;
  void warnOfRivalry();
  void chooseStereo(const StereoOptions& stereo);
  void showStereo();
  void showParallax();
  /// The same colour for the same value in both views.
  void shareRange();

  // main_window_unsaved.cpp
  /// Back to the start page, once nothing is unsaved.
  void closeDocument();
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
  void copyView();
  void pasteView();
  /// One step to a view's look and stereo; its turn comes with it.
  void showView(const ViewState& view, const QString& name);
  void offerLeftWork();

  // main_window_light.cpp
  void makeLightCommands();
  void connectLight();
  void stepLight(int clockwise, int higher);
  void chooseLight(const LightOptions& light, int merge_id);
  void showLight();
  static constexpr int kMergeDraggedLight = 104;

  // main_window_profile.cpp
  void makeProfileCommands();
  void connectProfile();
  void showProfile();
  void showProfileMark();    ///< In both views, where the curve has its cursor.
  void showProfileCursor();  ///< And carries the hand there.
  void saveProfile();

  // main_window_suggest.cpp
  void makeSuggestCommand();
  void connectSuggestions();

  // main_window_pointer.cpp
  void makePointerCommands();
  PointerBindings pointerBindings() const;  ///< As preferences say.
  void choosePointerMode(PointerMode mode);
  void showPointerMode(PointerMode mode);
  void showBindings();
  void touchWhileForcesAreOn(bool on);  ///< Does something when they come on or go off.

  // main_window_measure.cpp
  void makeMeasureCommands();
  void makeReliefCommands();
  void beginMeasuring(MeasureKind kind);
  void showMeasurements();
  void saveMeasurements();

  // main_window_replay.cpp
  void makeReplayCommands();
  void makeRecordingKinds();
  void connectReplay();
  void chooseRecording();
  void chooseRecordingFolder();
  void askForRecordingFolder();
  void showReplaying(bool on);
  void offerRecordedMap(const QString& sentence);
  void openRecordedMap(const QString& file);
  void openOld(const Project& project);

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
  FieldManners field_manners_{this};
  QuietTurns quiet_turns_;  ///< Before the views, which are children and go first.
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
  LightBall* light_ball_ = nullptr;
  SidePanels* panels_ = nullptr;
  SurfacePanel* surface_panel_ = nullptr;
  RegionPanel* region_panel_ = nullptr;
  ViewPanel* view_panel_ = nullptr;
  StereoPanel* stereo_panel_ = nullptr;
  StereoPanel::Shown whole_shown_;  ///< By the reference view.
  MeasurePanel* measure_panel_ = nullptr;
  PlacesPanel* places_panel_ = nullptr;
  SuggestPanel* suggest_panel_ = nullptr;
  WorkKeeper* keeper_ = nullptr;
  TimePlot* plot_ = nullptr;
  ProfileStrip* profile_ = nullptr;
  ReplayControl* replay_ = nullptr;
  VideoControl* video_ = nullptr;
  PathPreview* path_preview_ = nullptr;
  StatusFields* status_ = nullptr;
  QToolBar* tools_ = nullptr;
  QComboBox* detail_choice_ = nullptr;
  QMenu* recent_menu_ = nullptr;

  /// Files that the project names and that nobody wanted read.
  std::vector<std::filesystem::path> withheld_;
  /// How the view looked when the figure's look was chosen; nothing: not chosen yet.
  std::optional<ReliefLook> figure_view_;
  LatestWorker face_worker_, foreign_work_;
  std::vector<std::function<void()>> questions_;  ///< Not yet asked, the next one first.
  std::optional<OpenRequest> restoring_;          ///< With a project, until its file is open.
  bool closes_anyway_ = false;
  bool ends_at_once_ = false;
  bool title_due_ = false;
  QString recovered_copy_;  ///< Of what a crash left, until it is open again.
  std::optional<Probe> probe_;
  TouchReadout touch_;
  std::function<bool(const QString& text)> speaker_;
  bool touch_present_ = false;
  quint64 late_ticks_seen_ = 0;
  bool forces_were_on_ = false;
  bool looks_after_forces_ = false;  ///< Touch was chosen by the forces, not by the person.
  QByteArray layout_before_full_screen_;
  bool closes_when_saved_ = false;
  std::shared_ptr<const Surface> warned_of_rivalry_;
  CompanionsOf companions_;
  WorkQueue image_work_, package_work_, unpack_work_, record_work_, export_work_;
};

}  // namespace relievo
