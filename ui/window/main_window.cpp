// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QMimeData>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QUrl>
#include <QVBoxLayout>

#include "core/region/smoothing.h"
#include "ui/frame/side_panels.h"
#include "ui/frame/start_page.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/suggest_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/views/cloud_view.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/views/scan_view.h"
#include "ui/window/first_view.h"
#include "ui/window/work_area.h"
#include "ui/work/file_names.h"

namespace relievo {
namespace {

constexpr QSize kFirstSize(1440, 900);
constexpr QSize kLeastSize(760, 460);

QString levelTip(const DetailLadder& ladder, Level level) {
  if (level.value == 0) return MainWindow::tr("Level 0 of the pyramid: not smoothed");
  return MainWindow::tr("Level %1 of the pyramid, smoothed by a Gaussian of \u03c3 = %2")
      .arg(QString::number(level.value), lengthText(smoothingMm(ladder, level)));
}

/// A window of its own inside the window: Qt puts a window that has OpenGL in it together anew, all
/// of it and by OpenGL, whenever one letter of it changes; a part that is a window is left alone,
/// and one without OpenGL is painted without it (docs/adr/0150).
void makeOwnWindow(QWidget* part) {
  part->setAttribute(Qt::WA_DontCreateNativeAncestors);
  part->setAttribute(Qt::WA_NativeWindow);
}

}  // namespace

MainWindow::MainWindow(DepthEngine depth_buffer, Settings::Mode settings)
    : settings_(settings), document_(std::move(depth_buffer)) {
  setObjectName(QStringLiteral("main_window"));
  setWindowTitle(QStringLiteral("relievo"));
  setAcceptDrops(true);
  setMinimumSize(kLeastSize);
  // Room for the frame that the window manager adds: the status bar must not hang below the screen.
  resize(kFirstSize.boundedTo(screen()->availableSize() - QSize(16, 48)).expandedTo(kLeastSize));
  status_ = new StatusFields(*statusBar());
  layOut();
  messages_ = std::make_unique<WindowMessages>(*strip_, *status_);
  connectDocument();
  makeCommands();
  makeMenus();
  makeToolBar();
  controllers_ = std::make_unique<Controllers>(
      ControllerParts{document_, settings_, commands_, *messages_, *this}, *area_);
  connectParts();
  showSurface();
  showWindow();
  showRecent();
  for (const char* key :
       {"theme", "text_percent", "size_unit", "stereo_kind", "recording_kind", "pointer_mode"}) {
    applyPreference(QString::fromLatin1(key));
  }
  restoreLayout();
  start_->setFocus();
  qApp->installEventFilter(this);
  controllers_->opening.offerLeftWork();
}

// The parts go before the document that they show. Views that vanish under the pointer still speak:
// by then neither a controller nor the window hears them. Qt itself must hear that a view is gone,
// or a screen reader is given it in the next one's place.
MainWindow::~MainWindow() {
  qApp->removeEventFilter(this);
  hearing_.reset();
  controllers_.reset();
  delete takeCentralWidget();
}

CloudView* MainWindow::scanInHand() {
  CloudView* scan = area_->scan().cloud();
  return scan != nullptr && scan->isVisible() && scan == focusWidget() ? scan : nullptr;
}

DetailView& MainWindow::detailView() {
  return area_->detail();
}

ReferenceView& MainWindow::referenceView() {
  return area_->reference();
}

void MainWindow::layOut() {
  auto* centre = new QWidget(this);
  auto* column = new QVBoxLayout(centre);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  strip_ = new MessageStrip(centre);
  column->addWidget(strip_);
  pages_ = new QStackedWidget(centre);
  column->addWidget(pages_, 1);
  start_ = new StartPage(pages_);
  pages_->addWidget(start_);
  area_ = new WorkArea(document_, render_scheduler_, pages_);
  pages_->addWidget(area_);
  first_view_ = new FirstViewCard(document_, pages_);
  setCentralWidget(centre);
  for (QWidget* part : std::initializer_list<QWidget*>{
           &area_->reference(), &area_->scan(), &area_->detail(), &area_->plot(), &area_->profile(),
           area_->panels().all, first_view_, statusBar()}) {
    makeOwnWindow(part);
  }
}

// Before the controllers, so that what they show and say of a change stands on the window's.
void MainWindow::connectDocument() {
  QObject* heard = hearing_.get();
  connect(&document_, &Document::surfaceChanged, heard, [this] { showSurface(); });
  connect(&document_, &Document::windowChanged, heard, [this] { showWindow(); });
  connect(&document_, &Document::stereoChanged, heard, [this] { showAroundDetail(); });
  messages_->follow(document_.loader());
  connect(messages_.get(), &WindowMessages::workBegan, heard, [this] {
    area_->reference().warmUp();  // Pictures will be wanted.
    area_->detail().warmUp();
  });
  connect(&document_.loader(), &SurfaceLoader::cancelled, heard,
          [this] { messages_->announce(tr("Cancelled. Nothing was changed.")); });
  // Said before the surface is made, while there is still time to stop.
  connect(&document_.loader(), &SurfaceLoader::scanRead, heard,
          [this](const QString& file, double w, double h, double d, quint64 points) {
            messages_->announce(
                tr("%1: %2, points: %3")
                    .arg(shownName(file), sizeText({w, h, d}), QString::number(points)));
          });
  connect(&document_, &Document::opened, heard, [this](const QString& file) {
    settings_.addRecentFile(file);
    showRecent();
    const QString open_now = tr("%1 is open.").arg(shownName(file));
    const bool can_touch = commands_.named(QStringLiteral("forces")) != nullptr;
    // So much appears with it that a screen reader drops what is said at the same moment.
    messages_->announceWhenCalm(can_touch ? tr("%1 Press F5 to switch forces on.").arg(open_now)
                                          : open_now);
  });
  connect(&document_, &Document::fileChanged, heard, [this](const QString& file) {
    settings_.addRecentFile(file);
    showRecent();
    controllers_->saving.showTitle();
  });
}

void MainWindow::connectParts() {
  QObject* heard = hearing_.get();
  Controllers& c = *controllers_;
  connect(start_, &StartPage::openAsked, &c.opening, &OpenController::choose);
  connect(start_, &StartPage::fileChosen, &c.opening,
          [&opening = c.opening](const QString& file) { opening.open(file); });
  connect(first_view_, &FirstViewCard::said, messages_.get(), &WindowMessages::announce);
  connect(&c.saving, &SaveController::saved, heard, [this] { showRecent(); });
  connect(&c.replays, &ReplayController::shownChanged, heard, [this](bool on) {
    area_->panels().suggestions->setEnabled(!on && document_.isOpen());
    showPlots();
    enableCommands();
  });
  connect(&c.measure, &MeasureController::profileChanged, heard, [this] { showPlots(); });
  DetailView& detail = area_->detail();
  connect(&detail, &DetailView::turned, heard, [this](bool turned) {
    area_->panels().view->showTurned(turned);
    enableCommands();
  });
  connect(&detail, &DetailView::handMoved, heard,
          [this](const ViewMm& position, bool inside) { Q_EMIT handMoved(position, inside); });
  connect(&area_->scan(), &ScanView::turnedChanged, heard, [this] { enableCommands(); });
  connect(&area_->scan(), &ScanView::said, messages_.get(), &WindowMessages::announce);
  connect(&area_->scan(), &ScanView::left, &detail, [&detail] { detail.setFocus(); });
  connect(&area_->scan(), &ScanView::reliefAsked, heard,
          [this] { commands_[Command::relief_from_scan].trigger(); });
  connect(&area_->reference(), &ReferenceView::said, messages_.get(), &WindowMessages::announce);
  connect(&area_->reference(), &ReferenceView::left, &detail, [&detail] { detail.setFocus(); });
  connect(&document_, &Document::windowChanged, heard, [this] {
    if (const auto window = document_.window()) Q_EMIT windowShown(window);
  });
  QAction& answer = commands_[Command::answer];
  strip_->setOfferKey(answer.shortcut());
  answer.setEnabled(strip_->hasOffer());
  connect(strip_, &MessageStrip::offerChanged, &answer, &QAction::setEnabled);
}

void MainWindow::showSurface() {
  const bool is_open = document_.isOpen();
  pages_->setCurrentIndex(is_open ? 1 : 0);
  tools_->setVisible(is_open);
  enableCommands();
  // What was open may still lie in the force loop.
  if (QAction* forces = commands_.named(QStringLiteral("forces"))) {
    forces->setEnabled(is_open && !area_->replay().showing());
  }
  if (!is_open) return;
  area_->panels().view->showView(QString::fromStdString(document_.surface()->view_name));
  controllers_->saving.showTitle();
  area_->showMapTitle();
}

void MainWindow::showWindow() {
  const auto window = document_.window();
  enableCommands();
  if (!window) return;
  const int detail = document_.detail();
  const int details = document_.details();
  area_->showWindowTitle();
  detail_choice_->setCurrentIndex(-1);
  if (detail_choice_->count() != details) {
    detail_choice_->clear();
    for (int d = 1; d <= details; ++d) {
      detail_choice_->addItem(tr("Resolution %1 of %2").arg(d).arg(details), d);
    }
  }
  detail_choice_->setCurrentIndex(detail - 1);
  const DetailLadder& ladder = document_.surface()->ladder;
  const int shown = ladder.detailOf(window->region.level);
  messages_->set(StatusField::detail,
                 shown < detail
                     ? tr("Resolution %1/%2, %3 on its way").arg(shown).arg(details).arg(detail)
                     : tr("Resolution %1/%2").arg(detail).arg(details),
                 levelTip(ladder, window->region.level));
}

void MainWindow::closeDocument(const QString& read) {
  if (!document_.isOpen()) return;
  RecordingsEnd& ending = controllers_->recordings_end;
  const QString name = shownName(document_.file());
  if (ending.endFirst(commands_.named(QStringLiteral("record")),
                      [this, read] { closeDocument(read); })) {
    messages_->announce(tr("%1 is closed when the recording is saved").arg(name));
    return;
  }
  controllers_->saving.whenNothingIsUnsaved([this, name, read, saved = ending.takeWords()] {
    Controllers& c = *controllers_;
    c.touch.stopForces();
    c.videos.preview().stop();
    if (area_->replay().showing()) area_->replay().close();
    area_->replay().forgetWaiting();
    area_->panels().measure->cancel();
    if (isFullScreen()) setFullScreenDetail(false);
    c.questions.forget();
    if (messages_->shown() == read) messages_->close();
    c.opening.forgetState();
    c.touch.forgetProbe();
    document_.close();
    c.saving.autosave().forget();
    for (const StatusField field :
         {StatusField::position, StatusField::origin, StatusField::detail, StatusField::force}) {
      messages_->set(field, {});
    }
    setWindowTitle(QStringLiteral("relievo"));
    setWindowModified(false);
    start_->setFocus();
    const QString closed = tr("%1 is closed").arg(name);
    messages_->announce(saved.isEmpty() ? closed : tr("%1. %2").arg(saved, closed));
  });
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!controllers_->saving.mayClose()) {
    event->ignore();
    return;
  }
  saveLayout();
  document_.loader().cancel();
  Q_EMIT closing();
  QMainWindow::closeEvent(event);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QMimeData& dropped = *event->mimeData();
  if (dropped.hasUrls() || isAddress(dropped.text().trimmed())) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  // A link, or a text that is an address.
  const QString link = urls.size() == 1 ? urls.front().toString(QUrl::FullyEncoded)
                                        : event->mimeData()->text().trimmed();
  if (urls.size() < 2 && isAddress(link)) {
    event->acceptProposedAction();
    controllers_->opening.open(link);
    return;
  }
  if (urls.isEmpty()) return;
  event->acceptProposedAction();
  QStringList files;
  for (const QUrl& url : urls) {
    if (url.isLocalFile()) files << droppedPath(url);
  }
  if (files.size() < urls.size()) {
    messages_->show(
        tr("Only files on this computer, or one address of a published map, can be "
           "opened. Nothing was opened."));
  } else {
    const bool keeps_view = event->keyboardModifiers().testFlag(Qt::ControlModifier);
    controllers_->opening.openPaths(files, keeps_view);
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == area_->rows() && event->type() == QEvent::Resize) showPlots();
  if (event->type() != QEvent::KeyPress || QApplication::activeModalWidget() != nullptr ||
      QApplication::activePopupWidget() != nullptr || !watched->isWidgetType() ||
      static_cast<QWidget*>(watched)->window() != this) {
    return QMainWindow::eventFilter(watched, event);
  }
  if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && escape()) return true;
  return QMainWindow::eventFilter(watched, event);
}

bool MainWindow::escape() {
  Controllers& c = *controllers_;
  VideoControl& video = c.videos.control();
  ReplayControl& replay = area_->replay();
  MeasurePanel& measure = *area_->panels().measure;
  if (c.touch.stopForces()) return true;
  if (c.recordings_end.ending()) {
    c.recordings_end.forget();
    messages_->announce(tr("%1 stays open").arg(shownName(document_.file())));
    return true;
  }
  if (area_->panels().suggestions->cancel()) return true;
  if (c.pointer.stopFeeling()) return true;
  if (c.foreign.cancel()) return true;
  if (document_.loader().busy()) {
    c.opening.cancel();
  } else if (video.writing() || (c.saving.closesWhenSaved() && video.live())) {
    c.saving.stayOpen();
    if (video.writing()) video.cancel();
  } else if (c.videos.preview().playing()) {
    c.videos.preview().stop();
  } else if (replay.reading()) {
    replay.cancel();
  } else if (measure.measuring()) {
    measure.cancel();
  } else if (replay.showing()) {
    replay.close();
  } else if (isFullScreen()) {
    setFullScreenDetail(false);
  } else {
    return false;
  }
  return true;
}

}  // namespace relievo
