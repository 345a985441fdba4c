// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <QObject>
#include <QString>
#include <utility>
#include <vector>

#include "core/measure/measure.h"
#include "ui/work/document.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// What measurements read on the document's map, each read once. What may take long is read by a
/// worker: sections, which always cross it all, areas of a map of more than a million cells, and of
/// a map by tiles all profiles and areas, which may cross all of its files; of a map from the web
/// all. The rest is read at once. [GUI thread]
class MeasureReadings : public QObject {
  Q_OBJECT
 public:
  struct Entry {
    std::optional<Reading> reading;  ///< Nothing: `problem` says why.
    QString problem;
    std::vector<ProfileRow> rows;  ///< Of a profile.
  };

  explicit MeasureReadings(Document& document, QObject* parent = nullptr);

  /// Null while a worker reads it: changed() tells when it is there. @pre document is open
  std::shared_ptr<const Entry> of(const Measurement& m);
  /// Forgets what others read.
  void keepOnly(const std::vector<Measurement>& list);
  /// Can pointAt() say something? Of a map from the web the place may have to be fetched first.
  /// @pre document is open
  bool isHere(const PlaceMm& place) const;
  /// Begins that, in a worker. @pre !isHere(place)
  void fetch(const PlaceMm& place);
  /// The surface at a place, as MeasureReadings reads it; nothing where it is not here.
  /// @pre document is open @throw FileError
  std::optional<SurfacePoint> pointAt(const PlaceMm& place) const;

 Q_SIGNALS:
  void changed();

 private:
  using Known = std::pair<Measurement, std::shared_ptr<const Entry>>;  ///< Null: being read.

  void readMissing();

  Document& document_;
  std::vector<Known> known_;
  bool asked_ = false;  ///< readMissing() comes when control returns to the event loop.
  // Last: their jobs end before anything else goes.
  LatestWorker fetcher_;
  LatestWorker worker_;
};

}  // namespace relievo
