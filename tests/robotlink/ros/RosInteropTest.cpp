// SPDX-License-Identifier: GPL-3.0-or-later
// Messages that the npm packages for ROS have written, field by field.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "robotlink/packages/FieldValues.h"
#include "tests/robotlink/ros/RosMessages.h"

namespace robotlink::ros {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using nlohmann::json;

struct Output {
  int status = -1;
  std::string text;
};

Output runScript() {
  Output output;
  FILE* const pipe =
      ::popen("node '" ROBOTCONTROL_SOURCE_DIR "/tests/robotlink/ros/ros_messages.mjs' 2>&1", "r");
  if (pipe == nullptr) return output;
  char buffer[4096];
  for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    output.text.append(buffer, count);
  const int status = ::pclose(pipe);
  output.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return output;
}

void compare(const Message& message, const json& wanted, const std::string& path);

/// Compares a value with what the script was given.
struct Comparison {
  const json& wanted;
  const std::string& path;

  void operator()(const Message& value) const {
    if (!isTime(*value.GetDescriptor())) return compare(value, wanted, path);
    EXPECT_EQ(wholeSeconds(value), wanted.at("seconds").get<std::int64_t>()) << path;
    EXPECT_EQ(nanoseconds(value), wanted.at("nanos").get<std::int32_t>()) << path;
  }
  void operator()(const std::string& value) const {
    if (wanted.is_string()) {
      EXPECT_EQ(value, wanted.get<std::string>()) << path;
    } else {
      const auto bytes = test::bytesOf(wanted.at("bytes").get<std::string>());
      EXPECT_EQ(value, std::string(bytes.begin(), bytes.end())) << path;
    }
  }
  void operator()(EnumNumber value) const { EXPECT_EQ(value.number, wanted.get<int>()) << path; }
  void operator()(bool value) const { EXPECT_EQ(value, wanted.get<bool>()) << path; }
  template <typename Number>
  void operator()(Number value) const {
    if (wanted.is_object())
      EXPECT_EQ(std::to_string(value), wanted.at("integer").get<std::string>()) << path;
    else
      EXPECT_EQ(value, wanted.get<Number>()) << path;
  }
};

void compare(const Message& message, const json& wanted, const std::string& path) {
  for (int i = 0; i < message.GetDescriptor()->field_count(); ++i) {
    const FieldDescriptor& field = *message.GetDescriptor()->field(i);
    const std::string where = path + "." + field.name();
    ASSERT_TRUE(wanted.contains(field.name())) << where;
    const json& value = wanted.at(field.name());
    if (!field.is_repeated()) {
      visitValue(message, field, -1, Comparison{value, where});
      continue;
    }
    const int size = message.GetReflection()->FieldSize(message, &field);
    ASSERT_EQ(static_cast<std::size_t>(size), value.size()) << where;
    for (int e = 0; e < size; ++e)
      visitValue(message, field, e, Comparison{value.at(static_cast<std::size_t>(e)), where});
  }
}

TEST(RosInterop, messagesOfNpmAreReadAsTheyWereWritten) {
  const Output output = runScript();
  if (output.status != 0)
    GTEST_SKIP()
        << "it takes node with the packages @foxglove/rosmsg, @foxglove/ros2idl-parser, "
           "@foxglove/rosmsg-serialization and @foxglove/rosmsg2-serialization: npm install them anywhere, "
           "and set ROBOTCONTROL_NODE_MODULES to the folder node_modules there ("
        << output.text << ")";
  std::istringstream lines(output.text);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count) {
    const json known = json::parse(line);
    const std::string name = known.at("type").get<std::string>();
    const auto type =
        RosType::of(name, known.at("schemaEncoding").get<std::string>(),
                    known.at("definition").get<std::string>(), known.at("encoding").get<std::string>());
    ASSERT_TRUE(type) << type.error().describe();
    const auto message = RosType::read(*type, test::bytesOf(known.at("bytes").get<std::string>()));
    ASSERT_TRUE(message) << name << ": " << message.error().text;
    compare(**message, known.at("value"), name);
  }
  EXPECT_EQ(count, 13);
}

}  // namespace
}  // namespace robotlink::ros
