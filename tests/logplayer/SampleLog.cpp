// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/logplayer/SampleLog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "foxglove/Scene.pb.h"
#include "logplayer/base/LogWriter.h"
#include "logplayer/mcap/read/Reader.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/packages/Conversions.h"

namespace logplayer {
namespace {

using robotlink::Instant;
using robotlink::StreamMessage;

std::shared_ptr<foxglove::RawImage> sampleImage(int number, Instant time) {
  robotlink::Image pixels(4, 2, robotlink::PixelFormat::kMono8);
  pixels.data[0] = static_cast<std::uint8_t>(number);
  auto message = std::make_shared<foxglove::RawImage>();
  assign(*message, pixels.view(), time, "red1/camera");
  return message;
}

std::shared_ptr<foxglove::Log> logText(int number, Instant time) {
  auto message = std::make_shared<foxglove::Log>();
  robotlink::assign(*message->mutable_timestamp(), time);
  message->set_level(foxglove::Log::WARNING);
  message->set_name("cognition/test");
  message->set_message("frame " + std::to_string(number) + ", \"quoted\"");
  return message;
}

std::shared_ptr<robotcontrol::FrameInfo> sampleFrameInfo(const std::string& process, int number,
                                                         Instant time) {
  auto message = std::make_shared<robotcontrol::FrameInfo>();
  robotlink::assign(*message->mutable_timestamp(), time);
  message->set_process(process);
  message->set_number(static_cast<std::uint64_t>(number));
  return message;
}

StreamMessage keyTable(const SampleLog& log, const std::string& key, Instant time) {
  auto table = std::make_shared<robotcontrol::KeyTable>();
  table->add_keys()->set_name(key);
  return {log.robot + "/tables/keys", time, table, "debug"};
}

StreamMessage scene(Instant time) {
  auto message = std::make_shared<foxglove::SceneUpdate>();
  message->add_entities()->set_id("ball");
  return {"scene", time, message};
}

std::vector<StreamMessage> cognitionFrame(const SampleLog& log, int i) {
  const Instant time = sampleTime(i) + log.start;
  auto ball = std::make_shared<robotcontrol::BallModel>();
  robotlink::assign(*ball->mutable_timestamp(), time);
  ball->mutable_position_in_robot()->set_x(i);
  const auto frame = static_cast<std::uint64_t>(i + 1);
  std::vector<StreamMessage> messages{
      {log.robot + "/camera/image", time, sampleImage(i, time), "cognition", frame},
      {log.robot + "/models/ball", time, ball, "cognition", frame}};
  if (i % 10 == 0) messages.push_back({log.robot + "/log", time, logText(i, time), "cognition", frame});
  if (!log.cutLastFrame || i + 1 < log.frames) {
    messages.push_back({log.robot + "/frames/cognition", time, sampleFrameInfo("cognition", i + 1, time),
                        "cognition", frame});
  }
  return messages;
}

std::vector<StreamMessage> platformFrame(const SampleLog& log, int i) {
  const Instant time = sampleTime(i) + log.start;
  auto joints = std::make_shared<foxglove::JointStates>();
  auto* joint = joints->add_joints();
  joint->set_name("head_pan");
  joint->set_position(0.5 * i);
  const auto frame = static_cast<std::uint64_t>(i + 1);
  return {
      {log.robot + "/joints/states", time, joints, "platform", frame},
      {log.robot + "/frames/platform", time, sampleFrameInfo("platform", i + 1, time), "platform", frame}};
}

}  // namespace

void SampleLog::write(const std::filesystem::path& file) const {
  auto writer = LogWriter::create(file, {});
  ASSERT_TRUE(writer) << writer.error().describe();
  const Instant begin{start};
  ASSERT_TRUE((*writer)->write({scene(begin), keyTable(*this, "before", begin)}));
  for (int i = 0; i < frames; ++i) {
    if (i == 50) {
      ASSERT_TRUE((*writer)->write({keyTable(*this, "after", sampleTime(i) + start)}));
    }
    ASSERT_TRUE((*writer)->write(platformFrame(*this, i)));
    ASSERT_TRUE((*writer)->write(cognitionFrame(*this, i)));
    if (i % 25 == 24) {
      ASSERT_TRUE((*writer)->container().flush());
    }
  }
  ASSERT_TRUE((*writer)->container().close());
  if (close) return;
  // Without its summary and the footer, as a killed writer leaves it.
  const auto reader = mcap::Reader::open(file, {});
  ASSERT_TRUE(reader);
  std::uint64_t bytes = 0;
  for (const auto& chunk : (*reader)->chunks()) bytes = std::max(bytes, chunk.offset + chunk.length);
  std::filesystem::resize_file(file, bytes);
}

}  // namespace logplayer
