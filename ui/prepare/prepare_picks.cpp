// SPDX-License-Identifier: BSD-3-Clause
// What is chosen on the views of the dialog Prepare: pairs of places, and outlines.
#include <algorithm>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include "core/prepare/align/align_picks.h"
#include "ui/message/message_text.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/prepare/step_form.h"
#include "ui/style/text.h"

namespace relievo {

std::vector<PickedPair> PrepareDialog::Pick::pairs() const {
  std::vector<PickedPair> pairs;
  for (std::size_t i = 0; i < std::min(on_scan.size(), on_reference.size()); ++i) {
    pairs.push_back({.scan = static_cast<std::uint32_t>(input),
                     .point = on_scan[i],
                     .reference = on_reference[i]});
  }
  return pairs;
}

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
  const std::vector<PickedPair> pairs = pick.pairs();
  std::erase_if(align.pairs, [&](const PickedPair& pair) { return pair.scan == pick.input; });
  align.pairs.insert(align.pairs.end(), pairs.begin(), pairs.end());
  if (!pairs.empty()) align.method = AlignMethod::points;
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

void PrepareDialog::removePair() {
  const int row = pairs_->indexOfTopLevelItem(pairs_->currentItem());
  if (!pick_ || row < 0) return;
  for (const bool on_reference : {false, true}) {
    auto& places = on_reference ? pick_->on_reference : pick_->on_scan;
    places.erase(places.begin() + row);
    // Of the places on this side the row-th was placed then.
    auto placed = pick_->order.begin();
    for (int left = row; *placed != on_reference || left-- > 0;) ++placed;
    pick_->order.erase(placed);
  }
  showPicks();
  sayNextPick();
}

void PrepareDialog::sayNextPick() {
  if (!pick_) return;
  const bool on_scan = pick_->on_scan.size() <= pick_->on_reference.size();
  (on_scan ? view_ : other_view_)->setFocus();
  const QStringList texts{nextPickText(), pairsText()};
  words_->setText(texts.join('\n').trimmed());
  Q_EMIT said(texts.join(' ').trimmed());
}

QString PrepareDialog::nextPickText() const {
  const std::size_t a = pick_->on_scan.size(), b = pick_->on_reference.size();
  const std::size_t whole = std::min(a, b);
  if (a > b) return tr("Now place %1 on the reference").arg(b + 1);
  if (b > a) return tr("Now place %1 on the scan").arg(a + 1);
  if (whole < 3) {
    return tr("Choose place %1 on the scan, then the same on the reference").arg(whole + 1);
  }
  return tr("%n pair(s). Escape or the button ends; more pairs do no harm.", nullptr,
            static_cast<int>(whole));
}

/// How well the pairs go together, or why they say no pose.
QString PrepareDialog::pairsText() const {
  const std::vector<PickedPair> pairs = pick_->pairs();
  if (pairs.size() < 3) return {};
  const PrepareInput& input = state_.now().inputs[pick_->input];
  const auto problem = align::pickProblem(pairs, nameOf(input).toStdString());
  if (problem) return messageText(*problem);
  const align::PickedFit fit = align::fitPicks(pairs, {});
  const auto worst = std::max_element(fit.errors.begin(), fit.errors.end());
  const double mm = mmPer(unitOf(input));
  return tr("They fit to %1 mm; pair %2 fits worst, %3 mm.")
      .arg(numberText(mm * fit.error, 3))
      .arg(worst - fit.errors.begin() + 1)
      .arg(numberText(mm * *worst, 3));
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
  showPairs();
}

void PrepareDialog::showPairs() {
  const std::vector<PickedPair> pairs = pick_->pairs();
  std::vector<double> errors;
  if (!align::pickProblem(pairs, {})) errors = align::fitPicks(pairs, {}).errors;
  const auto worst = std::max_element(errors.begin(), errors.end());
  const double mm = mmPer(unitOf(state_.now().inputs[pick_->input]));
  const int chosen = pairs_->indexOfTopLevelItem(pairs_->currentItem());
  pairs_->clear();
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    auto* item = new QTreeWidgetItem(pairs_);
    item->setText(0, tr("Pair %1").arg(i + 1));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    if (errors.empty()) continue;
    const bool is_worst = worst == errors.begin() + static_cast<std::ptrdiff_t>(i);
    const QString error = numberText(mm * errors[i], 3);
    item->setText(1, is_worst ? tr("%1 mm, worst").arg(error) : tr("%1 mm").arg(error));
    QFont font = item->font(0);
    font.setBold(is_worst);
    for (const int column : {0, 1}) item->setFont(column, font);
  }
  if (!pairs.empty()) {
    pairs_->setCurrentItem(
        pairs_->topLevelItem(std::clamp(chosen, 0, static_cast<int>(pairs.size()) - 1)));
  }
  remove_pair_->setEnabled(!pairs.empty());
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
