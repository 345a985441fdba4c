// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <QString>

#include "core/base/error.h"
#include "ui/dialogs/figure/figure_dialog.h"
#include "ui/language/error_text.h"

namespace relievo {

/// Runs `work` and turns what it throws into words; nothing if it was stopped. [any thread]
template <class Work>
QString errorOf(const Work& work) {
  try {
    work();
  } catch (const Cancelled&) {
    return {};
  } catch (const Error& error) {
    return shownError(error);
  } catch (const std::bad_alloc&) {
    return FigureDialog::tr("There is not enough memory for this figure. Nothing was written.");
  }
  return {};
}

}  // namespace relievo
