// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/prepare_state.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace relievo {
namespace {

constexpr std::size_t kMostHistory = 250;

std::optional<std::size_t> alignIn(const std::vector<PrepareStep>& steps) {
  const auto found = std::find_if(steps.begin(), steps.end(), [](const PrepareStep& s) {
    return std::holds_alternative<Align>(s.step);
  });
  if (found == steps.end()) return std::nullopt;
  return static_cast<std::size_t>(found - steps.begin());
}

/// Where Align, or the end of what comes before it, belongs.
std::size_t endOfFirstPart(const std::vector<PrepareStep>& steps) {
  if (const auto align = alignIn(steps)) return *align;
  std::size_t end = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (comesBeforeAlign(steps[i].step)) end = i + 1;
  }
  return end;
}

void insert(std::vector<PrepareStep>& steps, std::size_t at, const Step& step) {
  steps.insert(steps.begin() + static_cast<std::ptrdiff_t>(at), PrepareStep{step, true});
}

/// With one more or one less input, numbers behind it shift.
void forget(Align& align, std::uint32_t input) {
  const auto shifted = [&](std::uint32_t n) { return n > input ? n - 1 : n; };
  if (align.reference == input) {
    align.reference = 0;
    align.pairs.clear();  // Their other halves were picked on it.
  }
  std::erase_if(align.pairs, [&](const PickedPair& pair) { return pair.scan == input; });
  align.reference = shifted(align.reference);
  for (PickedPair& pair : align.pairs) pair.scan = shifted(pair.scan);
}

/// Up to Align, without poses.
std::vector<Step> beginningOf(const Recipe& recipe) {
  std::vector<Step> beginning;
  for (const Step& step : recipe.steps) {
    beginning.push_back(step);
    if (auto* const align = std::get_if<Align>(&beginning.back())) {
      align->poses.clear();
      break;
    }
  }
  return beginning;
}

std::vector<PrepareInput> usedOf(const PrepareChoices& choices) {
  std::vector<PrepareInput> used;
  std::copy_if(choices.inputs.begin(), choices.inputs.end(), std::back_inserter(used),
               [](const PrepareInput& input) { return input.used; });
  return used;
}

}  // namespace

bool comesBeforeAlign(const Step& step) noexcept {
  return !std::holds_alternative<Thin>(step) && !std::holds_alternative<Base>(step) &&
         !std::holds_alternative<Normals>(step) && !std::holds_alternative<Align>(step);
}

PrepareState::PrepareState(PrepareChoices first) : history_{PrepareChoices{}} {
  history_[0].steps = std::move(first.steps);
  addInputs(first.inputs);
  history_ = {now()};
  at_ = 0;
}

void PrepareState::change(PrepareChoices next, int merge) {
  if (next == now()) return;
  const bool merges = merge != 0 && merge == merge_ && at_ + 1 == history_.size() && at_ > 0;
  merge_ = merge;
  if (merges) {
    history_[at_] = std::move(next);
    return;
  }
  history_.resize(at_ + 1);
  history_.push_back(std::move(next));
  if (history_.size() > kMostHistory) history_.erase(history_.begin());
  at_ = history_.size() - 1;
}

bool PrepareState::undo() {
  if (!canUndo()) return false;
  --at_;
  merge_ = 0;
  return true;
}

bool PrepareState::redo() {
  if (!canRedo()) return false;
  ++at_;
  merge_ = 0;
  return true;
}

std::size_t PrepareState::addStep(const Step& step) {
  PrepareChoices next = now();
  const std::size_t at = comesBeforeAlign(step) ? endOfFirstPart(next.steps) : next.steps.size();
  insert(next.steps, at, step);
  change(std::move(next));
  return at;
}

void PrepareState::removeStep(std::size_t step) {
  PrepareChoices next = now();
  next.steps.erase(next.steps.begin() + static_cast<std::ptrdiff_t>(step));
  change(std::move(next));
}

bool PrepareState::moveStep(std::size_t step, int by) {
  PrepareChoices next = now();
  const auto to = static_cast<std::ptrdiff_t>(step) + by;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(next.steps.size())) return false;
  std::swap(next.steps[step], next.steps[static_cast<std::size_t>(to)]);
  change(std::move(next));
  return true;
}

void PrepareState::addInputs(const std::vector<PrepareInput>& inputs) {
  PrepareChoices next = now();
  next.inputs.insert(next.inputs.end(), inputs.begin(), inputs.end());
  if (next.inputs.size() > 1 && !alignIn(next.steps)) {
    insert(next.steps, endOfFirstPart(next.steps), Align{});
  }
  change(std::move(next));
}

void PrepareState::splitInput(std::size_t input, int parts) {
  PrepareChoices next = now();
  const PrepareInput whole = next.inputs[input];
  const auto at = next.inputs.begin() + static_cast<std::ptrdiff_t>(input);
  std::vector<PrepareInput> each;
  for (int part = 1; part <= parts; ++part) {
    each.push_back(whole);
    each.back().read.parts = {part};
  }
  next.inputs.insert(next.inputs.erase(at), each.begin(), each.end());
  if (!alignIn(next.steps)) insert(next.steps, endOfFirstPart(next.steps), Align{});
  // Places picked on the whole file are on one of its scans, but nobody said on which.
  auto& align = std::get<Align>(next.steps[*alignIn(next.steps)].step);
  const auto shift = static_cast<std::uint32_t>(parts - 1);
  const bool was_reference = align.reference == input;
  std::erase_if(align.pairs, [&](const PickedPair& p) { return was_reference || p.scan == input; });
  for (PickedPair& pair : align.pairs) pair.scan += pair.scan > input ? shift : 0;
  align.reference += align.reference > input ? shift : 0;
  change(std::move(next));
}

void PrepareState::removeInput(std::size_t input) {
  PrepareChoices next = now();
  next.inputs.erase(next.inputs.begin() + static_cast<std::ptrdiff_t>(input));
  if (const auto at = alignIn(next.steps)) {
    if (next.inputs.size() < 2) {
      next.steps.erase(next.steps.begin() + static_cast<std::ptrdiff_t>(*at));
    } else {
      forget(std::get<Align>(next.steps[*at].step), static_cast<std::uint32_t>(input));
    }
  }
  change(std::move(next));
}

std::optional<std::size_t> PrepareState::alignStep() const {
  return alignIn(now().steps);
}

std::vector<std::size_t> PrepareState::usedInputs() const {
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < now().inputs.size(); ++i) {
    if (now().inputs[i].used) used.push_back(i);
  }
  return used;
}

std::size_t PrepareState::reference() const {
  const auto at = alignStep();
  const std::size_t chosen = at ? std::get<Align>(now().steps[*at].step).reference : 0;
  if (chosen < now().inputs.size() && now().inputs[chosen].used) return chosen;
  const auto used = usedInputs();
  return used.empty() ? 0 : used.front();
}

Recipe PrepareState::recipeWithoutPoses() const {
  const std::vector<std::size_t> used = usedInputs();
  const auto number = [&](std::size_t input) {
    const auto found = std::find(used.begin(), used.end(), input);
    return found == used.end() ? std::nullopt
                               : std::optional(static_cast<std::uint32_t>(found - used.begin()));
  };
  Recipe recipe;
  for (const std::size_t i : used) {
    const PrepareInput& input = now().inputs[i];
    recipe.scans.push_back({.file = input.file.string(),
                            .sha256 = {},
                            .unit = input.unit,
                            .parts = input.read.parts,
                            .keep_withheld = input.read.keep_withheld});
  }
  const std::size_t laid_on = reference();
  for (const std::size_t at : stepsInRecipe()) {
    const PrepareStep& s = now().steps[at];
    const auto* const align = std::get_if<Align>(&s.step);
    if (align == nullptr) {
      recipe.steps.push_back(s.step);
      continue;
    }
    // A scan that is not laid on the others stays where its file has it; joined they are anyhow.
    Align step = s.on ? *align : Align{};
    step.reference = number(laid_on).value_or(0);
    std::vector<PickedPair> pairs;
    for (PickedPair pair : step.pairs) {
      const auto scan = number(pair.scan);
      if (!scan || laid_on != align->reference) continue;
      pair.scan = *scan;
      pairs.push_back(pair);
    }
    step.pairs = step.method == AlignMethod::points ? pairs : std::vector<PickedPair>{};
    recipe.steps.emplace_back(step);
  }
  return recipe;
}

std::vector<std::size_t> PrepareState::stepsInRecipe() const {
  std::vector<std::size_t> in_recipe;
  const bool joins = usedInputs().size() > 1;
  for (std::size_t i = 0; i < now().steps.size(); ++i) {
    const PrepareStep& s = now().steps[i];
    const bool is_align = std::holds_alternative<Align>(s.step);
    const auto* const outline = std::get_if<CropOutline>(&s.step);
    const bool is_drawn = outline == nullptr || outline->outline.size() >= 3;
    if (is_align ? joins : s.on && is_drawn) in_recipe.push_back(i);
  }
  return in_recipe;
}

Recipe PrepareState::recipe() const {
  Recipe recipe = recipeWithoutPoses();
  const AlignAnswer* const known = foundAlign();
  if (known == nullptr) return recipe;
  for (Step& step : recipe.steps) {
    if (auto* const align = std::get_if<Align>(&step)) {
      for (const AlignVerdict& verdict : known->scans) align->poses.push_back(verdict.pose);
    }
  }
  return recipe;
}

void PrepareState::keepPoses(const PrepareChoices& choices, const Recipe& recipe,
                             const AlignAnswer& answer) {
  for (const Step& step : recipe.steps) {
    const auto* const align = std::get_if<Align>(&step);
    if (align == nullptr) continue;
    // As stored needs no search, and poses in the recipe were found before.
    if (align->method == AlignMethod::stored || !align->poses.empty()) return;
    const bool all_hold = std::all_of(answer.scans.begin(), answer.scans.end(),
                                      [](const AlignVerdict& v) { return v.holds; });
    if (all_hold) found_ = Found{usedOf(choices), beginningOf(recipe), answer};
  }
}

const AlignAnswer* PrepareState::foundAlign() const {
  const bool same = found_ && found_->inputs == usedOf(now()) &&
                    found_->steps == beginningOf(recipeWithoutPoses());
  return same ? &found_->answer : nullptr;
}

}  // namespace relievo
