// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/io/import.h"
#include "core/prepare/align/align.h"
#include "core/prepare/recipe.h"

namespace relievo {

/// One of the scans, as chosen.
struct PrepareInput {
  std::filesystem::path file;
  ScanChoices read = {};  ///< What of the file.
  bool accept_incomplete = false;
  std::optional<LengthUnit> unit = std::nullopt;  ///< Nothing: as the file says.
  bool used = true;
  friend bool operator==(const PrepareInput&, const PrepareInput&) = default;
};

struct PrepareStep {
  Step step;
  bool on = true;
  friend bool operator==(const PrepareStep&, const PrepareStep&) = default;
};

/// Everything that is chosen. Scans are counted from 0 among all inputs, used or not, also in the
/// step Align, of which there is at most one: with two inputs or more there always is.
struct PrepareChoices {
  std::vector<PrepareInput> inputs;
  std::vector<PrepareStep> steps;
  friend bool operator==(const PrepareChoices&, const PrepareChoices&) = default;
};

/// What the dialog Prepare shows, without a window: the choices and their history, the recipe they
/// are, and where scans were found to lie, so that they are not searched again for every change of
/// a later step. [GUI thread]
class PrepareState {
 public:
  explicit PrepareState(PrepareChoices first);

  const PrepareChoices& now() const { return history_[at_]; }
  /// Becomes what undo leaves. Nothing happens if it is what there is.
  /// @param merge  a number for changes that are one step of the history, such as of one field; 0:
  ///               a step of its own
  void change(PrepareChoices next, int merge = 0);
  bool undo();
  bool redo();
  bool canUndo() const { return at_ > 0; }
  bool canRedo() const { return at_ + 1 < history_.size(); }

  // Changes with a rule of their own.
  /// After the last step that sees every scan alone, for a step that does; else at the end.
  /// @return  its place
  std::size_t addStep(const Step& step);
  void removeStep(std::size_t step);
  /// @return  false: there is no room  @param by  -1 or 1
  bool moveStep(std::size_t step, int by);
  void addInputs(const std::vector<PrepareInput>& inputs);
  /// A file's scans, each for itself in the place of the one. @param parts  how many
  void splitInput(std::size_t input, int parts);
  /// With the pairs that were picked on it. @pre two or more
  void removeInput(std::size_t input);

  std::optional<std::size_t> alignStep() const;
  /// Of now(): the input that the others are laid on, one that is used.
  std::size_t reference() const;
  std::vector<std::size_t> usedInputs() const;
  /// Of the inputs in use and the steps that are on, numbered as a recipe does. Without Align if
  /// one input is used. Poses that were found for the same beginning are in it.
  /// An outline that is not drawn yet is no step.
  Recipe recipe() const;
  /// Which of now().steps the steps of recipe() are.
  std::vector<std::size_t> stepsInRecipe() const;

  /// Where the scans of `recipe`, which `choices` gave, were found to lie: kept if all hold.
  void keepPoses(const PrepareChoices& choices, const Recipe& recipe, const AlignAnswer& answer);
  /// What was said when the poses in recipe() were found; nothing: they were not.
  const AlignAnswer* foundAlign() const;

 private:
  struct Found {
    std::vector<PrepareInput> inputs;  ///< In use.
    std::vector<Step> steps;           ///< Up to Align, without poses.
    AlignAnswer answer;
  };
  Recipe recipeWithoutPoses() const;

  std::vector<PrepareChoices> history_;
  std::size_t at_ = 0;
  int merge_ = 0;
  std::optional<Found> found_;
};

/// Does the step see every scan alone when there are several?
bool comesBeforeAlign(const Step& step) noexcept;

}  // namespace relievo
