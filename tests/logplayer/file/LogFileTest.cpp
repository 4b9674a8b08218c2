// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/file/LogFile.h"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <gtest/gtest.h>

#include <thread>

#include "logplayer/base/LogChannels.h"
#include "robotlink/expressions/FieldPath.h"
#include "tests/logplayer/LogFixture.h"

using namespace logplayer;
using namespace logplayer::tests;

namespace {

std::shared_ptr<LogFile> opened(const std::filesystem::path& file) {
  auto log = LogFile::open(file, {});
  EXPECT_TRUE(log.has_value()) << (log ? "" : log.error().describe());
  return log ? *log : nullptr;
}

double valueOf(const StreamMessage& message) {
  return robotlink::numberAt(*message.value, "value").value_or(-1);
}

std::vector<double> valuesFrom(LogFile::Cursor& cursor) {
  std::vector<double> values;
  while (const auto message = cursor.next()) values.push_back(valueOf(*message));
  return values;
}

/// Ten frames of cognition, a tenth of a second apart, each with a plot.
void writeFrames(LogWriter& writer, std::uint64_t firstFrame = 1) {
  for (std::uint64_t i = 0; i < 10; ++i) {
    const double time = 0.1 * static_cast<double>(i);
    const std::uint64_t frame = firstFrame + i;
    ASSERT_TRUE(writer.write({plot("red1/plots/a", time, static_cast<double>(i), "cognition", frame),
                              frameInfo("red1", "cognition", time, frame)}));
  }
}

}  // namespace

TEST(LogFile, listsWhatItHolds) {
  const LogFixture fixture;
  {
    const auto writer = fixture.write();
    auto table = std::make_shared<robotcontrol::KeyTable>();
    ASSERT_TRUE(writer->write({StreamMessage{"red1/tables/keys", at(-50), table, "debug"}}));
    writeFrames(*writer);
    ASSERT_TRUE(writer->write({plot("blue1/plots/b", 0.35, 7)}));
    auto scene = std::make_shared<foxglove::SceneUpdate>();
    ASSERT_TRUE(writer->write({StreamMessage{"scene", at(-60), scene}}));
  }
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  std::vector<std::string> paths;
  for (const auto& stream : log->streams()) paths.push_back(stream.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"blue1/plots/b", "red1/frames/cognition", "red1/plots/a",
                                             "red1/tables/keys", "scene"}));
  EXPECT_EQ(log->robots(), (std::vector<std::string>{"blue1", "red1"}));
  // A table and a scene that were published long before are not when the recording began.
  EXPECT_EQ(log->begin(), at(0));
  EXPECT_EQ(log->end(), at(0.9));
  const auto& plots = log->streams()[2];
  EXPECT_EQ(plots.type, "robotcontrol.PlotValue");
  EXPECT_EQ(plots.count, 10U);
  EXPECT_EQ(plots.first, at(0));
  EXPECT_EQ(plots.last, at(0.9));
  EXPECT_TRUE(log->complete());
  EXPECT_EQ(log->damageText(), "");
  EXPECT_FALSE(log->readOnly());
  const auto counted = log->countBytes({});
  ASSERT_EQ(counted.size(), 5U);
  EXPECT_EQ(counted[2].bytes, 9U * 9U);  // zero is not written
  EXPECT_TRUE(log->countBytes([](double) { return false; }).size() == 5U) << "too few messages to be asked";
}

TEST(LogFile, findsTheNewestMessageAndItsNeighbors) {
  const LogFixture fixture;
  writeFrames(*fixture.write());
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  const auto message = log->latest("red1/plots/a", at(0.45));
  ASSERT_TRUE(message);
  EXPECT_EQ(message->time, at(0.4));
  EXPECT_EQ(message->process, "cognition");
  EXPECT_EQ(message->frame, 5U);
  EXPECT_EQ(valueOf(*message), 4);
  EXPECT_EQ(valueOf(*log->latest("red1/plots/a", at(0.4))), 4);
  EXPECT_FALSE(log->latest("red1/plots/a", at(-0.1)));
  EXPECT_FALSE(log->latest("red1/plots/none", at(1)));
  EXPECT_EQ(log->timeAfter("red1/plots/a", at(0.4)), at(0.5));
  EXPECT_FALSE(log->timeAfter("red1/plots/a", at(0.9)));
  EXPECT_EQ(log->times("red1/plots/a").size(), 10U);
}

TEST(LogFile, aFileThatIsCutShortWhileItIsOpenSaysSo) {
  const LogFixture fixture;
  writeFrames(*fixture.write());
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  EXPECT_EQ(log->damageText(), "");
  fixture.truncate(std::filesystem::file_size(fixture.path()) - 100);
  EXPECT_NE(log->damageText().find("cut short while it was open: 100 bytes"), std::string::npos)
      << log->damageText();
}

TEST(LogFile, aStreamThatIsFoundOnlyWhileBytesAreCountedIsLeftOut) {
  const LogFixture fixture;
  const auto writeChunks = [&](const std::string& name, const std::vector<std::string>& paths,
                               std::size_t bytes) {
    const auto writer = fixture.write(name);
    double time = 0;
    for (const std::string& path : paths) {
      auto value = std::make_shared<robotcontrol::PlotValue>();
      value->set_unit(std::string(bytes, 'x'));
      ASSERT_TRUE(writer->write({StreamMessage{path, at(time += 1), value}}));
      ASSERT_TRUE(writer->container().flush());
    }
  };
  const auto chunksOf = [](const std::filesystem::path& file) {
    return (*mcap::Reader::open(file, {}))->chunks();
  };
  writeChunks("log.mcap", std::vector<std::string>(100, "red1/plots/a"), 50'000);
  writeChunks("other.mcap", {"red1/plots/a", "red1/plots/b"}, 10);
  // A chunk of another file takes the place of one that is not looked at when the file is opened.
  const auto chunks = chunksOf(fixture.path()), others = chunksOf(fixture.path("other.mcap"));
  std::string foreign(others[1].length, '\0');
  std::ifstream from(fixture.path("other.mcap"), std::ios::binary);
  from.seekg(static_cast<std::streamoff>(others[1].offset));
  from.read(foreign.data(), static_cast<std::streamsize>(foreign.size()));
  const std::size_t place = chunks[99].offset - chunks[98].offset;
  std::string filler{static_cast<char>(0x80)};
  for (std::size_t i = 0, length = place - foreign.size() - 9; i < 8; ++i, length >>= 8U)
    filler += static_cast<char>(length & 0xFFU);
  std::fstream file(fixture.path(), std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(static_cast<std::streamoff>(chunks[98].offset));
  file << foreign << filler << std::flush;

  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  ASSERT_EQ(log->streams().size(), 1U);
  const auto counted = log->countBytes({});
  ASSERT_EQ(counted.size(), 1U);
  EXPECT_GT(counted[0].bytes, 99U * 50'000U);
  EXPECT_NE(log->damageText().find("summary does not fit"), std::string::npos) << log->damageText();
}

TEST(LogFile, aCursorGoesInTheOrderOfTimeFromAnywhere) {
  const LogFixture fixture;
  {
    const auto writer = fixture.write();
    ASSERT_TRUE(writer->write({plot("red1/plots/a", 2, 2)}));
    ASSERT_TRUE(writer->container().flush());
    ASSERT_TRUE(writer->write({plot("red1/plots/b", 1, 1), plot("red1/plots/a", 3, 3)}));
  }
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  LogFile::Cursor all(log, {});
  EXPECT_EQ(all.nextTime(), at(1));
  EXPECT_EQ(valuesFrom(all), (std::vector<double>{1, 2, 3}));
  EXPECT_FALSE(all.nextTime());
  all.seek(at(2));
  EXPECT_EQ(valuesFrom(all), (std::vector<double>{2, 3}));
  LogFile::Cursor some(log, {"red1/plots/a"});
  EXPECT_EQ(valuesFrom(some), (std::vector<double>{2, 3}));
  LogFile::Cursor none(log, {"red1/plots/none"});
  EXPECT_FALSE(none.next());
}

TEST(LogFile, whatTheLastFrameLacksIsNotShownIfTheRecorderWasKilled) {
  const LogFixture fixture;
  {
    const auto writer = fixture.write();
    writeFrames(*writer);
    // Larger than what gets a chunk of its own; its frame never came to its end.
    auto text = std::make_shared<foxglove::Log>();
    text->set_message(std::string(300'000, 'x'));
    ASSERT_TRUE(writer->write({StreamMessage{"red1/log", at(1), text, "cognition", 11}}));
    ASSERT_TRUE(writer->write({plot("red1/plots/a", 1, 10, "cognition", 11), plot("red1/plots/free", 1, 5)}));
  }
  const auto whole = opened(fixture.path());
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->times("red1/plots/a").size(), 11U) << "a complete file may hold messages between frames";
  const auto bytes = std::filesystem::file_size(fixture.path());
  fixture.truncate(bytes - 40);
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  EXPECT_FALSE(log->complete());
  EXPECT_NE(log->damageText(), "");
  EXPECT_EQ(log->times("red1/plots/a").size(), 10U);
  EXPECT_EQ(log->latest("red1/plots/a", at(5))->time, at(0.9));
  EXPECT_FALSE(log->latest("red1/log", at(5)));
  EXPECT_TRUE(log->latest("red1/plots/free", at(5))) << "it belongs to no frame";
  EXPECT_FALSE(log->timeAfter("red1/plots/a", at(0.9)));
  LogFile::Cursor cursor(log, {"red1/plots/a"});
  EXPECT_EQ(valuesFrom(cursor).size(), 10U);
  for (const auto& stream : log->streams()) {
    if (stream.path == "red1/plots/a") {
      EXPECT_EQ(stream.count, 10U);
    }
    EXPECT_NE(stream.path, "red1/log") << "it has nothing to show";
  }
  EXPECT_EQ(log->end(), at(1));
}

TEST(LogFile, numbersOfFramesAreWholeAlthoughTheFileHoldsHalfOfEach) {
  EXPECT_EQ(widenFrame(5, 3), 5U);
  EXPECT_EQ(widenFrame(0, 3), 0U);
  EXPECT_EQ(widenFrame(1, 0xFFFF'FFFF), 0x1'0000'0001U);
  EXPECT_EQ(widenFrame(0, 0xFFFF'FFFF), 0x1'0000'0000U);
  EXPECT_EQ(widenFrame(0xFFFF'FFFE, 0x3'0000'0001), 0x2'FFFF'FFFEU);
  const LogFixture fixture;
  writeFrames(*fixture.write(), 0x7'FFFF'FFFC);
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  EXPECT_EQ(log->latest("red1/plots/a", at(0))->frame, 0x7'FFFF'FFFCU);
  EXPECT_EQ(log->latest("red1/plots/a", at(0.9))->frame, 0x8'0000'0005U);
}

TEST(LogFile, typesThatTheProgramDoesNotKnowAreReadByTheirSchema) {
  const LogFixture fixture;
  google::protobuf::FileDescriptorProto file;
  file.set_name("unknown/Thing.proto");
  file.set_package("unknown");
  file.set_syntax("proto3");
  auto& type = *file.add_message_type();
  type.set_name("Thing");
  auto& field = *type.add_field();
  field.set_name("value");
  field.set_number(1);
  field.set_type(google::protobuf::FieldDescriptorProto::TYPE_DOUBLE);
  field.set_label(google::protobuf::FieldDescriptorProto::LABEL_OPTIONAL);
  google::protobuf::FileDescriptorSet set;
  *set.add_file() = file;
  {
    // 0x09 is field 1 as a double.
    const std::vector<std::uint8_t> thing{0x09, 0, 0, 0, 0, 0, 0, 0x45, 0x40};
    const auto writer = fixture.write();
    auto& container = writer->container();
    const auto schema = *container.addSchema("unknown.Thing", "protobuf", set.SerializeAsString());
    const auto nonsense = *container.addSchema("unknown.Other", "protobuf", "\x7F\x7F");
    const auto known = *container.addChannel("red1/thing", schema, "protobuf", {});
    const auto unknown = *container.addChannel("red1/other", nonsense, "protobuf", {});
    const auto text = *container.addChannel("red1/text", 0, "json", {});
    for (const std::uint16_t channel : {known, unknown, text}) {
      ASSERT_TRUE(container.write({channel, 0, at(1), at(1), thing}));
    }
    ASSERT_TRUE(container.write({known, 0, at(2), at(2), std::span(thing).first(3)}));
  }
  std::optional<StreamMessage> thing;
  {
    const auto log = opened(fixture.path());
    ASSERT_TRUE(log);
    EXPECT_EQ(log->streams()[2].type, "unknown.Thing");
    // The one at 2 s is cut off.
    thing = log->latest("red1/thing", at(3));
    EXPECT_NE(log->damageText().find("1 message could not be read"), std::string::npos) << log->damageText();
    const auto other = log->latest("red1/other", at(3));
    ASSERT_TRUE(other);
    const auto* copy = dynamic_cast<const robotcontrol::PackageCopy*>(other->value.get());
    ASSERT_NE(copy, nullptr);
    EXPECT_EQ(copy->type(), "unknown.Other");
    EXPECT_EQ(copy->data().size(), 9U);
    EXPECT_TRUE(log->latest("red1/text", at(3)));
  }
  // The file is closed: the message keeps its type alive.
  ASSERT_TRUE(thing);
  EXPECT_EQ(valueOf(*thing), 42);
  EXPECT_EQ(thing->value->GetDescriptor()->full_name(), "unknown.Thing");
}

TEST(LogFile, aDamagedChunkCostsNothingElse) {
  const LogFixture fixture;
  {
    const auto writer = fixture.write();
    for (int i = 0; i < 3; ++i) {
      ASSERT_TRUE(writer->write({plot("red1/plots/a", i, i + 1)}));
      ASSERT_TRUE(writer->container().flush());
    }
  }
  std::uint64_t middle = 0;
  {
    const auto reader = mcap::Reader::open(fixture.path(), {});
    ASSERT_TRUE(reader);
    ASSERT_GE((*reader)->chunks().size(), 3U);
    const auto& chunk = (*reader)->chunks()[1];
    middle = chunk.offset + chunk.length - 4;
  }
  fixture.flipByte(static_cast<std::streamoff>(middle));
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  LogFile::Cursor cursor(log, {});
  EXPECT_EQ(valuesFrom(cursor), (std::vector<double>{1, 3}));
  EXPECT_EQ(valueOf(*log->latest("red1/plots/a", at(1.5))), 1) << "the newest one that can be read";
  EXPECT_NE(log->damageText().find("1 damaged place"), std::string::npos) << log->damageText();
}

namespace {

/// Reads all that there is; how many messages that is, nothing if it is refused.
std::optional<std::size_t> readThrough(const std::filesystem::path& file) {
  const auto log = LogFile::open(file, {});
  if (!log) {
    EXPECT_FALSE(log.error().text.empty());
    return std::nullopt;
  }
  std::size_t count = 0;
  LogFile::Cursor cursor(*log, {});
  for (auto message = cursor.next(); message; message = cursor.next()) ++count;
  for (const auto& stream : (*log)->streams()) {
    (void)(*log)->latest(stream.path, stream.last);
    (void)(*log)->times(stream.path);
  }
  (void)(*log)->damageText();
  return count;
}

}  // namespace

/// Every byte of the container is hit in the tests of logplayer/mcap; here it is about frames.
TEST(LogFile, cutAnywhereItIsReadAsFarAsItGoes) {
  const LogFixture fixture;
  writeFrames(*fixture.write());
  const auto whole = readThrough(fixture.path());
  ASSERT_EQ(whole, 20U);
  std::size_t before = *whole;
  for (auto bytes = std::filesystem::file_size(fixture.path()); bytes > 11; bytes -= 11) {
    fixture.truncate(bytes - 11);
    const std::size_t count = readThrough(fixture.path()).value_or(0);
    EXPECT_LE(count, before) << bytes;
    EXPECT_EQ(count % 2, 0U) << "half a frame is shown, cut at " << bytes - 11;
    before = count;
  }
}

TEST(LogFile, anyFlippedByteHarmsAtMostItsChunk) {
  const LogFixture fixture;
  writeFrames(*fixture.write());
  const auto bytes = static_cast<std::streamoff>(std::filesystem::file_size(fixture.path()));
  for (std::streamoff at = 0; at < bytes; at += 13) {
    fixture.flipByte(at);
    const auto count = readThrough(fixture.path());
    EXPECT_TRUE(at < 8 || count.has_value()) << at;
    EXPECT_LE(count.value_or(0), 20U) << at;
    fixture.flipByte(at);
  }
}

TEST(LogFile, whatIsNoLogIsRefusedWithItsName) {
  const LogFixture fixture;
  std::ofstream(fixture.path("text.mcap"))
      << "Dear diary, today I recorded nothing at all, and I am not ashamed of it.";
  const auto text = LogFile::open(fixture.path("text.mcap"), {});
  ASSERT_FALSE(text);
  EXPECT_NE(text.error().describe().find("text.mcap"), std::string::npos) << text.error().describe();
  const auto missing = LogFile::open(fixture.path("missing.mcap"), {});
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().describe().find("missing.mcap"), std::string::npos) << missing.error().describe();
}

TEST(LogFile, severalThreadsReadAtOnce) {
  const LogFixture fixture;
  writeFrames(*fixture.write());
  const auto log = opened(fixture.path());
  ASSERT_TRUE(log);
  std::vector<std::thread> threads;
  std::atomic<int> read{0};
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      LogFile::Cursor cursor(log, {"red1/plots/a"});
      while (cursor.next()) {
        if (log->latest("red1/plots/a", at(0.5))) ++read;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(read, 40);
}
