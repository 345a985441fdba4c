// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <variant>

#include "core/base/task.h"
#include "core/message/message.h"
#include "core/prepare/job.h"

namespace relievo {

/// Why the worker has nothing to give.
struct PrepareRefusal {
  Message message;
};

/// Writes a job over whatever a memory file held. [worker] @throw Error, std::bad_alloc, Cancelled
void sendJob(int fd, const PrepareJob& job, const Task& task);

/// A job whose lists lie in the memory file it came in.
struct ReceivedJob {
  PrepareJob job;
  std::shared_ptr<const void> memory;
};
/// In the child. Nothing if the file holds no complete, consistent job.
std::optional<ReceivedJob> receiveJob(int fd);

/// Bytes of the file, for the child's limit of memory; 0 if it cannot be asked.
std::uint64_t jobBytes(int fd);

/// In the child. @throw Error, std::bad_alloc
void sendPrepareAnswer(int fd, const PrepareAnswer& answer);
void sendPrepareAnswer(int fd, const PrepareRefusal& refusal);

/// In the parent, as if the answer were hostile: sizes must agree, every step's points be among
/// those before it and as many as it says, poses rigid to 1e-9, normals of length 1 or 0, all
/// numbers finite. Nothing (monostate) if they are not. @throw Cancelled
std::variant<std::monostate, PrepareAnswer, PrepareRefusal> receivePrepareAnswer(
    int fd, const PrepareJob& job, const Task& task);

}  // namespace relievo
