// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/TcpStream.h"

#include <gmock/gmock.h>

#include <array>
#include <thread>
#include <vector>

#include "tests/robotlink/arcos/TcpServer.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

struct TcpStreamTest : testing::Test {
  std::unique_ptr<ByteStream> connect() {
    auto stream = open("tcp://127.0.0.1:" + std::to_string(server.port()));
    EXPECT_TRUE(stream.has_value()) << stream.error().text;
    server.accept();
    return std::move(*stream);
  }

  TcpServer server;
  std::array<std::uint8_t, 8> room{};
};

TEST_F(TcpStreamTest, bytesGoBothWaysAndNoneIsNoError) {
  const auto stream = connect();
  EXPECT_EQ(stream->address(), "tcp://127.0.0.1:" + std::to_string(server.port()));
  EXPECT_EQ(stream->read(room, 0ms), 0u);
  EXPECT_EQ(stream->read(room, 2ms), 0u);
  server.send({1, 2, 3});
  EXPECT_EQ(stream->read(std::span(room).first(2), 5s), 2u);
  EXPECT_EQ(stream->read(room, 5s), 1u);
  EXPECT_EQ(room[0], 3);
  ASSERT_TRUE(stream->write(std::array<std::uint8_t, 2>{7, 8}));
  EXPECT_THAT(server.receive(2), ElementsAre(7, 8));
}

TEST_F(TcpStreamTest, whenTheFarEndGoesTheRestIsReadFirst) {
  const auto stream = connect();
  server.send({5});
  server.hangUp();
  EXPECT_EQ(stream->read(room, 5s), 1u);
  const auto lost = stream->read(room, 5s);
  ASSERT_FALSE(lost.has_value());
  EXPECT_EQ(lost.error().id, "stream.lost");
  EXPECT_THAT(lost.error().text, HasSubstr("closed the connection"));
}

TEST_F(TcpStreamTest, writingToAFarEndThatWentIsAnErrorAndNoSignal) {
  const auto stream = connect();
  server.hangUp();
  const std::vector<std::uint8_t> bytes(100'000);
  Result<void> written;
  for (int attempt = 0; attempt < 100 && written; ++attempt) written = stream->write(bytes);
  ASSERT_FALSE(written.has_value());
  EXPECT_EQ(written.error().id, "stream.lost");
}

TEST_F(TcpStreamTest, closingWakesAThreadThatReads) {
  const auto stream = connect();
  std::jthread closer([&] { stream->close(); });
  EXPECT_EQ(stream->read(room, 20s).error().id, "stream.closed");
  closer.join();
  stream->close();
  EXPECT_EQ(stream->write(room).error().id, "stream.closed");
  EXPECT_TRUE(server.receive(1).empty()) << "the far end does not see that it was closed";
}

TEST_F(TcpStreamTest, oneThreadMayReadWhileAnotherWrites) {
  const auto stream = connect();
  std::jthread writer([&] {
    for (std::uint8_t i = 0; i < 100; ++i) EXPECT_TRUE(stream->write(std::array{i}));
  });
  server.send(std::vector<std::uint8_t>(100, 4));
  std::size_t received = 0;
  while (received < 100) received += stream->read(room, 5s).value();
  EXPECT_EQ(server.receive(100).size(), 100u);
}

TEST_F(TcpStreamTest, aPortWhereNobodyListensSaysSo) {
  const std::uint16_t port = server.port();
  server.stop();
  const auto stream = openTcp({"127.0.0.1", port}, 5s);
  ASSERT_FALSE(stream.has_value());
  EXPECT_EQ(stream.error().id, "stream.refused");
  EXPECT_THAT(stream.error().text, HasSubstr("nothing listens at 127.0.0.1:" + std::to_string(port)));
}

TEST_F(TcpStreamTest, aHostThatDoesNotAnswerCostsNoMoreThanTheLimit) {
  server.fillBacklog();  // from then on the system answers no one
  const auto start = std::chrono::steady_clock::now();
  const auto stream = openTcp({"127.0.0.1", server.port()}, 50ms);
  EXPECT_LT(std::chrono::steady_clock::now() - start, 30s) << "the system itself waits for two minutes";
  ASSERT_FALSE(stream.has_value());
  EXPECT_EQ(stream.error().id, "stream.no-answer");
}

TEST(TcpStream, aHostThatDoesNotExistIsNamed) {
  const auto stream = open("tcp://no.such.host.invalid:8101");
  ASSERT_FALSE(stream.has_value());
  EXPECT_EQ(stream.error().id, "stream.no-host");
  EXPECT_THAT(stream.error().text, HasSubstr("no.such.host.invalid"));
}

TEST(TcpStream, aWrongUrlIsNotOpened) {
  EXPECT_EQ(open("localhost").error().id, "url.bad");
}

}  // namespace
}  // namespace robotlink::arcos
