// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/ClientSession.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/codec/ArcosCommandCatalog.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;

/// A session whose robot is the test: it sees what is said, and answers when it likes.
class ClientSessionTest : public ::testing::Test {
 protected:
  /// What was said since the last call: "SYNC0"s are PULSE, OPEN and CLOSE without argument.
  std::string said() {
    PacketParser parser;
    parser.push(session.takeOutgoing());
    std::string text;
    while (const auto found = parser.next()) {
      const auto command = toCommand(std::get<Packet>(*found));
      text += (text.empty() ? "" : " ") + nameOf(command->id);
      if (const int* value = std::get_if<int>(&command->argument)) text += "=" + std::to_string(*value);
    }
    return text;
  }

  /// Time passes, in steps of 10 ms. Yields what is said meanwhile.
  std::string pass(Duration duration) {
    std::string text;
    for (const Instant end = now + duration; now < end;) {
      now += 10ms;
      session.tick(now);
      const std::string step = said();
      if (!step.empty()) text += (text.empty() ? "" : " ") + step;
    }
    return text;
  }

  void answer(const Packet& packet) { session.take(packet, now); }
  void answerInformation() { answer(toPacket(StandardInformation{})); }
  void answerConfiguration() {
    Configuration configuration;
    configuration.subtype = "p3at-sh";
    answer(toPacket(configuration));
  }

  void openLine() {
    session.open(now);
    session.linkOpened(now);
  }
  void handshake() {
    openLine();
    answer({0, {}});
    answer({1, {}});
    answer(toPacket(Identity{"Robbie", "Pioneer", "p3at-sh", {}}));
  }
  void connect() {
    handshake();
    pass(100ms);
    answerConfiguration();
    answerInformation();
    ASSERT_TRUE(session.isConnected());
  }
  /// Information packets come every 100 ms.
  std::string drive(Duration duration) {
    std::string text;
    for (Duration t{}; t < duration; t += 100ms) {
      const std::string step = pass(100ms);
      if (!step.empty()) text += (text.empty() ? "" : " ") + step;
      answerInformation();
    }
    return text;
  }
  std::string problem() const { return session.problem() ? session.problem()->id : "none"; }

  ClientSession session;
  Instant now{5s};
};

TEST_F(ClientSessionTest, aConnectionIsMadeStepByStep) {
  EXPECT_FALSE(session.wantsLink());
  session.open(now);
  EXPECT_TRUE(session.wantsLink());
  EXPECT_EQ(said(), "");
  session.linkOpened(now);
  EXPECT_EQ(said(), "PULSE");
  EXPECT_EQ(session.describe(), "sent SYNC0, try 1 of 5");
  answer({0, {}});
  EXPECT_EQ(said(), "OPEN");
  answer({1, {}});
  EXPECT_EQ(said(), "CLOSE");
  answer(toPacket(Identity{"Robbie", "Pioneer", "p3at-sh", {}}));
  EXPECT_EQ(session.state(), ClientSession::State::kOpening);
  ASSERT_TRUE(session.identity());
  EXPECT_EQ(session.identity()->name, "Robbie");
  EXPECT_EQ(pass(90ms), "");
  EXPECT_EQ(pass(10ms), "OPEN=1 CONFIG=1");
  answerConfiguration();
  EXPECT_FALSE(session.isConnected());
  answerInformation();
  EXPECT_TRUE(session.isConnected());
  EXPECT_EQ(session.describe(), "connected to Robbie (Pioneer, p3at-sh)");
  EXPECT_EQ(session.configuration()->subtype, "p3at-sh");
  EXPECT_TRUE(session.information());
  EXPECT_EQ(session.statistics().connections, 1U);
  EXPECT_EQ(problem(), "none");
}

TEST_F(ClientSessionTest, everySyncIsRepeatedAndAtLastTheLineIsGivenUp) {
  openLine();
  EXPECT_EQ(said(), "PULSE");
  EXPECT_EQ(pass(990ms), "");
  EXPECT_EQ(pass(10ms), "PULSE");
  // Perhaps the robot is in the connection of somebody who is gone.
  EXPECT_EQ(pass(1s), "CLOSE=1");
  EXPECT_EQ(pass(300ms), "PULSE");
  EXPECT_EQ(pass(2300ms), "PULSE CLOSE=1 PULSE");
  EXPECT_EQ(session.state(), ClientSession::State::kSynchronizing);
  EXPECT_EQ(problem(), "arcos.no-answer");
  EXPECT_EQ(pass(1s), "");
  EXPECT_EQ(session.state(), ClientSession::State::kPausing);
  EXPECT_FALSE(session.wantsLink());
  EXPECT_NE(session.describe().find("waits 1 s before it connects again (no answer to SYNC0"),
            std::string::npos)
      << session.describe();
}

TEST_F(ClientSessionTest, anEchoThatIsLostOrLateDoesNoHarm) {
  openLine();
  answer({0, {}});
  EXPECT_EQ(said(), "PULSE OPEN");
  EXPECT_EQ(pass(1s), "OPEN");     // SYNC1 was lost
  EXPECT_EQ(pass(1s), "CLOSE=1");  // from the beginning
  answer({1, {}});                 // but its answer comes late
  EXPECT_EQ(pass(300ms), "PULSE");
  answer({1, {}});
  EXPECT_EQ(said(), "");
  answer({0, {}});
  EXPECT_EQ(said(), "OPEN");
  answer({0, {}});
  EXPECT_EQ(said(), "");
  answer({1, {}});
  EXPECT_EQ(said(), "CLOSE");
  EXPECT_EQ(pass(1s), "CLOSE");
  answer(toPacket(Identity{}));
  EXPECT_EQ(session.state(), ClientSession::State::kOpening);
}

TEST_F(ClientSessionTest, aRobotThatNeverAnswersAllIsGivenUp) {
  openLine();
  for (int i = 0; i < 100 && session.wantsLink(); ++i) {
    pass(500ms);
    answer({0, {}});
  }
  EXPECT_EQ(session.state(), ClientSession::State::kPausing);
  EXPECT_EQ(problem(), "arcos.no-answer");
}

TEST_F(ClientSessionTest, aRobotThatIsConnectedAlreadyIsSentClose) {
  openLine();
  said();
  answerInformation();
  EXPECT_EQ(said(), "CLOSE=1");
  EXPECT_EQ(session.state(), ClientSession::State::kResynchronizing);
  EXPECT_EQ(problem(), "arcos.busy");
  answerInformation();  // was on its way
  EXPECT_EQ(pass(290ms), "");
  EXPECT_EQ(pass(10ms), "PULSE");
  EXPECT_TRUE(session.wantsLink());
  answer({0, {}});
  EXPECT_EQ(said(), "OPEN");
}

TEST_F(ClientSessionTest, aRobotThatDoesNotCloseIsGivenUp) {
  openLine();
  for (int i = 0; i < 200 && session.wantsLink(); ++i) {
    answerInformation();
    pass(100ms);
  }
  EXPECT_EQ(session.state(), ClientSession::State::kPausing);
  EXPECT_EQ(problem(), "arcos.busy");
}

TEST_F(ClientSessionTest, aControllerThatRestartsIsConnectedAnew) {
  openLine();
  said();
  for (int i = 0; i < 20; ++i) answer({0xFF, {}});  // what it says until it is silent does not count
  EXPECT_EQ(problem(), "arcos.controller-reset");
  EXPECT_EQ(pass(300ms), "PULSE");
  EXPECT_EQ(session.state(), ClientSession::State::kSynchronizing);

  session = {};
  connect();
  said();
  answer({0xFF, {}});
  EXPECT_FALSE(session.isConnected());
  EXPECT_TRUE(session.wantsLink());
  EXPECT_EQ(problem(), "arcos.controller-reset");
  EXPECT_EQ(session.statistics().losses, 1U);
  EXPECT_EQ(said(), "");
  EXPECT_EQ(pass(300ms), "PULSE");
}

TEST_F(ClientSessionTest, withoutAConfigurationItGoesOnAfterASecond) {
  handshake();
  pass(100ms);
  answerInformation();
  EXPECT_EQ(pass(990ms), "CONFIG=1 CONFIG=1 CONFIG=1 CONFIG=1");
  EXPECT_FALSE(session.isConnected());
  EXPECT_EQ(pass(10ms), "");
  EXPECT_TRUE(session.isConnected());
  EXPECT_EQ(session.configuration(), nullptr);
  EXPECT_NE(session.describe().find("has not reported its configuration"), std::string::npos);
  answerConfiguration();
  EXPECT_TRUE(session.configuration());
}

TEST_F(ClientSessionTest, openIsRepeatedUntilInformationComes) {
  handshake();
  said();
  EXPECT_EQ(pass(1300ms), "OPEN=1 CONFIG=1 CONFIG=1 CONFIG=1 CONFIG=1 CONFIG=1 OPEN=1");
  answerConfiguration();
  EXPECT_EQ(pass(1s), "OPEN=1");
  EXPECT_EQ(pass(1s), "CLOSE=1");
  EXPECT_EQ(problem(), "arcos.no-information");
  EXPECT_EQ(session.state(), ClientSession::State::kResynchronizing);
}

TEST_F(ClientSessionTest, aSilentProgramIsKeptAlive) {
  connect();
  said();
  EXPECT_EQ(drive(2s), "PULSE PULSE PULSE PULSE");
  ASSERT_TRUE(session.send(command(CommandId::kVel, 100), now));
  EXPECT_EQ(said(), "VEL=100");
  EXPECT_EQ(drive(400ms), "");
  EXPECT_EQ(drive(100ms), "PULSE");
}

TEST_F(ClientSessionTest, silenceOfEightSecondsIsALoss) {
  connect();
  pass(7990ms);
  EXPECT_TRUE(session.isConnected());
  pass(10ms);
  EXPECT_EQ(session.state(), ClientSession::State::kPausing);
  EXPECT_EQ(session.problem()->text, "nothing was received from the robot for 8 s");
  EXPECT_EQ(session.statistics().losses, 1U);
  pass(1s);
  EXPECT_EQ(session.state(), ClientSession::State::kWaitingForLink);
  session.linkOpened(now);
  EXPECT_EQ(said(), "PULSE");
}

TEST_F(ClientSessionTest, packetsWithoutInformationAreALossToo) {
  connect();
  for (int i = 0; i < 79; ++i) {
    pass(100ms);
    answer({0x90, Bytes(8)});
  }
  EXPECT_TRUE(session.isConnected());
  pass(100ms);
  EXPECT_EQ(problem(), "arcos.lost-information");
}

TEST_F(ClientSessionTest, closingStopsTheMotorsFirst) {
  connect();
  said();
  session.close(now);
  EXPECT_EQ(said(), "ENABLE=0 CLOSE=1");
  EXPECT_EQ(session.state(), ClientSession::State::kClosed);
  EXPECT_FALSE(session.wantsLink());
  EXPECT_EQ(problem(), "none");
  EXPECT_EQ(pass(20s), "");
  answerInformation();
  session.linkClosed({"x", "gone", {}, {}}, now);
  EXPECT_EQ(session.state(), ClientSession::State::kClosed);

  handshake();  // and again
  session.close(now);
  EXPECT_EQ(said(), "PULSE OPEN CLOSE CLOSE=1");
}

TEST_F(ClientSessionTest, pausesGrowUntilItIsConnectedAgain) {
  const auto failToOpen = [&] {
    session.linkClosed({"stream.refused", "nobody listens", {}, {}}, now);
    const Instant start = now;
    while (!session.wantsLink()) pass(10ms);
    return (now - start) / 1s;
  };
  session.open(now);
  for (const int seconds : {1, 2, 4, 8, 16, 30, 30}) EXPECT_EQ(failToOpen(), seconds);
  EXPECT_EQ(problem(), "stream.refused");
  session.linkOpened(now);
  answer({0, {}});
  answer({1, {}});
  answer(toPacket(Identity{}));
  pass(100ms);
  answerConfiguration();
  answerInformation();
  EXPECT_TRUE(session.isConnected());
  EXPECT_EQ(failToOpen(), 1);
}

TEST_F(ClientSessionTest, withoutReconnectingItFailsOnce) {
  ClientSession::Options options;
  options.reconnect = false;
  session = ClientSession(options);
  openLine();
  session.linkClosed({"stream.closed", "the robot closed the line", {}, {}}, now);
  EXPECT_EQ(session.state(), ClientSession::State::kFailed);
  EXPECT_EQ(session.describe(), "has given up (the robot closed the line)");
  pass(60s);
  EXPECT_FALSE(session.wantsLink());
  session.open(now);
  EXPECT_TRUE(session.wantsLink());
}

TEST_F(ClientSessionTest, commandsNeedAConnectionAndMustFit) {
  openLine();
  const auto early = session.send(command(CommandId::kVel, 1), now);
  ASSERT_FALSE(early);
  EXPECT_EQ(early.error().text,
            "VEL cannot be sent: there is no connection to the robot (sent SYNC0, try 1 of 5)");
  session = {};
  connect();
  said();
  EXPECT_FALSE(session.send(command(CommandId::kVel, 70000), now));
  EXPECT_FALSE(session.send(Packet{1, Bytes(198)}, now));
  EXPECT_TRUE(session.send(Packet{1, Bytes(197)}, now));
  Result<void> sent;
  int count = 0;
  while (sent && count < 10000) {
    sent = session.send(command(CommandId::kVel, 1), now);
    ++count;
  }
  ASSERT_FALSE(sent);
  EXPECT_EQ(sent.error().id, "arcos.line-full");
  EXPECT_LT(session.takeOutgoing().size(), 70000U);
}

TEST_F(ClientSessionTest, theRoundTripIsMeasuredNowAndThen) {
  handshake();
  pass(100ms);
  now += 30ms;
  answerConfiguration();
  answerInformation();
  EXPECT_EQ(session.statistics().roundTrip, 30ms);
  const std::string text = drive(10s);
  EXPECT_NE(text.find("CONFIG=1"), std::string::npos) << text;
  EXPECT_EQ(text.find("CONFIG=1"), text.rfind("CONFIG=1"));

  // Which of two requests is answered is not known.
  session = {};
  handshake();
  pass(310ms);
  answerConfiguration();
  EXPECT_EQ(session.statistics().roundTrip, 0ms);
}

TEST_F(ClientSessionTest, theLongestGapIsOfTheLastSeconds) {
  connect();
  drive(1s);
  EXPECT_EQ(session.statistics().longestGap, 100ms);
  pass(700ms);
  EXPECT_EQ(session.statistics().longestGap, 700ms);
  answerInformation();
  drive(4900ms);
  EXPECT_EQ(session.statistics().longestGap, 700ms);
  drive(300ms);
  EXPECT_EQ(session.statistics().longestGap, 100ms);
}

TEST_F(ClientSessionTest, bytesWithoutPacketsPointToTheLinesRate) {
  openLine();
  for (int i = 0; i < 80; ++i) {
    session.take(DamagedBytes{DamagedBytes::Kind::kGarbage, {1, 2, 3}}, now);
    pass(100ms);
  }
  EXPECT_EQ(problem(), "arcos.only-damage");
  EXPECT_NE(session.problem()->text.find("rate"), std::string::npos);
}

TEST_F(ClientSessionTest, packetsThatLackSomethingAreCounted) {
  connect();
  answer({0x32, {1, 2}});
  answer({0x20, {}});
  answer({0x61, {1}});
  EXPECT_EQ(session.statistics().undecodable, 3U);
  EXPECT_TRUE(session.isConnected());
}

}  // namespace
}  // namespace robotlink::arcos
