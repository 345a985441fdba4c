// SPDX-License-Identifier: BSD-3-Clause
#include "plugins/voice/espeak_child.h"

#include <algorithm>
#include <utility>

#include "core/message/catalogue.h"

namespace relievo {

EspeakChild::EspeakChild(SpeakingProgram program, QObject* parent)
    : QObject(parent), program_(std::move(program)) {}

EspeakChild::~EspeakChild() {
  cancel();
  // What is being ended ends at once, for it was killed.
  for (auto* child : findChildren<QProcess*>()) {
    constexpr int kMost = 5000;
    child->disconnect();
    child->waitForFinished(kMost);
  }
}

void EspeakChild::speak(const QString& text, const SpeechStyle& style) {
  cancel();
  auto* child = new QProcess(this);
  child_ = child;
  const std::filesystem::path name = program_.name.toStdString();
  connect(child, &QProcess::errorOccurred, this, [this, child, name](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    const bool is_wanted = child == child_;
    leave(*child);
    if (is_wanted) Q_EMIT failed(said<MessageId::voice_no_program>(name));
  });
  connect(child, QOverload<int, QProcess::ExitStatus>::of(&QProcess::finished), this,
          [this, child, name](int code, QProcess::ExitStatus how) {
            const bool is_wanted = child == child_;
            leave(*child);
            if (!is_wanted) return;
            if (code != 0 || how != QProcess::NormalExit) {
              Q_EMIT failed(said<MessageId::voice_program_failed>(name));
            } else {
              Q_EMIT ended();
            }
          });
  child->setStandardErrorFile(QProcess::nullDevice());
  child->setProgram(program_.name);
  child->setArguments(program_.more +
                      QStringList{QStringLiteral("-v"), QString::fromStdString(style.language),
                                  QStringLiteral("-s"), QString::number(style.words_per_minute),
                                  QStringLiteral("-a"),
                                  QString::number(std::clamp(style.volume_percent, 0, 100)),
                                  QStringLiteral("--stdin")});
  child->start();
  child->write(text.toUtf8() + '\n');
  child->closeWriteChannel();
}

void EspeakChild::cancel() {
  if (child_ == nullptr) return;
  std::exchange(child_, nullptr)->kill();
}

void EspeakChild::leave(QProcess& child) {
  if (&child == child_) child_ = nullptr;
  child.deleteLater();
}

}  // namespace relievo
