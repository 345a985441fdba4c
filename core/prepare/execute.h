// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/task.h"
#include "core/prepare/job.h"

namespace relievo {

/// Does the steps of a job, one after the other; every step on what the one before it left. The
/// same job gives the same answer. [worker, in the child process]
/// @param align  does the methods `points` and `auto`; empty: they are not done, and the answer
///               says so
/// @pre  the steps and sizes were checked
/// @throw ArgumentError  a step cannot be done with these scans  @throw Cancelled, std::bad_alloc
PrepareAnswer execute(const PrepareJob& job, const AlignFunction& align, const Task& task);

}  // namespace relievo
