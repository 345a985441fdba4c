// SPDX-License-Identifier: BSD-3-Clause
#include "core/project/undo_step.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/project/project.h"

namespace relievo {
namespace {

template <class T>
std::optional<ListChange<T>> changeBack(const std::vector<T>& before, const std::vector<T>& after) {
  if (before == after) return std::nullopt;
  const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  // What is the same at the end, of what is left behind the beginning.
  const auto [rb, ra] = std::mismatch(before.rbegin(), std::make_reverse_iterator(b),
                                      after.rbegin(), std::make_reverse_iterator(a));
  return ListChange<T>{.at = static_cast<std::size_t>(a - after.begin()),
                       .gone = static_cast<std::size_t>(ra.base() - a),
                       .back = {b, rb.base()}};
}

template <class T>
bool fits(const std::optional<ListChange<T>>& change, const std::vector<T>& list) {
  return !change || (change->at <= list.size() && change->gone <= list.size() - change->at);
}

template <class T>
void takeBack(const std::optional<ListChange<T>>& change, std::vector<T>& list) {
  if (!change) return;
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(change->at);
  const auto at = list.erase(begin, begin + static_cast<std::ptrdiff_t>(change->gone));
  list.insert(at, change->back.begin(), change->back.end());
}

bool looksTheSame(const Project& a, const Project& b) {
  return a.look == b.look && chosenStereo(a) == chosenStereo(b) && a.azimuth_deg == b.azimuth_deg &&
         a.elevation_deg == b.elevation_deg;
}

}  // namespace

UndoStep undoStep(std::string name, const Project& before, const Project& after) {
  UndoStep step{.before = {.name = std::move(name), .region = before.region, .gain = before.gain},
                .places = changeBack(before.places, after.places),
                .measurements = changeBack(before.measurements, after.measurements)};
  if (!looksTheSame(before, after)) {
    step.before.view = viewOf(before);
    step.chosen_eye_angle_deg = before.chosen_eye_angle_deg;
  }
  return step;
}

bool takeBack(const UndoStep& step, Project& project) {
  if (!fits(step.places, project.places) || !fits(step.measurements, project.measurements)) {
    return false;
  }
  if (step.before.view) {
    setView(project, *step.before.view);
    project.chosen_eye_angle_deg = step.chosen_eye_angle_deg;
  }
  project.region = step.before.region;
  project.gain = step.before.gain;
  takeBack(step.places, project.places);
  takeBack(step.measurements, project.measurements);
  return true;
}

}  // namespace relievo
