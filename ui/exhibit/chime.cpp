// SPDX-License-Identifier: BSD-3-Clause
#include "ui/exhibit/chime.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <QApplication>
#include <QDataStream>
#include <QIODevice>
#include <QStandardPaths>

namespace relievo {
namespace {

constexpr quint32 kRateHz = 44100;

/// @param sound  from -1 to 1 at each time in seconds
template <class Sound>
QByteArray wavOf(double length_s, int volume_percent, const Sound& sound) {
  constexpr quint32 kHeader = 36, kFormat = 16, kBytes = 2;
  constexpr double kFull = 32767;
  const auto frames = static_cast<quint32>(length_s * kRateHz);
  QByteArray wav;
  QDataStream out(&wav, QIODevice::WriteOnly);
  out.setByteOrder(QDataStream::LittleEndian);
  out.writeRawData("RIFF", 4);
  out << kHeader + frames * kBytes;
  out.writeRawData("WAVEfmt ", 8);
  out << kFormat << quint16{1} << quint16{1} << kRateHz << kRateHz * kBytes << quint16{kBytes}
      << quint16{8 * kBytes};
  out.writeRawData("data", 4);
  out << frames * kBytes;
  const double peak = Chime::kPeak * volume_percent / 100;
  for (quint32 i = 0; i < frames; ++i) {
    out << static_cast<qint16>(std::lround(kFull * peak * sound(static_cast<double>(i) / kRateHz)));
  }
  return wav;
}

double tone(double hz, double t_s) {
  return std::sin(2 * std::numbers::pi * hz * t_s);
}

}  // namespace

QByteArray chimeWav(int volume_percent) {
  constexpr double kLengthS = 0.8, kDecayS = 0.25, kRiseS = 0.01;
  constexpr std::array<double, 2> kTonesHz{523.25, 659.26};  // C and E above it.
  return wavOf(kLengthS, volume_percent, [&](double t_s) {
    double sum = 0;
    for (const double tone_hz : kTonesHz) sum += tone(tone_hz, t_s);
    return std::min(1.0, t_s / kRiseS) * std::exp(-t_s / kDecayS) * sum / kTonesHz.size();
  });
}

QByteArray lowTonesWav(int volume_percent) {
  constexpr double kToneS = 0.2, kStepS = 0.3, kEdgeS = 0.01, kLowHz = 196;  // G below middle C.
  constexpr int kTones = 3;
  return wavOf(kTones * kStepS, volume_percent, [&](double t_s) {
    const double since_s = std::fmod(t_s, kStepS);
    const double edge_s = std::min(since_s, kToneS - since_s);
    return std::clamp(edge_s / kEdgeS, 0.0, 1.0) * tone(kLowHz, since_s);
  });
}

Chime::Chime(const QByteArray& wav, QObject* parent) : QObject(parent) {
  for (const char* name : {"pw-play", "paplay", "aplay"}) {
    const QString found = QStandardPaths::findExecutable(QString::fromLatin1(name));
    if (found.isEmpty()) continue;
    player_ = QStringList{found};
    break;
  }
  if (file_.open()) {
    file_.write(wav);
    file_.flush();
  }
}

Chime::~Chime() {
  process_.kill();
  process_.waitForFinished();
}

void Chime::play() {
  if (player_.isEmpty()) return QApplication::beep();
  if (process_.state() != QProcess::NotRunning) return;
  process_.start(player_.front(), player_.mid(1) << file_.fileName());
}

}  // namespace relievo
