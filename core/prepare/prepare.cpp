// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/prepare.h"

#include <sys/mman.h>

#include <array>
#include <csignal>
#include <utility>

#include "core/base/failure.h"
#include "core/io/file_check.h"
#include "core/io/formats/number_text.h"
#include "core/io/worker/worker_process.h"
#include "core/prepare/assemble.h"
#include "core/prepare/transport.h"
#include "core/prepare/worker.h"

namespace relievo {
namespace {

struct CommonUnit {
  LengthUnit unit = LengthUnit::mm;
  bool known = false;
};

Message messageOf(const CommonUnit& unit) {
  if (!unit.known) return said<MessageId::unit_not_stated>();
  return said<MessageId::quoted>(name(unit.unit));
}

/// What all scans are in. @throw ArgumentError
CommonUnit commonUnit(const std::vector<const Scan*>& scans, const Recipe& recipe) {
  CommonUnit common;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto given = recipe.scans.empty() ? std::nullopt : recipe.scans[i].unit;
    const auto known = given ? given : scans[i]->info.unit;
    const LengthUnit unit = known.value_or(LengthUnit::mm);
    if (i > 0 && (unit != common.unit || known.has_value() != common.known)) {
      throw failure<MessageId::scans_of_two_units>(
          shownName(scans[0]->info.file), messageOf(common), shownName(scans[i]->info.file),
          messageOf({unit, known.has_value()}));
    }
    common = {unit, known.has_value()};
  }
  return common;
}

PrepareJob jobOf(const std::vector<const Scan*>& scans, const Recipe& recipe, LengthUnit unit) {
  PrepareJob job{.steps = recipe.steps, .scans = {}};
  for (const Scan* scan : scans) {
    std::optional<FilePoint> viewpoint;
    if (scan->info.parts.size() == 1) viewpoint = scan->info.parts[0].viewpoint;
    job.scans.push_back({.name = scan->info.file.filename().string(),
                         .origin = scan->origin,
                         .viewpoint = viewpoint,
                         .mm_per_unit = mmPer(unit),
                         .points = scan->points,
                         .classes = scan->classes,
                         .returns = scan->returns,
                         .intensities = scan->intensities,
                         .intensity = scan->info.intensity});
  }
  return job;
}

[[noreturn]] void refuseEnd(const PrepareOptions& options, const WorkerEnd& end) {
  if (!end.exited && end.number == SIGXCPU) {
    throw failure<MessageId::prepare_took_long>(
        CountArgument::grouped(static_cast<std::uint64_t>(options.max_cpu_s)));
  }
  if (!end.exited && end.number == SIGKILL) {
    throw failure<MessageId::prepare_stopped_by_system>();
  }
  if (end.last_words.empty()) throw failure<MessageId::prepare_broke_down>();
  throw failure<MessageId::prepare_broke_down_saying>(end.last_words);
}

PrepareAnswer workedOn(const PrepareJob& job, const PrepareOptions& options, const Task& task) {
  const OwnedFd input(::memfd_create("relievo-prepare", MFD_CLOEXEC));
  if (input.get() < 0) throw failure<MessageId::prepare_without_memory>();
  sendJob(input.get(), job, task);
  task.report("preparing", 0);
  WorkerProcess worker({.program = kPrepareProgram,
                        .arguments = {kPrepareArgument, std::to_string(options.max_memory_bytes),
                                      roundTripText(std::array{options.max_cpu_s})},
                        .input = input.get()});
  const WorkerEnd end = worker.wait(task);
  task.check();
  if (end.exited && end.number == 0) {
    auto answer = receivePrepareAnswer(worker.answerFd(), job, task);
    if (auto* good = std::get_if<PrepareAnswer>(&answer)) return std::move(*good);
    if (const auto* refusal = std::get_if<PrepareRefusal>(&answer)) {
      const Message& message = refusal->message;
      throw ArgumentError(message);
    }
  }
  refuseEnd(options, end);
}

}  // namespace

std::vector<std::vector<Message>> Prepared::notDone() const {
  std::vector<std::vector<Message>> words;
  for (const StepResult& step : answer.steps) {
    if (!step.done) words.push_back(step.notes);
  }
  return words;
}

Prepared prepare(const std::vector<const Scan*>& scans, const Recipe& recipe,
                 const PrepareOptions& options, const Task& task) {
  task.check();
  check(recipe);
  if (scans.empty() || scans.size() > kMostScans ||
      (!recipe.scans.empty() && recipe.scans.size() != scans.size())) {
    throw failure<MessageId::recipe_for_other_scans>(recipe.scans.size(), scans.size());
  }
  const CommonUnit unit = commonUnit(scans, recipe);
  const PrepareJob job = jobOf(scans, recipe, unit.unit);
  Prepared prepared;
  prepared.unit = unit.unit;
  prepared.unit_known = unit.known;
  if (recipe.steps.empty()) {
    prepared.answer.poses.resize(scans.size());
  } else {
    prepared.answer = workedOn(job, options, task);
  }
  const PointBits all(job.points());
  const PointBits& kept = recipe.steps.empty() ? all : prepared.answer.steps.back().kept;
  prepared.scan = assembled(scans, prepared.answer.poses, kept, task);
  if (unit.known) prepared.scan.info.unit = unit.unit;
  return prepared;
}

}  // namespace relievo
