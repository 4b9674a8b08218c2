// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/bhuman/MessageQueueReader.h"

#include <gtest/gtest.h>

#include "tests/logplayer/bhuman/MemoryBytes.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

using namespace logplayer::bhuman;

namespace {

struct Read {
  std::vector<int> ids;
  std::string damage;  ///< "offset: text" a line
};

Read readAll(const std::vector<std::uint8_t>& file) {
  const auto source = bytesInMemory(file);
  MessageQueueReader reader(*source);
  Read result;
  while (const auto message = reader.next()) result.ids.push_back(message->id);
  for (const QueueDamage& damage : reader.damage())
    result.damage += std::to_string(damage.offset) + ": " + damage.text + "\n";
  return result;
}

bool recognized(const std::vector<std::uint8_t>& file) {
  return MessageQueueReader::recognizes(*bytesInMemory(file));
}

QueueBuilder twoFrames() {
  return QueueBuilder()
      .begin('m')
      .joints(100)
      .odometry(0.1, 20, 30)
      .end('m')
      .begin('c')
      .image(150, 4, 2)
      .text("seen")
      .end('c');
}

const std::vector<int> kTwoFrames = {1, 5, 8, 2, 1, 3, 36, 2};

}  // namespace

TEST(MessageQueueReader, yieldsEveryMessageOfAFile) {
  const Read read = readAll(twoFrames().file());
  EXPECT_EQ(read.ids, kTwoFrames);
  EXPECT_EQ(read.damage, "");
}

TEST(MessageQueueReader, readsAnAppendableFileToItsEnd) {
  const Read read = readAll(twoFrames().appendableFile());
  EXPECT_EQ(read.ids, kTwoFrames);
  EXPECT_EQ(read.damage, "");
}

TEST(MessageQueueReader, skipsMessagesOfUnknownKinds) {
  const Read read =
      readAll(twoFrames().message(200, "from later code").begin('m').joints(200).end('m').file());
  EXPECT_EQ(read.ids.size(), 12U);
  EXPECT_EQ(read.ids[8], 200);
  EXPECT_EQ(read.damage, "");
}

TEST(MessageQueueReader, reportsWhatAHeaderLiesAbout) {
  auto file = twoFrames().file();
  file[0] = 1;
  file[4] = 77;
  const Read read = readAll(file);
  EXPECT_EQ(read.ids, kTwoFrames) << "all of them are read";
  EXPECT_NE(read.damage.find("0: the header states"), std::string::npos) << read.damage;
  EXPECT_NE(read.damage.find("4: the header states 77 messages, 8 were read"), std::string::npos)
      << read.damage;
}

TEST(MessageQueueReader, aLyingSizeCostsOneMessage) {
  auto file = twoFrames().file();
  const std::size_t joints = 8 + 5;
  for (const std::uint8_t size : {std::uint8_t{0}, std::uint8_t{17}, std::uint8_t{255}}) {
    file[joints + 1] = size;
    const Read read = readAll(file);
    EXPECT_EQ(read.ids, (std::vector<int>{1, 8, 2, 1, 3, 36, 2})) << int{size};
    EXPECT_NE(read.damage.find("13: 184 bytes that are not messages were left out"), std::string::npos)
        << read.damage;
  }
}

TEST(MessageQueueReader, aSizePastTheEndCostsOneMessage) {
  auto file = twoFrames().file();
  file[8 + 5 + 3] = 0xFF;
  EXPECT_EQ(readAll(file).ids, (std::vector<int>{1, 8, 2, 1, 3, 36, 2}));
}

TEST(MessageQueueReader, aFileCutAnywhereYieldsWhatIsWhole) {
  const auto file = twoFrames().file();
  for (std::size_t size = 0; size < file.size(); ++size) {
    const Read read = readAll({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)});
    ASSERT_LE(read.ids.size(), kTwoFrames.size());
    EXPECT_TRUE(std::equal(read.ids.begin(), read.ids.end(), kTwoFrames.begin())) << size;
    if (size >= 8) {
      EXPECT_NE(read.damage, "") << size;
    }
  }
}

TEST(MessageQueueReader, anyFlippedByteCostsFewMessages) {
  const auto file = twoFrames().begin('m').joints(300).odometry(0, 0, 0).end('m').file();
  const std::size_t all = readAll(file).ids.size();
  for (std::size_t at = 8; at < file.size(); ++at) {
    for (const int flip : {0x01, 0x80, 0xFF}) {
      auto damaged = file;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ flip);
      EXPECT_GE(readAll(damaged).ids.size() + 2, all) << "byte " << at << " by " << flip;
    }
  }
}

TEST(MessageQueueReader, recognizesItsFilesOnly) {
  EXPECT_TRUE(recognized(twoFrames().file()));
  EXPECT_TRUE(recognized(twoFrames().appendableFile()));
  auto damaged = twoFrames().file();
  damaged[8] = 0xEE;
  EXPECT_TRUE(recognized(damaged)) << "a first message that is damaged";
  damaged = twoFrames().file();
  damaged[0] ^= 0x10;
  EXPECT_TRUE(recognized(damaged)) << "a header that is damaged";

  const std::string mcap =
      "\x89MCAP0\r\n this is another file, of some length, of which the first bytes say so";
  EXPECT_FALSE(recognized({mcap.begin(), mcap.end()}));
  EXPECT_FALSE(recognized({}));
  EXPECT_FALSE(recognized(std::vector<std::uint8_t>(1000, 0)));
  EXPECT_FALSE(recognized(std::vector<std::uint8_t>(1000, 0xFF)));
}

TEST(MessageQueueReader, filesOfOtherYearsKeepTheirMessages) {
  // Joint data of more joints than those of 2009.
  const std::string joints(200, 'x');
  QueueBuilder builder;
  for (int i = 0; i < 5; ++i) builder.begin('m').message(5, joints).end('m');
  const Read read = readAll(builder.file());
  EXPECT_EQ(read.ids.size(), 15U);
  EXPECT_EQ(read.damage, "");
}
