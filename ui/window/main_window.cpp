// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/main_window.h"

#include <algorithm>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QScreen>
#include <QSplitter>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QUrl>

#include "core/region/smoothing.h"
#include "core/session/map_facts.h"
#include "ui/dialogs/video_control.h"
#include "ui/frame/header_row.h"
#include "ui/frame/message_strip.h"
#include "ui/frame/overview_inset.h"
#include "ui/frame/side_panels.h"
#include "ui/frame/start_page.h"
#include "ui/frame/status_fields.h"
#include "ui/language/spoken_error.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/replay_panel.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/suggest_panel.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/plots/time_plot.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/path_preview.h"
#include "ui/views/reference_view.h"
#include "ui/window/first_view.h"
#include "ui/work/file_names.h"
#include "ui/work/work_keeper.h"

namespace relievo {
namespace {

constexpr int kPlotHeight = 140;
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

QLabel* headerLabel(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setContentsMargins(10, 4, 10, 4);
  label->setMinimumWidth(10);
  return label;
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
  keeper_ = new WorkKeeper(
      settings_.choice(QStringLiteral("keep_work"), true).toBool()
          ? settings_.stateFolder(QStringLiteral("autosave"))
          : QString(),
      [this] { return keptWork(); }, this);
  layOut();
  makeCommands();
  makeMenus();
  makeToolBar();
  connectParts();
  showSurface();
  showWindow();
  showHistory();
  showRecent();
  for (const char* key :
       {"theme", "text_percent", "size_unit", "stereo_kind", "recording_kind", "pointer_mode"}) {
    applyPreference(QString::fromLatin1(key));
  }
  restoreLayout();
  start_->setFocus();
  qApp->installEventFilter(this);
  offerLeftWork();
}

MainWindow::~MainWindow() {
  qApp->removeEventFilter(this);
  // Views that vanish under the pointer still speak; nobody must be half gone when they do. Only to
  // us: Qt itself must hear that a view is gone, or a screen reader is given it in the next one's
  // place.
  document_.disconnect();
  document_.history().disconnect();
  disconnect(replay_, nullptr, this, nullptr);
  disconnect(video_, nullptr, this, nullptr);
  disconnect(path_preview_, nullptr, this, nullptr);
  disconnect(detail_, nullptr, this, nullptr);
  disconnect(reference_, nullptr, this, nullptr);
  delete takeCentralWidget();
}

QWidget* MainWindow::headed(QWidget* view, QLabel* title, QLabel* note) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(new HeaderRow(title, note));
  column->addWidget(view, 1);
  return box;
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

  auto* work = new QWidget(pages_);
  auto* row = new QHBoxLayout(work);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  reference_ = new ReferenceView(document_, quiet_turns_);
  detail_ = new DetailView(document_, quiet_turns_);
  inset_ = new OverviewInset(document_, detail_);
  reference_title_ = headerLabel(QStringLiteral("reference_title"));
  reference_note_ = headerLabel(QStringLiteral("reference_note"));
  detail_title_ = headerLabel(QStringLiteral("detail_title"));
  detail_note_ = headerLabel(QStringLiteral("detail_note"));
  reference_box_ = headed(reference_, reference_title_, reference_note_);
  views_ = new QSplitter(Qt::Horizontal);
  views_->setChildrenCollapsible(false);
  views_->addWidget(reference_box_);
  views_->addWidget(headed(detail_, detail_title_, detail_note_));
  views_->setStretchFactor(0, 1);
  views_->setStretchFactor(1, 2);
  views_->setSizes({1000, 2000});
  plot_ = new TimePlot;
  plot_->hide();
  rows_ = new QSplitter(Qt::Vertical);
  rows_->addWidget(views_);
  rows_->addWidget(plot_);
  replay_ = new ReplayControl(document_, this);
  video_ = new VideoControl(this);
  path_preview_ = new PathPreview(this);
  rows_->addWidget(replay_->panel());
  profile_ = new ProfileStrip;
  profile_->hide();
  rows_->addWidget(profile_);  // Last: kept layouts know the parts by their order.
  rows_->setCollapsible(0, false);
  rows_->setStretchFactor(0, 1);
  rows_->setStretchFactor(1, 0);
  rows_->setStretchFactor(2, 0);
  rows_->setStretchFactor(3, 0);
  rows_->setSizes({kFirstSize.height(), kPlotHeight, kPlotHeight, kPlotHeight});
  row->addWidget(rows_, 1);

  panels_ = new SidePanels(work);
  surface_panel_ = new SurfacePanel(document_);
  region_panel_ = new RegionPanel(document_);
  view_panel_ = new ViewPanel;
  stereo_panel_ = new StereoPanel;
  panels_->add(tr("Surface"), surface_panel_);
  panels_->add(tr("Window"), region_panel_);
  panels_->add(tr("View"), view_panel_);
  panels_->add(tr("Stereo"), stereo_panel_);
  measure_panel_ = new MeasurePanel(document_);
  panels_->add(tr("Measure"), measure_panel_);
  places_panel_ = new PlacesPanel(document_);
  panels_->add(tr("Places"), places_panel_);
  suggest_panel_ = new SuggestPanel(document_);
  panels_->add(tr("Suggestions"), suggest_panel_);
  row->addWidget(panels_);
  pages_->addWidget(work);
  first_view_ = new FirstViewCard(document_, pages_);
  setCentralWidget(centre);
  for (QWidget* part : std::initializer_list<QWidget*>{reference_, detail_, plot_, profile_,
                                                       panels_, first_view_, statusBar()}) {
    makeOwnWindow(part);
  }
}

void MainWindow::connectParts() {
  connect(start_, &StartPage::openAsked, this, &MainWindow::chooseFile);
  connect(start_, &StartPage::fileChosen, this, qOverload<const QString&>(&MainWindow::open));

  connect(&document_, &Document::surfaceChanged, this, &MainWindow::showSurface);
  connect(&document_, &Document::windowChanged, this, &MainWindow::showWindow);
  connect(&document_, &Document::busyChanged, this, &MainWindow::showBusy);
  connect(&document_, &Document::failed, this, &MainWindow::showFailure);
  connect(&document_, &Document::cancelled, this,
          [this] { announce(tr("Cancelled. Nothing was changed.")); });
  connect(&document_, &Document::progressed, status_, &StatusFields::showWork);
  connect(first_view_, &FirstViewCard::said, this, &MainWindow::announce);
  // Said before the surface is made, while there is still time to stop.
  connect(&document_, &Document::scanRead, this,
          [this](const QString& file, double w, double h, double d, quint64 points) {
            announce(tr("%1: %2, points: %3")
                         .arg(shownName(file), sizeText({w, h, d}), QString::number(points)));
          });
  connect(&document_, &Document::opened, this, [this](const QString& file) {
    settings_.addRecentFile(file);
    showRecent();
    const QString open_now = tr("%1 is open.").arg(shownName(file));
    announce(command("forces") == nullptr ? open_now
                                          : tr("%1 Press F5 to switch forces on.").arg(open_now));
    askQuestions();
    showRestored();
    warnOfRivalry();
    detail_->setFocus();
    replay_->showWaiting();
  });
  connect(&document_, &Document::fileChanged, this, [this](const QString& file) {
    settings_.addRecentFile(file);
    showRecent();
    showTitle();
  });
  connect(status_, &StatusFields::cancelAsked, this, [this] {
    restoring_.reset();
    document_.cancel();
  });
  for (const auto signal : {&QUndoStack::undoTextChanged, &QUndoStack::redoTextChanged}) {
    connect(&document_.history(), signal, this, &MainWindow::showHistory);
  }

  connect(surface_panel_, &SurfacePanel::unitChosen, this, &MainWindow::chooseUnit);
  connect(view_panel_, &ViewPanel::viewChosen, this, [this](const QString& name) {
    document_.setView({name.toStdString(), {}});
  });
  connect(view_panel_, &ViewPanel::useThisViewAsked, this, &MainWindow::useThisView);
  connect(view_panel_, &ViewPanel::straightenAsked, detail_, &DetailView::straighten);
  connect(&document_, &Document::lookChanged, this, &MainWindow::showLook);
  connect(&document_, &Document::lookRefused, this, &MainWindow::tellLookRefused);
  connect(&document_, &Document::stereoChanged, this, &MainWindow::showStereo);

  for (SurfaceView* view :
       {static_cast<SurfaceView*>(reference_), static_cast<SurfaceView*>(detail_)}) {
    connect(view, &SurfaceView::sized, this, &MainWindow::showParallax);
  }
  connect(reference_, &SurfaceView::painted, this, &MainWindow::shareRange);
  connect(detail_, &DetailView::turned, this, [this](bool turned) {
    view_panel_->showTurned(turned);
    enableCommands();
  });
  connect(detail_, &DetailView::handMoved, this, &MainWindow::handMoved);
  connect(detail_, &DetailView::handMoved, this, [this](const ViewMm& position, bool inside) {
    if (inside && !probe_) showPosition(position, {});
  });
  connect(measure_panel_, &MeasurePanel::changed, this, &MainWindow::showMeasurements);
  connect(measure_panel_, &MeasurePanel::said, this, &MainWindow::announce);
  connect(measure_panel_, &MeasurePanel::saveAsked, this, &MainWindow::saveMeasurements);
  connect(detail_, &DetailView::picked, measure_panel_, &MeasurePanel::addPlace);
  connect(detail_, &DetailView::pickingEnded, measure_panel_, &MeasurePanel::finish);
  connect(detail_, &DetailView::pressDepthChanged, this, [this](double depth) {
    announce(tr("Press depth %1 mm of hand").arg(numberText(depth, 2)));
  });
  connectPlaces();
  connectLight();
  connectProfile();
  connectSuggestions();
  connectReplay();
  connectVideo();
  connectImages();
  connectPackages();
  connectForeignFiles();
  connectExports();
  connectQuestions();
  strip_->setOfferKey(command("answer")->shortcut());
  command("answer")->setEnabled(strip_->hasOffer());
  connect(strip_, &MessageStrip::shown, this, &MainWindow::tell);
  connect(strip_, &MessageStrip::offerChanged, command("answer"), &QAction::setEnabled);
  connect(reference_, &ReferenceView::left, detail_, [this] { detail_->setFocus(); });
}

void MainWindow::open(const QString& file) {
  whenNothingIsUnsaved([this, file] {
    unpack_work_.cancel();  // Else its project would take the place of what is opened now.
    restoring_.reset();
    recovered_copy_.clear();  // What is opened now does not hold that work.
    replay_->forgetWaiting();
    if (restoreFromFile(QFileInfo(file).absoluteFilePath())) return;
    OpenRequest request;
    request.file = file;
    open(request);
  });
}

void MainWindow::open(const OpenRequest& request) {
  strip_->close();
  OpenRequest asked = request;
  asked.file = QFileInfo(request.file).absoluteFilePath();
  // Only a file that is opened for a state brings it back.
  if (request.project) {
    restoring_ = asked;
  } else {
    restoring_.reset();
    recovered_copy_.clear();  // What is opened now does not hold that work.
  }
  asked.remembered_unit = settings_.unitOfFolder(asked.file);
  if (!asked.remembered_unit) {
    asked.remembered_unit = lengthUnit(
        settings_.choice(QStringLiteral("unit_without"), QString()).toString().toStdString());
  }
  document_.open(asked);
}

void MainWindow::showSurface() {
  const bool is_open = document_.isOpen();
  pages_->setCurrentIndex(is_open ? 1 : 0);
  tools_->setVisible(is_open);
  enableCommands();
  // What was open may still lie in the force loop.
  if (QAction* forces = command("forces")) forces->setEnabled(is_open && !replay_->showing());
  showBindings();
  if (!is_open) return;
  const Surface& surface = *document_.surface();
  const HeightRange heights = mapFacts(surface).heights;
  stereo_panel_->setHeights(heights.min_mm, heights.max_mm);
  whole_shown_.low_mm = heights.min_mm;
  whole_shown_.high_mm = heights.max_mm;
  view_panel_->showView(QString::fromStdString(surface.view_name));
  showTitle();
  reference_title_->setText(tr("REFERENCE"));
  reference_note_->setText(sizeText({surface.ladder.width_mm, surface.ladder.height_mm}));
}

void MainWindow::showWindow() {
  const auto window = document_.window();
  enableCommands();
  if (!window) return;
  probe_.reset();
  const int detail = document_.detail();
  const int details = document_.details();
  const double side = window->region.side_mm;
  detail_title_->setText(tr("DETAIL %1 of %2").arg(detail).arg(details));
  const double scale = handMapping(*window).objectMmPerHandMm();
  const QString scale_text = mmText(scale, scale / 10);
  QString note = QStringLiteral("%1   |   %2")
                     .arg(sizeText({side, side}), tr("1 mm of hand = %1 mm").arg(scale_text));
  if (window->gain != 1) {
    note.prepend(tr("heights \u00d7 %1   |   ").arg(numberText(window->gain, 2)));
  }
  detail_note_->setText(note);
  detail_note_->parentWidget()->updateGeometry();
  detail_choice_->setCurrentIndex(-1);
  if (detail_choice_->count() != details) {
    detail_choice_->clear();
    for (int d = 1; d <= details; ++d) {
      detail_choice_->addItem(tr("Detail %1 of %2").arg(d).arg(details), d);
    }
  }
  detail_choice_->setCurrentIndex(detail - 1);
  status_->set(StatusField::detail, tr("Detail %1/%2").arg(detail).arg(details),
               levelTip(document_.surface()->ladder, window->region.level));
  showParallax();
  shareRange();
  Q_EMIT windowShown(window);
}

void MainWindow::showBusy(bool busy) {
  if (busy) {
    status_->beginWork();
    reference_->warmUp();  // Pictures will be wanted.
    detail_->warmUp();
  } else {
    status_->endWork();
  }
}

void MainWindow::showMessage(const QString& text) {
  strip_->show(text);
}

void MainWindow::showError(const QString& text, const QString& code) {
  strip_->show(shownError(text, code));
}

QString MainWindow::message() const {
  return strip_->text();
}

void MainWindow::showFailure(const QString& message, const QString& code, const QString& file) {
  std::vector<MessageStrip::Button> buttons;
  if (code == QLatin1String("E101") && !file.isEmpty()) {
    buttons.push_back({tr("&Load what is there"), [this, file] {
                         OpenRequest request;
                         if (restoring_ && restoring_->file == file) request = *restoring_;
                         request.file = file;
                         request.accept_incomplete = true;
                         if (request.project) request.project->accept_incomplete = true;
                         open(request);
                       }});
  }
  if (!file.isEmpty()) buttons.push_back({tr("&Choose\u2026"), [this] { chooseFile(); }});
  strip_->show(code.isEmpty() ? message : QStringLiteral("%1 (%2)").arg(message, code), buttons);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  event->acceptProposedAction();
  QStringList files;
  for (const QUrl& url : urls) {
    if (url.isLocalFile()) files << droppedPath(url);
  }
  if (files.size() < urls.size()) {
    strip_->show(tr("Only files on this computer can be opened. Nothing was opened."));
  } else {
    openPaths(files);
  }
}

bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == rows_ && event->type() == QEvent::Resize) showPlots();
  if (event->type() != QEvent::KeyPress || QApplication::activeModalWidget() != nullptr ||
      QApplication::activePopupWidget() != nullptr || !watched->isWidgetType() ||
      static_cast<QWidget*>(watched)->window() != this) {
    return QMainWindow::eventFilter(watched, event);
  }
  // Escape, wherever the focus is: first the forces, then long work, then the mode.
  if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    if (stopForces()) return true;
    if (foreign_work_.cancel()) {
      announce(tr("Cancelled. Nothing was changed."));
      return true;
    }
    if (document_.busy()) {
      restoring_.reset();
      document_.cancel();
      return true;
    }
    if (video_->writing() || (closes_when_saved_ && video_->live())) {
      stayOpen();
      if (video_->writing()) video_->cancel();
      return true;
    }
    if (path_preview_->playing()) {
      path_preview_->stop();
      return true;
    }
    if (replay_->reading()) {
      replay_->cancel();
      return true;
    }
    if (measure_panel_->measuring()) {
      measure_panel_->cancel();
      return true;
    }
    if (replay_->showing()) {
      replay_->close();
      return true;
    }
    if (isFullScreen()) {
      setFullScreenDetail(false);
      return true;
    }
  }
  return QMainWindow::eventFilter(watched, event);
}

}  // namespace relievo
