// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QString>
#include <type_traits>

#include "ui/dialogs/figure/figure_number.h"

class QLineEdit;

namespace relievo {

/// Where a file of a figure is chosen.
struct FigurePlace {
  QString title, filter;  ///< Of the dialog that "..." opens.
  bool new_file = true;   ///< Or one that exists.
};

/// Adds rows to the form of a figure. [GUI thread]
class FigureFormRows {
 public:
  /// @param dialog   other dialogs stand before it; its font and screen say how wide a field is
  /// @param near     where files are looked for while a field is empty
  /// @param changed  is called after every change of a field by the person
  FigureFormRows(QFormLayout* layout, QWidget* dialog, QString near, std::function<void()> changed);

  template <class Widget>
  Widget* field(const QString& title, const char* name, const QString& tip) {
    auto* widget = new Widget;
    if constexpr (std::is_base_of_v<QCheckBox, Widget>) {
      widget->setText(title);
      addBox(widget, title, name, tip);
    } else {
      addRow(widget, title, name, tip);
    }
    if constexpr (std::is_base_of_v<QComboBox, Widget>) {
      widget->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
      QObject::connect(widget, QOverload<int>::of(&QComboBox::activated), widget, changed_);
    } else if constexpr (std::is_base_of_v<FigureNumber, Widget>) {
      QObject::connect(widget, QOverload<double>::of(&QDoubleSpinBox::valueChanged), widget,
                       changed_);
    }
    return widget;
  }

  /// A path, with a button that looks for another.
  QLineEdit* place(const QString& title, const char* name, const QString& tip,
                   const FigurePlace& chosen_in);

 private:
  void addBox(QCheckBox* box, const QString& title, const char* name, const QString& tip);
  void addRow(QWidget* field, const QString& title, const char* name, const QString& tip);

  QFormLayout* layout_;
  QWidget* dialog_;
  QString near_;
  std::function<void()> changed_;
};

/// Enables a field, or says in its tooltip what keeps it from being of use.
void setUsable(QWidget* widget, bool usable, const QString& why_not);
/// The same of a path and of its button.
void setPlaceUsable(QLineEdit* path, bool usable, const QString& why_not);

}  // namespace relievo
