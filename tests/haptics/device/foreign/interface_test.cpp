// SPDX-License-Identifier: BSD-3-Clause
// What plug-ins for devices are built with: the header that is installed, and the example as a
// project of its own against it.
#include <cstdio>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/hash/sha256.h"
#include "haptics/device/foreign/ask_host.h"
#include "haptics/device/foreign/relievo_device.h"
#include "tests/haptics/device/foreign/foreign_fixture.h"

namespace relievo::foreign {
namespace {

/// Whoever changes the interface looks at its version. A change that old plug-ins do not survive
/// raises the major number, any other the minor one.
constexpr std::uint32_t kMajor = 1, kMinor = 0;
constexpr const char* kChecksum =
    "a2d6e763e4e8dcb6de33586eb9e5606038bd3612c8c37053304e4c08e42d9926";

/// Without comments and blanks.
std::string checksumOf(const std::string& header) {
  const std::string code =
      std::regex_replace(header, std::regex("/\\*[^*]*\\*+([^/*][^*]*\\*+)*/"), "");
  return sha256OfText(std::regex_replace(code, std::regex("\\s+"), " "));
}

std::string header() {
  std::ostringstream text;
  text << std::ifstream(RELIEVO_SOURCE_DIR "/haptics/device/foreign/relievo_device.h").rdbuf();
  return text.str();
}

TEST(DeviceInterface, ChangesWithItsVersion) {
  EXPECT_EQ(RELIEVO_DEVICE_ABI_MAJOR, kMajor);
  EXPECT_EQ(RELIEVO_DEVICE_ABI_MINOR, kMinor);
  EXPECT_EQ(checksumOf(header()), kChecksum);
  EXPECT_EQ(checksumOf(header() + "/* More is said. */\n"), kChecksum);
  EXPECT_NE(checksumOf(header() + "int more;\n"), kChecksum);
}

/// What two compilers must agree on; these are numbers of the interface, for 64-bit systems.
TEST(DeviceInterface, HasTheSizesThatPlugInsWereBuiltWith) {
  EXPECT_EQ(sizeof(relievo_host), 40U);
  EXPECT_EQ(sizeof(relievo_device_name), 136U);
  EXPECT_EQ(sizeof(relievo_device_limits), 80U);
  EXPECT_EQ(sizeof(relievo_sample), 72U);
  EXPECT_EQ(sizeof(relievo_device), 72U);
  EXPECT_EQ(sizeof(relievo_device_entry_t), 88U);
}

struct Said {
  int status = -1;
  std::string text;
};
Said said(const std::string& command) {
  Said said;
  FILE* const pipe = ::popen(("(" + command + ") 2>&1").c_str(), "r");
  if (pipe == nullptr) return said;
  for (int c = 0; (c = std::fgetc(pipe)) != EOF;) said.text += static_cast<char>(c);
  said.status = ::pclose(pipe);
  return said;
}

class DeviceExample : public test::ForeignTest {};

TEST_F(DeviceExample, IsBuiltAgainstTheInstalledTreeAndConforms) {
  const std::string prefix = folder / "usr", build = folder / "build";
  const Said installed =
      said(CMAKE_PROGRAM " --install " RELIEVO_BINARY_DIR " --component dev --prefix " + prefix);
  ASSERT_EQ(installed.status, 0) << installed.text;
  const std::string source = prefix + "/share/doc/relievo-dev/examples/device";
  const Said built = said(
      CMAKE_PROGRAM " -G Ninja -S " + source + " -B " + build + " -DCMAKE_PREFIX_PATH=" + prefix +
      " -DCMAKE_C_FLAGS='-Wall -Wextra -pedantic -Werror' && " CMAKE_PROGRAM " --build " + build);
  ASSERT_EQ(built.status, 0) << built.text;
  for (const CheckResult& result :
       checkPlugin(build + "/spring_hand.so", {.device = "spring.1",
                                              .newton = 1,
                                              .seconds = 0.1,
                                              .is_held = [] { return true; },
                                              .patience = test::longPatience()})) {
    EXPECT_NE(result.verdict, Verdict::failed) << result.check.code << ": " << result.why;
  }
}

}  // namespace
}  // namespace relievo::foreign
