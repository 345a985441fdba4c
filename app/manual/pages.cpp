// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "app/manual/manual.h"

namespace relievo::manual {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 9> kExitCodes{
    {{"0", "Done."},
     {"1", "The command line was not understood; nothing was done."},
     {"2", "A file cannot be read."},
     {"3", "A file cannot be written."},
     {"4", "Done, but for a requested step, which the messages name."},
     {"5", "Something is not as before: a replay, a checksum, a set of files."},
     {"6", "A device is absent, busy or has a fault."},
     {"7", "There are no graphics to draw with."},
     {"130", "Interrupted."}}};

/// Text of a person as roff: nothing in it is a request, and each hyphen is the one that is typed.
std::string roff(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\') {
      safe += "\\e";
    } else if (c == '-') {
      safe += "\\-";
    } else {
      safe += c;
    }
  }
  if (safe.starts_with('.') || safe.starts_with('\'')) safe.insert(0, "\\&");
  return safe;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string title(const std::string& name) {
  return ".\\\" SPDX-License-Identifier: BSD-3-Clause\n.TH " + roff(upper(name)) +
         " 1 \"\" \"relievo " RELIEVO_VERSION_STRING "\" \"User Commands\"\n";
}

/// ".TP", the names in bold with the value in italics, the help.
std::string entry(const OptionRow& row) {
  std::string text = ".TP\n";
  for (std::size_t i = 0; i < row.names.size(); ++i) {
    text += (i > 0 ? ", " : "") + ("\\fB" + roff(row.names[i]) + "\\fR");
  }
  if (!row.value.empty()) text += " \\fI" + roff(row.value) + "\\fR";
  if (row.repeated) text += " ...";
  text += "\n" + roff(row.help.empty() ? row.names.front() : row.help) + ".";
  return text + (row.required ? " Required.\n" : "\n");
}

std::string exitStatus() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : kExitCodes) {
    text += ".TP\n\\fB" + std::string(code) + "\\fR\n" + roff(meaning) + "\n";
  }
  return text;
}

/// What is behind the name on the command line.
std::string argumentsOf(const CommandRow& verb) {
  std::string text = "[\\fIOPTIONS\\fR]";
  for (const OptionRow& row : verb.positionals) {
    const std::string name =
        "\\fI" + roff(row.names.front()) + "\\fR" + (row.repeated ? "..." : "");
    text += row.required ? " " + name : " [" + name + "]";
  }
  for (const OptionRow& row : verb.options) {
    if (!row.required) continue;
    text += " \\fB" + roff(row.names.front()) + "\\fR \\fI" + roff(row.value) + "\\fR";
  }
  return text + "\n";
}

std::string synopsis(const CommandRow& verb) {
  const std::string name = "relievo " + verb.name;
  std::string text = ".SH SYNOPSIS\n.B " + roff(name) + "\n" + argumentsOf(verb);
  for (const CommandRow& part : verb.parts) {
    text += ".br\n.B " + roff(name + " " + part.name) + "\n" + argumentsOf(part);
  }
  return text;
}

std::string partOf(const CommandRow& part) {
  std::string text = ".SS " + roff(part.name) + "\n" + roff(part.help) + ".\n";
  for (const OptionRow& row : part.positionals) text += entry(row);
  for (const OptionRow& row : part.options) text += entry(row);
  return text;
}

std::string verbPage(const CommandRow& verb) {
  std::string text = title("relievo-" + verb.name) + ".SH NAME\n" + roff("relievo-" + verb.name) +
                     " \\- " + roff(verb.help) + "\n" + synopsis(verb);
  if (!verb.positionals.empty()) text += ".SH ARGUMENTS\n";
  for (const OptionRow& row : verb.positionals) text += entry(row);
  text += ".SH OPTIONS\n";
  for (const OptionRow& row : verb.options) text += entry(row);
  if (!verb.parts.empty()) text += ".SH SUBCOMMANDS\n";
  for (const CommandRow& part : verb.parts) text += partOf(part);
  return text + exitStatus() + ".SH SEE ALSO\n.BR relievo (1)\n";
}

std::string mainPage(const CommandLine& line) {
  std::string text =
      title("relievo") +
      ".SH NAME\nrelievo \\- feel and see scanned heritage at every scale\n"
      ".SH SYNOPSIS\n.B relievo\n[\\fIOPTIONS\\fR] [\\fIFILE\\fR...]\n.br\n"
      ".B relievo\n\\fIVERB\\fR [\\fIOPTIONS\\fR] ...\n"
      ".SH DESCRIPTION\n"
      "A scan becomes a depth map and its Gaussian pyramid. The window shows a region of it at a "
      "level, in stereo too, and lets the hand touch the same samples with a mouse or a haptic "
      "device. The verbs do the same without a window.\n"
      ".PP\nSeveral files, or a folder, are scans of one object, which are joined first.\n"
      ".SH OPTIONS OF THE WINDOW\n";
  for (const OptionRow& row : line.window) text += entry(row);
  text += ".SH VERBS\n";
  for (const CommandRow& verb : line.verbs) {
    text += ".TP\n\\fB" + roff(verb.name) + "\\fR\n" + roff(verb.help) + ".\n";
  }
  text += exitStatus() + ".SH SEE ALSO\n";
  for (std::size_t i = 0; i < line.verbs.size(); ++i) {
    text += ".BR " + roff("relievo-" + line.verbs[i].name) + " (1)" +
            (i + 1 < line.verbs.size() ? ",\n" : "\n");
  }
  return text;
}

}  // namespace

std::map<std::string, std::string> pages(const CommandLine& line) {
  std::map<std::string, std::string> all{{"relievo.1", mainPage(line)}};
  for (const CommandRow& verb : line.verbs) all["relievo-" + verb.name + ".1"] = verbPage(verb);
  return all;
}

}  // namespace relievo::manual
