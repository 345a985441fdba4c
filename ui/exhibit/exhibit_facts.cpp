// SPDX-License-Identifier: BSD-3-Clause
#include "ui/exhibit/exhibit_facts.h"

#include <utility>

#include "core/base/error.h"
#include "core/describe/describe.h"
#include "core/session/surface.h"

namespace relievo {

void ExhibitFacts::find(const std::shared_ptr<const Surface>& surface) {
  worker_.cancel();
  facts_.clear();
  awaits_ = {};
  if (!surface) return;
  const auto found = std::make_shared<std::vector<Message>>();
  worker_.start(
      [surface, found](const Task&) {
        try {
          *found = sentencesOf(describe(*surface));
        } catch (const Error&) {
          found->clear();  // Its tiles cannot be read: whoever shows them says so.
        }
      },
      [this, found] {
        facts_ = std::move(*found);
        if (facts_.size() > kMost) facts_.resize(kMost);
        if (const Take take = std::exchange(awaits_, {})) take(facts_);
      });
}

void ExhibitFacts::give(Take take) {
  if (!worker_.busy()) return take(facts_);
  awaits_ = std::move(take);
}

}  // namespace relievo
