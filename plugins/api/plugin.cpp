// SPDX-License-Identifier: BSD-3-Clause
// The meta-object of Host lives in this library.
#include "plugins/api/plugin.h"
