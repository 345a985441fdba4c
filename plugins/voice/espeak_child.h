// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QStringList>
#include <QTimer>
#include <vector>

#include "core/message/message.h"
#include "plugins/voice/ssip.h"

namespace relievo {

/// Which program speaks where Speech Dispatcher does not.
struct SpeakingProgram {
  QString name = QStringLiteral("espeak-ng");
  QStringList more = {};  ///< Arguments: tests let it write a file.
};

/// Says one text after the other by a child each, which is ended to be silent. The child is made
/// without a copy of this process, whose pages the force loop would have to wait for otherwise, and
/// nothing here waits for it. [GUI thread]
class EspeakChild : public QObject {
  Q_OBJECT
 public:
  explicit EspeakChild(SpeakingProgram program, QObject* parent = nullptr);
  ~EspeakChild() override;

  /// In place of what is being said.
  void speak(const QString& text, const SpeechStyle& style);
  void cancel();
  bool isSpeaking() const { return child_ != nullptr; }

 Q_SIGNALS:
  void ended();
  void failed(const relievo::Message& why);

 private:
  struct Process;

  void start(Process& process, const QStringList& arguments);
  void hasEnded(const Process& process);
  void reap();

  SpeakingProgram program_;
  std::unique_ptr<Process> child_;
  /// Not yet buried: killed, or found to have ended a moment before the system says so.
  std::vector<std::unique_ptr<Process>> leaving_;
  QTimer burial_;
};

}  // namespace relievo
