// SPDX-License-Identifier: BSD-3-Clause
#include "ui/window/work_area.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "core/session/map_facts.h"
#include "ui/frame/header_row.h"
#include "ui/frame/overview_inset.h"
#include "ui/frame/side_panels.h"
#include "ui/panels/measure_panel.h"
#include "ui/panels/places_panel.h"
#include "ui/panels/replay_control.h"
#include "ui/panels/replay_panel.h"
#include "ui/panels/stereo_panel.h"
#include "ui/panels/suggest_panel.h"
#include "ui/panels/surface_panel.h"
#include "ui/panels/view_panel.h"
#include "ui/plots/profile_strip.h"
#include "ui/plots/time_plot.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/views/detail_view.h"
#include "ui/views/reference_view.h"
#include "ui/views/scan_view.h"
#include "ui/work/document.h"
#include "ui/work/settings.h"

namespace relievo {
namespace {

constexpr int kFirstHeight = 900, kPlotHeight = 140;
/// Views of fewer lines of text, their headers among them, show little: with large text and a
/// message above them the plots make room.
constexpr int kLeastViewLines = 8;

QLabel* headerLabel(const QString& name) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setContentsMargins(10, 4, 10, 4);
  label->setMinimumWidth(10);
  return label;
}

QWidget* headed(QWidget* view, QLayout* header) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(header);
  column->addWidget(view, 1);
  return box;
}

QBoxLayout* headerOf(QLabel* title, QLabel* note) {
  auto* row = new QHBoxLayout;
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(new HeaderRow(title, note), 1);
  return row;
}

}  // namespace

WorkArea::WorkArea(Document& document, RenderScheduler& turns, QWidget* parent)
    : QWidget(parent), document_(document) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  layOutViews(document, turns);
  row->addWidget(rows_, 1);
  makePanels(document);
  row->addWidget(panels_.all);
}

void WorkArea::layOutViews(Document& document, RenderScheduler& turns) {
  reference_ = new ReferenceView(document, turns);
  detail_ = new DetailView(document, turns);
  inset_ = new OverviewInset(document, detail_);
  reference_title_ = headerLabel(QStringLiteral("reference_title"));
  reference_note_ = headerLabel(QStringLiteral("reference_note"));
  detail_title_ = headerLabel(QStringLiteral("detail_title"));
  detail_note_ = headerLabel(QStringLiteral("detail_note"));
  scan_ = new ScanView(document);
  beside_ = new QStackedWidget;
  beside_->addWidget(reference_);
  beside_->addWidget(scan_);
  reference_header_ = headerOf(reference_title_, reference_note_);
  reference_box_ = headed(beside_, reference_header_);
  views_ = new QSplitter(Qt::Horizontal);
  views_->setChildrenCollapsible(false);
  views_->addWidget(reference_box_);
  views_->addWidget(headed(detail_, headerOf(detail_title_, detail_note_)));
  views_->setStretchFactor(0, 1);
  views_->setStretchFactor(1, 2);
  views_->setSizes({1000, 2000});
  plot_ = new TimePlot;
  plot_->hide();
  rows_ = new QSplitter(Qt::Vertical);
  rows_->addWidget(views_);
  rows_->addWidget(plot_);
  replay_ = new ReplayControl(document, this);
  rows_->addWidget(replay_->panel());
  profile_ = new ProfileStrip;
  profile_->hide();
  rows_->addWidget(profile_);  // Last: kept layouts know the parts by their order.
  rows_->setCollapsible(0, false);
  rows_->setStretchFactor(0, 1);
  rows_->setStretchFactor(1, 0);
  rows_->setStretchFactor(2, 0);
  rows_->setStretchFactor(3, 0);
  rows_->setSizes({kFirstHeight, kPlotHeight, kPlotHeight, kPlotHeight});
}

void WorkArea::makePanels(Document& document) {
  panels_.all = new SidePanels(this);
  panels_.surface = new SurfacePanel(document);
  panels_.region = new RegionPanel(document);
  panels_.view = new ViewPanel;
  panels_.stereo = new StereoPanel;
  panels_.measure = new MeasurePanel(document);
  panels_.places = new PlacesPanel(document);
  panels_.suggestions = new SuggestPanel(document);
  // What everybody needs first; then what modules add, and what is opened when it is wanted.
  panels_.all->add(tr("Scan"), panels_.surface);
  panels_.all->add(tr("View"), panels_.view);
  panels_.all->add(tr("Window"), panels_.region);
  panels_.all->add(tr("Light"), panels_.view->lightPart());
  panels_.all->add(tr("Measure"), panels_.measure);
  panels_.all->keepPlaceHere();
  panels_.all->add(tr("Stereo"), panels_.stereo);
  panels_.all->add(tr("Bookmarks"), panels_.places);
  panels_.all->add(tr("Suggestions"), panels_.suggestions);
}

const QObject* WorkArea::rows() const {
  return rows_;
}

void WorkArea::showMapTitle() {
  const DetailLadder& ladder = document_.surface()->ladder;
  reference_title_->setText(beside_->currentWidget() == scan_ ? tr("SCAN") : tr("OVERVIEW"));
  reference_note_->setText(sizeText({ladder.width_mm, ladder.height_mm}));
}

void WorkArea::showWindowTitle() {
  const auto window = document_.window();
  const double side = window->region.side_mm;
  detail_title_->setText(
      tr("DETAIL   |   Resolution %1 of %2").arg(document_.detail()).arg(document_.details()));
  const double scale = handMapping(*window).objectMmPerHandMm();
  const QString scale_text = mmText(scale, scale / 10);
  QString note = QStringLiteral("%1   |   %2")
                     .arg(sizeText({side, side}), tr("hand scale 1 : %1").arg(scale_text));
  if (window->gain != 1) {
    note.prepend(tr("heights \u00d7 %1   |   ").arg(numberText(window->gain, 2)));
  }
  detail_note_->setText(note);
  detail_note_->parentWidget()->updateGeometry();
}

void WorkArea::showPlots(bool curve_wanted, bool plots_wanted) {
  const int least = kLeastViewLines * fontMetrics().height();
  int views = rows_->height() - profile_->minimumSizeHint().height() - rows_->handleWidth();
  const bool has_curve = curve_wanted && !profile_->isEmpty() && views >= least;
  profile_->setVisible(has_curve);
  if (!has_curve) views = rows_->height();
  views -= plot_->minimumSizeHint().height() + rows_->handleWidth();
  plot_->setVisible(plots_wanted && views >= least);
}

void WorkArea::showReference(bool on) {
  reference_box_->setVisible(on);
}

void WorkArea::showScan(bool on) {
  beside_->setCurrentWidget(on ? static_cast<QWidget*>(scan_) : reference_);
  if (document_.isOpen()) showMapTitle();
}

QWidget& WorkArea::besideDetail() {
  return *beside_->currentWidget();
}

void WorkArea::addSwitch(QWidget* widget) {
  reference_header_->addWidget(widget, 0, Qt::AlignTop);
}

void WorkArea::showInset(bool on) {
  inset_->setVisible(on);
}

void WorkArea::takeColours() {
  const ThemeColours& c = currentColours();
  reference_->setBackground(c.viewport);
  detail_->setBackground(c.viewport);
  scan_->takeColours();
  plot_->takeColours();
  profile_->takeColours();
  replay_->panel()->takeColours();
  for (QLabel* label : {reference_title_, reference_note_, detail_title_, detail_note_}) {
    QPalette quiet = label->palette();
    quiet.setColor(QPalette::WindowText, c.quiet_text);
    label->setPalette(quiet);
  }
}

void WorkArea::saveTo(Settings& settings) const {
  settings.setLayout(QStringLiteral("views"), views_->saveState());
  settings.setLayout(QStringLiteral("rows"), rows_->saveState());
  settings.setLayout(QStringLiteral("folds"), panels_.all->folds());
}

void WorkArea::restoreFrom(const Settings& settings) {
  views_->restoreState(settings.layout(QStringLiteral("views")).toByteArray());
  rows_->restoreState(settings.layout(QStringLiteral("rows")).toByteArray());
  panels_.all->setFolds(settings.layout(QStringLiteral("folds")).toStringList());
}

}  // namespace relievo
