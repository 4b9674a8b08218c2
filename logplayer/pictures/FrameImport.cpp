// SPDX-License-Identifier: GPL-3.0-or-later
// Makes streams of a camera's frames.
#include "logplayer/pictures/FrameImport.h"

#include <cmath>

#include "logplayer/base/Plural.h"
#include "logplayer/file/LogFormat.h"
#include "logplayer/pictures/PictureFrames.h"
#include "logplayer/pictures/VideoFrames.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Resources.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"

namespace logplayer {

using robotlink::Instant;
using robotlink::Result;
using robotlink::StreamMessage;

namespace {

/// The process whose frames the images are, for those who step through the log.
constexpr char kProcess[] = "camera";
/// After this many consecutive unreadable frames, the rest is skipped.
constexpr int kMaxUnreadable = 100;

std::shared_ptr<robotcontrol::CameraPose> poseOf(const robotlink::RobotDescription::Camera& camera,
                                                 const FrameSource::Frame& frame, Instant time) {
  auto pose = std::make_shared<robotcontrol::CameraPose>();
  robotlink::assign(*pose->mutable_timestamp(), time);
  robotlink::assign(*pose->mutable_camera_in_robot(), camera.inRobot);
  pose->set_horizontal_angle(camera.horizontalAngle);
  pose->set_vertical_angle(2 * std::atan(std::tan(camera.horizontalAngle / 2) * frame.height / frame.width));
  pose->set_width(static_cast<std::uint32_t>(frame.width));
  pose->set_height(static_cast<std::uint32_t>(frame.height));
  return pose;
}

std::shared_ptr<robotcontrol::FrameInfo> infoOf(std::uint64_t number, Instant time) {
  auto info = std::make_shared<robotcontrol::FrameInfo>();
  robotlink::assign(*info->mutable_timestamp(), time);
  info->set_process(kProcess);
  info->set_number(number);
  return info;
}

}  // namespace

Result<ImportReport> importFrames(FrameSource& source, const robotlink::RobotDescription::Camera& camera,
                                  const ImportSink& sink, const std::string& robot,
                                  const std::function<bool(double)>& progress) {
  ImportReport report;
  report.format = source.format();
  std::uint64_t unreadable = 0;
  int inARow = 0;
  std::optional<robotlink::Error> firstError;
  while (inARow < kMaxUnreadable) {
    auto frame = source.next();
    if (!frame) {
      if (!firstError) firstError = frame.error();
      ++unreadable, ++inARow;
      continue;
    }
    inARow = 0;
    if (!*frame) break;
    ++report.messages;
    const Instant time((*frame)->time);
    std::vector<StreamMessage> messages{
        {robotlink::kCameraImage.name, time, (*frame)->image},
        {robotlink::kCameraPose.name, time, poseOf(camera, **frame, time)},
        {std::string(robotlink::streams::kFrames) + kProcess, time, infoOf(report.messages, time)}};
    for (StreamMessage& message : messages) {
      message.path = robot + "/" + message.path;
      message.process = kProcess;
      message.frame = report.messages;
    }
    if (auto written = sink(messages); !written) return tl::unexpected(std::move(written.error()));
    if (progress && !progress(source.share()))
      return robotlink::failure("log.given-up", "the import was canceled");
  }
  if (report.messages == 0) {
    if (firstError) return tl::unexpected(std::move(*firstError));
    return robotlink::failure("import.empty", "it contains no images");
  }
  report.imported["image"] = report.messages;
  if (firstError) {
    report.notUnderstood["image"] = unreadable;
    report.damage = plural(unreadable, "image") + " cannot be read; " + firstError->describe();
  }
  return report;
}

namespace {

LogFormat::Robot camera() {
  return {"camera", "robots/camera.yaml"};
}

/// Imports frames; the pose of the camera is taken from its description.
Result<ImportReport> importFrom(FrameSource& source, const ImportSink& sink, const ImportOptions& options) {
  const auto file = robotlink::resource(camera().description);
  const auto description = robotlink::readRobotDescription(file);
  if (!description) return tl::unexpected(description.error().front());
  if (!description->camera)
    return robotlink::failure("import.camera", "there is no camera in this description",
                              {file.string(), 0, 0});
  return importFrames(source, *description->camera, sink, options.robot, options.progress);
}

Result<ImportReport> importVideo(const std::filesystem::path& from, const ImportSink& sink,
                                 const ImportOptions& options) {
  auto video = VideoFrames::open(from);
  if (!video) return tl::unexpected(video.error());
  return importFrom(*video, sink, options);
}

Result<ImportReport> importPictures(const std::filesystem::path& from, const ImportSink& sink,
                                    const ImportOptions& options) {
  auto pictures = PictureFrames::open(from);
  if (!pictures) return tl::unexpected(pictures.error());
  return importFrom(*pictures, sink, options);
}

const LogFormatRegistration kVideoFormat{{"video", camera, isVideo, importVideo}};
const LogFormatRegistration kPicturesFormat{{"folder of pictures", camera, isPictureFolder, importPictures}};

}  // namespace

}  // namespace logplayer
