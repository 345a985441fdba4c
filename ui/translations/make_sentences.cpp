// SPDX-License-Identifier: BSD-3-Clause
// Makes C++ functions of what Qt Linguist's files say of the catalogue's sentences, at build time:
//   relievo-make-sentences OUT.cpp relievo_de.ts relievo_hi.ts
#include <array>
#include <cctype>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace {

/// What stands between two marks, from a place on, which moves behind the second.
std::string between(const std::string& text, std::size_t& at, std::string_view first,
                    std::string_view last) {
  at = text.find(first, at);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + first.size(), end = text.find(last, begin);
  if (end == std::string::npos) {
    at = end;
    return {};
  }
  at = end + last.size();
  return text.substr(begin, end - begin);
}

std::string withoutEntities(std::string text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
      {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  for (const auto& [entity, character] : kEntities) {
    for (std::size_t at = 0; (at = text.find(entity, at)) != std::string::npos; ++at) {
      text.replace(at, entity.size(), 1, character);
    }
  }
  return text;
}

/// By sentence, ascending, as whoever looks them up expects.
std::map<std::string, std::string> sentencesIn(const std::string& file) {
  std::ifstream in(file);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  std::size_t at = text.find("<name>relievo::Message</name>");
  const std::string context = text.substr(at, text.find("</context>", at) - at);
  std::map<std::string, std::string> found;
  for (at = 0; at != std::string::npos;) {
    const std::string english = between(context, at, "<source>", "</source>");
    if (at == std::string::npos) break;
    // What nobody has translated yet says so in its tag, and stays English.
    const std::string translated = between(context, at, "<translation>", "</translation>");
    if (!translated.empty()) found[withoutEntities(english)] = withoutEntities(translated);
  }
  return found;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) return 1;
  std::ofstream out(argv[1]);
  out << "#include <array>\n#include \"ui/translations/translated_sentences.h\"\n"
         "namespace relievo {\n";
  for (int i = 2; i < argc; ++i) {
    const std::string file = argv[i];
    const auto sentences = sentencesIn(file);
    if (sentences.empty()) {
      std::cerr << file << ": no sentence of the catalogue\n";
      return 1;
    }
    std::string tag = file.substr(file.rfind('_') + 1, 2);
    tag[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(tag[0])));
    out << "std::span<const TranslatedSentence> sentences" << tag << "() {\n"
        << "  static constexpr std::array<TranslatedSentence, " << sentences.size() << "> kAll{{\n";
    for (const auto& [english, translated] : sentences) {
      out << "    {R\"|(" << english << ")|\", R\"|(" << translated << ")|\"},\n";
    }
    out << "  }};\n  return kAll;\n}\n";
  }
  out << "}  // namespace relievo\n";
  return out.flush() ? 0 : 1;
}
