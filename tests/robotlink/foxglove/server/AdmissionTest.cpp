// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/server/Admission.h"

#include <gmock/gmock.h>

#include "robotlink/foxglove/server/ListenAddress.h"

namespace robotlink::websocket::test {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;

Knock knock(const std::string& authorization = {}, const std::string& target = "/") {
  return {true, "10.0.0.1", "other, foxglove.websocket.v1", {}, authorization, target};
}

unsigned statusOf(Admission& admission, const Knock& request, Instant now = Instant()) {
  const auto decision = admission.decide(request, now);
  const auto* refusal = std::get_if<Refusal>(&decision);
  return refusal == nullptr ? 101 : refusal->status;
}

TEST(Admission, oneOfTheSubProtocolsMustBeOffered) {
  Admission admission({});
  Knock request = knock();
  EXPECT_EQ(std::get<Admitted>(admission.decide(request, {})).protocol, "foxglove.websocket.v1");
  request.protocols = "foxglove.websocket.v1 ,foxglove.sdk.v1";
  EXPECT_EQ(std::get<Admitted>(admission.decide(request, {})).protocol, "foxglove.sdk.v1");
  for (const char* others : {"", "foxglove.sdk.v2", "xfoxglove.sdk.v1", ", ,"}) {
    request.protocols = others;
    EXPECT_EQ(statusOf(admission, request), 400U) << others;
  }
  request.isWebSocket = false;
  EXPECT_EQ(statusOf(admission, request), 426U);
}

TEST(Admission, webPagesMayNotConnectUnlessTheirOriginIsAllowed) {
  Admission closed({}), open({"", {"https://a.org"}}), all({"", {"*"}});
  Knock request = knock();
  request.origin = "https://a.org";
  EXPECT_EQ(statusOf(closed, request), 403U);
  EXPECT_EQ(statusOf(open, request), 101U);
  request.origin = "https://a.org.evil.com";
  EXPECT_EQ(statusOf(open, request), 403U);
  EXPECT_EQ(statusOf(all, request), 101U);
  // What is shown of it can be shown.
  request.origin = "https://\xff\t.org" + std::string(5000, 'x');
  const auto refusal = open.decide(request, Instant());
  const std::string sentence = std::get<Refusal>(refusal).sentence;
  EXPECT_LT(sentence.size(), 400U);
  EXPECT_EQ(sentence.find_first_of("\xff\t"), std::string::npos);
}

TEST(Admission, theTokenIsInTheHeaderOrInTheUrl) {
  Admission admission({"secret", {}});
  EXPECT_EQ(statusOf(admission, knock("Bearer secret")), 101U);
  EXPECT_EQ(statusOf(admission, knock({}, "/?a=b&token=secret")), 101U);
  for (const char* wrong : {"", "secret", "Bearer secre", "Bearer secret2", "Basic secret"})
    EXPECT_EQ(statusOf(admission, knock(wrong)), 401U) << wrong;
  for (const char* wrong : {"/?token=", "/?xtoken=secret", "/token=secret", "/?token=secret2", "/?&&"})
    EXPECT_EQ(statusOf(admission, knock({}, wrong)), 401U) << wrong;
}

TEST(Admission, aWrongTokenAndNoneAreToldApart) {
  Admission admission({"secret", {}});
  const auto sentence = [&](const Knock& request) {
    return std::get<Refusal>(admission.decide(request, Instant())).sentence;
  };
  EXPECT_THAT(sentence(knock()), HasSubstr("No token was sent"));
  for (const Knock& wrong : {knock("Bearer wrong"), knock({}, "/?token=wrong")})
    EXPECT_THAT(sentence(wrong), HasSubstr("The token is not one of this robot's"));
}

TEST(Admission, wrongTokensMakeTheirMachineWaitAndNoOther) {
  Admission admission({"secret", {}, milliseconds(1000)});
  const Instant now(milliseconds(5000));
  EXPECT_LE(admission.decidableAt("10.0.0.1"), now);
  EXPECT_EQ(statusOf(admission, knock("Bearer wrong"), now), 401U);
  EXPECT_EQ(admission.decidableAt("10.0.0.1"), now + milliseconds(1000));
  EXPECT_LE(admission.decidableAt("10.0.0.2"), now);
  for (int i = 0; i < 3000; ++i) {  // what is remembered is bounded
    Knock request = knock("Bearer wrong");
    request.address = std::to_string(i);
    statusOf(admission, request, now + milliseconds(1));
  }
  EXPECT_EQ(admission.decidableAt("2999"), now + milliseconds(1001));
}

TEST(ListenAddress, isAPortOrAnAddressWithOne) {
  EXPECT_EQ(parseListenAddress("8765").value(), (ListenAddress{"127.0.0.1", 8765}));
  EXPECT_EQ(parseListenAddress("localhost:0").value(), (ListenAddress{"127.0.0.1", 0}));
  EXPECT_EQ(parseListenAddress("0.0.0.0:80").value(), (ListenAddress{"0.0.0.0", 80}));
  EXPECT_EQ(parseListenAddress("[::1]:80").value(), (ListenAddress{"::1", 80}));
  EXPECT_EQ(toString({"::1", 80}), "[::1]:80");
  EXPECT_EQ(toString({"10.0.0.1", 80}), "10.0.0.1:80");
  for (const char* wrong :
       {"", ":", "65536", "-1", "80x", "1.2.3.4", "1.2.3.4:", ":80", "::1:80", "[[]]:2", "]:2", "[::1]"})
    EXPECT_FALSE(parseListenAddress(wrong)) << wrong;
  EXPECT_THAT(parseListenAddress("::1:80").error().text, HasSubstr("needs brackets"));
}

TEST(Admission, oneTokenIsForThoseWhoOnlyWatch) {
  Admission admission({.token = "secret", .watchToken = "look"});
  const auto isReadOnly = [&](const std::string& token) {
    return std::get<Admitted>(admission.decide(knock("Bearer " + token), {})).isReadOnly;
  };
  EXPECT_FALSE(isReadOnly("secret"));
  EXPECT_TRUE(isReadOnly("look"));
  EXPECT_EQ(statusOf(admission, knock()), 401U);
  // Without a token for control nobody has it.
  Admission watched({.watchToken = "look"});
  EXPECT_EQ(statusOf(watched, knock("Bearer ")), 401U);
  EXPECT_EQ(statusOf(watched, knock("Bearer look"), Instant(std::chrono::hours(1))), 101U);
}

TEST(ListenAddress, onlyAddressesOfThisMachineAreLoopback) {
  for (const char* inside : {"127.0.0.1", "127.1.2.3", "::1"}) EXPECT_TRUE(isLoopback({inside, 1})) << inside;
  for (const char* outside : {"0.0.0.0", "::", "10.127.0.1", "127.evil.com"})
    EXPECT_FALSE(isLoopback({outside, 1})) << outside;
}

}  // namespace
}  // namespace robotlink::websocket::test
