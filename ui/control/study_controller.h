// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "core/project/study.h"
#include "ui/views/touch_readout.h"
#include "ui/window/controller.h"

namespace relievo {

class LookController;

/// A sitting of a study: shows the conditions one after the other under their letters, and keeps
/// what happens in the sitting's folder; recordings go there, too. [GUI thread]
class StudyController : public Controller {
  Q_OBJECT
 public:
  StudyController(const ControllerParts& parts, LookController& look);

  bool running() const { return sitting_.has_value(); }
  QString folder() const;         ///< Of the sitting. @pre running()
  QString recordingName() const;  ///< "trial_03_B". @pre running()
  /// Where sittings are offered to go.
  void setStudiesFolder(std::function<QString()> folder) { studies_folder_ = std::move(folder); }
  /// Fixed orders for those who look at them; nothing: a new one for each sitting.
  void setSeed(std::uint64_t seed) { seed_ = seed; }

  void follow(const TouchReadout& readout) { is_recording_ = readout.recording; }
  void noteRecording(const QString& file);
  void begin(const Study& study, const QString& folder);
  void next();
  void end();

 private:
  struct Sitting {
    Study study;
    std::vector<StudyTrial> order;
    std::vector<NamedRegion> places;  ///< Of the conditions, as they were at the beginning.
    std::filesystem::path folder;
    std::vector<TrialRecord> trials;  ///< That began; the last one is shown.
  };

  void ask();
  void showTrial();
  void enableCommands();
  bool keepTrials();

  LookController& look_;
  std::function<QString()> studies_folder_;
  std::optional<std::uint64_t> seed_;
  std::optional<Sitting> sitting_;
  bool is_recording_ = false;
};

}  // namespace relievo
