// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/Conversation.h"

#include <gtest/gtest.h>

#include "tests/TestFolder.h"
#include "tests/robotlink/arcos/HexBytes.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using Kind = Conversation::Kind;

const std::string kText =
    "=== new connection\n"
    "     73.9 C>S id=0(0x00) len=3 ck=ok fafb03000000\n"
    "    174.2 S>C id=0(0x00) len=3 ck=ok fafb03000000\n"
    "    180.0 S>C id=0(0x00) len=3 ck=bad fafb03000001\n"
    "    181.5 S>C damage=3 010203\n"
    "   4625.1 client closed\n";

TEST(ConversationTest, aFileIsReadAndWrittenBack) {
  const auto conversation = readConversation(kText, "a.wire");
  ASSERT_TRUE(conversation) << conversation.error().describe();
  ASSERT_EQ(conversation->events.size(), 6U);
  EXPECT_EQ(conversation->events[0].kind, Kind::kNewConnection);
  EXPECT_EQ(conversation->events[1],
            (Conversation::Event{Kind::kPacket, 73900us, Direction::kFromClient, hexBytes("fafb03000000")}));
  EXPECT_EQ(conversation->events[2].direction, Direction::kFromRobot);
  EXPECT_EQ(conversation->events[4].bytes, (Bytes{1, 2, 3}));
  EXPECT_EQ(conversation->events[5], (Conversation::Event{Kind::kClosed, 4625100us, {}, {}}));
  EXPECT_EQ(writeConversation(*conversation), kText);
}

TEST(ConversationTest, remarksAndEmptyLinesAreSkipped) {
  const auto conversation =
      readConversation("# recorded in the corridor\n\n=== new connection\r\n  5 client closed", "");
  ASSERT_TRUE(conversation);
  EXPECT_EQ(writeConversation(*conversation), "=== new connection\n      5.0 client closed\n");
}

TEST(ConversationTest, aTimeThatIsRoundedToZeroIsWrittenWithoutASign) {
  const auto conversation = readConversation("-0.0051 client closed\n-0.05 client closed\n", "");
  ASSERT_TRUE(conversation);
  const std::string text = writeConversation(*conversation);
  EXPECT_EQ(text, "      0.0 client closed\n     -0.1 client closed\n");
  EXPECT_EQ(writeConversation(readConversation(text, "").value()), text);
}

TEST(ConversationTest, whatIsWrongIsReportedWithItsLine) {
  const auto problem = [](const std::string& line) {
    const auto conversation = readConversation("=== new connection\n" + line + "\n", "a.wire");
    return conversation ? "none" : conversation.error().describe();
  };
  EXPECT_EQ(problem("soon C>S id=0"), "a.wire:2: expected '=== new connection' or a time in ms, not 'soon'");
  EXPECT_EQ(problem("1e300 client closed"),
            "a.wire:2: expected '=== new connection' or a time in ms, not '1e300'");
  EXPECT_EQ(problem("nan client closed"),
            "a.wire:2: expected '=== new connection' or a time in ms, not 'nan'");
  EXPECT_EQ(problem("5.0 C<S fafb03000000"),
            "a.wire:2: expected 'C>S', 'S>C' or 'client closed' after the time");
  EXPECT_EQ(problem("5.0 C>S id=0(0x00) len=3 ck=ok fafb0300000"),
            "a.wire:2: expected the packet's bytes, two hexadecimal digits each, at the end");
  EXPECT_EQ(problem("5.0 C>S"),
            "a.wire:2: expected the packet's bytes, two hexadecimal digits each, at the end");
  EXPECT_EQ(problem("5.0 C>S id=1(0x01) len=3 ck=ok fafb03000000"),
            "a.wire:2: the line says 'id=1(0x01) len=3 ck=ok', but its bytes are 'id=0(0x00) len=3 ck=ok'");
  EXPECT_EQ(problem("5.0 C>S id=0(0x00) len=3 ck=ok fafb03000001"),
            "a.wire:2: the line says 'id=0(0x00) len=3 ck=ok', but its bytes are 'id=0(0x00) len=3 ck=bad'");
}

TEST(ConversationTest, filesThatCannotBeReadAreReported) {
  const TestFolder folder;
  const auto missing = readConversationFile(folder / "none.wire");
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().describe().find("none.wire"), std::string::npos) << missing.error().describe();
}

}  // namespace
}  // namespace robotlink::arcos
