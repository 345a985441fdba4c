// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clocale>  // With the locales of threads, which POSIX adds to it.

namespace relievo::python {

/// As long as it lives, this thread reads and writes numbers with a point, whatever language
/// somebody's Python has set for the process: relievo's own programs do nothing else.
class PlainNumbers {
 public:
  PlainNumbers() : plain_(newlocale(LC_NUMERIC_MASK, "C", nullptr)), before_(uselocale(plain_)) {}
  ~PlainNumbers() {
    uselocale(before_);
    freelocale(plain_);
  }
  PlainNumbers(const PlainNumbers&) = delete;
  PlainNumbers& operator=(const PlainNumbers&) = delete;

 private:
  locale_t plain_, before_;
};

}  // namespace relievo::python
