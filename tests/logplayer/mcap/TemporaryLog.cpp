// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/logplayer/mcap/TemporaryLog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>

#include "logplayer/mcap/RecordBytes.h"
#include "logplayer/mcap/read/MessageCursor.h"

namespace logplayer::mcap::test {

void PrintTo(const Expected& expected, std::ostream* out) {
  *out << "channel " << expected.channelId << " #" << expected.sequence << " at " << expected.time << ", "
       << expected.data.size() << " bytes";
}

std::string readBytes(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

void writeBytes(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

void addChannels(Writer& writer, int channels) {
  const auto schema = writer.addSchema("s", "protobuf", "described by this");
  ASSERT_TRUE(schema) << schema.error().describe();
  for (int i = 1; i <= channels; ++i) {
    const auto id = writer.addChannel("c" + std::to_string(i), *schema, "protobuf", {{"process", "p"}});
    ASSERT_TRUE(id) << id.error().describe();
    ASSERT_EQ(*id, i);
  }
}

void write(Writer& writer, const Expected& expected) {
  const auto written = writer.write({expected.channelId, expected.sequence, at(expected.time),
                                     at(expected.time + 1), bytesOf(expected.data)});
  ASSERT_TRUE(written) << written.error().describe();
}

void writeLog(const std::filesystem::path& file, const std::vector<Expected>& messages,
              Writer::Options options, const std::vector<std::size_t>& flushBefore, int channels) {
  auto writer = Writer::create(file, std::move(options));
  ASSERT_TRUE(writer) << writer.error().describe();
  addChannels(**writer, channels);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (std::ranges::find(flushBefore, i) != flushBefore.end()) {
      ASSERT_TRUE((*writer)->flush());
    }
    write(**writer, messages[i]);
  }
  const auto closed = (*writer)->close();
  ASSERT_TRUE(closed) << closed.error().describe();
}

std::unique_ptr<Reader> open(const std::filesystem::path& file, Reader::Options options) {
  auto reader = Reader::open(file, std::move(options));
  EXPECT_TRUE(reader) << reader.error().describe();
  return reader ? std::move(*reader) : nullptr;
}

Expected readFrom(const Message& message) {
  EXPECT_EQ(message.publishTime - message.logTime, robotlink::Duration(1));
  return {message.channelId, message.sequence, message.logTime.time_since_epoch().count(),
          std::string(textOf(message.data))};
}

std::vector<Expected> readAll(Reader& reader) {
  std::vector<Expected> expected;
  reader.readAll([&](const Message& message) {
    expected.push_back(readFrom(message));
    return true;
  });
  return expected;
}

std::vector<Expected> readForwards(Reader& reader, std::vector<std::uint16_t> channels) {
  std::vector<Expected> expected;
  MessagePosition position{Instant::min(), 0, 0, 0};
  while (const auto next = reader.next(position, channels)) {
    if (const auto message = reader.read(*next)) expected.push_back(readFrom(message->message));
    position = *next;
  }
  return expected;
}

std::vector<Expected> readByCursor(Reader& reader, const std::vector<std::uint16_t>& channels) {
  std::vector<Expected> expected;
  for (MessageCursor cursor(reader, channels); cursor.next();) {
    if (cursor.readable()) expected.push_back(readFrom(cursor.message()));
  }
  return expected;
}

std::vector<Expected> readBackwards(Reader& reader, std::vector<std::uint16_t> channels) {
  std::vector<Expected> expected;
  MessagePosition position{Instant::max(), UINT64_MAX, UINT64_MAX, UINT16_MAX};
  while (const auto previous = reader.previous(position, channels)) {
    if (const auto message = reader.read(*previous)) expected.push_back(readFrom(message->message));
    position = *previous;
  }
  return expected;
}

std::vector<Expected> someMessages(int count, std::size_t bytes) {
  std::minstd_rand random(1);
  std::vector<Expected> messages;
  for (int i = 0; i < count; ++i) {
    Expected expected{static_cast<std::uint16_t>(1 + i % 3), static_cast<std::uint32_t>(i), 10 * (i + 1), {}};
    for (std::size_t j = 0; j < bytes; ++j) {
      expected.data.push_back(j % 2 == 0 ? 'x' : static_cast<char>(random() & 0xFF));
    }
    messages.push_back(std::move(expected));
  }
  return messages;
}

}  // namespace logplayer::mcap::test
