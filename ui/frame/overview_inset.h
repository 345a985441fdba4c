// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

#include "ui/work/document.h"

namespace relievo {

/// A small plan over the full-screen detail view: the map's outline and the pink window on it.
/// [GUI thread]
class OverviewInset : public QWidget {
  Q_OBJECT
 public:
  OverviewInset(Document& document, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Document& document_;
};

}  // namespace relievo
