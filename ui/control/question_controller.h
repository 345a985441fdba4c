// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <QImage>

#include "core/session/strays.h"
#include "ui/window/controller.h"
#include "ui/work/latest_worker.h"

namespace relievo {

/// What was found in an opened file and may be meant otherwise: the strip asks, one question at a
/// time, and stops nothing. [GUI thread]
class QuestionController : public Controller {
  Q_OBJECT
 public:
  explicit QuestionController(const ControllerParts& parts);

  /// @param restored  the file was opened for a state, which has answered most
  /// @param withheld  how many files that the state names were not read
  void begin(bool restored, std::size_t withheld);
  void forget() { questions_.clear(); }
  void askUnit();
  void askScale();
  void chooseScale();
  void chooseUnit(LengthUnit unit);

 private:
  void tellWithheld(int count);
  void askNext();
  void askStrays();
  void askGroups();
  void answerStrays(StrayRule rule);
  void askNodata();
  /// Draws the six faces in a worker and asks for one of them then.
  void drawFaces();
  void askFace(const std::vector<std::pair<std::string, QImage>>& faces);

  std::vector<std::function<void()>> questions_;  ///< Not yet asked, the next one first.
  LatestWorker face_worker_;                      ///< Last: its job ends before anything else goes.
};

}  // namespace relievo
