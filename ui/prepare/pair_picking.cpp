// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/pair_picking.h"

#include <algorithm>

#include "core/prepare/align/align_picks.h"
#include "ui/message/message_text.h"
#include "ui/prepare/prepare_report.h"
#include "ui/prepare/prepare_views.h"
#include "ui/prepare/read_scans.h"
#include "ui/prepare/scan_list.h"
#include "ui/style/text.h"

namespace relievo {

PickedPlaces::PickedPlaces(std::size_t input, const std::vector<PickedPair>& pairs)
    : input_(input) {
  for (const PickedPair& pair : pairs) {
    if (pair.scan != input) continue;
    on_scan_.push_back(pair.point);
    on_reference_.push_back(pair.reference);
    order_.insert(order_.end(), {false, true});
  }
}

std::vector<PickedPair> PickedPlaces::pairs() const {
  std::vector<PickedPair> pairs;
  for (std::size_t i = 0; i < std::min(on_scan_.size(), on_reference_.size()); ++i) {
    pairs.push_back({.scan = static_cast<std::uint32_t>(input_),
                     .point = on_scan_[i],
                     .reference = on_reference_[i]});
  }
  return pairs;
}

void PickedPlaces::place(bool on_reference, const FilePoint& point) {
  auto& places = on_reference ? on_reference_ : on_scan_;
  const auto& others = on_reference ? on_scan_ : on_reference_;
  if (places.size() > others.size()) {
    places.back() = point;
  } else {
    places.push_back(point);
    order_.push_back(on_reference);
  }
}

bool PickedPlaces::takeBack() {
  if (order_.empty()) return false;
  (order_.back() ? on_reference_ : on_scan_).pop_back();
  order_.pop_back();
  return true;
}

void PickedPlaces::removePair(std::size_t pair) {
  for (const bool on_reference : {false, true}) {
    auto& places = on_reference ? on_reference_ : on_scan_;
    places.erase(places.begin() + static_cast<std::ptrdiff_t>(pair));
    // Of the places on this side that one was placed then.
    auto placed = order_.begin();
    for (std::size_t left = pair; *placed != on_reference || left-- > 0;) ++placed;
    order_.erase(placed);
  }
}

PairPicking::PairPicking(PrepareState& state, const ReadScans& reads, ScanList& list,
                         PrepareViews& views, PrepareReport& report)
    : state_(state), reads_(reads), list_(list), views_(views), report_(report) {
  connect(&list, &ScanList::pickToggled, this, &PairPicking::toggle);
  connect(&list, &ScanList::takeBackAsked, this, &PairPicking::takeBack);
  connect(&list, &ScanList::removePairAsked, this, &PairPicking::removePair);
  connect(&views, &PrepareViews::pointChosen, this, &PairPicking::place);
}

void PairPicking::toggle() {
  if (isOn()) {
    end();
  } else {
    begin();
  }
}

void PairPicking::begin() {
  const auto at = state_.alignStep();
  const std::size_t input = list_.chosen();
  const std::size_t reference = state_.reference();
  if (!at || input == reference) return;
  const auto& inputs = state_.now().inputs;
  const auto scan = reads_.held(inputs[input]);
  const auto laid_on = reads_.held(inputs[reference]);
  if (!scan || !laid_on) {
    Q_EMIT said(tr("The scans are still being read"));
    return;
  }
  picked_.emplace(input, std::get<Align>(state_.now().steps[*at].step).pairs);
  list_.setPicking(true);
  views_.showBeside(tr("Scan %1: %2").arg(input + 1).arg(reads_.nameOf(inputs[input])), *scan,
                    tr("Reference: %1").arg(reads_.nameOf(inputs[reference])), *laid_on);
  Q_EMIT began();
  show();
  sayNext();
}

void PairPicking::end() {
  if (!picked_) return;
  const PickedPlaces picked = *std::exchange(picked_, std::nullopt);
  list_.setPicking(false);
  views_.endBeside();
  PrepareChoices next = state_.now();
  auto& align = std::get<Align>(next.steps[*state_.alignStep()].step);
  const std::vector<PickedPair> pairs = picked.pairs();
  std::erase_if(align.pairs, [&](const PickedPair& pair) { return pair.scan == picked.input(); });
  align.pairs.insert(align.pairs.end(), pairs.begin(), pairs.end());
  if (!pairs.empty()) align.method = AlignMethod::points;
  align.reference = static_cast<std::uint32_t>(state_.reference());
  state_.change(std::move(next));
  Q_EMIT ended();
}

void PairPicking::place(bool on_reference, const FilePoint& point) {
  if (!picked_) return;
  picked_->place(on_reference, point);
  show();
  sayNext();
}

void PairPicking::takeBack() {
  if (!picked_ || !picked_->takeBack()) return;
  show();
  sayNext();
}

void PairPicking::removePair() {
  const int row = list_.chosenPair();
  if (!picked_ || row < 0) return;
  picked_->removePair(static_cast<std::size_t>(row));
  show();
  sayNext();
}

void PairPicking::sayNext() {
  const bool on_scan = picked_->onScan().size() <= picked_->onReference().size();
  (on_scan ? views_.scan() : views_.reference()).setFocus();
  const QStringList texts{nextText(), fitText()};
  report_.showAdvice(texts.join('\n').trimmed());
  Q_EMIT said(texts.join(' ').trimmed());
}

QString PairPicking::nextText() const {
  const std::size_t a = picked_->onScan().size(), b = picked_->onReference().size();
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
QString PairPicking::fitText() const {
  const std::vector<PickedPair> pairs = picked_->pairs();
  if (pairs.size() < 3) return {};
  const PrepareInput& input = state_.now().inputs[picked_->input()];
  const auto problem = align::pickProblem(pairs, reads_.nameOf(input).toStdString());
  if (problem) return messageText(*problem);
  const align::PickedFit fit = align::fitPicks(pairs, {});
  const auto worst = std::max_element(fit.errors.begin(), fit.errors.end());
  const double mm = mmPer(reads_.unitOf(input));
  return tr("They fit to %1 mm; pair %2 fits worst, %3 mm.")
      .arg(numberText(mm * fit.error, 3))
      .arg(worst - fit.errors.begin() + 1)
      .arg(numberText(mm * *worst, 3));
}

void PairPicking::show() {
  if (!picked_) return;
  const auto marks = [](const std::vector<FilePoint>& places) {
    std::vector<CloudView::Mark> list;
    for (std::size_t i = 0; i < places.size(); ++i) {
      list.push_back({places[i], QString::number(i + 1)});
    }
    return list;
  };
  views_.scan().setMarks(marks(picked_->onScan()));
  views_.reference().setMarks(marks(picked_->onReference()));
  showPairs();
}

void PairPicking::showPairs() {
  const std::vector<PickedPair> pairs = picked_->pairs();
  std::vector<double> errors;
  if (!align::pickProblem(pairs, {})) errors = align::fitPicks(pairs, {}).errors;
  list_.showPairs(pairs.size(), errors,
                  mmPer(reads_.unitOf(state_.now().inputs[picked_->input()])));
}

}  // namespace relievo
