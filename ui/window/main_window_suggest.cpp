// SPDX-License-Identifier: BSD-3-Clause
// Windows that are worth touching: the panel, and their frames in the overview.
#include <QAction>

#include "ui/frame/side_panels.h"
#include "ui/frame/status_fields.h"
#include "ui/panels/suggest_panel.h"
#include "ui/views/reference_view.h"
#include "ui/window/main_window.h"

namespace relievo {

void MainWindow::makeSuggestCommand() {
  make({"suggest_windows",
        tr("&Suggest windows"),
        {QKeySequence("Ctrl+Shift+F")},
        tr("Rank windows by how much of their relief a hand feels"),
        [this] {
          command("show_panels")->setChecked(true);
          panels_->reveal(suggest_panel_);
          suggest_panel_->find();
        },
        {}});
}

void MainWindow::connectSuggestions() {
  connect(suggest_panel_, &SuggestPanel::said, this, &MainWindow::announce);
  connect(suggest_panel_, &SuggestPanel::busyChanged, this, &MainWindow::showBusy);
  connect(suggest_panel_, &SuggestPanel::progressed, status_, &StatusFields::showWork);
  connect(status_, &StatusFields::cancelAsked, suggest_panel_, &SuggestPanel::cancel);
  connect(suggest_panel_, &SuggestPanel::shownChanged, this, [this] {
    std::vector<SuggestedFrame> frames;
    if (suggest_panel_->overlayWanted()) {
      for (const FeelableWindow& w : suggest_panel_->windows()) {
        const Region& r = w.region;
        const bool is_current = static_cast<int>(frames.size()) == suggest_panel_->current();
        frames.push_back({{r.x_mm, r.y_mm, r.side_mm, r.side_mm}, is_current});
      }
    }
    reference_->setSuggestions(frames);
  });
}

}  // namespace relievo
