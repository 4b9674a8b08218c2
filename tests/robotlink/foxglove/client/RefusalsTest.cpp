// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/Refusals.h"

#include <gmock/gmock.h>

#include <boost/asio/error.hpp>

namespace robotlink::websocket::test {
namespace {

namespace asioError = boost::asio::error;
using testing::HasSubstr;
using testing::Not;

TEST(Refusals, aTokenIsOneWordOfPlainCharacters) {
  EXPECT_EQ(whyNoToken(""), "") << "none was given";
  EXPECT_EQ(whyNoToken("abc-._~!\"09"), "");
  for (const char* token : {"two words", "line\n", " abc", "größe", "tab\t"})
    EXPECT_THAT(whyNoToken(token), HasSubstr("the token is one word")) << token;
}

TEST(Refusals, whoIsNotReachedIsToldWhatToLookAt) {
  EXPECT_THAT(whyNotReached(asioError::connection_refused), HasSubstr("--listen"));
  EXPECT_THAT(whyNotReached(asioError::host_unreachable), HasSubstr("switched on"));
  EXPECT_EQ(whyNotReached(asioError::network_unreachable), whyNotReached(asioError::host_unreachable));
  EXPECT_THAT(whyNotReached(asioError::timed_out), HasSubstr("nothing answers"));
  EXPECT_THAT(whyNotReached(asioError::no_permission), HasSubstr("it cannot connect: "));
}

TEST(Refusals, aConnectionThatIsCutMeansSomethingElseAtEachStage) {
  for (const auto error : {asioError::misc_errors::eof}) {
    EXPECT_THAT(whyNotSecured(error), HasSubstr("use ws://"));
    EXPECT_THAT(whyNoHandshake(error), HasSubstr("before it began"));
    EXPECT_THAT(whyBroken(error), HasSubstr("program ended"));
  }
  EXPECT_EQ(whyNotSecured(asioError::connection_reset), whyNotSecured(asioError::eof));
  EXPECT_EQ(whyBroken(asioError::broken_pipe), whyBroken(asioError::eof));
  EXPECT_THAT(whyNoHandshake(asioError::access_denied), HasSubstr("not a WebSocket server"));
  EXPECT_THAT(whyBroken(asioError::access_denied), HasSubstr("the connection broke: "));
}

TEST(Refusals, aStatusSaysWhatTheRobotWants) {
  EXPECT_THAT(whyRefused(401, "", ShownToken::kNone), HasSubstr("the robot requires a token: "));
  EXPECT_THAT(whyRefused(401, "", ShownToken::kOne), HasSubstr("the robot requires a different token: "));
  EXPECT_THAT(whyRefused(404, "", ShownToken::kNone), HasSubstr("leave out what follows the port"));
  EXPECT_THAT(whyRefused(503, "", ShownToken::kNone), HasSubstr("too many clients"));
  EXPECT_EQ(whyRefused(500, "", ShownToken::kNone), "the robot refused the connection (HTTP 500)");
}

TEST(Refusals, aForeignTextIsAPartOfTheSentence) {
  EXPECT_EQ(whyRefused(418, "I am a teapot.\n", ShownToken::kNone).find('\n'), std::string::npos);
  EXPECT_THAT(whyRefused(403, "not you. ", ShownToken::kNone), HasSubstr("(HTTP 403: not you)"));
  const std::string longer = whyClosed(std::string(5000, 'x'));
  EXPECT_LT(longer.size(), 400U);
  EXPECT_THAT(longer, HasSubstr("the robot ended the connection: xxx"));
  EXPECT_EQ(whyClosed(" . "), "the robot ended the connection");
}

TEST(Refusals, anotherSubProtocolIsNamedWithThoseThatWork) {
  EXPECT_THAT(whyOtherProtocol("chat"), HasSubstr("the sub-protocol 'chat', but not "));
  EXPECT_THAT(whyOtherProtocol(""), HasSubstr("speaks no sub-protocol"));
}

TEST(Refusals, theLongestMessageIsInMegabytes) {
  EXPECT_THAT(whyTooLong(std::size_t{64} << 20U), HasSubstr("more than 64 MiB"));
}

}  // namespace
}  // namespace robotlink::websocket::test
