// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/decoding/MessageType.h"

#include <google/protobuf/descriptor.pb.h>
#include <gtest/gtest.h>

namespace robotlink {
namespace {

using google::protobuf::FileDescriptorProto;
using google::protobuf::FileDescriptorSet;

/// A schema of so many files, each of which imports the next one; the first one has the message "a.M".
std::string chainOfImports(int files) {
  FileDescriptorSet set;
  for (int i = 0; i < files; ++i) {
    FileDescriptorProto& file = *set.add_file();
    file.set_name("file" + std::to_string(i));
    if (i + 1 < files) file.add_dependency("file" + std::to_string(i + 1));
  }
  set.mutable_file(0)->set_package("a");
  set.mutable_file(0)->add_message_type()->set_name("M");
  return set.SerializeAsString();
}

bool isDecoded(const std::string& schema) {
  const MessageSchema given{"a.M", "protobuf", schema};
  return MessageType(&given, "protobuf").isDecoded();
}

TEST(MessageType, importsAreFoundWhereverTheyAreInTheSchema) {
  EXPECT_TRUE(isDecoded(chainOfImports(1)));
  EXPECT_TRUE(isDecoded(chainOfImports(50)));
}

TEST(MessageType, anEndlessChainOfImportsIsNoSchema) {
  EXPECT_FALSE(isDecoded(chainOfImports(200'000)));
}

TEST(MessageType, filesThatImportEachOtherAreNoSchema) {
  FileDescriptorSet set;
  set.ParseFromString(chainOfImports(2));
  set.mutable_file(1)->add_dependency("file0");
  EXPECT_FALSE(isDecoded(set.SerializeAsString()));
}

}  // namespace
}  // namespace robotlink
