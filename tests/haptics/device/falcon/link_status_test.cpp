// SPDX-License-Identifier: BSD-3-Clause
// What a Falcon's status says: its detail crosses threads as a message's bytes.
#include "haptics/device/falcon/link/link_status.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/message/catalogue.h"

namespace relievo::falcon {
namespace {

using std::filesystem::path;

LinkStatus notStarted() {
  LinkStatus status;
  status.state = LinkState::not_started;
  status.attempts = 10;
  return status;
}

TEST(LinkStatus, CarriesItsDetailAsAMessage) {
  LinkStatus status = notStarted();
  EXPECT_FALSE(detailOf(status));
  putDetail(said<MessageId::falcon_wrong_echo>(992, 8464), status);
  const LinkStatus arrived = status;  // As the threads' buffer copies it.
  const auto detail = detailOf(arrived);
  ASSERT_TRUE(detail);
  EXPECT_EQ(detail->id, MessageId::falcon_wrong_echo);
  EXPECT_TRUE(englishText(describe(arrived))
                  .ends_with("Retry. (it echoed wrongly after byte 992 of 8464)"));
}

TEST(LinkStatus, ADetailThatIsTooLongIsCutAndStillSaid) {
  LinkStatus status = notStarted();
  status.state = LinkState::no_firmware;
  const std::string name(4000, 'x');
  putDetail(said<MessageId::firmware_missing>(path(name)), status);
  const std::string text = englishText(describe(status));
  EXPECT_TRUE(text.starts_with("There is no file \"xxx")) << text;
  EXPECT_GT(text.size(), 600U);
  putDetail(said<MessageId::image_odd>(), status);
  EXPECT_EQ(englishText(describe(status)), "its length is odd") << "nothing of the one before";
}

TEST(LinkStatus, IsInTheNumberOfItsCounts) {
  LinkStatus status = notStarted();
  EXPECT_TRUE(
      englishText(describe(status)).starts_with("The Falcon did not start after 10 attempts;"));
  status.attempts = 1;
  EXPECT_TRUE(
      englishText(describe(status)).starts_with("The Falcon did not start after 1 attempt;"));
}

TEST(LinkStatus, EveryStateSaysASentenceForTheScreenAndAFewWordsForEars) {
  for (int i = 0; i <= static_cast<int>(LinkState::silent); ++i) {
    for (const int failed : {0, 3}) {
      LinkStatus status;
      status.state = static_cast<LinkState>(i);
      status.failed_openings = failed;
      const Message message = describe(status);
      EXPECT_TRUE(englishText(message).ends_with('.')) << i << ": " << englishText(message);
      EXPECT_LE(englishSpoken(message).size(), 90U) << englishSpoken(message);
    }
  }
}

}  // namespace
}  // namespace relievo::falcon
