// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <QObject>
#include <vector>

#include "ui/prepare/prepare_state.h"

namespace relievo {

class PrepareReport;
class PrepareViews;
class ReadScans;
class ScanList;

/// Places on a scan and on the reference that are picked in turn, and the pairs they make.
class PickedPlaces {
 public:
  /// @param pairs  picked earlier; those of other scans are passed over
  PickedPlaces(std::size_t input, const std::vector<PickedPair>& pairs);

  std::size_t input() const { return input_; }
  const std::vector<FilePoint>& onScan() const { return on_scan_; }
  const std::vector<FilePoint>& onReference() const { return on_reference_; }
  std::vector<PickedPair> pairs() const;  ///< The whole ones.
  /// A second place in turn on the same side takes the first one's place: it is a better try.
  void place(bool on_reference, const FilePoint& point);
  bool takeBack();  ///< The place picked last. False: there is none.
  void removePair(std::size_t pair);

 private:
  std::size_t input_;
  std::vector<FilePoint> on_scan_, on_reference_;
  std::vector<bool> order_;  ///< As they were placed: was it on the reference?
};

/// Picking pairs on the views of the dialog Prepare: begins with those there are, says what is next
/// and how well they fit, and at the end writes them into the step Align. [GUI thread]
class PairPicking : public QObject {
  Q_OBJECT
 public:
  PairPicking(PrepareState& state, const ReadScans& reads, ScanList& list, PrepareViews& views,
              PrepareReport& report);

  bool isOn() const { return picked_.has_value(); }
  void toggle();
  void end();
  void show();  ///< The places and pairs, if it is on.

 Q_SIGNALS:
  void began();
  void ended();  ///< The choices are other ones.
  void said(const QString& text);

 private:
  void begin();
  void place(bool on_reference, const FilePoint& point);
  void takeBack();
  void removePair();
  QString nextText() const;
  QString fitText() const;
  void showPairs();
  void sayNext();

  PrepareState& state_;
  const ReadScans& reads_;
  ScanList& list_;
  PrepareViews& views_;
  PrepareReport& report_;
  std::optional<PickedPlaces> picked_;
};

}  // namespace relievo
