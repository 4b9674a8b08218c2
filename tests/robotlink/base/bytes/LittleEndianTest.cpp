// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/base/bytes/LittleEndian.h"

#include <gmock/gmock.h>

#include <limits>
#include <vector>

#include "robotlink/base/bytes/ByteReader.h"
#include "robotlink/base/bytes/ByteWriter.h"

using namespace robotlink;
using testing::ElementsAre;

TEST(LittleEndian, theFirstByteIsTheLowest) {
  std::uint8_t bytes[4] = {};
  storeNumber(bytes, std::uint32_t{0x01020304});
  EXPECT_THAT(bytes, ElementsAre(4, 3, 2, 1));
  EXPECT_EQ(loadNumber<std::uint32_t>(bytes), 0x01020304U);
  EXPECT_EQ(loadNumber<std::uint16_t>(bytes + 1), 0x0203U) << "which is not aligned";
  storeNumber(bytes, std::int16_t{-2});
  EXPECT_THAT(bytes, ElementsAre(0xFE, 0xFF, 2, 1));
  EXPECT_EQ(loadNumber<std::int16_t>(bytes), -2);
  storeNumber(bytes, 1.0F);
  EXPECT_THAT(bytes, ElementsAre(0, 0, 0x80, 0x3F));
  EXPECT_EQ(loadNumber<float>(bytes), 1);
}

TEST(ByteReader, readsWhatTheWriterWrote) {
  std::vector<std::uint8_t> bytes;
  ByteWriter writer(bytes);
  writer.put(std::uint8_t{200});
  writer.put(std::int64_t{-5});
  writer.put(std::string_view("text"));
  writer.put(0.1);
  writer.put(std::span<const std::uint8_t>(std::vector<std::uint8_t>{7, 8}));
  EXPECT_EQ(bytes.size(), 1U + 8 + 4 + 4 + 8 + 2);
  ByteReader reader(bytes);
  EXPECT_EQ(reader.take<std::uint8_t>(), 200);
  EXPECT_EQ(reader.take<std::int64_t>(), -5);
  EXPECT_EQ(reader.takeText(), "text");
  EXPECT_EQ(reader.take<double>(), 0.1);
  EXPECT_FALSE(reader.complete());
  EXPECT_THAT(reader.rest(), ElementsAre(7, 8));
  EXPECT_THAT(reader.take(2), ElementsAre(7, 8));
  EXPECT_TRUE(reader.complete());
}

TEST(ByteReader, valuesPastTheEndAreNothingAndAreSeen) {
  const std::vector<std::uint8_t> bytes = {1, 2, 3};
  ByteReader reader(bytes);
  EXPECT_EQ(reader.take<std::uint16_t>(), 0x0201);
  EXPECT_TRUE(reader.good());
  EXPECT_EQ(reader.take<std::uint16_t>(), 0);
  EXPECT_FALSE(reader.good());
  EXPECT_TRUE(reader.rest().empty()) << "a shorter value must not be read from the middle of a longer one";
  EXPECT_EQ(reader.take<std::uint8_t>(), 0);
  EXPECT_FALSE(reader.complete());
}

TEST(ByteReader, aLengthThatLiesReadsNothing) {
  const std::vector<std::uint8_t> bytes = {0xFF, 0xFF, 0xFF, 0xFF, 'a'};
  ByteReader reader(bytes);
  EXPECT_EQ(reader.takeText(), "");
  EXPECT_FALSE(reader.good());
  ByteReader whole(bytes);
  EXPECT_TRUE(whole.take(std::numeric_limits<std::uint64_t>::max()).empty());
  EXPECT_FALSE(whole.good());
}
