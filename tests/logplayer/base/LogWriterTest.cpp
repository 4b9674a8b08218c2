// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/base/LogWriter.h"

#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>
#include <gtest/gtest.h>

#include "tests/logplayer/RecordedMessages.h"

using namespace logplayer;
using namespace logplayer::tests;

namespace {

std::unique_ptr<LogWriter> create(const std::filesystem::path& file, mcap::Writer::Options options = {}) {
  auto writer = LogWriter::create(file, std::move(options));
  EXPECT_TRUE(writer.has_value());
  return writer ? std::move(*writer) : nullptr;
}

/// A message of a type that exists only in a pool of its own, which goes with the message.
StreamMessage foreign(const std::string& field) {
  struct Owner {
    google::protobuf::DescriptorPool pool;
    google::protobuf::DynamicMessageFactory factory;
    std::unique_ptr<google::protobuf::Message> message;
  };
  google::protobuf::FileDescriptorProto file;
  file.set_name("foreign.proto");
  file.set_syntax("proto3");
  auto& type = *file.add_message_type();
  type.set_name("Foreign");
  auto& added = *type.add_field();
  added.set_name(field);
  added.set_number(1);
  added.set_type(google::protobuf::FieldDescriptorProto::TYPE_STRING);
  added.set_label(google::protobuf::FieldDescriptorProto::LABEL_OPTIONAL);
  auto owner = std::make_shared<Owner>();
  const auto* descriptor = owner->pool.BuildFile(file)->message_type(0);
  owner->message.reset(owner->factory.GetPrototype(descriptor)->New());
  owner->message->GetReflection()->SetString(owner->message.get(), descriptor->field(0), field);
  return {"red1/foreign", at(1), robotlink::PackagePtr(owner, owner->message.get())};
}

}  // namespace

TEST(LogWriter, aChannelIsAStreamAndTheProcessThatPublishedIt) {
  const TestFolder folder;
  {
    const auto writer = create(folder / "a.mcap");
    ASSERT_TRUE(
        writer->write({plot("red1/plots/x", 8, 1, "cognition", 3), plot("red1/plots/x", 8, 2, "motion", 4),
                       plot("transforms", 8, 3, ""), frameInfo(8, 3)}));
  }
  const ReadLog log = readLog(folder / "a.mcap");
  EXPECT_TRUE(log.complete);
  ASSERT_EQ(log.entries.size(), 4U);
  EXPECT_EQ(log.entries[0].process, "cognition");
  EXPECT_EQ(log.entries[1].process, "motion");
  EXPECT_EQ(log.entries[2].process, "");
  EXPECT_EQ(log.entries[0].frame, 3U);
  EXPECT_EQ(log.entries[2].frame, 0U);
  EXPECT_EQ(log.entries[0].time, at(8));
  EXPECT_EQ(log.entries[3].type, "robotcontrol.FrameInfo");
  robotcontrol::PlotValue value;
  ASSERT_TRUE(value.ParseFromString(log.entries[1].data));
  EXPECT_EQ(value.value(), 2);
}

TEST(LogWriter, theSchemasExplainEveryMessage) {
  const TestFolder folder;
  ASSERT_TRUE(create(folder / "a.mcap")->write({image("red1/camera/image", 1, 1000), frameInfo(1, 1)}));
  const auto reader = mcap::Reader::open(folder / "a.mcap", {});
  ASSERT_TRUE(reader.has_value());
  EXPECT_EQ((*reader)->schemas().size(), 2U);
  for (const auto& [id, schema] : (*reader)->schemas()) {
    EXPECT_EQ(schema.encoding, "protobuf");
    google::protobuf::FileDescriptorSet files;
    ASSERT_TRUE(files.ParseFromString(schema.data));
    google::protobuf::DescriptorPool pool;
    for (const auto& file : files.file()) ASSERT_NE(pool.BuildFile(file), nullptr);
    EXPECT_NE(pool.FindMessageTypeByName(schema.name), nullptr) << schema.name;
  }
}

TEST(LogWriter, aStreamThatChangesItsTypeGetsAnotherChannel) {
  const TestFolder folder;
  {
    const auto writer = create(folder / "a.mcap");
    ASSERT_TRUE(writer->write({plot("red1/camera/image", 1, 1, "")}));
    ASSERT_TRUE(writer->write({image("red1/camera/image", 2, 1000, "")}));
    ASSERT_TRUE(writer->write({plot("red1/camera/image", 3, 1, "")}));
  }
  const auto reader = mcap::Reader::open(folder / "a.mcap", {});
  ASSERT_TRUE(reader.has_value());
  EXPECT_EQ((*reader)->channels().size(), 2U);
  EXPECT_EQ(readLog(folder / "a.mcap").entries[1].type, "foxglove.RawImage");
}

TEST(LogWriter, typesOfOneNameThatDifferAreDistinguishedThoughTheyVanish) {
  const TestFolder folder;
  {
    const auto writer = create(folder / "a.mcap");
    for (const char* field : {"one", "two", "three"}) ASSERT_TRUE(writer->write({foreign(field)}));
  }
  const auto reader = mcap::Reader::open(folder / "a.mcap", {});
  ASSERT_TRUE(reader.has_value());
  EXPECT_EQ((*reader)->schemas().size(), 3U);
  EXPECT_EQ((*reader)->channels().size(), 3U);
}

TEST(LogWriter, aFrameIsInOneChunkButForLargeMessagesBeforeIt) {
  const TestFolder folder;
  mcap::Writer::Options options;
  options.chunkBytes = 1000;
  options.ownChunkBytes = 50'000;
  {
    const auto writer = create(folder / "a.mcap", options);
    std::vector<StreamMessage> frame;
    for (int i = 0; i < 500; ++i) frame.push_back(plot("red1/plots/x", 1, i));
    frame.push_back(image("red1/camera/image", 1, 60'000));
    frame.push_back(frameInfo(1, 1));
    ASSERT_TRUE(writer->write(frame));
  }
  const auto reader = mcap::Reader::open(folder / "a.mcap", {});
  ASSERT_TRUE(reader.has_value());
  ASSERT_EQ((*reader)->chunks().size(), 2U);
  EXPECT_EQ((*reader)->chunks()[0].messages, 1U);
  EXPECT_EQ((*reader)->chunks()[1].messages, 501U);
}

TEST(LogWriter, aFileThatExistsIsNotTouched) {
  const TestFolder folder;
  ASSERT_TRUE(create(folder / "a.mcap")->write({plot("red1/plots/x", 1, 1)}));
  const auto size = std::filesystem::file_size(folder / "a.mcap");
  const auto again = LogWriter::create(folder / "a.mcap", {});
  ASSERT_FALSE(again.has_value());
  EXPECT_NE(again.error().describe().find("a.mcap"), std::string::npos);
  EXPECT_EQ(std::filesystem::file_size(folder / "a.mcap"), size);
}
