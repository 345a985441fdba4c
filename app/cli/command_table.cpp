// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/command_table.h"

#include <CLI/CLI.hpp>

#include "app/cli/verbs/declare_verbs.h"

namespace relievo {
namespace {

/// "TEXT:{json,text}" -> json, text.
std::vector<std::string> wordsOf(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

OptionRow rowOf(const CLI::Option& option) {
  OptionRow row;
  for (const std::string& name : option.get_snames()) row.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) row.names.push_back("--" + name);
  if (row.names.empty()) row.names.push_back(option.get_name());
  if (option.get_items_expected_max() > 0) row.value = option.get_type_name();
  row.words = wordsOf(row.value);
  row.help = option.get_description();
  row.required = option.get_required();
  row.repeated = option.get_items_expected_max() > 1;
  return row;
}

std::vector<CommandRow> rowsOf(const CLI::App& app) {
  std::vector<CommandRow> table;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    CommandRow row{.name = command->get_name(),
                   .help = command->get_description(),
                   .positionals = {},
                   .options = {},
                   .parts = rowsOf(*command)};
    for (const CLI::Option* option : command->get_options()) {
      (option->get_positional() ? row.positionals : row.options).push_back(rowOf(*option));
    }
    table.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<CommandRow> commandTable() {
  CLI::App app;
  std::vector<batch::Verb> verbs = batch::verbs();
  std::string format;
  batch::declareVerbs(app, verbs, format);
  return rowsOf(app);
}

}  // namespace relievo
