// SPDX-License-Identifier: BSD-3-Clause
#include "ui/work/state_command.h"

#include <utility>

namespace relievo {
namespace {

template <class T>
void takeChange(T& now, const T& from, const T& to) {
  if (!(from == to)) now = to;
}

/// What no step changes, and what would otherwise be kept for each of them.
DocumentState withoutRest(DocumentState state) {
  Project& p = state.project;
  p.history.clear();
  p.undo.clear();
  p.paths.clear();
  p.figures.clear();
  p.recordings.clear();
  return state;
}

bool sameStereo(const Project& a, const Project& b) {
  return chosenStereo(a) == chosenStereo(b);
}

}  // namespace

bool sameInSteps(const DocumentState& a, const DocumentState& b) {
  const Project &p = a.project, &q = b.project;
  return a == b && p.look == q.look && sameStereo(p, q) && p.azimuth_deg == q.azimuth_deg &&
         p.elevation_deg == q.elevation_deg && p.places == q.places &&
         p.measurements == q.measurements;
}

DocumentState withChange(DocumentState now, const DocumentState& from, const DocumentState& to) {
  Project& p = now.project;
  const Project &q = from.project, &r = to.project;
  if (from.surface != to.surface) {
    now.surface = to.surface;
    now.source = to.source;
    p.file = r.file;
    p.sha256 = r.sha256;
    p.bytes = r.bytes;
    p.accept_incomplete = r.accept_incomplete;
    p.scan = r.scan;
    p.options = r.options;
  }
  takeChange(p.azimuth_deg, q.azimuth_deg, r.azimuth_deg);
  takeChange(p.elevation_deg, q.elevation_deg, r.elevation_deg);
  takeChange(p.region, q.region, r.region);
  takeChange(p.gain, q.gain, r.gain);
  takeChange(p.look, q.look, r.look);
  if (!sameStereo(q, r)) {
    p.stereo = r.stereo;
    p.chosen_eye_angle_deg = r.chosen_eye_angle_deg;
  }
  takeChange(p.places, q.places, r.places);
  takeChange(p.measurements, q.measurements, r.measurements);
  return now;
}

StateCommand::StateCommand(Document& document, DocumentState before, DocumentState after,
                           const QString& name, int merge_id)
    : QUndoCommand(name),
      document_(document),
      before_(withoutRest(std::move(before))),
      after_(withoutRest(std::move(after))),
      merge_id_(merge_id) {}

// A step to what cannot be read leaves the history.
void StateCommand::undo() {
  keepTurn(after_);
  setObsolete(!document_.change(after_, before_));
}

void StateCommand::redo() {
  keepTurn(before_);
  setObsolete(!document_.change(before_, after_));
}

bool StateCommand::mergeWith(const QUndoCommand* later) {
  if (later->id() != merge_id_ || later->isObsolete()) return false;
  after_ = static_cast<const StateCommand*>(later)->after_;
  return true;
}

// Another surface is looked straight at; the one that is left comes back as it was turned.
void StateCommand::keepTurn(DocumentState& left) const {
  if (before_.surface == after_.surface) return;
  left.project.azimuth_deg = document_.project().azimuth_deg;
  left.project.elevation_deg = document_.project().elevation_deg;
}

}  // namespace relievo
