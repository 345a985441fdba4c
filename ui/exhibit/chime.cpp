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
constexpr double kLengthS = 0.8, kDecayS = 0.25, kRiseS = 0.01;
constexpr std::array<double, 2> kTonesHz{523.25, 659.26};  // C and E above it.

}  // namespace

QByteArray chimeWav(int volume_percent) {
  constexpr quint32 kHeader = 36, kFormat = 16, kBytes = 2;
  constexpr double kFull = 32767;
  const auto frames = static_cast<quint32>(kLengthS * kRateHz);
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
  const double peak = Chime::kPeak * volume_percent / 100 / kTonesHz.size();
  for (quint32 i = 0; i < frames; ++i) {
    const double t_s = static_cast<double>(i) / kRateHz;
    double sum = 0;
    for (const double tone_hz : kTonesHz) sum += std::sin(2 * std::numbers::pi * tone_hz * t_s);
    const double shape = std::min(1.0, t_s / kRiseS) * std::exp(-t_s / kDecayS);
    out << static_cast<qint16>(std::lround(kFull * peak * shape * sum));
  }
  return wav;
}

Chime::Chime(int volume_percent, QObject* parent) : QObject(parent) {
  for (const char* name : {"pw-play", "paplay", "aplay"}) {
    const QString found = QStandardPaths::findExecutable(QString::fromLatin1(name));
    if (found.isEmpty()) continue;
    player_ = QStringList{found};
    break;
  }
  if (file_.open()) {
    file_.write(chimeWav(volume_percent));
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
