// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QStringList>
#include <QTemporaryDir>

/// A test of what a program does is no test where there is no such program.
#define RELIEVO_NEEDS_PROGRAM(name)                                              \
  if (QStandardPaths::findExecutable(QStringLiteral(name)).isEmpty()) {          \
    GTEST_SKIP() << "The program " name " is not installed; it is needed here."; \
  }                                                                              \
  static_assert(true)

namespace relievo::test {

/// Debian's speech-dispatcher, on a socket of its own, whose one module writes into a file what it
/// would say: language, rate, volume and text, by the generic module and a script. It has the null
/// driver of libao for its sound.
class SpeechDispatcher {
 public:
  SpeechDispatcher() {
    write("speechd.conf",
          "LogLevel 3\nAudioOutputMethod \"libao\"\n"
          "AddModule \"text\" \"sd_generic\" \"text.conf\"\nDefaultModule text\n");
    write(".libao", "default_driver=null\n");
    folder("modules");
    write("modules/text.conf",
          "Debug 0\nGenericExecuteSynth \"sh " + path("say.sh") +
              " '$LANGUAGE' '$RATE' '$VOLUME' '$DATA'\"\n"
              "GenericLanguage \"en\" \"en\" \"utf-8\"\nGenericLanguage \"de\" \"de\" \"utf-8\"\n"
              "GenericLanguage \"hi\" \"hi\" \"utf-8\"\nGenericRateAdd 0\n"
              "GenericRateMultiply 100\nGenericPunctNone \"\"\nAddVoice \"en\" \"male1\" \"en\"\n"
              "AddVoice \"de\" \"male1\" \"de\"\nAddVoice \"hi\" \"male1\" \"hi\"\n");
    write("say.sh", "echo $$ >" + path("speaker") +
                        "\nprintf '%s|%s|%s|%s\\n' \"$1\" \"$2\" \"$3\" \"$4\" >>" + path("said") +
                        "\nwhile [ -e " + path("slow") + " ]; do sleep 0.05; done\n");
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("HOME", folder_.path());
    process_.setProcessEnvironment(environment);
    process_.setStandardOutputFile(path("out"));
    process_.setStandardErrorFile(path("out"));
    process_.start("speech-dispatcher", {"-s", "-t", "0", "-C", folder_.path(), "-S", socket(),
                                         "-P", path("pid"), "-L", folder_.path()});
  }
  ~SpeechDispatcher() { stop(); }
  void stop() {
    process_.kill();
    process_.waitForFinished();
  }
  /// What spoke last still does; where speaking is slow, it ends only if it is cut.
  bool isSpeaking() const {
    const QString speaker = read("speaker").trimmed();
    return !speaker.isEmpty() && QFile::exists("/proc/" + speaker);
  }
  /// Speaking lasts from now on until it is quick again.
  void speakSlowly(bool slowly) {
    if (slowly) {
      write("slow", "");
    } else {
      QFile::remove(path("slow"));
    }
  }

  QString socket() const { return path("socket"); }
  /// It takes a connection: its socket is there some time before.
  bool isListening() const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, socket().toUtf8().constData(), sizeof address.sun_path - 1);
    const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
    const bool connected =
        ::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    ::close(fd);
    return connected;
  }
  QStringList said() const { return read("said").split('\n', Qt::SkipEmptyParts); }
  QString log() const { return read("out"); }

 private:
  QString path(const QString& name) const { return folder_.filePath(name); }
  void folder(const QString& name) const { QDir(folder_.path()).mkdir(name); }
  QString read(const QString& name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
  }
  void write(const QString& name, const QString& text) const {
    QFile file(path(name));
    if (file.open(QIODevice::WriteOnly)) file.write(text.toUtf8());
  }

  QTemporaryDir folder_;
  QProcess process_;
};

}  // namespace relievo::test
