// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "robotlink/foxglove/protocol/Base64.h"
#include "tests/robotlink/foxglove/Samples.h"

namespace robotlink::websocket::test {
namespace {

using testing::HasSubstr;

FrameKind kindOf(const std::string& wire) {
  return wire.starts_with('{') ? FrameKind::kText : FrameKind::kBinary;
}

std::string clientProblem(FrameKind kind, const std::string& wire) {
  const auto message = decodeClientMessage(kind, wire);
  return message ? "none" : message.error().text;
}

TEST(FoxgloveCodec, everyMessageOfAServerIsWrittenAndReadAsTheProtocolSays) {
  for (const auto& [message, wire] : serverSamples()) {
    EXPECT_EQ(encode(message), (Frame{kindOf(wire), wire}));
    const auto read = decodeServerMessage(kindOf(wire), wire);
    ASSERT_TRUE(read) << wire << ": " << read.error().text;
    EXPECT_EQ(*read, message) << wire;
  }
}

TEST(FoxgloveCodec, everyMessageOfAClientIsWrittenAndReadAsTheProtocolSays) {
  for (const auto& [message, wire] : clientSamples()) {
    EXPECT_EQ(encode(message), (Frame{kindOf(wire), wire}));
    const auto read = decodeClientMessage(kindOf(wire), wire);
    ASSERT_TRUE(read) << wire << ": " << read.error().text;
    EXPECT_EQ(*read, message) << wire;
  }
}

TEST(FoxgloveCodec, everyCutOfABinaryMessageThatLacksAFieldIsRefused) {
  for (const auto& [message, wire] : clientSamples()) {
    if (kindOf(wire) == FrameKind::kText) continue;
    EXPECT_TRUE(decodeClientMessage(FrameKind::kBinary, wire));
    for (std::size_t size = 0; size < 5; ++size)
      EXPECT_FALSE(decodeClientMessage(FrameKind::kBinary, wire.substr(0, size))) << size;
  }
}

TEST(FoxgloveCodec, lyingLengthsAndWrongBytesAreNamed) {
  const auto problem = [](const std::string& wire) { return clientProblem(FrameKind::kBinary, wire); };
  EXPECT_THAT(problem(""), HasSubstr("empty"));
  EXPECT_THAT(problem("\x09"), HasSubstr("no binary message with opcode 9"));
  EXPECT_THAT(problem(bytes("\x02\x03\0\0\0\x09\0\0\0\xff\xff\xff\xffjson")), HasSubstr("shorter than"));
  EXPECT_THAT(problem(bytes("\x03\x02\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0")),
              HasSubstr("its command is 2"));
  EXPECT_THAT(problem(bytes("\x03\x01\0\0\xc0\x7f\0\0\0\0\0\0\0\0\0\0\0\0\0")),
              HasSubstr("speed is not a number"));
  EXPECT_THAT(problem(bytes("\x03\x01\0\0\x80\x3f\x01\0\0\0\0\0\0\0\x80\0\0\0\0")), HasSubstr("2262"));
  EXPECT_THAT(problem(bytes("\x03\0\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0xyz")),
              HasSubstr("3 bytes too many"));
  std::string longName = bytes("\x02\x03\0\0\0\x09\0\0\0\x01\x10\0\0");
  EXPECT_THAT(problem(longName + std::string(4097, 'a')), HasSubstr("longer than 4096"));
}

TEST(FoxgloveCodec, problemsOfJsonNameTheField) {
  const auto problem = [](const std::string& wire) { return clientProblem(FrameKind::kText, wire); };
  EXPECT_THAT(problem("{"), HasSubstr("not JSON"));
  EXPECT_THAT(problem("\"\xff\""), HasSubstr("not JSON"));
  EXPECT_THAT(problem("[]"), HasSubstr("a text called op"));
  EXPECT_THAT(problem(R"({"op":7})"), HasSubstr("a text called op"));
  EXPECT_THAT(problem(R"({"op":"serverInfo"})"), HasSubstr("no message called 'serverInfo'"));
  EXPECT_EQ(problem(R"({"op":"subscribe"})"), "subscribe: subscriptions is missing");
  EXPECT_EQ(problem(R"({"op":"subscribe","subscriptions":{}})"), "subscribe: subscriptions must be an array");
  EXPECT_EQ(problem(R"({"op":"subscribe","subscriptions":[1]})"),
            "subscribe: subscriptions[0] must be an object");
  EXPECT_EQ(problem(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":2},{"id":-1,"channelId":2}]})"),
            "subscribe: subscriptions[1].id must be a whole number from 0 to 4294967295");
  EXPECT_EQ(problem(R"({"op":"setParameters","parameters":[{"name":"a","value":"!","type":"byte_array"}]})"),
            "setParameters: parameters[0].value must be base64, as its type is byte_array");
  EXPECT_EQ(problem(R"({"op":"setParameters","parameters":[{"name":"a","value":{"x":[null]}}]})"),
            "setParameters: parameters[0].value.x[0] must not be null");
  EXPECT_EQ(problem(R"({"op":"fetchAsset","requestId":1,"uri":")" + std::string(5000, 'a') + "\"}"),
            "fetchAsset: uri is longer than 4096 bytes");
  EXPECT_THAT(problem(R"({"op":"x","a":)" + std::string(100'000, '[')), HasSubstr("nested deeper than 32"));
}

TEST(FoxgloveCodec, bracketsInTextsAreNoNesting) {
  const std::string text =
      R"({"op":"getParameters","parameterNames":["\")" + std::string(40, '[') + R"("],"id":"1"})";
  const auto message = decodeClientMessage(FrameKind::kText, text);
  ASSERT_TRUE(message) << message.error().text;
  EXPECT_EQ(*message, ClientMessage(GetParameters{{"\"" + std::string(40, '[')}, "1"}));
}

TEST(FoxgloveCodec, whatLaterVersionsAddIsIgnored) {
  EXPECT_TRUE(
      decodeClientMessage(FrameKind::kText, R"({"op":"unsubscribe","subscriptionIds":[],"more":null})"));
}

TEST(FoxgloveCodec, wholeNumbersOfOtherLanguagesStayWhatTheirTypeSays) {
  // JavaScript writes 3.0 as 3.
  const auto message = decodeClientMessage(
      FrameKind::kText,
      R"({"op":"setParameters","parameters":[{"name":"a","value":3,"type":"float64"},{"name":"b","value":3}]})");
  ASSERT_TRUE(message);
  EXPECT_EQ(*message, ClientMessage(SetParameters{{{"a", Value{3.0}}, {"b", Value{std::int64_t{3}}}}, ""}));
}

TEST(FoxgloveCodec, textThatIsNoUtf8IsReplacedRatherThanRefused) {
  EXPECT_EQ(encode(ServerMessage(Status{StatusLevel::kInfo, "a\xff", ""})).bytes,
            "{\"level\":0,\"message\":\"a\xef\xbf\xbd\",\"op\":\"status\"}");
}

TEST(FoxgloveCodec, aSentenceThatIsTooLongIsCutRatherThanLost) {
  std::string text = "a";
  for (int i = 0; i < 5000; ++i) text += "\xc3\xbc";
  for (const ServerMessage& message : {ServerMessage(Status{StatusLevel::kError, text, ""}),
                                       ServerMessage(ServiceCallFailure{1, 2, text})}) {
    const Frame frame = encode(message);
    const auto read = decodeServerMessage(frame.kind, frame.bytes);
    ASSERT_TRUE(read) << read.error().text;
    const auto* status = std::get_if<Status>(&*read);
    const std::string& sentence =
        status != nullptr ? status->message : std::get<ServiceCallFailure>(*read).message;
    EXPECT_EQ(sentence, text.substr(0, kMaxName - 1) + "?");
  }
  // Those of others, too.
  const auto foreign =
      decodeServerMessage(FrameKind::kText, R"({"op":"status","level":1,"message":")" + text + "\"}");
  ASSERT_TRUE(foreign) << foreign.error().text;
  EXPECT_EQ(std::get<Status>(*foreign).message.size(), kMaxName);
}

TEST(FoxgloveCodec, noTimeIsBeforeTheFirst) {
  const Instant before(Duration(-5));
  const Frame time = encode(ServerMessage(Time{before}));
  EXPECT_EQ(decodeServerMessage(time.kind, time.bytes).value(), ServerMessage(Time{Instant()}));
  ServerInfo info{"s", {}, {}, {}, "1", before, Instant(Duration(7))};
  const Frame frame = encode(ServerMessage(info));
  info.dataStart = Instant();
  EXPECT_EQ(decodeServerMessage(frame.kind, frame.bytes).value(), ServerMessage(info));
}

TEST(Base64, isThatOfTheStandard) {
  const std::vector<std::pair<std::string, std::string>> vectors{
      {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, text] : vectors) {
    EXPECT_EQ(toBase64(plain), text);
    EXPECT_EQ(fromBase64(text), plain);
  }
  for (const char* wrong : {"Z", "Zg=", "Zg=g", "Z===", "Zm9v!m9v", "===="})
    EXPECT_FALSE(fromBase64(wrong)) << wrong;
}

}  // namespace
}  // namespace robotlink::websocket::test
