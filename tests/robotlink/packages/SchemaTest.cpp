// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/Schema.h"

#include <gmock/gmock.h>
#include <google/protobuf/descriptor.h>
#include <google/protobuf/descriptor.pb.h>
#include <google/protobuf/dynamic_message.h>

#include "foxglove/Scene.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Requests.pb.h"

namespace robotlink {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::DescriptorPool;
using google::protobuf::FileDescriptorSet;

FileDescriptorSet filesOf(const Descriptor& type) {
  FileDescriptorSet files;
  EXPECT_TRUE(files.ParseFromString(schemaOf(type)));
  return files;
}

/// The type as a reader has it that knows nothing but the schema; null if it is incomplete.
const Descriptor* builtFrom(DescriptorPool& pool, const Descriptor& type) {
  const FileDescriptorSet files = filesOf(type);
  for (const auto& file : files.file()) {
    if (pool.BuildFile(file) == nullptr) return nullptr;
  }
  return pool.FindMessageTypeByName(type.full_name());
}

TEST(Schema, buildsTheWholeTypeInTheOrderOfItsFiles) {
  for (const Descriptor* type : {robotcontrol::PlotValue::descriptor(), robotcontrol::Request::descriptor(),
                                 robotcontrol::ProgramSetup::descriptor(),
                                 foxglove::SceneUpdate::descriptor(), robotcontrol::KeyTable::descriptor()}) {
    DescriptorPool pool;
    const Descriptor* built = builtFrom(pool, *type);
    ASSERT_NE(built, nullptr) << type->full_name();
    google::protobuf::DescriptorProto expected, found;
    type->CopyTo(&expected);
    built->CopyTo(&found);
    EXPECT_EQ(found.SerializeAsString(), expected.SerializeAsString()) << type->full_name();
  }
}

TEST(Schema, aForeignReaderDecodesMessages) {
  robotcontrol::KeyTable table;
  auto& key = *table.add_keys();
  key.set_name("a");
  key.mutable_mode()->set_kind(robotcontrol::KeyMode::EVERY_N);
  DescriptorPool pool;
  google::protobuf::DynamicMessageFactory factory(&pool);
  const Descriptor* built = builtFrom(pool, *robotcontrol::KeyTable::descriptor());
  ASSERT_NE(built, nullptr);
  const std::unique_ptr<google::protobuf::Message> message(factory.GetPrototype(built)->New());
  ASSERT_TRUE(message->ParseFromString(table.SerializeAsString()));
  EXPECT_EQ(message->DebugString(), table.DebugString());
}

TEST(Schema, hasNoTypesThatAreNotNeeded) {
  int types = 0;
  const FileDescriptorSet files = filesOf(*robotcontrol::PlotValue::descriptor());
  for (const auto& file : files.file()) types += file.message_type_size() + file.enum_type_size();
  EXPECT_EQ(types, 2) << "the plot's value and its timestamp";
  EXPECT_LT(schemaOf(*robotcontrol::PlotValue::descriptor()).size(), 500U);
}

}  // namespace
}  // namespace robotlink
