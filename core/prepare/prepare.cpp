// SPDX-License-Identifier: BSD-3-Clause
#include "core/prepare/prepare.h"

#include <sys/mman.h>

#include <array>
#include <csignal>
#include <utility>

#include "core/base/error.h"
#include "core/io/file_check.h"
#include "core/io/number_text.h"
#include "core/io/worker_process.h"
#include "core/prepare/assemble.h"
#include "core/prepare/transport.h"
#include "core/prepare/worker.h"

namespace relievo {
namespace {

struct CommonUnit {
  LengthUnit unit = LengthUnit::mm;
  bool known = false;
};

/// What all scans are in. @throw ArgumentError
CommonUnit commonUnit(const std::vector<const Scan*>& scans, const Recipe& recipe) {
  CommonUnit common;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const auto given = recipe.scans.empty() ? std::nullopt : recipe.scans[i].unit;
    const auto known = given ? given : scans[i]->info.unit;
    const LengthUnit unit = known.value_or(LengthUnit::mm);
    if (i > 0 && (unit != common.unit || known.has_value() != common.known)) {
      throw ArgumentError("The scans are not all in one unit: " + shownName(scans[0]->info.file) +
                          " is in " +
                          (common.known ? std::string(name(common.unit)) : "none that it states") +
                          ", " + shownName(scans[i]->info.file) + " in " +
                          (known ? std::string(name(unit)) : "none that it states") +
                          ". Nothing was done. Give --unit if it is the same for all.");
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
  const std::string nothing = " Nothing was changed.";
  if (!end.exited && end.number == SIGXCPU) {
    throw FileError("The scans cannot be prepared: the steps take more than " +
                    grouped(static_cast<std::uint64_t>(options.max_cpu_s)) +
                    " s of processor time." + nothing + " Thin the scans out first.");
  }
  if (!end.exited && end.number == SIGKILL) {
    throw FileError(
        "The scans cannot be prepared: the system stopped the work, probably for lack of memory." +
        nothing + " Close other programs, or thin the scans out first.");
  }
  const std::string words = end.last_words.empty() ? "" : " (\"" + end.last_words + "\")";
  throw FileError("The scans cannot be prepared: the program that does it broke down" + words +
                  "." + nothing + " Leave out one step after the other to find the one.");
}

PrepareAnswer workedOn(const PrepareJob& job, const PrepareOptions& options, const Task& task) {
  const OwnedFd input(::memfd_create("relievo-prepare", MFD_CLOEXEC));
  if (input.get() < 0) {
    throw FileError(
        "The scans cannot be prepared: the system gives no memory for them. Nothing was changed. "
        "Close other programs and try again.");
  }
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
      throw ArgumentError(refusal->message);
    }
  }
  refuseEnd(options, end);
}

}  // namespace

std::vector<std::string> Prepared::notDone() const {
  std::vector<std::string> words;
  for (const StepResult& step : answer.steps) {
    if (!step.done) words.push_back(step.note);
  }
  return words;
}

Prepared prepare(const std::vector<const Scan*>& scans, const Recipe& recipe,
                 const PrepareOptions& options, const Task& task) {
  task.check();
  check(recipe);
  if (scans.empty() || scans.size() > kMostScans ||
      (!recipe.scans.empty() && recipe.scans.size() != scans.size())) {
    throw ArgumentError("The recipe is for " + std::to_string(recipe.scans.size()) +
                        " scans, but there are " + std::to_string(scans.size()) +
                        ". Nothing was done.");
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
