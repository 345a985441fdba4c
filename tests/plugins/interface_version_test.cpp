// SPDX-License-Identifier: BSD-3-Clause
// A plugin is built against headers and loaded by their version alone: whatever changes in one of
// them raises RELIEVO_PLUGIN_VERSION. This test knows the version's checksum.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>

#include "core/hash/sha256.h"
#include "tests/architecture/include_table.h"

namespace relievo {
namespace {

// Whoever changes an installed header raises the version in plugins/api/plugin.h and writes both
// here. Comments, spaces and line ends do not count.
constexpr const char* kVersion = "2";
constexpr const char* kChecksum =
    "6a8636dd5a46bda6ff7aea6c82548e42648059edacee92fffd0fac9992a39221";

std::string read(const std::string& path) {
  std::ifstream in(RELIEVO_SOURCE_DIR "/" + path);
  EXPECT_TRUE(in.is_open()) << path;
  return {std::istreambuf_iterator<char>(in), {}};
}

/// plugin.h and all that it includes of the tree.
std::map<std::string, std::string> interfaceHeaders() {
  std::map<std::string, std::string> headers;
  std::vector<std::string> left{"plugins/api/plugin.h"};
  while (!left.empty()) {
    const std::string path = left.back();
    left.pop_back();
    if (headers.contains(path)) continue;
    headers[path] = read(path);
    for (const architecture::Include& include : architecture::includesOf(headers[path])) {
      if (include.quoted) left.push_back(include.header);
    }
  }
  return headers;
}

/// What a compiler makes of it, near enough: no string of these headers has a "//".
std::string withoutComments(const std::string& text) {
  static const std::regex kComment("//[^\n]*|/\\*[^*]*(\\*(?!/)[^*]*)*\\*/"), kSpace("\\s+");
  return std::regex_replace(std::regex_replace(text, kComment, ""), kSpace, " ");
}

std::string checksumOf(const std::map<std::string, std::string>& headers) {
  std::string all;
  for (const auto& [path, text] : headers) all += path + '\n' + withoutComments(text) + '\n';
  return sha256OfText(all);
}

TEST(PluginInterface, HasTheChecksumOfItsVersion) {
  const auto headers = interfaceHeaders();
  std::smatch version;
  const std::string& plugin = headers.at("plugins/api/plugin.h");
  ASSERT_TRUE(
      std::regex_search(plugin, version, std::regex("#define RELIEVO_PLUGIN_VERSION \"(.*)\"")));
  EXPECT_EQ(version[1], kVersion);
  EXPECT_EQ(checksumOf(headers), kChecksum)
      << "An installed header has changed: raise RELIEVO_PLUGIN_VERSION if the last release has "
         "this one, and write both here.";
}

TEST(PluginInterface, HasFewHeaders) {
  std::string paths;
  for (const auto& [path, text] : interfaceHeaders()) paths += path + ' ';
  EXPECT_EQ(paths,
            "core/base/grid.h core/base/origin.h core/base/vec3.h core/recording/force_point.h "
            "core/region/probe.h core/region/region_window.h core/region/square.h "
            "plugins/api/host.h plugins/api/plugin.h ");
}

TEST(PluginInterface, NoticesAChangedMemberAndNoComment) {
  const auto headers = interfaceHeaders();
  auto said = headers, changed = headers;
  said.at("core/region/probe.h") += "// More is said.\n\n";
  EXPECT_EQ(checksumOf(said), checksumOf(headers));
  changed.at("core/region/probe.h") += "struct More {};\n";
  EXPECT_NE(checksumOf(changed), checksumOf(headers));
}

}  // namespace
}  // namespace relievo
