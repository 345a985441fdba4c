// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QStringList;
class QWidget;

// Widgets of the panel Touch: each has a name for tests and scripts, and one for speech.
namespace relievo {

inline constexpr double kMmPerM = 1000, kUmPerMm = 1000, kPercent = 100;

void setNames(QWidget* widget, const char* object_name, const QString& accessible);
template <class Widget>
Widget* named(Widget* widget, const char* object_name, const QString& accessible) {
  setNames(widget, object_name, accessible);
  return widget;
}

/// A text that the program changes and a person may select.
QLabel* readout(const char* object_name, const QString& accessible);

QComboBox* choice(const char* object_name, const QString& accessible, const QStringList& items);

struct NumberBox {
  const char* object_name;
  QString accessible, suffix, tip;
  double least, most, step;
  int decimals;
};
QDoubleSpinBox* numberBox(const NumberBox& what);

/// A row whose label leads to `buddy`.
void addLabelled(QFormLayout* form, const QString& text, QWidget* buddy, QWidget* field);

/// No repaint and no event if nothing changed.
void setTextIfNew(QLabel* label, const QString& text);

}  // namespace relievo
