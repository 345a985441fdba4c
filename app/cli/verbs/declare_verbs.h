// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/cli/verb.h"

namespace relievo::batch {

/// Makes each verb a subcommand with its options, and gives it `--report`.
/// @param verbs, format  must outlive the parser, which keeps references to them
void declareVerbs(CLI::App& app, std::vector<Verb>& verbs, std::string& format);

}  // namespace relievo::batch
