// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/manual.h"

namespace relievo::manual {
namespace {

constexpr const char* kLicence = "# SPDX-License-Identifier: BSD-3-Clause\n";

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> namesOf(const std::vector<CommandRow>& commands) {
  std::vector<std::string> names;
  for (const CommandRow& row : commands) names.push_back(row.name);
  return names;
}

/// Verbs, each with its parts behind it as "devices firmware".
std::vector<CommandRow> withParts(const std::vector<CommandRow>& verbs) {
  std::vector<CommandRow> all;
  for (const CommandRow& verb : verbs) {
    all.push_back(verb);
    for (CommandRow part : verb.parts) {
      part.name = verb.name + " " + part.name;
      all.push_back(std::move(part));
    }
  }
  return all;
}

std::string namesOf(const std::vector<OptionRow>& options) {
  std::string text;
  for (const OptionRow& row : options) text += (text.empty() ? "" : " ") + joined(row.names, " ");
  return text;
}

/// The text with a backslash before each of these characters.
std::string escaped(const std::string& text, std::string_view characters) {
  std::string safe;
  for (const char c : text) {
    if (characters.find(c) != std::string_view::npos) safe += '\\';
    safe += c;
  }
  return safe;
}

/// Within single quotes of a POSIX shell.
std::string inQuotes(const std::string& text) {
  std::string safe = "'";
  for (const char c : text) {
    if (c == '\'') {
      safe += "'\\''";
    } else {
      safe += c;
    }
  }
  return safe + "'";
}

// ---- bash ----------------------------------------------------------------------------------

/// `case` branches for the values of the options of a verb ("" of the window).
std::string bashValues(const std::string& verb, const std::vector<OptionRow>& options) {
  std::string text, files, others;
  for (const OptionRow& row : options) {
    if (row.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : row.names) {
      patterns.emplace_back("'").append(verb).append(" ").append(name).append("'");
    }
    const std::string names = joined(patterns, "|");
    if (!row.words.empty()) {
      text += "    " + names + ") words='" + joined(row.words, " ") + "' ;;\n";
    } else {
      std::string& list = row.takesText() ? files : others;
      list += (list.empty() ? "" : "|") + names;
    }
  }
  if (!files.empty()) text += "    " + files + ") files=yes ;;\n";
  if (!others.empty()) text += "    " + others + ") ;;\n";
  return text;
}

std::string bashOptions(const CommandLine& line) {
  std::string text = "      '') words='" + namesOf(line.window) + "' ;;\n";
  for (const CommandRow& verb : withParts(line.verbs)) {
    text += "      '" + verb.name + "') words='" + namesOf(verb.options) + "' ;;\n";
  }
  return text;
}

/// Of verbs that have parts: which one is chosen, and what is offered in its place.
std::pair<std::string, std::string> bashParts(const CommandLine& line) {
  std::string chosen, offered;
  for (const CommandRow& verb : line.verbs) {
    if (verb.parts.empty()) continue;
    const std::vector<std::string> parts = namesOf(verb.parts);
    const std::string with_verb = verb.name + ":";
    chosen += "    " + with_verb + joined(parts, "|" + with_verb) +
              ") [ $COMP_CWORD -gt 2 ] && verb+=\" ${COMP_WORDS[2]}\" ;;\n";
    offered += "        [ \"$verb\" = " + verb.name + " ] && [ $COMP_CWORD -eq 2 ] && words='" +
               joined(parts, " ") + "'\n";
  }
  return {chosen, offered};
}

// ---- zsh -----------------------------------------------------------------------------------

std::string zshOption(const OptionRow& row, const std::string& name) {
  std::string spec = (row.repeated ? "*" : "") + name;
  spec += "[" + escaped(row.help, "[]\\") + "]";
  if (!row.value.empty()) {
    spec += ":" + escaped(row.value, ":\\") + ":";
    if (!row.words.empty()) {
      spec += "(" + joined(row.words, " ") + ")";
    } else if (row.takesText()) {
      spec += "_files";
    }
  }
  return inQuotes(spec);
}

std::string zshArguments(const std::vector<OptionRow>& options) {
  std::string text = "_arguments";
  for (const OptionRow& row : options) {
    for (const std::string& name : row.names) {
      if (name != "--") text += " \\\n        " + zshOption(row, name);
    }
  }
  return text + " \\\n        '*:file:_files'\n";
}

/// What comes before the options of a verb that has parts.
std::string zshParts(const CommandRow& verb) {
  if (verb.parts.empty()) return {};
  std::string list, chosen;
  for (const CommandRow& part : verb.parts) {
    list += " " + inQuotes(part.name + ":" + escaped(part.help, ":\\"));
    chosen += "        " + part.name +
              ")\n          shift 2 words; (( CURRENT -= 2 ))\n          " +
              zshArguments(part.options) + "          return ;;\n";
  }
  return "      local -a parts=(" + list +
         ")\n      (( CURRENT == 3 )) && _describe -t parts part parts\n"
         "      (( CURRENT > 3 )) && case ${words[3]} in\n" +
         chosen + "      esac\n";
}

// ---- fish ----------------------------------------------------------------------------------

std::string fishOption(const std::string& condition, const OptionRow& row) {
  std::string names;
  for (const std::string& name : row.names) {
    if (name == "--") continue;
    names += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (names.empty()) return {};
  std::string text = "complete -c relievo -n " + condition + names;
  if (!row.words.empty()) {
    text += " -x -a '" + joined(row.words, " ") + "'";
  } else if (!row.value.empty()) {
    text += row.takesText() ? " -r -F" : " -x";
  }
  return text + " -d '" + escaped(row.help, "'\\") + "'\n";
}

}  // namespace

std::string bashCompletion(const CommandLine& line) {
  const std::vector<std::string> verbs = namesOf(line.verbs);
  const auto [parts_chosen, parts_offered] = bashParts(line);
  std::string text = kLicence;
  text +=
      "# Completion of relievo for bash.\n"
      "_relievo() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
      "  local verb='' words='' files='' file\n"
      "  COMPREPLY=()\n"
      "  case ${COMP_WORDS[1]} in\n"
      "    " +
      joined(verbs, "|") +
      ") [ $COMP_CWORD -gt 1 ] && verb=${COMP_WORDS[1]} ;;\n"
      "  esac\n"
      "  case $verb:${COMP_WORDS[2]} in\n" +
      parts_chosen +
      "  esac\n"
      "  case \"$verb $before\" in\n" +
      bashValues("", line.window);
  for (const CommandRow& verb : withParts(line.verbs)) {
    text += bashValues(verb.name, verb.options);
  }
  text +=
      "    *)\n      if [[ $word == -* ]]; then\n        case $verb in\n" + bashOptions(line) +
      "        esac\n"
      "      else\n"
      "        files=yes\n"
      "        [ $COMP_CWORD -eq 1 ] && words='" +
      joined(verbs, " ") + "'\n" + parts_offered +
      "      fi ;;\n"
      "  esac\n"
      "  [ -n \"$words\" ] && mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
      "  if [ -n \"$files\" ]; then\n"
      "    compopt -o filenames 2>/dev/null\n"
      "    while IFS= read -r file; do COMPREPLY+=(\"$file\"); done < <(compgen -f -- \"$word\")\n"
      "  fi\n"
      "  return 0\n"
      "}\n"
      "complete -F _relievo relievo\n";
  return text;
}

std::string zshCompletion(const CommandLine& line) {
  std::string text = "#compdef relievo\n" + std::string(kLicence) +
                     "# Completion of relievo for zsh.\n_relievo() {\n  local -a verbs=(\n";
  for (const CommandRow& verb : line.verbs) {
    text += "    " + inQuotes(verb.name + ":" + escaped(verb.help, ":\\")) + "\n";
  }
  text +=
      "  )\n"
      "  if (( CURRENT == 2 )) && [[ ${words[2]} != -* ]]; then\n"
      "    _describe -t verbs verb verbs\n"
      "    _files\n"
      "    return\n"
      "  fi\n"
      "  case ${words[2]} in\n";
  for (const CommandRow& verb : line.verbs) {
    text += "    " + verb.name + ")\n" + zshParts(verb) +
            "      shift words; (( CURRENT-- ))\n      " + zshArguments(verb.options) +
            "      ;;\n";
  }
  return text + "    *)\n      " + zshArguments(line.window) +
         "      ;;\n  esac\n}\n_relievo \"$@\"\n";
}

std::string fishCompletion(const CommandLine& line) {
  std::string text = std::string(kLicence) + "# Completion of relievo for fish.\n";
  for (const CommandRow& verb : line.verbs) {
    text += "complete -c relievo -n __fish_use_subcommand -a " + verb.name + " -d '" +
            escaped(verb.help, "'\\") + "'\n";
  }
  for (const OptionRow& row : line.window) text += fishOption("__fish_use_subcommand", row);
  for (const CommandRow& verb : line.verbs) {
    const std::string seen = "__fish_seen_subcommand_from ";
    const std::string parts = joined(namesOf(verb.parts), " ");
    const std::string in_verb =
        "'" + seen + verb.name + (parts.empty() ? "'" : "; and not " + seen + parts + "'");
    for (const OptionRow& row : verb.options) text += fishOption(in_verb, row);
    for (const CommandRow& part : verb.parts) {
      text += "complete -c relievo -n " + in_verb + " -a " + part.name + " -d '" +
              escaped(part.help, "'\\") + "'\n";
      const std::string in_part = "'" + seen + verb.name + "; and " + seen + part.name + "'";
      for (const OptionRow& row : part.options) text += fishOption(in_part, row);
    }
  }
  return text;
}

}  // namespace relievo::manual
