// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QByteArray>
#include <QObject>
#include <QProcess>
#include <QStringList>
#include <QTemporaryFile>

namespace relievo {

/// A short sound as a file for a program of the sound system (pw-play, paplay or aplay); the beep
/// of the screen where there is none. [GUI thread]
class Chime : public QObject {
  Q_OBJECT
 public:
  static constexpr double kPeak = 0.2;  ///< Of full scale, at 100 percent.

  explicit Chime(const QByteArray& wav, QObject* parent = nullptr);
  ~Chime() override;
  void play();
  /// Which program plays, with its arguments before the file; empty: none is there.
  void setPlayer(const QStringList& player) { player_ = player; }

 private:
  QStringList player_;
  QTemporaryFile file_;
  QProcess process_;
};

/// What sounds while nobody is there: two sines, 0.8 s. As the next, a WAV file of 16 bits, one
/// channel.
QByteArray chimeWav(int volume_percent);
/// What sounds where nothing can be said (E402): three low tones of 0.2 s, 0.1 s apart.
QByteArray lowTonesWav(int volume_percent);

/// What an exhibit plays beside its voice.
struct ExhibitSounds {
  explicit ExhibitSounds(int volume_percent)
      : chime(chimeWav(volume_percent)), low_tones(lowTonesWav(volume_percent)) {}
  Chime chime, low_tones;
};

}  // namespace relievo
