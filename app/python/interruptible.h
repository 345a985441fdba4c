// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>
#include <chrono>
#include <future>
#include <stop_token>

#include "app/python/plain_numbers.h"
#include "core/base/task.h"

namespace relievo::python {

/// Computes on a thread of its own while other threads of Python run; Ctrl+C stops it, and nobody
/// waits longer than the work takes to see that. [interpreter held]
/// @param work  called with a Task; touches no object of Python
/// @throw what `work` throws; pybind11::error_already_set  a signal's handler raised
template <class Work>
auto interruptible(const Work& work) {
  constexpr std::chrono::milliseconds kLook{50};
  std::stop_source stop;
  const pybind11::gil_scoped_release others_run;
  auto result = std::async(std::launch::async, [&work, token = stop.get_token()] {
    const PlainNumbers points_in_numbers;
    return work(Task{.stop = token, .progress = {}});
  });
  while (result.wait_for(kLook) != std::future_status::ready) {
    const pybind11::gil_scoped_acquire held;
    if (PyErr_CheckSignals() == 0) continue;
    stop.request_stop();
    {
      const pybind11::gil_scoped_release meanwhile;
      result.wait();
    }
    throw pybind11::error_already_set();
  }
  return result.get();
}

}  // namespace relievo::python
