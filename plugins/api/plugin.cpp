// SPDX-License-Identifier: BSD-3-Clause
// The meta-object of ShownWindow lives in this library.
#include "plugins/api/plugin.h"
