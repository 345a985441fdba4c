// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <QObject>
#include <QProcess>
#include <QStringList>

#include "core/message/message.h"
#include "plugins/voice/ssip.h"

namespace relievo {

/// Which program speaks where Speech Dispatcher does not.
struct SpeakingProgram {
  QString name = QStringLiteral("espeak-ng");
  QStringList more = {};  ///< Arguments: tests let it write a file.
};

/// Says one text after the other by a child each, which is ended to be silent. [GUI thread]
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
  void leave(QProcess& child);

  SpeakingProgram program_;
  QProcess* child_ = nullptr;  // Of this, until it has ended.
};

}  // namespace relievo
