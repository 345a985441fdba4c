// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"

#include "core/base/failure.h"
#include "core/base/task.h"
#include "core/message/catalogue.h"

namespace relievo {

Error::Error(const Message& of_catalogue)
    : std::runtime_error(englishText(of_catalogue)),
      code(codeOf(of_catalogue)),
      message(std::make_shared<const Message>(of_catalogue)) {}

Message messageOf(const std::exception& error) {
  const auto* const ours = dynamic_cast<const Error*>(&error);
  if (ours != nullptr && ours->message) return *ours->message;
  return said<MessageId::quoted>(error.what());
}

void Task::throwCancelled() {
  throw failure<MessageId::cancelled>();
}

}  // namespace relievo
