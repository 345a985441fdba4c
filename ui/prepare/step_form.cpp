// SPDX-License-Identifier: BSD-3-Clause
#include "ui/prepare/step_form.h"

#include <algorithm>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QScopedValueRollback>
#include <QSpinBox>
#include <QVBoxLayout>

#include "ui/prepare/step_words.h"
#include "ui/style/mnemonic.h"

namespace relievo {
namespace {

constexpr double kFar = 1e12;
constexpr int kDecimals = 4;
constexpr int kMostSeed = 1'000'000;

}  // namespace

StepForm::StepForm(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("step_form"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
}

void StepForm::show(const Step* step) {
  const bool same_kind = step != nullptr && form_ != nullptr && step_.index() == step->index();
  if (same_kind && *step == step_) return;
  const QScopedValueRollback<bool> quiet(filling_, true);
  // What has the keyboard keeps it: only the value of its field came from it.
  const QString focused = same_kind && focusWidget() != nullptr ? focusWidget()->objectName() : "";
  clear();
  if (step == nullptr) return;
  step_ = *step;
  auto* page = new QWidget;
  form_ = new QFormLayout(page);
  form_->setContentsMargins(0, 0, 0, 0);
  form_->setRowWrapPolicy(QFormLayout::WrapLongRows);
  layout()->addWidget(page);
  std::visit([this](const auto& s) { fill(s); }, *step);
  if (auto* field = focused.isEmpty() ? nullptr : findChild<QWidget*>(focused)) field->setFocus();
}

void StepForm::clear() {
  form_ = nullptr;
  while (QLayoutItem* item = layout()->takeAt(0)) {
    if (item->widget() != nullptr) {
      item->widget()->hide();
      item->widget()->setObjectName({});
      for (QWidget* child : item->widget()->findChildren<QWidget*>()) child->setObjectName({});
      item->widget()->deleteLater();
    }
    delete item;
  }
}

template <class Widget>
Widget* StepForm::field(const QString& title, const char* name, const QString& tip) {
  auto* widget = new Widget;
  widget->setObjectName(QString::fromLatin1(name));
  widget->setAccessibleName(withoutMnemonic(title));
  widget->setToolTip(tip);
  form_->addRow(title, widget);
  return widget;
}

QSpinBox* StepForm::whole(const QString& title, const char* name, const QString& tip, int least,
                          int most, int value) {
  auto* box = field<QSpinBox>(title, name, tip);
  box->setRange(least, most);
  box->setValue(value);
  box->setKeyboardTracking(false);
  return box;
}

QDoubleSpinBox* StepForm::real(const QString& title, const char* name, const QString& tip,
                               double least, double most, double value, const QString& suffix) {
  auto* box = field<QDoubleSpinBox>(title, name, tip);
  box->setDecimals(kDecimals);
  box->setRange(least, most);
  box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  box->setSuffix(suffix);
  box->setValue(value);
  box->setKeyboardTracking(false);
  return box;
}

void StepForm::note(const QString& text) {
  auto* label = new QLabel(text);
  label->setWordWrap(true);
  form_->addRow(label);
}

template <class Kind, class Set>
void StepForm::put(const Set& set) {
  if (filling_) return;
  Step next = step_;
  auto* const of = std::get_if<Kind>(&next);
  if (of == nullptr) return;
  set(*of);
  if (next == step_) return;
  step_ = next;
  Q_EMIT changed(step_);
}

namespace {

/// Adds "inside" and "outside" and tells which is chosen.
void fillSides(QComboBox* box, bool keep_inside) {
  box->addItem(StepForm::tr("What is inside"));
  box->addItem(StepForm::tr("What is outside"));
  box->setCurrentIndex(keep_inside ? 0 : 1);
}

}  // namespace

void StepForm::fill(const CropBox& step) {
  auto* side = field<QComboBox>(tr("Stays"), "crop_side", tr("Which part of the scan stays"));
  fillSides(side, step.keep_inside);
  connect(side, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int index) { put<CropBox>([&](CropBox& s) { s.keep_inside = index == 0; }); });
  struct Edge {
    QString title;
    const char* name;
    FilePoint CropBox::*corner;
    double FilePoint::*axis;
  };
  const std::array<Edge, 6> edges{{{tr("x from"), "crop_x_min", &CropBox::min, &FilePoint::x},
                                   {tr("x to"), "crop_x_max", &CropBox::max, &FilePoint::x},
                                   {tr("y from"), "crop_y_min", &CropBox::min, &FilePoint::y},
                                   {tr("y to"), "crop_y_max", &CropBox::max, &FilePoint::y},
                                   {tr("z from"), "crop_z_min", &CropBox::min, &FilePoint::z},
                                   {tr("z to"), "crop_z_max", &CropBox::max, &FilePoint::z}}};
  for (const Edge& e : edges) {
    auto* box = real(e.title, e.name, tr("In the file's coordinates"), -kFar, kFar,
                     step.*e.corner.*e.axis, {});
    connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
            [this, corner = e.corner, axis = e.axis](double value) {
              // Only what was typed: the field shows less digits than there are.
              put<CropBox>([&](CropBox& s) {
                s.*corner.*axis = value;
                const bool is_max = corner == &CropBox::max;
                FilePoint& other = is_max ? s.min : s.max;
                other.*axis = is_max ? std::min(other.*axis, value) : std::max(other.*axis, value);
              });
            });
  }
}

void StepForm::fill(const CropOutline& step) {
  auto* side = field<QComboBox>(tr("Stays"), "outline_side", tr("Which part of the scan stays"));
  fillSides(side, step.keep_inside);
  connect(side, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    put<CropOutline>([&](CropOutline& s) { s.keep_inside = index == 0; });
  });
  auto* draw =
      new QPushButton(step.outline.empty() ? tr("&Draw on the view") : tr("&Draw it anew"));
  draw->setObjectName(QStringLiteral("outline_draw"));
  draw->setAccessibleName(withoutMnemonic(draw->text()));
  draw->setToolTip(
      tr("Drag the mouse round what is meant; or arrow keys and Enter for each corner, Ctrl+Enter "
         "to close"));
  draw->setAutoDefault(false);
  form_->addRow(draw);
  connect(draw, &QPushButton::clicked, this, &StepForm::outlineAsked);
  note(step.outline.empty() ? tr("No outline is drawn yet; nothing is left out.")
                            : tr("%1 corners").arg(step.outline.size()));
}

void StepForm::fill(const Classes& step) {
  auto* list = field<QLineEdit>(tr("Classes that stay"), "classes_keep",
                                tr("Numbers of LAS classes such as 2, 6; none: all"));
  QStringList kept;
  for (const int c : step.keep) kept << QString::number(c);
  list->setText(kept.join(QStringLiteral(", ")));
  list->setValidator(
      new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[0-9, ]*")), list));
  connect(list, &QLineEdit::editingFinished, this, [this, list] {
    put<Classes>([&](Classes& s) {
      s.keep.clear();
      for (const QString& word :
           list->text().split(QRegularExpression(QStringLiteral("[, ]+")), Qt::SkipEmptyParts)) {
        const int number = word.toInt();
        if (number >= 0 && number <= 255) s.keep.push_back(static_cast<std::uint8_t>(number));
      }
    });
  });
  auto* noise = new QCheckBox(tr("Noise stays, too"));
  noise->setObjectName(QStringLiteral("classes_noise"));
  noise->setAccessibleName(noise->text());
  noise->setToolTip(tr("Classes 7 and 18 are marked as noise"));
  noise->setChecked(step.keep_noise);
  form_->addRow(noise);
  connect(noise, &QCheckBox::toggled, this,
          [this](bool on) { put<Classes>([&](Classes& s) { s.keep_noise = on; }); });
}

void StepForm::fill(const Returns& step) {
  auto* kept = field<QComboBox>(tr("Returns that stay"), "returns_keep",
                                tr("Of each pulse of a laser scanner; one that came back once is "
                                   "first, last and single"));
  kept->addItem(tr("First: the tops of trees and roofs"));
  kept->addItem(tr("Last: mostly the ground"));
  kept->addItem(tr("Single: pulses that came back once"));
  kept->setCurrentIndex(static_cast<int>(step.keep));
  connect(kept, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
    put<Returns>([&](Returns& s) { s.keep = static_cast<ReturnChoice>(index); });
  });
}

void StepForm::fill(const Intensities& step) {
  auto* low = real(tr("From"), "intensity_low", tr("Lowest intensity that stays, as stored"), -kFar,
                   kFar, step.low, {});
  auto* high = real(tr("To"), "intensity_high", tr("Highest intensity that stays, as stored"),
                    -kFar, kFar, step.high, {});
  connect(low, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    put<Intensities>([&](Intensities& s) {
      s.low = value;
      s.high = std::max(s.high, value);
    });
  });
  connect(high, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    put<Intensities>([&](Intensities& s) {
      s.high = value;
      s.low = std::min(s.low, value);
    });
  });
}

void StepForm::fill(const Duplicates&) {
  note(tr("Of points with equal coordinates the first stays."));
}

void StepForm::fill(const Outliers& step) {
  auto* count =
      whole(tr("Neighbours"), "outliers_neighbours", tr("How many nearest points are looked at"), 1,
            kMostNeighbours, step.neighbours);
  auto* far = real(tr("Deviations"), "outliers_deviations",
                   tr("Points farther from these than the mean and so many standard deviations go"),
                   0, 1000, step.deviations, {});
  connect(count, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int value) { put<Outliers>([&](Outliers& s) { s.neighbours = value; }); });
  connect(far, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { put<Outliers>([&](Outliers& s) { s.deviations = value; }); });
}

void StepForm::fill(const Lonely& step) {
  auto* how = field<QComboBox>(tr("Radius in"), "lonely_unit",
                               tr("Whether the radius follows the scan's density"));
  how->addItem(tr("Spacings of the scan"));
  how->addItem(tr("Millimetres"));
  how->setCurrentIndex(step.radius_mm ? 1 : 0);
  auto* radius = real(tr("Radius"), "lonely_radius", tr("How far neighbours may be"), 0.0001, kFar,
                      step.radius_mm.value_or(step.spacings), {});
  auto* count = whole(tr("Neighbours"), "lonely_neighbours",
                      tr("Points with fewer neighbours within the radius go"), 1, kMostNeighbours,
                      step.neighbours);
  const auto tell = [this, how, radius] {
    put<Lonely>([&](Lonely& s) {
      if (how->currentIndex() == 1) {
        s.radius_mm = radius->value();
      } else {
        s.radius_mm.reset();
        s.spacings = radius->value();
      }
    });
  };
  connect(how, QOverload<int>::of(&QComboBox::currentIndexChanged), this, tell);
  connect(radius, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, tell);
  connect(count, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int value) { put<Lonely>([&](Lonely& s) { s.neighbours = value; }); });
}

void StepForm::fill(const Sparse& step) {
  auto* count =
      whole(tr("Neighbours"), "sparse_neighbours", tr("How many nearest points are looked at"), 1,
            kMostNeighbours, step.neighbours);
  auto* factor = real(tr("Times"), "sparse_factor",
                      tr("Points so many times as far from these as the densest of them go"), 1,
                      1000, step.factor, {});
  connect(count, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int value) { put<Sparse>([&](Sparse& s) { s.neighbours = value; }); });
  connect(factor, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { put<Sparse>([&](Sparse& s) { s.factor = value; }); });
  auto* off = real(tr("Off the surface"), "sparse_off_surface",
                   tr("Then points go that lie so many times as far off the plane of their "
                      "neighbours as others, at most 0.18 % of them"),
                   0, 1000, step.off_surface, {});
  off->setSpecialValueText(tr("Nothing goes"));
  connect(off, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { put<Sparse>([&](Sparse& s) { s.off_surface = value; }); });
}

void StepForm::fill(const Thin& step) {
  auto* spacing =
      real(tr("Spacing"), "thin_spacing", tr("In every cube of this side one point stays"), 0.0001,
           kFar, step.spacing_mm, QStringLiteral(" mm"));
  connect(spacing, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) { put<Thin>([&](Thin& s) { s.spacing_mm = value; }); });
}

void StepForm::fill(const Base& step) {
  auto* what = field<QComboBox>(tr("Its points"), "base_what",
                                tr("What becomes of the plane that holds most points"));
  what->addItem(tr("Are left out"));
  what->addItem(tr("Are laid level, with the object above them"));
  what->setCurrentIndex(step.lay ? 1 : 0);
  connect(what, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
          [this](int index) { put<Base>([&](Base& s) { s.lay = index == 1; }); });
  auto* distance = real(tr("Distance"), "base_distance",
                        tr("Nearer points are on the plane; 0: twice the scan's spacing"), 0, kFar,
                        step.distance_mm.value_or(0), QStringLiteral(" mm"));
  distance->setSpecialValueText(tr("Twice the spacing"));
  connect(distance, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double value) {
            put<Base>(
                [&](Base& s) { s.distance_mm = value > 0 ? std::optional(value) : std::nullopt; });
          });
}

void StepForm::fill(const Normals& step) {
  auto* count =
      whole(tr("Neighbours"), "normals_neighbours",
            tr("How many nearest points a normal is made of"), 3, kMostNeighbours, step.neighbours);
  connect(count, QOverload<int>::of(&QSpinBox::valueChanged), this,
          [this](int value) { put<Normals>([&](Normals& s) { s.neighbours = value; }); });
}

void StepForm::fill(const Align& step) {
  auto* how = field<QComboBox>(tr("Where they lie"), "align_method",
                               tr("How the scans are laid on the reference"));
  how->addItem(tr("As stored"), static_cast<int>(AlignMethod::stored));
  how->addItem(tr("By three picked pairs"), static_cast<int>(AlignMethod::points));
  how->addItem(tr("Automatic"), static_cast<int>(AlignMethod::automatic));
  how->setCurrentIndex(how->findData(static_cast<int>(step.method)));
  connect(how, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, how] {
    put<Align>([&](Align& s) { s.method = static_cast<AlignMethod>(how->currentData().toInt()); });
  });
  auto* seed = whole(tr("Seed"), "align_seed", tr("Another number is another search"), 1, kMostSeed,
                     static_cast<int>(step.seed));
  seed->setEnabled(step.method == AlignMethod::automatic);
  connect(how, QOverload<int>::of(&QComboBox::currentIndexChanged), seed, [how, seed] {
    seed->setEnabled(how->currentData().toInt() == static_cast<int>(AlignMethod::automatic));
  });
  connect(seed, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int value) {
    put<Align>([&](Align& s) { s.seed = static_cast<std::uint32_t>(value); });
  });
}

}  // namespace relievo
