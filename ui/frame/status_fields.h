// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <QObject>
#include <QString>

class QLabel;
class QProgressBar;
class QStatusBar;
class QTimer;
class QToolButton;
class QWidget;

namespace relievo {

class Announcer;
class StatusRows;

enum class StatusField { message, position, origin, detail, force, rate, recording, pointer };
inline constexpr std::size_t kStatusFieldCount = 8;

/// The status bar: fields that can be focused and read one by one, and the progress of long work
/// with Cancel. [GUI thread]
class StatusFields : public QObject {
  Q_OBJECT
 public:
  explicit StatusFields(QStatusBar& bar);

  /// @param tip  says more; shown as tooltip and accessible description
  void set(StatusField field, const QString& text, const QString& tip = {});
  QString text(StatusField field) const;
  QWidget* firstField() const;
  /// To whoever does not look, by the screen reader.
  void tell(const QString& words);

  /// A bar appears if the work lasts longer than 0.3 s.
  void beginWork();
  void showWork(const QString& step, double fraction);
  void endWork();
  QToolButton* cancelButton() const { return cancel_; }

 Q_SIGNALS:
  void cancelAsked();

 private:
  QLabel* label(StatusField field) const { return labels_[static_cast<std::size_t>(field)]; }

  std::array<QLabel*, kStatusFieldCount> labels_{};
  QWidget* work_;
  QLabel* work_step_;
  QProgressBar* work_bar_;
  QToolButton* cancel_;
  QTimer* work_delay_;
  Announcer* announcer_;        ///< Owned by the bar.
  StatusRows* rows_ = nullptr;  ///< Owned by the widget that it lays out.
};

}  // namespace relievo
