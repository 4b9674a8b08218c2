// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/foxglove/client/ServerUrl.h"

#include <gmock/gmock.h>

namespace robotlink::websocket {
namespace {

using testing::HasSubstr;

std::string problemOf(std::string_view text) {
  const auto url = parseServerUrl(text);
  return url ? "none" : url.error().text;
}

TEST(ServerUrl, hostPortAndTargetAreRead) {
  EXPECT_EQ(parseServerUrl("ws://127.0.0.1:9000").value(), (ServerUrl{false, "127.0.0.1", 9000, "/"}));
  EXPECT_EQ(parseServerUrl("wss://red1.local").value(), (ServerUrl{true, "red1.local", 8765, "/"}));
  EXPECT_EQ(parseServerUrl("ws://[::1]:8766/a/b?token=x#c").value(),
            (ServerUrl{false, "::1", 8766, "/a/b?token=x"}));
  EXPECT_EQ(parseServerUrl("ws://a?token=x").value(), (ServerUrl{false, "a", 8765, "/?token=x"}));
}

TEST(ServerUrl, itIsShownWithoutWhatMayBeAToken) {
  EXPECT_EQ(toString(*parseServerUrl("ws://[::1]/a?token=secret")), "ws://[::1]:8765/a");
  EXPECT_EQ(toString(*parseServerUrl("wss://b:1/")), "wss://b:1");
}

TEST(ServerUrl, anErrorSaysHowToWriteOne) {
  EXPECT_THAT(problemOf("127.0.0.1:8765"), HasSubstr("begin with ws://"));
  EXPECT_THAT(problemOf("ws://"), HasSubstr("host is missing"));
  EXPECT_THAT(problemOf("ws://a:99999"), HasSubstr("port must be a number"));
  EXPECT_THAT(problemOf("ws://a:"), HasSubstr("port must be a number"));
  EXPECT_THAT(problemOf("ws://[::1:80"), HasSubstr("bracket"));
  EXPECT_THAT(problemOf("ws://[[]:2"), HasSubstr("bracket"));
  EXPECT_THAT(problemOf("ws://a b"), HasSubstr("blanks"));
  EXPECT_THAT(problemOf("ws://a\r\nX: y"), HasSubstr("blanks"));
  EXPECT_THAT(problemOf("ws://me:secret@a"), Not(HasSubstr("secret")));
  EXPECT_THAT(problemOf("http://a"), HasSubstr("ws://HOST:PORT"));
}

}  // namespace
}  // namespace robotlink::websocket
