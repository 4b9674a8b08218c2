// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/RecordingCommands.h"

#include "app/core/CommandValues.h"
#include "app/core/OpenPlatform.h"
#include "app/core/Recording.h"
#include "app/core/platform/RecordOptions.h"
#include "logplayer/base/RecordedStreams.h"

namespace app {
namespace {

using robotcontrol::ControlRecording;
using robotlink::CommandTable;
using robotlink::failure;
using robotlink::Result;

/// Starts, stops or saves a recording; an empty path means a new file in the folder for recordings.
Result<void> act(OpenPlatform& open, ControlRecording::Action action, const std::string& path = {}) {
  ControlRecording control;
  control.set_action(action);
  control.set_path(path);
  return open.recording().control(control);
}

void addActions(CommandTable& commands, OpenPlatform& open) {
  commands.attach("recording.start", [&open](const Values&) { return act(open, ControlRecording::START); });
  commands.attach("recording.start-file", [&open](const Values& values) {
    return act(open, ControlRecording::START, text(values, 0));
  });
  commands.attach("recording.stop", [&open](const Values&) { return act(open, ControlRecording::STOP); });
  commands.attach("recording.toggle", [&open](const Values&) {
    const bool running = open.recording().status().recording();
    return act(open, running ? ControlRecording::STOP : ControlRecording::START);
  });
  commands.attach("recording.save-last",
                  [&open](const Values&) { return act(open, ControlRecording::SAVE_LAST); });
  commands.attach("recording.save-last-file", [&open](const Values& values) {
    return act(open, ControlRecording::SAVE_LAST, text(values, 0));
  });
  commands.attach("recording.bookmark", [&open](const Values& values) {
    return open.recording().bookmark(text(values, 0), open.session().timeline().shown());
  });
}

Result<void> chooseImages(Recording& recording, const std::string& name) {
  ControlRecording control;
  control.set_image_coding(imageCodingNamed(name).value());
  return recording.control(control);
}

Result<void> chooseCompression(Recording& recording, const std::string& name) {
  ControlRecording control;
  control.set_compression(compressionNamed(name).value());
  return recording.control(control);
}

Result<void> chooseStreams(Recording& recording, const std::string& selection) {
  auto read = logplayer::readSelection(selection);
  if (!read) return tl::unexpected(read.error());
  ControlRecording control;
  *control.mutable_selection() = std::move(*read);
  return recording.control(control);
}

void addChoices(CommandTable& commands, Recording& recording) {
  commands.attach("recording.streams",
                  [&recording](const Values& values) { return chooseStreams(recording, text(values, 0)); });
  commands.attach("recording.images",
                  [&recording](const Values& values) { return chooseImages(recording, text(values, 0)); });
  commands.attach("recording.compression", [&recording](const Values& values) {
    return chooseCompression(recording, text(values, 0));
  });
  commands.attach("recording.keep", [&recording](const Values& values) {
    ControlRecording control;
    control.set_keep_last(std::get<double>(values[0]));
    return recording.control(control);
  });
  commands.attach("recording.trigger", [&recording](const Values& values) {
    ControlRecording control;
    control.set_trigger(text(values, 0));
    return recording.control(control);
  });
  commands.attach("recording.folder",
                  [&recording](const Values& values) { return recording.setFolder(text(values, 0)); });
}

}  // namespace

void addRecordingCommands(CommandTable& commands, OpenPlatform& open) {
  addActions(commands, open);
  addChoices(commands, open.recording());
}

}  // namespace app
