// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QCoreApplication>

#include "core/region/region.h"

namespace relievo {

class Document;

/// Moves the window of a document, and changes how far its heights are drawn out. Each change is
/// one step of the history; a gesture shows many and leaves one. [GUI thread]
class RegionEditor {
  Q_DECLARE_TR_FUNCTIONS(relievo::RegionEditor)
 public:
  explicit RegionEditor(Document& document) : document_(document) {}

  // At once. Each returns false at a limit, within a gesture or while nothing is open.
  bool finer(const StepAbout& about);
  bool coarser(const StepAbout& about);
  bool whole();
  bool move(double dx, double dy);
  bool setLevel(Level level);
  /// A drawn or typed rectangle; widened to a square about its centre.
  bool setRect(const RectMm& rect);
  bool setGain(double gain);
  /// A place as it is, with its gain, as one step.
  bool goTo(const Region& region, double gain, const QString& name);
  /// Like setRect, but one zoom in several steps is one entry in the history.
  bool zoomTo(const Region& region);
  StepAbout aboutCentre() const;

  // A gesture shows many states and leaves one entry in the history.
  void preview(const Region& region);
  void previewGain(double gain);
  void commit(const QString& name);
  void revert();
  bool inGesture() const { return gesture_start_.has_value(); }
  /// Another map is shown, on which what the gesture began with is nowhere.
  void forgetGesture() { gesture_start_.reset(); }

 private:
  struct Place {
    Region region;
    double gain = 1;
  };

  bool isAtRest() const;  ///< Something is open and no gesture is being made.
  void beginGesture();
  void go(const std::optional<Region>& region, const QString& name);

  Document& document_;
  std::optional<Place> gesture_start_;
};

}  // namespace relievo
