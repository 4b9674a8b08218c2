// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/SerialStream.h"

#include <gmock/gmock.h>

#include <numeric>
#include <thread>

#include "robotlink/arcos/stream/OpenStream.h"
#include "tests/TestFolder.h"
#include "tests/robotlink/arcos/PseudoTerminal.h"

namespace robotlink::arcos {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

struct SerialStreamTest : testing::Test {
  std::unique_ptr<ByteStream> plug(int baud = 9600) {
    auto stream = open(line.url(baud));
    EXPECT_TRUE(stream.has_value()) << stream.error().text;
    return std::move(*stream);
  }

  TestFolder folder;
  PseudoTerminal line{folder / "ttyUSB0"};
  std::array<std::uint8_t, 64> room{};
};

TEST_F(SerialStreamTest, allBytesPassUnchangedBothWaysAtThePaceOfTheLine) {
  const auto stream = plug();
  std::vector<std::uint8_t> all(256);
  std::iota(all.begin(), all.end(), std::uint8_t{0});  // with XON, XOFF, newlines, DEL and NUL
  ASSERT_TRUE(stream->write(all));
  EXPECT_EQ(line.receive(all.size()), all);

  std::jthread robot([&] { line.send(all); });
  std::vector<std::uint8_t> received;
  int pieces = 0;
  while (received.size() < all.size()) {
    const std::size_t count = stream->read(room, 2s).value();
    ASSERT_GT(count, 0u);
    received.insert(received.end(), room.begin(), room.begin() + static_cast<std::ptrdiff_t>(count));
    ++pieces;
  }
  EXPECT_EQ(received, all);
  EXPECT_GT(pieces, 10) << "they should have trickled in";
}

TEST_F(SerialStreamTest, theSpeedOfTheUrlIsSet) {
  for (const auto& [baud, speed] : {std::pair(9600, B9600), {38400, B38400}, {115200, B115200}}) {
    const auto stream = plug(baud);
    termios settings{};
    ASSERT_EQ(::tcgetattr(line.master(), &settings), 0);
    EXPECT_EQ(::cfgetospeed(&settings), speed) << baud;
    EXPECT_EQ(settings.c_lflag & static_cast<tcflag_t>(ICANON | ECHO), 0u);
  }
}

TEST_F(SerialStreamTest, silenceIsNoError) {
  const auto stream = plug();
  EXPECT_EQ(stream->read(room, 5ms), 0u);
}

TEST_F(SerialStreamTest, anAdapterThatIsUnpluggedIsNamedAndWorksAgainWhenItIsBack) {
  auto stream = plug();
  std::jthread hand([&] { line.unplug(); });
  Result<std::size_t> read = std::size_t{0};
  while (read && *read == 0) read = stream->read(room, 5s);
  hand.join();
  ASSERT_FALSE(read.has_value());
  EXPECT_EQ(read.error().id, "stream.lost");
  EXPECT_THAT(read.error().text, HasSubstr(line.path().string() + " is gone"));
  EXPECT_EQ(stream->write(room).error().id, "stream.lost");

  const auto gone = open(line.url());
  ASSERT_FALSE(gone.has_value());
  EXPECT_EQ(gone.error().id, "stream.no-device");
  EXPECT_THAT(gone.error().text, HasSubstr("is its cable plugged in?"));

  line.plugIn();
  stream = plug();
  line.send(std::array<std::uint8_t, 1>{42});
  EXPECT_EQ(stream->read(room, 5s), 1u);
  EXPECT_EQ(room[0], 42);
}

TEST_F(SerialStreamTest, whatTheLineHeldBeforeIsNotRead) {
  plug();  // so that the line is raw
  line.send(std::array<std::uint8_t, 3>{1, 2, 3}, 115200);
  const auto stream = plug();
  EXPECT_EQ(stream->read(room, 5ms), 0u);
}

TEST_F(SerialStreamTest, aLineServesOneProgram) {
  auto stream = plug();
  const auto second = open(line.url());
  ASSERT_FALSE(second.has_value());
  EXPECT_EQ(second.error().id, "stream.in-use");
  stream.reset();
  plug();
}

TEST_F(SerialStreamTest, aFarEndThatTakesNothingDoesNotBlockForever) {
  const auto stream = plug();
  std::jthread closer([&] {
    pollfd full{line.master(), POLLIN, 0};  // the far end could read something, but does not
    ::poll(&full, 1, -1);
    stream->close();
  });
  const std::vector<std::uint8_t> flood(1 << 20);
  EXPECT_EQ(stream->write(flood).error().id, "stream.closed");
}

TEST_F(SerialStreamTest, aFileIsNoSerialPort) {
  const auto stream = openSerial({ROBOTCONTROL_SOURCE_DIR "/README.md", 9600});
  ASSERT_FALSE(stream.has_value());
  EXPECT_EQ(stream.error().id, "stream.not-serial") << stream.error().text;
}

}  // namespace
}  // namespace robotlink::arcos
