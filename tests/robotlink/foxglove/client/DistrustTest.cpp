// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Distrust.h"

#include <gmock/gmock.h>

#include "robotlink/foxglove/security/KnownServers.h"
#include "tests/TestFolder.h"

namespace robotlink::websocket::test {
namespace {

using Kind = ServerObjection::Kind;
using testing::HasSubstr;

class DistrustTest : public testing::Test {
 protected:
  Distrust ask(const std::string& fingerprint, bool isTrusted) {
    return whyNotTrusted("red1:8765", fingerprint, file_,
                         [this, isTrusted](const auto& server, const auto& shown) {
                           asked_ = server + " " + shown;
                           return isTrusted;
                         });
  }

  const TestFolder folder_;
  const std::filesystem::path file_ = folder_ / "known";
  std::string asked_;
};

TEST_F(DistrustTest, aRobotThatWasNeverSeenIsAskedAbout) {
  const Distrust distrust = ask("SHA256:abc", false);
  EXPECT_EQ(asked_, "red1:8765 SHA256:abc");
  EXPECT_THAT(distrust.why, HasSubstr("never seen before"));
  EXPECT_EQ(distrust.objection, (ServerObjection{Kind::kNewCertificate, "red1:8765", "SHA256:abc", {}}));
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(DistrustTest, whoIsTrustedIsRememberedAndNotAskedAboutAgain) {
  EXPECT_EQ(ask("SHA256:abc", true).why, "");
  asked_.clear();
  EXPECT_EQ(ask("SHA256:abc", false).why, "");
  EXPECT_TRUE(asked_.empty());
}

TEST_F(DistrustTest, anotherCertificateThanBeforeIsRefusedWithBoth) {
  ASSERT_TRUE(KnownServers(file_).add("red1:8765", "SHA256:abc"));
  const Distrust distrust = ask("SHA256:def", true);
  EXPECT_TRUE(asked_.empty());
  EXPECT_FALSE(distrust.why.empty());
  EXPECT_EQ(distrust.objection,
            (ServerObjection{Kind::kOtherCertificate, "red1:8765", "SHA256:def", "SHA256:abc"}));
  // It stays known by the first one.
  EXPECT_EQ(KnownServers(file_).isKnown("red1:8765", "SHA256:abc"), true);
}

TEST_F(DistrustTest, withoutAQuestionTheFirstCertificateIsBelieved) {
  EXPECT_EQ(whyNotTrusted("red1:8765", "SHA256:abc", file_, {}).why, "");
  EXPECT_EQ(KnownServers(file_).isKnown("red1:8765", "SHA256:abc"), true);
}

TEST(HostOf, hasBracketsForAddressesWithColons) {
  EXPECT_EQ(hostOf({.isEncrypted = true, .host = "red1", .port = 8765}), "red1:8765");
  EXPECT_EQ(hostOf({.isEncrypted = true, .host = "::1", .port = 1}), "[::1]:1");
}

}  // namespace
}  // namespace robotlink::websocket::test
