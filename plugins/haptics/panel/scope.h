// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <QDialog>
#include <QString>
#include <span>

#include "plugins/api/plugin.h"

class QAction;
class QLabel;

namespace relievo {

/// The plots' samples of a stretch of time, as a file. Numbers with the dot, whatever the language.
QString scopeCsv(std::span<const ForcePoint> samples);
QString scopeSvg(std::span<const ForcePoint> samples);

/// Height of hand and proxy and force against time: drawn with a cursor. [GUI thread]
class ScopeView : public QWidget {
  Q_OBJECT
 public:
  static constexpr double kLeastSpanS = 0.05, kMostSpanS = 30;

  explicit ScopeView(QWidget* parent = nullptr);
  void add(std::span<const ForcePoint> samples);  ///< Shown unless paused; kept for 30 s.
  void setPaused(bool paused);
  void zoom(double factor);  ///< Shows `factor` times as long a stretch, about the cursor.
  void moveCursor(int by);   ///< By samples; pauses are not needed.
  std::span<const ForcePoint> shown() const { return shown_; }
  double spanS() const { return span_s_; }
  QString cursorText() const;  ///< Values at the cursor, for the label and for speech.

 Q_SIGNALS:
  void cursorMoved();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void take();  // shown_ from samples_.

  std::deque<ForcePoint> samples_;
  std::vector<ForcePoint> shown_;
  double span_s_ = 5, end_s_ = 0;
  std::size_t cursor_ = 0;  // Of shown_.
  bool paused_ = false;
};

/// The same with its commands: pause, zoom, SVG and CSV.
class ScopeDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ScopeDialog(QWidget* parent);
  void add(std::span<const ForcePoint> samples);
  ScopeView& view() { return *view_; }
  /// SVG or CSV, as the name's ending says. @return empty, or why not
  QString exportTo(const QString& file) const;

 private:
  QAction* command(const char* name, const QString& text, const QString& tip);
  void ask(const QString& filter, const QString& ending);

  ScopeView* view_;
  QLabel* values_;
};

}  // namespace relievo
