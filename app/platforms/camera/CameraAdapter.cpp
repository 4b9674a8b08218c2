// SPDX-License-Identifier: GPL-3.0-or-later
// The adapter of cameras of this computer: the addresses that it opens, and the form for users.
#include <fmt/format.h>

#include "app/core/platform/PlatformAdapter.h"
#include "app/core/program/ShippedFiles.h"
#include "app/platforms/camera/CameraAddress.h"
#include "app/platforms/camera/CameraDevice.h"
#include "app/platforms/camera/CameraOptions.h"
#include "app/platforms/real/RealFeed.h"
#include "app/platforms/real/RealHeadless.h"

namespace app {
namespace {

using Kind = PlatformField::Kind;
using robotlink::Result;

constexpr char kUsualSize[] = "640x480";

Result<PlatformOpening> openCamera(const PlatformChoices& choices) {
  std::string url = choices.sources.front();
  if (const auto address = parseCameraAddress(url); !address) return tl::unexpected(address.error());
  RealRobotOptions options = cameraOptions(std::move(url));
  if (const std::string layout = textOf(choices.values, "layout"); !layout.empty())
    options.program.layout = layoutNamed(layout);
  options.program.hosting.ownProcesses = flagOf(choices.values, ownProcessField().name);
  return RealFeed::opening(std::move(options));
}

PlatformField::Items cameraItems() {
  PlatformField::Items items;
  for (const auto& [device, title] : camerasHere()) items.push_back({title + ", " + device, device, device});
  return items;
}

PlatformField::Items sizeItems() {
  PlatformField::Items items;
  for (const char* size : {"160x120", "320x240", kUsualSize, "800x600", "1280x720", "1920x1080"})
    items.push_back({size, size});
  return items;
}

PlatformField::Items formatItems() {
  return {{.title = "the camera's best", .value = ""},
          {.title = "YUYV (uncompressed)",
           .value = "YUYV",
           .help = "Lossless, but few images per second at large sizes"},
          {.title = "Motion JPEG",
           .value = "MJPG",
           .help = "More images per second at large sizes, but lossy (JPEG)"}};
}

/// Sets the address from its parts.
void writeCameraAddress(FormValues& values) {
  const auto before = parseCameraAddress(textOf(values, "address"));
  CameraAddress address{.device = textOf(values, "device")};
  if (before) address.controls = before->controls;
  if (const auto sized = parseCameraAddress(address.device + "?size=" + textOf(values, "size"))) {
    address.width = sized->width;
    address.height = sized->height;
  }
  address.rate = numberOf(values, "rate");
  address.format = textOf(values, "format");
  values["address"] = toString(address);
}

/// Sets the parts from the address.
void readCameraAddress(FormValues& values, const CameraAddress& address) {
  values["device"] = address.device;
  values["size"] = address.width > 0 ? fmt::format("{}x{}", address.width, address.height) : kUsualSize;
  values["rate"] = address.rate;
  values["format"] = address.format;
}

void followCameraAddress(FormState& state, const std::string& changed) {
  for (const char* part : {"device", "size", "rate", "format"}) {
    if (changed == part) writeCameraAddress(state.values);
  }
  const auto address = parseCameraAddress(textOf(state.values, "address"));
  if (address && (changed.empty() || changed == "address")) readCameraAddress(state.values, *address);
  if (!address) state.notes["address"] = {address.error().text, true};
  state.complete = address.has_value();
}

/// The images that the camera is to send.
std::vector<PlatformField> imageFields() {
  return {{.name = "size",
           .kind = Kind::kChoice,
           .label = "&Size:",
           .help = "Pixels; the camera uses the nearest size that it supports",
           .initial = std::string(kUsualSize),
           .unit = "pixels",
           .items = sizeItems,
           .editable = true,
           .isArgument = false},
          {.name = "rate",
           .kind = Kind::kNumber,
           .label = "at",
           .help = "Images per second",
           .initial = 0.0,
           .noun = "rate",
           .max = 1000,
           .unit = "images/s",
           .emptyText = "as the camera takes them",
           .sameRow = true,
           .isArgument = false},
          {.name = "format",
           .kind = Kind::kChoice,
           .label = "&Format:",
           .help = "How the camera sends its images",
           .items = formatItems,
           .isArgument = false}};
}

PlatformForm cameraForm() {
  PlatformForm form{.name = "camera",
                    .command = "camera.open",
                    .commandHelp = "Opens a camera of this computer and runs perception on its images",
                    .menu = "robot",
                    .entry = "Open a Ca&mera…",
                    .action = "robot.camera",
                    .icon = "camera",
                    .entryHelp = "Opens a camera of this computer, to calibrate colors and to try perception",
                    .title = "Open a camera",
                    .accept = "&Open"};
  form.fields = {
      {.name = "address",
       .kind = Kind::kChoice,
       .label = "&Address:",
       .help =
           "camera:///dev/video0?size=640x480&rate=30&format=YUYV; other names are the camera's controls, "
           "such as brightness=128; the list has the recent ones",
       .initial = std::string("camera:///dev/video0"),
       .noun = "address",
       .editable = true,
       .isSource = true,
       .remembered = "recent_cameras",
       .recent = true},
      {.name = "device",
       .kind = Kind::kChoice,
       .label = "&Camera:",
       .help = "Cameras of this computer; the device of another one can be typed",
       .initial = std::string("/dev/video0"),
       .emptyText = "no camera found; plug one in, or type its device",
       .items = cameraItems,
       .editable = true,
       .listAgain = "Searches for cameras",
       .isArgument = false}};
  for (auto& field : imageFields()) form.fields.push_back(std::move(field));
  form.fields.push_back({.name = "layout",
                         .kind = Kind::kChoice,
                         .label = "&Layout:",
                         .help = "Process layout (which process runs which tasks): a file or the name of a "
                                 "shipped one; empty: perception",
                         .noun = "layout",
                         .items =
                             [] {
                               return PlatformField::Items{{.title = "of the camera", .value = ""},
                                                           {"perception", "perception"}};
                             },
                         .editable = true});
  form.fields.push_back(ownProcessField());
  form.follow = followCameraAddress;
  form.normalize = [](FormValues& values) {
    if (const auto address = parseCameraAddress(textOf(values, "address")))
      values["address"] = toString(*address);
  };
  return form;
}

HeadlessPlatform headlessCamera() {
  return headlessReal(
      {.help = "a camera: camera:///dev/video0[?size=640x480&rate=30&format=YUYV]",
       .usage = "a camera: camera:///dev/video0",
       .robot = cameraOptions({}).robot,
       .robotOf = [](const std::string& url, const FormValues&) { return cameraOptions(url); }});
}

const PlatformRegistration kCameraRegistration{
    {.name = kCameraAdapter,
     .sources = "a camera, camera:///dev/video0[?size=640x480&rate=30&format=YUYV]",
     .time = TimeKind::kReal,
     .opens = isCameraAddress,
     .order = 1,
     .open = openCamera,
     .perspective = [](const std::string&) { return "Colour"; },
     .form = cameraForm,
     .headless = headlessCamera}};

}  // namespace
}  // namespace app
