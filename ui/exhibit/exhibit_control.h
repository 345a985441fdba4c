// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <QKeyEvent>
#include <QObject>
#include <QTimer>
#include <set>
#include <string>
#include <vector>

#include "core/exhibit/exhibit.h"
#include "core/exhibit/hand_watch.h"
#include "core/exhibit/rotating_log.h"
#include "core/exhibit/visit.h"
#include "core/exhibit/visit_counts.h"
#include "core/message/message.h"
#include "core/region/probe.h"
#include "ui/control/surface_controller.h"
#include "ui/exhibit/chime.h"
#include "ui/exhibit/exhibit_caption.h"
#include "ui/exhibit/exhibit_facts.h"
#include "ui/exhibit/exhibit_lock.h"
#include "ui/views/touch_readout.h"

namespace relievo {

class MainWindow;

/// What the window's exhibit needs of others.
struct ExhibitWays {
  /// Speaks sentences of the catalogue, in the language that the program has now.
  std::function<void(const std::vector<Message>& sentences)> say;
  /// Language and volume of the voice as at the start of a visit.
  std::function<void()> reset_voice;
  /// The voice says something; null: it is not known.
  std::function<bool()> speaks;
  std::function<double()> now_s;     ///< Of a clock that only goes on.
  std::function<std::string()> day;  ///< "2026-11-24".
};

/// An exhibit in a window that is locked: lets one visitor after the other choose language and
/// object by the four buttons, counts, keeps a log of its health, and asks whoever wants to leave
/// for the staff's PIN. [GUI thread]
class ExhibitControl : public QObject {
  Q_OBJECT
 public:
  /// @param starts  how often it was started again after it had ended unexpectedly
  ExhibitControl(MainWindow& window, Exhibit exhibit, ExhibitWays ways, int starts = 0);
  ~ExhibitControl() override;

  /// A button of the device, by the command that it stands for: "finer". @return false: it is not
  /// about the visit, and does what it always does
  bool press(const QString& command);
  /// Buttons choose something now.
  bool chooses() const { return visit_.chooses() && !caption_->asks(); }
  /// An error of a plugin. Where no voice speaks (E402) the grip's taps say yes and no.
  void noteError(const QString& code);
  /// How the device is.
  void noteDevice(VisitDevice device) { visit_.device(device, ways_.now_s()); }
  /// Where its grip is, mm of hand, told now and then: it wakes the exhibit while nothing is open,
  /// of which no probe could tell.
  void noteGrip(const DeviceMm& at);
  /// Whether a command may be run now: those of visitors, while the staff is not asked.
  bool allows(const QString& command) const;
  /// Where the hand is.
  void feel(const Probe& probe);
  /// What the window says by itself, of files and their size, is not for the ears of visitors now.
  bool isQuiet() const;
  /// The computer says that the program must end: without a PIN.
  void endAtOnce();
  /// What has to be done by now. A timer calls it, too.
  void tick();

  const Visit& visit() const { return visit_; }
  const ExhibitCaption& caption() const { return *caption_; }
  const VisitCounts& counts() const { return counts_; }
  Chime& chime() { return sounds_.chime; }
  Chime& lowTones() { return sounds_.low_tones; }

 private:
  void connectDocument();
  void watch(double now_s);
  void carryOutOrders(double now_s);
  void carryOut(const Visit::Order& order);
  void carryOutTouch(const Visit::Order& order);
  bool isChecked(const char* command) const;
  void toggle(const char* command, bool on);
  bool takesForcesBack();
  void setForces(bool on);
  void sayObject(std::vector<Message> words);
  void sayPlace();
  void speak(const std::vector<Message>& sentences);
  void tell(SurfaceController::Step step);
  void useLanguage(std::size_t index);
  void openObject(std::size_t index);
  void objectOpened();
  void objectFailed(const QString& why);
  void watchOpening();
  void endTouch();
  void reset();
  bool atWhole() const;
  void run(const char* command);

  bool key(const QKeyEvent& key);
  void askPin();
  void pinKey(const QKeyEvent& key);
  void showPin();
  void leave();

  void log(const std::string& words);
  void saveCounts();
  void noteReadout(const TouchReadout& readout);

  MainWindow& window_;
  Exhibit exhibit_;
  ExhibitWays ways_;
  ExhibitLock lock_;
  ExhibitCaption* caption_;
  ExhibitSounds sounds_;
  Visit visit_;
  StaffLock staff_;
  VisitCounts counts_;
  RotatingLog health_;
  QTimer timer_;
  std::size_t language_ = 0;  // That is spoken now.
  int open_object_ = -1;      // That the document has, or is being opened.
  WaitWatch nothing_;         // Comes of what is being opened.
  double pin_key_s_ = 0, saved_s_ = 0, felt_s_ = 0;
  double read_until_s_ = 0;  // Who reads what was said needs so long.
  HandWatch hand_;
  Probe probe_;                        // The newest.
  std::set<std::string> told_places_;  // To this visitor.
  std::vector<Message> said_;          // Last.
  ExhibitFacts facts_;
  bool had_forces_ = false;
  QString device_;
};

}  // namespace relievo
