// SPDX-License-Identifier: BSD-3-Clause
#include "ui/control/web_controller.h"

#include "core/message/catalogue.h"
#include "ui/control/open_controller.h"
#include "ui/dialogs/address_dialog.h"
#include "ui/message/message_text.h"
#include "ui/work/file_names.h"

namespace relievo {

WebController::WebController(const ControllerParts& parts, OpenController& opening)
    : Controller(parts), opening_(opening) {
  commands_.on(Command::open_address, this, [this] { choose(); });
  connect(&opening_, &OpenController::addressAsked, this, &WebController::choose);
  connect(&document_, &Document::toldOfWeb, this, &WebController::tell);
}

void WebController::choose(const QString& begun) {
  QStringList known;
  for (const QString& file : settings_.recentFiles()) {
    if (isAddress(file)) known << file;
  }
  auto* dialog = new AddressDialog(begun, known, &window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &AddressDialog::chosen, this,
          [this](const QString& address) { opening_.open(address); });
  dialog->open();
}

void WebController::tell(const Message& message) {
  const QString text = messageText(message);
  switch (message.id) {
    case MessageId::web_level_coarser:
    case MessageId::web_level_complete:
    case MessageId::web_map_from_before:
      messages_.announceAs(text, spokenMessage(message));
      return;
    case MessageId::web_server_back:
      if (!lost_.isEmpty() && messages_.shown() == lost_) messages_.close();
      lost_.clear();
      messages_.announceAs(text, spokenMessage(message));
      return;
    case MessageId::web_server_lost:
      lost_ = text;
      break;
    default:
      break;  // A tile that was refused.
  }
  messages_.show(text);
}

}  // namespace relievo
