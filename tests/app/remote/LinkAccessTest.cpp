// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/LinkAccess.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <sstream>

#include "robotlink/foxglove/security/RememberedTokens.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

namespace websocket = robotlink::websocket;
using ObjectionKind = websocket::ServerObjection::Kind;
using testing::HasSubstr;

class LinkAccessTest : public testing::Test {
 protected:
  LinkAccessTest() { ::setenv("XDG_STATE_HOME", state_.path().c_str(), 1); }
  ~LinkAccessTest() override { ::unsetenv("XDG_STATE_HOME"); }
  static std::string tokenFor(const std::string& url, const std::string& token = {}) {
    return linkOptions(url, token, askWhomToTrust()).value().token;
  }

  const TestFolder state_;
};

TEST_F(LinkAccessTest, aTokenIsThatOfTheUserOfTheUrlOrTheRememberedOne) {
  const std::string url = "wss://10.0.0.7:8765";
  EXPECT_EQ(tokenFor(url), "");
  ASSERT_TRUE(websocket::RememberedTokens().add(url, "remembered"));
  EXPECT_EQ(tokenFor(url), "remembered");
  EXPECT_EQ(tokenFor("wss://10.0.0.7"), "remembered");
  EXPECT_EQ(tokenFor("ws://10.0.0.7"), "");
  EXPECT_EQ(tokenFor(url + "/?a=b&token=inUrl&c=d"), "inUrl");
  EXPECT_EQ(tokenFor(url + "/token=none"), "");  // another URL, without a token
  EXPECT_EQ(tokenFor(url + "/?token=inUrl", "entered"), "entered");
  EXPECT_FALSE(linkOptions("http://10.0.0.7", {}, askWhomToTrust()));
}

TEST_F(LinkAccessTest, aPersonIsAskedWhomToTrustACommandSaysIt) {
  EXPECT_FALSE(askWhomToTrust()("10.0.0.7:8765", "SHA256:ab"));
  std::ostringstream out;
  EXPECT_TRUE(trustAndPrint(out)("10.0.0.7:8765", "SHA256:ab"));
  EXPECT_THAT(out.str(), HasSubstr("SHA256:ab: compare it"));
}

TEST_F(LinkAccessTest, whatAPersonCanDecideIsReadFromTheErrors) {
  websocket::ConnectionState state;
  state.phase = websocket::ConnectionState::Phase::kRefused;
  state.reason = "another robot";
  for (const auto kind :
       {ObjectionKind::kToken, ObjectionKind::kNewCertificate, ObjectionKind::kOtherCertificate}) {
    state.objection = {kind, "10.0.0.7:8765", "SHA256:ab", "SHA256:cd"};
    const auto error = refusalOf("wss://10.0.0.7:8765", state);
    EXPECT_EQ(error.text, "wss://10.0.0.7:8765: another robot");
    const auto question = questionIn({{"other", "", {}, {}}, error});
    ASSERT_TRUE(question);
    EXPECT_EQ(*question, (LinkQuestion{"wss://10.0.0.7:8765", state.objection}));
  }
  state.objection = {};
  EXPECT_FALSE(questionIn({refusalOf("wss://10.0.0.7:8765", state)}));
}

}  // namespace
}  // namespace app
