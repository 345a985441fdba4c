// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/output/exhibit_setup_controller.h"

#include <QLocale>

#include "ui/dialogs/exhibit/exhibit_dialog.h"
#include "ui/translations/message_languages.h"
#include "ui/work/file_names.h"

namespace relievo {

ExhibitSetupController::ExhibitSetupController(const ControllerParts& parts) : Controller(parts) {
  commands_.on(Command::exhibit_setup, this, [this] { show(); });
}

void ExhibitSetupController::show() {
  if (auto* shown = window_.findChild<ExhibitDialog*>()) {
    shown->raise();
    return;
  }
  auto* dialog = new ExhibitDialog(begun(), &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->open();
}

Exhibit ExhibitSetupController::begun() const {
  Exhibit begun;
  begun.languages = {std::string(messageLanguage(QLocale().name().toStdString()).tag)};
  if (!document_.isOpen()) return begun;
  const QString& project = document_.saved().projectFile();
  const QString file = project.isEmpty() ? document_.file() : project;
  if (isAddress(file)) return begun;
  ExhibitObject object;
  object.file = bytesOfPath(file);
  if (project.isEmpty()) {
    const SurfaceOptions& options = document_.project().options;
    object.unit = options.unit;
    const bool is_named = options.view && !options.view->rotation &&
                          options.view->turn_deg == std::array<double, 3>{};
    if (is_named) object.view = options.view->name;
  }
  begun.objects.push_back(std::move(object));
  return begun;
}

}  // namespace relievo
