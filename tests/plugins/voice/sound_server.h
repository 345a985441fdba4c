// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <QByteArray>
#include <QFile>
#include <QProcess>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>
#include <vector>

namespace relievo::test {

/// Debian's PulseAudio, on a socket of its own, with two outputs that nobody hears: `ears`, which
/// says of itself that it is headphones, and `room`, which does not. What sounds can be recorded.
class SoundServer {
 public:
  SoundServer() {
    server_.setProcessEnvironment(environment());
    server_.setStandardOutputFile(path("out"));
    server_.setStandardErrorFile(path("out"));
    server_.start("pulseaudio",
                  {"-n", "--daemonize=no", "--use-pid-file=no", "--exit-idle-time=-1",
                   "--disable-shm=yes", "--high-priority=no", "--realtime=no", "-L",
                   "module-native-protocol-unix auth-anonymous=1 socket=" + path("native"), "-L",
                   "module-null-sink sink_name=room rate=48000", "-L",
                   "module-null-sink sink_name=ears rate=48000 "
                   "sink_properties=device.form_factor=headphone"});
  }
  ~SoundServer() {
    for (QProcess* one : {&recorder_, &server_}) {
      one->kill();
      one->waitForFinished();
    }
  }
  QByteArray address() const { return "unix:" + path("native").toUtf8(); }
  QString log() const { return QString::fromUtf8(read("out")); }
  /// It answers.
  bool isReady() const { return control({"info"}) == 0; }
  /// From now on everything sounds by this output.
  bool sendTo(const QString& output) const { return control({"set-default-sink", output}) == 0; }
  /// What that output plays goes into a file, from now on.
  void record(const QString& output) {
    recorder_.setProcessEnvironment(environment());
    recorder_.setStandardOutputFile(path("sound"));
    recorder_.start(
        "parec", {"--server", QString::fromUtf8(address()), "--device", output + ".monitor",
                  "--format=s16le", "--rate=48000", "--channels=2", "--raw", "--latency-msec=50"});
  }
  /// Values so far, left and right in turn.
  std::vector<std::int16_t> recorded() const {
    const QByteArray bytes = read("sound");
    std::vector<std::int16_t> values(static_cast<std::size_t>(bytes.size()) / sizeof(std::int16_t));
    std::memcpy(values.data(), bytes.constData(), values.size() * sizeof(std::int16_t));
    return values;
  }
  /// The largest of them from a place on, 0 to 1.
  double peakFrom(std::size_t place) const {
    int largest = 0;
    const std::vector<std::int16_t> values = recorded();
    for (std::size_t i = place; i < values.size(); ++i) {
      largest = std::max(largest, std::abs(static_cast<int>(values[i])));
    }
    return largest / 32768.0;
  }

 private:
  QString path(const QString& name) const { return folder_.filePath(name); }
  QByteArray read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }
  QProcessEnvironment environment() const {
    QProcessEnvironment made = QProcessEnvironment::systemEnvironment();
    made.insert("HOME", folder_.path());
    made.insert("XDG_RUNTIME_DIR", folder_.path());
    made.remove("LD_PRELOAD");
    made.remove("PULSE_SERVER");
    return made;
  }
  int control(const QStringList& words) const {
    QProcess pactl;
    pactl.setProcessEnvironment(environment());
    pactl.start("pactl", QStringList{"--server", QString::fromUtf8(address())} + words);
    constexpr int kAnswerMs = 60'000;
    return pactl.waitForFinished(kAnswerMs) ? pactl.exitCode() : -1;
  }

  QTemporaryDir folder_;
  QProcess server_, recorder_;
};

}  // namespace relievo::test
