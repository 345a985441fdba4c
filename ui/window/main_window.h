// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QMainWindow>

#include "ui/style/input_event_filter.h"
#include "ui/style/palette.h"
#include "ui/window/controllers.h"
#include "ui/work/scheduling/render_scheduler.h"

class QComboBox;
class QStackedWidget;
class QToolBar;

namespace relievo {

class CloudView;
class FirstViewCard;
class MessageStrip;
class StartPage;
class StatusFields;
class WorkArea;

/// The window: one object, two views, one hand. It lays out, has the menus and the tool bar, and
/// takes what is dropped; what its commands do is said by its controllers. What it shows is
/// `document()`. [GUI thread]
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  /// @param depth_buffer  the OpenGL depth engine
  explicit MainWindow(DepthEngine depth_buffer,
                      Settings::Mode settings = Settings::Mode::remembered);
  ~MainWindow() override;

  Document& document() { return document_; }
  DetailView& detailView();
  /// The scan in 3-D, while it has the keyboard; else null.
  CloudView* scanInHand();
  ReferenceView& referenceView();
  Settings& settings() { return settings_; }
  Controllers& controllers() { return *controllers_; }
  WindowMessages& messages() { return *messages_; }
  const CommandTable& commands() const { return commands_; }

  void open(const OpenRequest& request) { controllers_->opening.open(request); }
  void open(const QString& file) { controllers_->opening.open(file); }
  void openTogether(const QStringList& files) { controllers_->opening.openTogether(files); }
  void openFolder(const QString& folder) { controllers_->opening.openFolder(folder); }
  void openPaths(const QStringList& paths) { controllers_->opening.openPaths(paths); }
  /// The present state, as projects and figures keep it.
  Project project() const { return document_.stored(); }
  void saveProject(const QString& file) { controllers_->saving.save(file); }
  /// Places, measurements, camera paths or, in a project, settings that no file holds.
  bool hasUnsavedWork() const { return document_.saved().hasUnsaved(); }
  void saveImage(ImageSource source, const QSize& pixels, const QString& file) {
    controllers_->pictures.save(source, pixels, file);
  }
  bool savingImage() const { return controllers_->pictures.busy(); }
  /// Shows a recording on the open map, or offers to open the one it was made on.
  void replay(const QString& file) { controllers_->replays.open(file); }
  /// The computer or a terminal says that the program must end: without a question and without
  /// waiting for long work. Work that no file holds stays as the automatic copy, a video of the
  /// view and recordings end whole, and what is half written goes.
  void endAtOnce() { controllers_->saving.endAtOnce(); }
  /// A sentence above the views.
  void showMessage(const QString& text) { messages_->show(text); }
  QString message() const { return messages_->shown(); }  ///< Empty while there is none.
  /// Runs a command by its object name. @return false: unknown or disabled
  bool runCommand(const QString& name) { return commands_.run(name); }

  // What a touch module adds; see plugins/api.
  void addPanel(const QString& title, QWidget* panel);
  void removePanel(QWidget* panel);  ///< And deletes it.
  void addToMenu(const QString& menu, QAction* action);

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
  // main_window.cpp
  void layOut();
  void connectDocument();
  void connectParts();
  void showSurface();
  void showWindow();
  /// Goes back to the start page when recordings are on the disk and nothing is unsaved.
  /// @param read  the sentence above the views that goes with the scan; a newer one stays
  void closeDocument(const QString& read);
  /// Wherever the focus is: first the forces, then long work, then the mode.
  /// @return false: there was nothing to end
  bool escape();

  // main_window_layout.cpp
  void setFullScreenDetail(bool on);
  /// Where they are wanted and leave the views enough height.
  void showPlots();
  void showAroundDetail();  ///< On a full screen, and when that ends.
  void showScan(bool on);   ///< In the place of the overview.
  void focusNextPart(int direction);
  void setTheme(Theme theme);
  void showPreferences();
  void applyPreference(const QString& key);
  void restoreLayout();
  void saveLayout();

  // main_window_menus.cpp
  void makeCommands();
  void makeMenus();
  void makeToolBar();
  void makeViewButton();
  void makeScanSwitch();
  void makeDetailChoice();
  void showRecent();
  void enableCommands();

  Settings settings_;
  Document document_;
  CommandTable commands_{*this};
  InputEventFilter input_filter_{this};
  RenderScheduler render_scheduler_;  ///< Before the views, which are children and go first.
  /// The window hears of its parts while this lives.
  std::unique_ptr<QObject> hearing_ = std::make_unique<QObject>();
  StatusFields* status_ = nullptr;
  MessageStrip* strip_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  FirstViewCard* first_view_ = nullptr;
  StartPage* start_ = nullptr;
  WorkArea* area_ = nullptr;
  QToolBar* tools_ = nullptr;
  QComboBox* detail_choice_ = nullptr;
  QMenu* recent_menu_ = nullptr;
  QByteArray layout_before_full_screen_;
  std::unique_ptr<WindowMessages> messages_;
  std::unique_ptr<Controllers> controllers_;
};

}  // namespace relievo
