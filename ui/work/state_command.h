// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QUndoCommand>

#include "ui/work/document.h"

namespace relievo {

/// Nothing that a step brings back differs.
bool sameInSteps(const DocumentState& a, const DocumentState& b);

/// The present state with what differs between two others as the second has it.
DocumentState withChange(DocumentState now, const DocumentState& from, const DocumentState& to);

/// An edit of the state of a document: undo and redo change what it changed, and nothing else.
/// [GUI thread]
class StateCommand : public QUndoCommand {
 public:
  /// @param merge_id  -1: a step of its own; else one step with those of the same id before it
  StateCommand(Document& document, DocumentState before, DocumentState after, const QString& name,
               int merge_id);

  void undo() override;
  void redo() override;
  int id() const override { return merge_id_; }
  bool mergeWith(const QUndoCommand* later) override;
  const DocumentState& before() const { return before_; }
  const DocumentState& after() const { return after_; }

 private:
  void keepTurn(DocumentState& left) const;

  Document& document_;
  DocumentState before_, after_;
  int merge_id_;
};

}  // namespace relievo
