// SPDX-License-Identifier: BSD-3-Clause
#include "core/provenance/name_text.h"

#include <gtest/gtest.h>

#include <random>

#include "core/provenance/parameters_json.h"

namespace relievo {
namespace {

TEST(NameText, UnicodeStaysAsItIs) {
  for (const char* name :
       {"vase.ply", "a b\n\"c\"\t\\", "M\xC3\xBCnze \xE0\xA4\xB8\xE0\xA4\xBF.ply",
        "\xF0\x9F\x8F\xBA.ply", ""}) {
    EXPECT_EQ(textOfName(name), name);
    EXPECT_EQ(nameFromText(name), name);
  }
}

TEST(NameText, AnyBytesComeBack) {
  constexpr unsigned kSeed = 5;
  std::mt19937 random(kSeed);
  // Bytes of which characters are made, whole, cut and wrong.
  const std::string bytes =
      "a/\x80\xBE\xBF\xC0\xC3\xBC\xE0\xA0\xED\xA0\xEE\xBE\xBF\xF0\x90\xF4\xFF";
  for (int i = 0; i < 20'000; ++i) {
    std::string name;
    for (std::size_t length = random() % 9; length > 0; --length) {
      name += bytes[random() % bytes.size()];
    }
    const std::string text = textOfName(name);
    ASSERT_EQ(nameFromText(text), name) << "seed " << kSeed << ", number " << i;
    ASSERT_EQ(nameFromText(textOfName(text)), text);
    ASSERT_NO_THROW(Json(text).dump()) << "is UTF-8, as the library sees it";
  }
}

TEST(NameText, EscapedItIsOneLineOfUtf8) {
  EXPECT_EQ(escapedName("M\xC3\xBCnze 100%.ply"), "M\xC3\xBCnze 100%.ply");
  EXPECT_EQ(escapedName("b\xFCste.ply"), "b%FCste.ply");
  EXPECT_EQ(escapedName("two\nlines\r\x1B[31m\x7F"), "two%0Alines%0D%1B[31m%7F");
  EXPECT_EQ(escapedName("a\xC2\x85"
                        "b\xE2\x80\xA8"
                        "c"),
            "a%C2%85b%E2%80%A8c");
  EXPECT_EQ(escapedName("\xC3"), "%C3") << "a character that is cut off";
  EXPECT_EQ(escapedName("-\"'\\&.ply"), "-\"'\\&.ply");
}

TEST(NameText, AnInputKeepsItsName) {
  const InputFile input{.file = "caf\xE9\n.ply", .sha256 = std::string(64, '0'), .bytes = 1};
  EXPECT_EQ(inputFrom(Json::parse(jsonOf(input).dump())), input);
}

}  // namespace
}  // namespace relievo
