// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_views.h"

#include <array>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/prepare/prepare_widgets.h"
#include "ui/style/text.h"
#include "ui/work/surface_work.h"

namespace relievo {
namespace {

constexpr std::array<const char*, 6> kSides{"front", "back", "left", "right", "top", "bottom"};

QWidget* titled(QLabel* title, CloudView* view) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(title);
  column->addWidget(view, 1);
  return box;
}

}  // namespace

PrepareViews::PrepareViews(QWidget* below) {
  QWidget* views = makeViews();
  connectViews();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(lookRow());
  column->addWidget(views, 4);
  column->addWidget(below, 1);
}

PrepareViews::~PrepareViews() {
  painter_.disconnect();
}

QWidget* PrepareViews::makeViews() {
  scan_ = new CloudView(tr("Points"));
  scan_->setObjectName(QStringLiteral("prepare_cloud"));
  scan_->setToolTip(
      tr("Drag or arrow keys turn, the right button moves, the wheel or + and - bring "
         "it nearer, Home shows all"));
  reference_ = new CloudView(tr("Points of the reference"));
  reference_->setObjectName(QStringLiteral("prepare_reference_cloud"));
  scan_title_ = new QLabel;
  reference_title_ = new QLabel;
  for (QLabel* title : {scan_title_, reference_title_}) title->setWordWrap(true);
  reference_box_ = titled(reference_title_, reference_);
  auto* views = new QSplitter(Qt::Horizontal);
  views->setChildrenCollapsible(false);
  views->addWidget(titled(scan_title_, scan_));
  views->addWidget(reference_box_);
  scan_title_->hide();
  reference_box_->hide();
  return views;
}

void PrepareViews::connectViews() {
  for (CloudView* view : {scan_, reference_}) {
    connect(view, &CloudView::said, this, &PrepareViews::said);
    connect(view, &CloudView::toolLeft, this, &PrepareViews::toolLeft);
    connect(view, &CloudView::pointChosen, this, [this, view](const FilePoint& point) {
      Q_EMIT pointChosen(view == reference_, point);
    });
  }
  connect(scan_, &CloudView::outlineDrawn, this, &PrepareViews::outlineDrawn);
}

QBoxLayout* PrepareViews::lookRow() {
  auto* row = new QHBoxLayout;
  QStringList sides;
  for (const char* side : kSides) sides << viewText(QString::fromLatin1(side));
  side_ = prepareChoice(tr("Seen &from:"), "prepare_side",
                        tr("From which side the points are seen"), row, sides);
  for (int i = 0; i < side_->count(); ++i) {
    side_->setItemData(i, QString::fromLatin1(kSides[static_cast<std::size_t>(i)]));
  }
  stage_ = prepareChoice(tr("Sho&w:"), "prepare_stage", tr("Points before and after the steps"),
                         row, {tr("Before"), tr("Both, red goes"), tr("After")});
  stage_->setCurrentIndex(static_cast<int>(CloudStage::both));
  colour_ =
      prepareChoice(tr("Co&lours:"), "prepare_colour", tr("What the colours of the points say"),
                    row, {tr("Their own"), tr("One for each scan"), tr("Distance of the scans")});
  colour_->setItemData(2,
                       tr("From the surface of the other scans: blue at 0, red at three "
                          "spacings, grey where there is none"),
                       Qt::ToolTipRole);
  row->addStretch(1);
  connect(side_, QOverload<int>::of(&QComboBox::activated), this, &PrepareViews::lookFromSide);
  for (QComboBox* box : {stage_, colour_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            &PrepareViews::looksChanged);
  }
  return row;
}

CloudColour PrepareViews::colour() const {
  return static_cast<CloudColour>(colour_->currentIndex());
}

void PrepareViews::lookFromSide(int side) {
  const Rotation view = *standardRotation(kSides[static_cast<std::size_t>(side)]);
  scan_->look(view);
  if (reference_box_->isVisible()) reference_->look(view);
}

void PrepareViews::look(const Rotation& view) {
  scan_->look(view);
  reference_->look(view);
  side_->setCurrentIndex(side_->findData(QString::fromStdString(nameOf(view))));
}

void PrepareViews::showResult(const std::shared_ptr<const PrepareResult>& result) {
  if (!result || beside_) return;
  const CloudWish wish{static_cast<CloudStage>(stage_->currentIndex()), colour()};
  const auto cloud = std::make_shared<CloudPoints>();
  painter_.start(
      [cloud, wish, result](const Task& task) {
        outcomeOf([&] {
          *cloud = cloudOf(*result, wish, task);
          return std::shared_ptr<const Surface>();
        });
      },
      [this, cloud] {
        if (!beside_) scan_->setCloud(cloud);
        Q_EMIT pictureShown();
      });
}

void PrepareViews::showBeside(const QString& scan_title, const ReadScan& scan,
                              const QString& reference_title, const ReadScan& reference) {
  beside_ = true;
  painter_.cancel();
  scan_->setBox(std::nullopt);
  scan_title_->setText(scan_title);
  reference_title_->setText(reference_title);
  scan_title_->show();
  reference_box_->show();
  scan_->setCloud(std::make_shared<const CloudPoints>(cloudOf(scan)));
  reference_->setCloud(std::make_shared<const CloudPoints>(cloudOf(reference)));
  for (CloudView* view : {scan_, reference_}) {
    view->fit();
    view->setTool(CloudView::Tool::point);
  }
  scan_->setFocus();
}

void PrepareViews::endBeside() {
  beside_ = false;
  for (CloudView* view : {scan_, reference_}) {
    view->setTool(CloudView::Tool::turn);
    view->setMarks({});
  }
  scan_title_->hide();
  reference_box_->hide();
}

}  // namespace relievo
