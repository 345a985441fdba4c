// SPDX-License-Identifier: BSD-3-Clause
// What is chosen on the views of the dialog Prepare: pairs of places, and outlines.
#include <algorithm>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "ui/prepare/prepare_dialog.h"
#include "ui/prepare/step_form.h"
#include "ui/text.h"

namespace relievo {
void PrepareDialog::beginPicking() {
  const auto at = state_.alignStep();
  const std::size_t input = chosenScan();
  const std::size_t reference = state_.reference();
  if (!at || input == reference) return;
  const auto scan = heldReadOf(state_.now().inputs[input]);
  const auto laid_on = heldReadOf(state_.now().inputs[reference]);
  if (!scan || !laid_on) {
    Q_EMIT said(tr("The scans are still being read"));
    return;
  }
  pick_ = Pick{.input = input, .on_scan = {}, .on_reference = {}, .order = {}};
  for (const PickedPair& pair : std::get<Align>(state_.now().steps[*at].step).pairs) {
    if (pair.scan != input) continue;
    pick_->on_scan.push_back(pair.point);
    pick_->on_reference.push_back(pair.reference);
    pick_->order.insert(pick_->order.end(), {false, true});
  }
  painter_.cancel();
  view_->setBox(std::nullopt);
  view_title_->setText(tr("Scan %1: %2").arg(input + 1).arg(nameOf(state_.now().inputs[input])));
  other_title_->setText(tr("Reference: %1").arg(nameOf(state_.now().inputs[reference])));
  view_title_->show();
  other_box_->show();
  view_->setCloud(std::make_shared<const CloudPoints>(cloudOf(*scan)));
  other_view_->setCloud(std::make_shared<const CloudPoints>(cloudOf(*laid_on)));
  view_->fit();
  other_view_->fit();
  for (CloudView* view : {view_, other_view_}) view->setTool(CloudView::Tool::point);
  view_->setFocus();
  showNumbers();
  showPicks();
  sayNextPick();
}

void PrepareDialog::endPicking() {
  if (!pick_) return;
  const Pick pick = *std::exchange(pick_, std::nullopt);
  for (CloudView* view : {view_, other_view_}) {
    view->setTool(CloudView::Tool::turn);
    view->setMarks({});
  }
  view_title_->hide();
  other_box_->hide();
  PrepareChoices next = state_.now();
  auto& align = std::get<Align>(next.steps[*state_.alignStep()].step);
  const auto scan = static_cast<std::uint32_t>(pick.input);
  std::erase_if(align.pairs, [&](const PickedPair& pair) { return pair.scan == scan; });
  const std::size_t whole = std::min(pick.on_scan.size(), pick.on_reference.size());
  for (std::size_t i = 0; i < whole; ++i) {
    align.pairs.push_back(
        {.scan = scan, .point = pick.on_scan[i], .reference = pick.on_reference[i]});
  }
  if (whole > 0) align.method = AlignMethod::points;
  align.reference = static_cast<std::uint32_t>(state_.reference());
  state_.change(std::move(next));
  showPicture();
  view_->fit();
  choicesChanged();
}

void PrepareDialog::placePick(bool on_reference, const FilePoint& point) {
  if (!pick_) return;
  auto& places = on_reference ? pick_->on_reference : pick_->on_scan;
  const auto& others = on_reference ? pick_->on_scan : pick_->on_reference;
  if (places.size() > others.size()) {
    places.back() = point;  // The same place once more: a better try.
  } else {
    places.push_back(point);
    pick_->order.push_back(on_reference);
  }
  showPicks();
  sayNextPick();
}

void PrepareDialog::takeBackPick() {
  if (!pick_ || pick_->order.empty()) return;
  (pick_->order.back() ? pick_->on_reference : pick_->on_scan).pop_back();
  pick_->order.pop_back();
  showPicks();
  sayNextPick();
}

void PrepareDialog::sayNextPick() {
  if (!pick_) return;
  const std::size_t a = pick_->on_scan.size(), b = pick_->on_reference.size();
  const std::size_t whole = std::min(a, b);
  QString text;
  if (a > b) {
    text = tr("Now place %1 on the reference").arg(b + 1);
    other_view_->setFocus();
  } else if (b > a) {
    text = tr("Now place %1 on the scan").arg(a + 1);
    view_->setFocus();
  } else if (whole < 3) {
    text = tr("Choose place %1 on the scan, then the same on the reference").arg(whole + 1);
    view_->setFocus();
  } else {
    text = tr("%n pair(s). Escape or the button ends; more pairs do no harm.", nullptr,
              static_cast<int>(whole));
    view_->setFocus();
  }
  words_->setText(text);
  Q_EMIT said(text);
}

void PrepareDialog::showPicks() {
  if (!pick_) return;
  const auto marks = [](const std::vector<FilePoint>& places) {
    std::vector<CloudView::Mark> list;
    for (std::size_t i = 0; i < places.size(); ++i) {
      list.push_back({places[i], QString::number(i + 1)});
    }
    return list;
  };
  view_->setMarks(marks(pick_->on_scan));
  other_view_->setMarks(marks(pick_->on_reference));
}

void PrepareDialog::drawOutline() {
  if (pick_) return;
  view_->setTool(CloudView::Tool::outline);
  view_->setFocus();
  Q_EMIT said(tr("Arrow keys carry the cross, Enter sets a corner, Ctrl+Enter closes the outline"));
  words_->setText(
      tr("Drag the mouse round what is meant, or set corners with Enter; Ctrl+Enter closes."));
}

void PrepareDialog::takeOutline(const CloudView::Outline& outline) {
  const auto at = chosenStep();
  view_->setTool(CloudView::Tool::turn);
  const auto* const chosen = at ? std::get_if<CropOutline>(&state_.now().steps[*at].step) : nullptr;
  if (chosen == nullptr) return;
  PrepareChoices next = state_.now();
  auto& step = std::get<CropOutline>(next.steps[*at].step);
  step.view = outline.view;
  step.outline = outline.corners;
  state_.change(std::move(next));
  choicesChanged();
}

void PrepareDialog::showOutline() {
  const auto at = chosenStep();
  const auto* const outline =
      at && !pick_ ? std::get_if<CropOutline>(&state_.now().steps[*at].step) : nullptr;
  if (outline == nullptr || outline->outline.empty()) {
    view_->setOutline(std::nullopt);
  } else {
    view_->setOutline(CloudView::Outline{outline->view, outline->outline});
  }
}

}  // namespace relievo
