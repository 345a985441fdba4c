// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QCoreApplication>

#include "core/session/surface.h"

namespace relievo {

class Document;
struct ReliefTurn;  // ui/work/surface_loader.h

/// Choices between the file of a document and its surface: each makes the surface anew from the
/// scan in memory, in the worker, as one step of the history. [GUI thread]
class SurfaceChoices {
  Q_DECLARE_TR_FUNCTIONS(relievo::SurfaceChoices)
 public:
  explicit SurfaceChoices(Document& document) : document_(document) {}

  void setView(const ViewChoice& view);
  /// As `view`, from where the turned view looks; what turns in a row do is one step.
  void turnTo(const Rotation& view, const ReliefTurn& turn);
  /// Whether somebody wants the relief to be made anew wherever the view is turned to, and it can.
  void setReliefFollows(bool on) { relief_follows_ = on; }
  bool reliefFollows() const { return relief_follows_; }
  void setEngine(const QString& engine);
  void setUnit(LengthUnit unit);
  void setStrays(StrayRule rule);
  void setNodata(const NodataChoice& nodata);
  void setRasterScale(const RasterScale& scale);

 private:
  const SurfaceOptions& now() const;

  Document& document_;
  bool relief_follows_ = false;
};

}  // namespace relievo
