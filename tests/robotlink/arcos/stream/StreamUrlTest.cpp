// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/StreamUrl.h"

#include <gmock/gmock.h>

#include <map>

namespace robotlink::arcos {
namespace {

using testing::HasSubstr;

StreamUrl parse(const std::string& url) {
  const auto parsed = parseUrl(url);
  EXPECT_TRUE(parsed.has_value()) << url;
  return parsed.value_or(TcpAddress{});
}

TEST(StreamUrl, aHostMayComeWithAPort) {
  EXPECT_EQ(parse("tcp://robot7:8102"), StreamUrl(TcpAddress{"robot7", 8102}));
  EXPECT_EQ(parse("tcp://127.0.0.1"), StreamUrl(TcpAddress{"127.0.0.1", 8101}));
  EXPECT_EQ(parse("tcp://localhost:8101/"), StreamUrl(TcpAddress{"localhost", 8101}));
  EXPECT_EQ(parse("tcp://[::1]:9000"), StreamUrl(TcpAddress{"::1", 9000}));
  EXPECT_EQ(parse("tcp://[fe80::2]"), StreamUrl(TcpAddress{"fe80::2", 8101}));
}

TEST(StreamUrl, aDeviceMayComeWithASpeed) {
  EXPECT_EQ(parse("serial:///dev/ttyUSB0"), StreamUrl(SerialAddress{"/dev/ttyUSB0", 9600}));
  EXPECT_EQ(parse("serial:///dev/ttyS1?baud=38400"), StreamUrl(SerialAddress{"/dev/ttyS1", 38400}));
}

TEST(StreamUrl, whatIsClearWithoutItsSchemeNeedsNone) {
  EXPECT_EQ(parse("localhost:8291"), StreamUrl(TcpAddress{"localhost", 8291}));
  EXPECT_EQ(parse("[::1]:9000"), StreamUrl(TcpAddress{"::1", 9000}));
  EXPECT_EQ(parse("/dev/ttyUSB0"), StreamUrl(SerialAddress{"/dev/ttyUSB0", 9600}));
  EXPECT_EQ(parse("/dev/ttyS1?baud=38400"), StreamUrl(SerialAddress{"/dev/ttyS1", 38400}));
}

TEST(StreamUrl, whatIsWrittenIsReadAgain) {
  for (const StreamUrl& url : {StreamUrl(TcpAddress{"a.example", 1}), StreamUrl(TcpAddress{"::1", 65535}),
                               StreamUrl(SerialAddress{"/dev/serial/by-id/usb-x", 115200})}) {
    EXPECT_EQ(parse(toString(url)), url) << toString(url);
  }
}

TEST(StreamUrl, aWrongOneIsAnsweredByHowToWriteIt) {
  const std::map<std::string, std::string> adviceOf = {
      {"", "write tcp://localhost:8101 or serial:///dev/ttyUSB0?baud=9600"},
      {"localhost", "also give its port, as in localhost:8101"},
      {"localhost:", "a number from 1 to 65535"},
      {"/dev/ttyUSB0?baud=fast", "9600, 19200, 38400"},
      {"http://localhost", "write tcp://localhost:8101 or serial:"},
      {"tcp://", "the host is missing"},
      {"tcp://:8101", "the host is missing"},
      {"tcp://robot:", "a number from 1 to 65535"},
      {"tcp://robot:0", "a number from 1 to 65535"},
      {"tcp://robot:65536", "a number from 1 to 65535"},
      {"tcp://robot:99999999999999999999", "a number from 1 to 65535"},
      {"tcp://robot:81o1", "a number from 1 to 65535"},
      {"tcp://robot/map", "a host and a port only"},
      {"tcp://::1:8101", "brackets"},
      {"tcp://[::1", "not closed"},
      {"tcp://[::1]8101", "a number from 1 to 65535"},
      {"serial://ttyUSB0", "whole path"},
      {"serial:///", "whole path"},
      {"serial:///dev/ttyUSB0?speed=9600", "?baud=9600"},
      {"serial:///dev/ttyUSB0?baud=1234", "9600, 19200, 38400"},
      {"serial:///dev/ttyUSB0?baud=fast", "9600, 19200, 38400"},
  };
  for (const auto& [url, advice] : adviceOf) {
    const auto parsed = parseUrl(url);
    ASSERT_FALSE(parsed.has_value()) << url;
    EXPECT_EQ(parsed.error().id, "url.bad");
    EXPECT_THAT(parsed.error().text, HasSubstr(advice));
    EXPECT_THAT(parsed.error().text, HasSubstr("'" + url + "'"));
  }
}

}  // namespace
}  // namespace robotlink::arcos
