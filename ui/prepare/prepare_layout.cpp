// SPDX-License-Identifier: BSD-3-Clause
// How the dialog Prepare is laid out.
#include <array>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/language/core_text.h"
#include "ui/prepare/prepare_dialog.h"
#include "ui/prepare/step_form.h"
#include "ui/prepare/step_words.h"
#include "ui/style/dialog_size.h"
#include "ui/style/mnemonic.h"
#include "ui/style/text.h"

namespace relievo {
namespace {

constexpr int kListLines = 6;

QPushButton* button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QString::fromLatin1(name));
  made->setAccessibleName(withoutMnemonic(text).remove(u'\u2026'));
  made->setToolTip(tip);
  made->setAutoDefault(false);
  return made;
}

QTreeWidget* list(const QString& name, const char* object, const QStringList& heads) {
  auto* tree = new QTreeWidget;
  tree->setObjectName(QString::fromLatin1(object));
  tree->setAccessibleName(name);
  tree->setHeaderLabels(heads);
  tree->setRootIsDecorated(false);
  tree->setUniformRowHeights(true);
  tree->setTabKeyNavigation(false);
  // As high as there is room, but never so that the buttons below are out of sight.
  tree->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
  tree->setMinimumHeight(kListLines * tree->fontMetrics().height());
  tree->header()->setStretchLastSection(false);
  tree->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  return tree;
}

QLabel* words(const char* name, const QString& title) {
  auto* label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setAccessibleName(title);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

QComboBox* choice(const QString& title, const char* name, const QString& tip, QBoxLayout* row,
                  const QStringList& entries) {
  auto* box = new QComboBox;
  box->setObjectName(QString::fromLatin1(name));
  box->setAccessibleName(withoutMnemonic(title));
  box->setToolTip(tip);
  box->addItems(entries);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* label = new QLabel(title);
  label->setBuddy(box);
  row->addWidget(label);
  row->addWidget(box);
  return box;
}

QBoxLayout* rowOf(std::initializer_list<QWidget*> widgets) {
  auto* row = new QHBoxLayout;
  for (QWidget* w : widgets) row->addWidget(w);
  row->addStretch(1);
  return row;
}

constexpr std::array<const char*, 6> kSides{"front", "back", "left", "right", "top", "bottom"};

}  // namespace

void PrepareDialog::layOut() {
  auto* left = new QWidget;
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 6, 0);
  column->addWidget(scansPart(), 2);
  column->addWidget(stepsPart(), 3);
  auto* scroll = new QScrollArea;
  scroll->setWidget(left);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(left->minimumSizeHint().width() + 24);
  auto* columns = new QHBoxLayout;
  columns->addWidget(scroll, 1);
  columns->addWidget(viewsPart(), 2);
  auto* all = new QVBoxLayout(this);
  all->addLayout(columns, 1);
  all->addLayout(bottomRow());
  resizeToText(*this, {150, 44});
}

QWidget* PrepareDialog::scansPart() {
  auto* box = new QGroupBox(tr("Scans"));
  scans_ = list(tr("Scans"), "prepare_scans", {tr("Scan"), tr("Lies")});
  add_scan_ = button(tr("&Add\u2026"), "prepare_add_scans", tr("Further scans of the same object"));
  remove_scan_ =
      button(tr("Remove"), "prepare_remove_scan", tr("Take the chosen scan off the list"));
  make_reference_ = button(tr("Reference"), "prepare_reference",
                           tr("The chosen scan stays where it is; the others are laid on it"));
  pick_button_ = button(tr("Pic&k pairs\u2026"), "prepare_pick",
                        tr("Show the same three places on the chosen scan and on the reference"));
  take_back_ = button(tr("Take back"), "prepare_take_back", tr("Forget the place picked last"));
  remove_pair_ = button(tr("Remove pair"), "prepare_remove_pair",
                        tr("Forget the chosen pair, such as the one that fits worst (Delete)"));
  pairs_ = list(tr("Picked pairs"), "prepare_pairs", {tr("Pair"), tr("Error")});
  pairs_->setToolTip(
      tr("How far apart each pair's places are left where all pairs fit best; from three on"));
  split_ = button(tr("Split"), "prepare_split",
                  tr("Each of the file's scans for itself, to leave some out or align them"));
  withheld_ = new QCheckBox(tr("With withheld points"));
  withheld_->setObjectName(QStringLiteral("prepare_withheld"));
  withheld_->setAccessibleName(withheld_->text());
  withheld_->setToolTip(tr("Points of the chosen scan that its file marks as not to be used"));
  auto* column = new QVBoxLayout(box);
  column->addWidget(scans_, 1);
  column->addLayout(rowOf({add_scan_, remove_scan_, make_reference_}));
  column->addLayout(rowOf({pick_button_, take_back_, split_}));
  column->addWidget(pairs_, 1);
  column->addLayout(rowOf({remove_pair_}));
  column->addWidget(withheld_);
  connect(scans_, &QTreeWidget::itemChanged, this, &PrepareDialog::scanItemChanged);
  connect(scans_, &QTreeWidget::currentItemChanged, this, [this] {
    if (!filling_) showNumbers();
  });
  connect(add_scan_, &QPushButton::clicked, this, &PrepareDialog::addScans);
  connect(remove_scan_, &QPushButton::clicked, this, [this] {
    if (state_.now().inputs.size() < 2) return;
    state_.removeInput(chosenScan());
    choicesChanged();
  });
  connect(make_reference_, &QPushButton::clicked, this, [this] {
    PrepareChoices next = state_.now();
    const auto at = state_.alignStep();
    if (!at) return;
    auto& align = std::get<Align>(next.steps[*at].step);
    align.pairs.clear();  // Their other halves were picked on the reference before.
    align.reference = static_cast<std::uint32_t>(chosenScan());
    state_.change(std::move(next));
    choicesChanged();
  });
  connect(pick_button_, &QPushButton::clicked, this, [this] {
    if (pick_) {
      endPicking();
    } else {
      beginPicking();
    }
  });
  connect(take_back_, &QPushButton::clicked, this, &PrepareDialog::takeBackPick);
  connect(remove_pair_, &QPushButton::clicked, this, &PrepareDialog::removePair);
  auto* remove_key = new QShortcut(QKeySequence(QKeySequence::Delete), pairs_);
  remove_key->setContext(Qt::WidgetShortcut);
  connect(remove_key, &QShortcut::activated, this, &PrepareDialog::removePair);
  connect(split_, &QPushButton::clicked, this, [this] {
    const ReadScan* const read = readOf(state_.now().inputs[chosenScan()]);
    if (read == nullptr || read->scan->info.parts.size() < 2) return;
    state_.splitInput(chosenScan(), static_cast<int>(read->scan->info.parts.size()));
    choicesChanged();
  });
  connect(withheld_, &QCheckBox::toggled, this, [this](bool on) {
    if (filling_) return;
    PrepareChoices next = state_.now();
    next.inputs[chosenScan()].read.keep_withheld = on;
    state_.change(std::move(next));
    choicesChanged();
  });
  return box;
}

QWidget* PrepareDialog::stepsPart() {
  auto* box = new QGroupBox(tr("Steps"));
  steps_ = list(tr("Steps"), "prepare_steps", {tr("Step"), tr("Points")});
  add_step_ = button(tr("Add s&tep"), "prepare_add_step", tr("Choose what is done next"));
  add_step_->setMenu(new QMenu(add_step_));
  add_step_->menu()->setToolTipsVisible(true);
  connect(add_step_->menu(), &QMenu::aboutToShow, this, &PrepareDialog::makeStepMenu);
  remove_step_ =
      button(tr("Remove"), "prepare_remove_step", tr("Leave the chosen step out (Delete)"));
  remove_step_->setAccessibleName(tr("Remove step"));
  up_ = button(tr("Earlier"), "prepare_step_up", tr("Do the chosen step earlier (Ctrl+Up)"));
  down_ = button(tr("Later"), "prepare_step_down", tr("Do the chosen step later (Ctrl+Down)"));
  undo_ = button(tr("&Undo"), "prepare_undo", tr("Undo the last change (Ctrl+Z)"));
  redo_ = button(tr("R&edo"), "prepare_redo", tr("Redo it (Ctrl+Y)"));
  form_ = new StepForm;
  auto* column = new QVBoxLayout(box);
  column->addWidget(steps_, 1);
  column->addLayout(rowOf({add_step_, remove_step_}));
  column->addLayout(rowOf({up_, down_, undo_, redo_}));
  column->addWidget(form_);
  connect(steps_, &QTreeWidget::itemChanged, this, &PrepareDialog::stepItemChanged);
  connect(steps_, &QTreeWidget::currentItemChanged, this, &PrepareDialog::showForm);
  const auto remove = [this] {
    const auto step = chosenStep();
    if (!step || std::holds_alternative<Align>(state_.now().steps[*step].step)) return;
    state_.removeStep(*step);
    choicesChanged();
  };
  const auto shift = [this](int by) {
    const auto step = chosenStep();
    if (!step || !state_.moveStep(*step, by)) return;
    choicesChanged();
    steps_->setCurrentItem(steps_->topLevelItem(static_cast<int>(*step) + by));
  };
  connect(remove_step_, &QPushButton::clicked, this, remove);
  connect(up_, &QPushButton::clicked, this, [shift] { shift(-1); });
  connect(down_, &QPushButton::clicked, this, [shift] { shift(1); });
  connect(undo_, &QPushButton::clicked, this, &PrepareDialog::undo);
  connect(redo_, &QPushButton::clicked, this, &PrepareDialog::redo);
  const auto key = [this](const char* keys, QWidget* where, const std::function<void()>& run) {
    auto* shortcut = new QShortcut(QKeySequence(QLatin1String(keys)), where);
    shortcut->setContext(where == this ? Qt::WindowShortcut : Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, run);
  };
  key("Del", steps_, remove);
  key("Ctrl+Up", steps_, [shift] { shift(-1); });
  key("Ctrl+Down", steps_, [shift] { shift(1); });
  key("Ctrl+Z", this, [this] { undo(); });
  key("Ctrl+Y", this, [this] { redo(); });
  key("Ctrl+Shift+Z", this, [this] { redo(); });
  connect(form_, &StepForm::changed, this, [this](const Step& step) {
    const auto at = chosenStep();
    if (!at) return;
    PrepareChoices next = state_.now();
    next.steps[*at].step = step;
    // A field that is changed again and again is one step of the history.
    state_.change(std::move(next), 1 + static_cast<int>(*at));
    choicesChanged();
  });
  connect(form_, &StepForm::outlineAsked, this, &PrepareDialog::drawOutline);
  return box;
}

void PrepareDialog::makeStepMenu() {
  QMenu* menu = add_step_->menu();
  menu->clear();
  const PrepareInput& reference = state_.now().inputs[state_.reference()];
  const ReadScan* const first = readOf(reference);
  const LengthUnit unit = unitOf(reference);
  const double spacing = first != nullptr ? first->spacing : 1;
  for (const OfferedStep& offered : offeredSteps(boxLeft(), unit, spacing)) {
    QAction* action = menu->addAction(offered.text);
    action->setObjectName(QLatin1String("add_") +
                          QString::fromLatin1(kindOf(offered.steps.front()).data()) +
                          (offered.steps.size() > 1 ? "_all" : "") +
                          (std::holds_alternative<Base>(offered.steps.front()) &&
                                   std::get<Base>(offered.steps.front()).lay
                               ? "_lay"
                               : ""));
    connect(action, &QAction::triggered, this, [this, steps = offered.steps] { addSteps(steps); });
  }
}

QBoxLayout* PrepareDialog::lookRow() {
  auto* row = new QHBoxLayout;
  QStringList sides;
  for (const char* side : kSides) sides << viewText(QString::fromLatin1(side));
  side_ = choice(tr("Seen &from:"), "prepare_side", tr("From which side the points are seen"), row,
                 sides);
  for (int i = 0; i < side_->count(); ++i) {
    side_->setItemData(i, QString::fromLatin1(kSides[static_cast<std::size_t>(i)]));
  }
  stage_ = choice(tr("Sho&w:"), "prepare_stage", tr("Points before and after the steps"), row,
                  {tr("Before"), tr("Both, red goes"), tr("After")});
  stage_->setCurrentIndex(static_cast<int>(CloudStage::both));
  colour_ = choice(tr("Co&lours:"), "prepare_colour", tr("What the colours of the points say"), row,
                   {tr("Their own"), tr("One for each scan"), tr("Distance of the scans")});
  colour_->setItemData(2,
                       tr("From the surface of the other scans: blue at 0, red at three "
                          "spacings, grey where there is none"),
                       Qt::ToolTipRole);
  row->addStretch(1);
  connect(side_, QOverload<int>::of(&QComboBox::activated), this, [this](int side) {
    const Rotation view = *standardRotation(kSides[static_cast<std::size_t>(side)]);
    view_->look(view);
    if (other_box_->isVisible()) other_view_->look(view);
  });
  for (QComboBox* box : {stage_, colour_}) {
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
      showPicture();
      showWords();
    });
  }
  return row;
}

QWidget* PrepareDialog::viewsPart() {
  view_ = new CloudView(tr("Points"));
  view_->setObjectName(QStringLiteral("prepare_cloud"));
  view_->setToolTip(
      tr("Drag or arrow keys turn, the right button moves, the wheel or + and - bring "
         "it nearer, Home shows all"));
  other_view_ = new CloudView(tr("Points of the reference"));
  other_view_->setObjectName(QStringLiteral("prepare_reference_cloud"));
  view_title_ = new QLabel;
  other_title_ = new QLabel;
  for (QLabel* title : {view_title_, other_title_}) title->setWordWrap(true);
  const auto titled = [](QLabel* title, CloudView* view) {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(title);
    column->addWidget(view, 1);
    return box;
  };
  other_box_ = titled(other_title_, other_view_);
  auto* views = new QSplitter(Qt::Horizontal);
  views->setChildrenCollapsible(false);
  views->addWidget(titled(view_title_, view_));
  views->addWidget(other_box_);
  view_title_->hide();
  other_box_->hide();
  for (CloudView* view : {view_, other_view_}) {
    connect(view, &CloudView::said, this, &PrepareDialog::said);
    connect(view, &CloudView::toolLeft, this, [this] {
      if (pick_) endPicking();
      showOutline();
    });
    connect(view, &CloudView::pointChosen, this,
            [this, view](const FilePoint& point) { placePick(view == other_view_, point); });
  }
  connect(view_, &CloudView::outlineDrawn, this, &PrepareDialog::takeOutline);

  total_ = words("prepare_total", tr("How many points stay"));
  QFont bold = total_->font();
  bold.setBold(true);
  total_->setFont(bold);
  words_ = words("prepare_words", tr("What was done"));
  problem_ = words("prepare_problem", tr("Problem"));
  problem_->hide();
  auto* texts = new QWidget;
  auto* lines = new QVBoxLayout(texts);
  lines->setContentsMargins(0, 0, 0, 0);
  for (QLabel* label : {problem_, total_, words_}) lines->addWidget(label);
  lines->addStretch(1);
  auto* area = new QScrollArea;
  area->setWidget(texts);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setFocusPolicy(Qt::NoFocus);
  area->setMinimumHeight(4 * fontMetrics().height());

  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(lookRow());
  column->addWidget(views, 4);
  column->addWidget(area, 1);
  return part;
}

QBoxLayout* PrepareDialog::bottomRow() {
  live_ = new QCheckBox(tr("L&ive"));
  live_->setObjectName(QStringLiteral("prepare_live"));
  live_->setAccessibleName(tr("Live preview"));
  live_->setToolTip(tr("Do the steps anew after each change"));
  live_->setChecked(true);
  recompute_ = button(tr("Recom&pute"), "prepare_recompute", tr("Do the steps as they are shown"));
  recompute_->setAccessibleName(tr("Recompute"));
  stop_ = button(tr("&Stop"), "prepare_stop", tr("Stop the work; the picture before stays"));
  bar_ = new QProgressBar;
  bar_->setAccessibleName(tr("Progress"));
  bar_->setRange(0, 100);
  step_name_ = new QLabel;
  step_name_->setAccessibleName(tr("What is being done"));
  save_recipe_ = button(tr("Sa&ve recipe\u2026"), "prepare_save_recipe",
                        tr("Keep these steps as a file, to do them again"));
  copy_command_ = button(tr("Cop&y as command"), "prepare_copy_command",
                         tr("The command that does the same, once the recipe is saved"));
  file_ = new QLineEdit;
  file_->setObjectName(QStringLiteral("prepare_file"));
  file_->setAccessibleName(tr("Prepared scan"));
  file_->setToolTip(
      tr("The file that the prepared scan is written to; the scans stay as they are"));
  file_note_ = new QLabel(tr("It is there already and will be replaced."));
  auto* browse = button(tr("Choose\u2026"), "prepare_browse", tr("Another place or name"));
  browse->setAccessibleName(tr("Choose the file"));
  auto* file_title = new QLabel(tr("P&repared scan:"));
  file_title->setBuddy(file_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  nameButtons(*buttons);
  ok_ = buttons->button(QDialogButtonBox::Ok);
  ok_->setObjectName(QStringLiteral("prepare_ok"));
  ok_->setToolTip(tr("Write the prepared scan and open it"));
  for (QAbstractButton* made : buttons->buttons()) made->setAccessibleName(made->text());
  connect(buttons, &QDialogButtonBox::accepted, this, &PrepareDialog::take);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(live_, &QCheckBox::toggled, this, [this](bool on) {
    if (on && stale_) compute();
  });
  connect(recompute_, &QPushButton::clicked, this, &PrepareDialog::compute);
  connect(stop_, &QPushButton::clicked, this, [this] {
    take_when_made_ = reading_ = false;
    delay_->stop();
    worker_.cancel();
  });
  connect(save_recipe_, &QPushButton::clicked, this, &PrepareDialog::saveRecipe);
  connect(copy_command_, &QPushButton::clicked, this, &PrepareDialog::copyCommand);
  connect(browse, &QPushButton::clicked, this, &PrepareDialog::chooseFile);
  connect(file_, &QLineEdit::textChanged, this,
          [this] { file_note_->setVisible(QFileInfo::exists(outputFile())); });

  auto* files = new QHBoxLayout;
  files->addWidget(file_title);
  files->addWidget(file_, 1);
  files->addWidget(browse);
  files->addWidget(file_note_);
  file_note_->hide();
  auto* work = new QHBoxLayout;
  work->addWidget(live_);
  work->addWidget(recompute_);
  work->addWidget(step_name_);
  work->addWidget(bar_, 1);
  work->addWidget(stop_);
  work->addStretch(1);
  work->addWidget(save_recipe_);
  work->addWidget(copy_command_);
  work->addWidget(buttons);
  auto* rows = new QVBoxLayout;
  rows->addLayout(files);
  rows->addLayout(work);
  return rows;
}

}  // namespace relievo
