// SPDX-License-Identifier: BSD-3-Clause
#include "ui/side_panels.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace relievo {
namespace {
constexpr int kWidth = 280;
}

SidePanels::SidePanels(QWidget* parent) : QScrollArea(parent) {
  setObjectName(QStringLiteral("side_panels"));
  setAccessibleName(tr("Panels"));
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(QFrame::NoFrame);
  setFixedWidth(kWidth);
  setFocusPolicy(Qt::NoFocus);
  auto* content = new QWidget(this);
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(8, 6, 8, 6);
  column_->setSpacing(4);
  column_->addStretch(1);
  setWidget(content);
}

void SidePanels::add(const QString& title, QWidget* panel) {
  auto* header = new QToolButton(widget());
  header->setText(title);
  header->setToolTip(tr("Show or hide %1").arg(title));
  header->setAccessibleName(tr("%1 panel").arg(title));
  header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header->setAutoRaise(true);
  header->setArrowType(Qt::DownArrow);
  header->setFocusPolicy(Qt::StrongFocus);
  QFont font = header->font();
  font.setBold(true);
  header->setFont(font);
  header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(header, &QToolButton::clicked, panel, [header, panel] {
    const bool open = panel->isHidden();
    header->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    panel->setVisible(open);
  });
  const int end = column_->count() - 1;  // Before the stretch.
  column_->insertWidget(end, header);
  column_->insertWidget(end + 1, panel);
  headers_.push_back(header);
}

QStringList SidePanels::titles() const {
  QStringList titles;
  for (const QToolButton* header : headers_) titles << header->text();
  return titles;
}

}  // namespace relievo
