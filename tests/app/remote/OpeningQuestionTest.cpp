// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/OpeningQuestion.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include "robotlink/foxglove/security/KnownServers.h"
#include "robotlink/foxglove/security/RememberedTokens.h"
#include "tests/TestFolder.h"

namespace app {
namespace {

namespace websocket = robotlink::websocket;
using BodyObjection = websocket::ServerObjection::Kind;

constexpr char kBody[] = "wss://10.0.0.7:8765", kOtherBody[] = "wss://10.0.0.8:8765";
constexpr char kServer[] = "10.0.0.7:8765", kFingerprint[] = "SHA256:ab";

/// What a remote body objects to, and what the user answers. What is remembered is in a folder.
class OpeningQuestionTest : public testing::Test {
 protected:
  OpeningQuestionTest() { ::setenv("XDG_STATE_HOME", state_.path().c_str(), 1); }
  ~OpeningQuestionTest() override { ::unsetenv("XDG_STATE_HOME"); }

  static robotlink::Errors refusal(BodyObjection kind, const std::string& url = kBody) {
    websocket::ConnectionState state;
    state.objection = {kind, kServer, kFingerprint, {}};
    state.reason = "it objects";
    return {refusalOf(url, state)};
  }
  /// The opening of a body; its adapter is the token with which it is opened.
  PlatformOpening bodyAt(const std::string& url, const std::string& token = {}) {
    PlatformOpening opening;
    opening.adapter = token;
    opening.sources = {url};
    opening.withToken = [this, url](const std::string& shown) { return bodyAt(url, shown); };
    opening.refusal = [this] { return refused_; };
    return opening;
  }
  static std::string remembered(const std::string& url = kBody) {
    return websocket::RememberedTokens().find(url).value_or("");
  }

  const TestFolder state_;
  /// What the body that is open objects to.
  robotlink::Errors refused_;
  OpeningQuestion question_;
};

TEST_F(OpeningQuestionTest, onlyWhatThePersonCanDecideIsAsked) {
  question_.begin(bodyAt(kBody));
  EXPECT_FALSE(question_.ask({{"link.refused", "nobody answers", {}, {}}}));
  EXPECT_FALSE(question_.ask(refusal(BodyObjection::kToken, kOtherBody))) << "about another body";
  EXPECT_FALSE(question_.asked());
  EXPECT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  EXPECT_TRUE(question_.isAbout(kBody));
  EXPECT_FALSE(question_.isAbout(kOtherBody));
}

TEST_F(OpeningQuestionTest, aPlatformWithoutTokensAsksNothing) {
  PlatformOpening scene;
  scene.sources = {kBody};
  question_.begin(scene);
  EXPECT_FALSE(question_.ask(refusal(BodyObjection::kToken)));
  question_.begin(PlatformOpening());
  EXPECT_FALSE(question_.ask(refusal(BodyObjection::kToken)));
}

TEST_F(OpeningQuestionTest, anotherPlatformEndsTheQuestion) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  question_.begin(bodyAt(kOtherBody));
  EXPECT_FALSE(question_.asked());
  EXPECT_FALSE(question_.isAbout(kBody));
}

TEST_F(OpeningQuestionTest, aFingerprintIsRememberedOnlyIfItIsTheOneThatWasAsked) {
  question_.begin(bodyAt(kBody));
  EXPECT_FALSE(question_.trust(kFingerprint)) << "nothing was asked";
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kNewCertificate)));
  const auto wrong = question_.trust("SHA256:cd");
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().text, "the robot at wss://10.0.0.7:8765 does not ask to be trusted by SHA256:cd");
  EXPECT_FALSE(websocket::KnownServers().isKnown(kServer, kFingerprint).value());
  const auto right = question_.trust(kFingerprint);
  ASSERT_TRUE(right);
  ASSERT_TRUE(*right) << "it is to be opened again";
  EXPECT_EQ((*right)->sources.front(), kBody);
  EXPECT_TRUE(websocket::KnownServers().isKnown(kServer, kFingerprint).value());
}

TEST_F(OpeningQuestionTest, aTokenIsRememberedOnceTheBodyAcceptsIt) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  const PlatformOpening again = question_.show("secret");
  EXPECT_EQ(again.adapter, "secret");
  question_.rememberToken();
  question_.begin(again);
  EXPECT_TRUE(question_.isShowing(kBody));
  EXPECT_FALSE(question_.isShowing(kOtherBody));
  EXPECT_EQ(remembered(), "");
  ASSERT_TRUE(question_.finish({kBody}));
  EXPECT_EQ(remembered(), "secret");
  EXPECT_FALSE(question_.isShowing(kBody));
}

TEST_F(OpeningQuestionTest, aTokenThatNobodyWantsToKeepIsNot) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  question_.begin(question_.show("secret"));
  ASSERT_TRUE(question_.finish({kBody}));
  EXPECT_EQ(remembered(), "");
}

TEST_F(OpeningQuestionTest, aWrongTokenIsForgotten) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  question_.begin(question_.show("wrong"));
  question_.rememberToken();
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  EXPECT_FALSE(question_.isShowing(kBody));
  ASSERT_TRUE(question_.finish({kBody}));
  EXPECT_EQ(remembered(), "");
}

TEST_F(OpeningQuestionTest, aTokenSurvivesTheQuestionAboutTheCertificate) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  question_.begin(question_.show("secret"));
  question_.rememberToken();
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kNewCertificate)));
  EXPECT_TRUE(question_.isShowing(kBody));
}

TEST_F(OpeningQuestionTest, theTokenOfOneBodyIsNotShownToAnother) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  question_.begin(question_.show("secret"));
  question_.rememberToken();
  question_.begin(bodyAt(kOtherBody));
  EXPECT_FALSE(question_.isShowing(kOtherBody));
  ASSERT_TRUE(question_.finish({kOtherBody}));
  EXPECT_EQ(remembered(kOtherBody), "");
}

TEST_F(OpeningQuestionTest, aBodyThatIsOpenMayObjectLater) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.finish({kBody}));
  question_.follow();
  EXPECT_FALSE(question_.asked());
  refused_ = refusal(BodyObjection::kNewCertificate);
  question_.follow();
  ASSERT_TRUE(question_.isAbout(kBody));
  const auto trusted = question_.trust(kFingerprint);
  ASSERT_TRUE(trusted);
  EXPECT_FALSE(*trusted) << "its connection is tried again all the time";
  question_.follow();
  EXPECT_FALSE(question_.asked()) << "until then it is not asked again";
  refused_ = {};
  question_.follow();
  refused_ = refusal(BodyObjection::kNewCertificate);
  question_.follow();
  EXPECT_TRUE(question_.asked()) << "it objects again";
}

TEST_F(OpeningQuestionTest, anObjectionThatIsOverIsNotAskedAnyMore) {
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.finish({kBody}));
  refused_ = refusal(BodyObjection::kToken);
  question_.follow();
  ASSERT_TRUE(question_.asked());
  refused_ = {};
  question_.follow();
  EXPECT_FALSE(question_.asked());
}

TEST_F(OpeningQuestionTest, theOneThatIsToBeOpenedIsAnsweredBeforeTheOneThatIsOpen) {
  question_.begin(bodyAt(kOtherBody));
  ASSERT_TRUE(question_.finish({kOtherBody}));
  question_.begin(bodyAt(kBody));
  ASSERT_TRUE(question_.ask(refusal(BodyObjection::kToken)));
  refused_ = refusal(BodyObjection::kToken, kOtherBody);
  question_.follow();
  EXPECT_TRUE(question_.isAbout(kBody));
  EXPECT_FALSE(question_.drop()) << "it is not open";
  question_.follow();
  EXPECT_TRUE(question_.isAbout(kOtherBody));
  EXPECT_EQ(question_.show("secret").sources.front(), kOtherBody);
  EXPECT_TRUE(question_.drop()) << "what runs is to be closed";
}

}  // namespace
}  // namespace app
