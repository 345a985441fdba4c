// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <QObject>
#include <QString>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/recording/force_point.h"
#include "core/region/probe.h"
#include "core/region/region_window.h"

class QAction;
class QWidget;

// What the application offers a plugin, in five parts. All calls and signals: GUI thread.
namespace relievo {

struct FirmnessMap;  // core/session/firmness.h; outside of the tree it is only handed on.
struct Message;      // core/message/message.h; likewise.

/// Panels, menu entries, and commands of the window.
class Controls {
 public:
  virtual ~Controls() = default;
  virtual void addPanel(const QString& title, QWidget* panel) = 0;  ///< Takes ownership.
  /// Adds to a menu of the menu bar ("Touch", "Record"); the action also gets its shortcut there.
  virtual void addAction(const QString& menu, QAction* action) = 0;  ///< Takes ownership.
  /// Runs a command by its object name ("finer", "coarser", "whole"): the same path as keys.
  /// With "button:" before the name it only offers a button's press to whoever has other use for
  /// buttons now, as an exhibit's list of objects has; without a name it asks whether somebody
  /// chooses by them now. @return false: unknown, disabled, not taken
  virtual bool run(const QString& command) = 0;
};

/// The hand as the mouse or the keys move it: where it wants to be, in the shown window's view mm.
struct HandTarget {
  ViewMm position;
  bool inside = false;  ///< The pointer is over the detail view.
};

/// The whole object, and what is known of a place on it.
struct ObjectPlace {
  double left_mm = 0, bottom_mm = 0;   ///< View mm.
  double width_mm = 0, height_mm = 0;  ///< 0: nothing is open.
  double spacing_mm = 0;               ///< Of the samples of the shown window's level.
  QString name = {};                   ///< That somebody gave the place; empty: nobody did.
};

/// A push of what is shown: the relief goes right and up, in parts of the window's side, and comes
/// nearer, as many times larger (> 0).
struct ViewPush {
  double right = 0, up = 0;
  double nearer = 1;
};

/// The window of the surface that is shown in detail, and what more is known of its place.
class ShownWindow : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  virtual std::shared_ptr<const RegionWindow> shownWindow() const = 0;  ///< May be null.
  /// Sides on which the shown window is at the object's edge, as edgesOf() says; 0 while there is
  /// no window.
  virtual std::uint8_t edges() const = 0;
  /// The object, and the place at x, y in view mm.
  virtual ObjectPlace placeAt(double x_mm, double y_mm) const = 0;
  /// Goes back to a region that was shown. @return false: nothing is open, or it is shown already
  virtual bool showRegion(const Region& region) = 0;
  /// Turns the detail view, as the commands "turn_left" and "turn_up" do in steps; while the scan
  /// in 3-D has the keyboard, that. Only that can be tilted, counter-clockwise as it is seen.
  virtual void turnView(double azimuth_deg, double elevation_deg, double tilt_deg) = 0;
  /// Moves the window as dragging and the wheel do, about its centre; or the scan in 3-D as above.
  /// Pushes that follow each other are one step of the history; within a gesture of the mouse they
  /// do nothing.
  virtual void pushView(const ViewPush& push) = 0;
  /// What the next finer level says about a shown window, 400 x 400 heights with its gain
  /// (core/session/finer_heights.h). Empty: nothing; or it is read from disk, off the GUI thread,
  /// and finerHeightsRead() answers, unless a newer call took the place of this one.
  virtual std::vector<float> finerHeights(const RegionWindow& /*window*/) { return {}; }
  /// Reads a raster that says where the ground is firm, off the GUI thread; firmnessRead() answers.
  /// A newer call takes the place of an older one.
  virtual void readFirmness(const QString& file) = 0;
  /// What it says at the samples of a window of the open map.
  /// @throw ArgumentError  it is no raster of that map, or no map is open
  virtual std::vector<float> firmnessUnder(const FirmnessMap& firmness,
                                           const RegionWindow& window) const = 0;

 Q_SIGNALS:
  void windowShown(std::shared_ptr<const RegionWindow> window);  ///< Also sent once after attach.
  void handMoved(const HandTarget& target);
  /// @param problem  a sentence, if they cannot be read
  void finerHeightsRead(quint64 window_id, const std::vector<float>& finer_mm,
                        const QString& problem);
  /// @param firmness  with its checksum; null: `problem` says why not, in a sentence
  void firmnessRead(const QString& file, std::shared_ptr<const FirmnessMap> firmness,
                    const QString& problem);
  void closing();
  /// Somebody went to a marker: a place that the hand is to find again. View mm. The window that
  /// it lies in is shown then, or will be.
  void wentToMarker(double x_mm, double y_mm);
};

/// Whether the device that was asked for can be touched with.
enum class TouchDevice : std::uint8_t {
  ready,
  preparing,  ///< It starts, or waits for a person to push its grip in.
  gone        ///< It failed, or another one has taken its place.
};

/// What the status bar and the accessible texts say about touch.
struct TouchStatus {
  TouchDevice state = TouchDevice::ready;
  QString device;      ///< "mouse", "Falcon ready", "no device".
  double rate_hz = 0;  ///< Measured rate of the force loop.
  double worst_period_ms = 0;
  quint64 late_ticks = 0;
  bool realtime = false;  ///< Real-time priority was granted.
  QString realtime_note;  ///< Why not, if not.
  bool forces_on = false;
  bool recording = false;
  quint64 recorded_samples = 0;
  double stiffness_n_per_mm = 0;
  /// Where the grip of a device is, mm of hand, also while nothing is open; none: the mouse's hand,
  /// or the device does not tell.
  std::optional<DeviceMm> grip;
};

/// Where the hand is, in the views, the plots and the status bar.
class TouchDisplay {
 public:
  virtual ~TouchDisplay() = default;
  virtual void showProbe(const Probe& probe) = 0;  ///< Detail view, next frame.
  virtual void plot(std::span<const ForcePoint> samples) = 0;
  virtual void showStatus(const TouchStatus& status) = 0;
};

/// Why something is said. What is asked for is said at once. What nobody asked for waits until the
/// hand rests, the newest of it alone.
enum class SaidBecause : std::uint8_t { asked, noticed };

/// A voice of the program's own, for what the hand meets. While it speaks the screen reader is not
/// told the same.
class Voice {
 public:
  virtual ~Voice() = default;
  /// Somebody has switched it on: its volume, and repeating, are commands.
  virtual bool isOn() const = 0;
  /// Something is being said.
  virtual bool isSpeaking() const = 0;
  /// @return false: it does not speak now; the screen reader is told
  virtual bool speak(const std::vector<Message>& sentences, SaidBecause why) = 0;
  /// The same of a text in the window's language.
  virtual bool speak(const QString& text, SaidBecause why) = 0;
  /// Whatever is being said stops; what was noticed is forgotten.
  virtual void hush() = 0;
  /// Where the hand is, 60 times a second.
  virtual void feel(const Probe& probe) = 0;
};

/// What is told to whoever sits there.
class Messages {
 public:
  virtual ~Messages() = default;
  /// Status text, accessible event, speech. News that nobody asked for is `noticed`: it never cuts
  /// in on an answer.
  virtual void announce(const QString& text, SaidBecause why = SaidBecause::asked) = 0;
  /// Sentences of the catalogue: on the screen as for eyes, spoken as for ears.
  virtual void say(const std::vector<Message>& sentences, SaidBecause why = SaidBecause::asked) = 0;
  /// A button went down: the voice stops.
  virtual void hush() = 0;
  /// Who speaks from now on; not owned; null: the screen reader alone.
  virtual void setVoice(Voice* voice) = 0;
  /// There is one, and it is on.
  virtual bool hasVoice() const = 0;
  /// The voice says something: other sounds that last are to be silent.
  virtual bool isSpeaking() const = 0;
  /// A sentence about a failure above the views; it stays until it is closed.
  /// @param code  of the catalogue ("E401"), or empty
  virtual void showError(const QString& sentence, const QString& code) = 0;
};

/// Where recordings go and what stands in them about the open map.
class Recordings {
 public:
  virtual ~Recordings() = default;
  /// Comment lines for the header of a recording in `file`: input (its path from there), hash,
  /// unit, view, region (conventions.md 5.5).
  virtual QString recordingHeader(const QString& file) const = 0;
  /// How a recording that nobody named is called: the open scan without its ending (empty: nothing
  /// is open), and the ending that was chosen, "csv" or "h5".
  virtual QString scanName() const = 0;
  virtual QString recordingEnding() const = 0;
  /// Where it goes. Not made yet, perhaps; empty: nothing was chosen, and there is no documents
  /// folder.
  virtual QString recordingFolder() const = 0;
  /// A recording of the open map is on the disk and belongs to the work.
  virtual void recordingSaved(const QString& file) = 0;
  /// How the open map is made, in one line: its input (the path from `folder`), hash, every choice;
  /// the same map gives the same line. Empty: nothing is open.
  virtual QString mapState(const QString& folder) const = 0;
};

/// The application as a plugin sees it. Its parts live until detach() has returned.
struct Host {
  Controls& controls;
  ShownWindow& view;
  TouchDisplay& touch;
  Messages& messages;
  Recordings& recordings;
};

}  // namespace relievo
