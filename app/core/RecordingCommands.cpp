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
using Type = CommandTable::Type;

/// Starts, stops or saves a recording; an empty path means a new file in the folder for recordings.
Result<void> act(OpenPlatform& open, ControlRecording::Action action, const std::string& path = {}) {
  ControlRecording control;
  control.set_action(action);
  control.set_path(path);
  return open.recording().control(control);
}

void addActions(CommandTable& commands, OpenPlatform& open) {
  commands.add({"recording.start",
                "Starts recording into a new file in the folder for recordings",
                {},
                [&open](const Values&) { return act(open, ControlRecording::START); }});
  commands.add(
      {"recording.start-file",
       "Starts recording into a file",
       {{"file", Type::kText, "a log file that does not exist yet"}},
       [&open](const Values& values) { return act(open, ControlRecording::START, text(values, 0)); }});
  commands.add({"recording.stop", "Ends the recording", {}, [&open](const Values&) {
                  return act(open, ControlRecording::STOP);
                }});
  commands.add({"recording.toggle",
                "Starts recording into a new file, or ends the recording",
                {},
                [&open](const Values&) {
                  const bool running = open.recording().status().recording();
                  return act(open, running ? ControlRecording::STOP : ControlRecording::START);
                }});
  commands.add({"recording.save-last",
                "Saves the last seconds, which are kept in memory, to a new file",
                {},
                [&open](const Values&) { return act(open, ControlRecording::SAVE_LAST); }});
  commands.add(
      {"recording.save-last-file",
       "Saves the last seconds, which are kept in memory, to a file",
       {{"file", Type::kText, "a log file that does not exist yet"}},
       [&open](const Values& values) { return act(open, ControlRecording::SAVE_LAST, text(values, 0)); }});
  commands.add({"recording.bookmark",
                "Marks the shown instant in the recording; without one, saves the last seconds with the mark",
                {{"text", Type::kText, "what happens there"}},
                [&open](const Values& values) {
                  return open.recording().bookmark(text(values, 0), open.session().timeline().shown());
                }});
}

Result<void> chooseImages(Recording& recording, const std::string& name) {
  const auto coding = imageCodingNamed(name);
  if (!coding)
    return failure("recording.images",
                   "images are recorded as-is, as jpeg or as png, not as \"" + name + "\"", {}, {name});
  ControlRecording control;
  control.set_image_coding(*coding);
  return recording.control(control);
}

Result<void> chooseCompression(Recording& recording, const std::string& name) {
  const auto compression = compressionNamed(name);
  if (!compression)
    return failure("recording.compression", "compression is none, lz4 or zstd, not \"" + name + "\"", {},
                   {name});
  ControlRecording control;
  control.set_compression(*compression);
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
  commands.add(
      {"recording.streams",
       "Chooses what is recorded; empty: all that a replay needs",
       {{"selection", Type::kText, "comma-separated paths; * matches any text, - excludes: red1/*,-*/log"}},
       [&recording](const Values& values) { return chooseStreams(recording, text(values, 0)); }});
  commands.add({"recording.images",
                "Chooses how images are recorded",
                {{"coding", Type::kText, "as-is, jpeg or png"}},
                [&recording](const Values& values) { return chooseImages(recording, text(values, 0)); }});
  commands.add(
      {"recording.compression",
       "Chooses how new files are compressed",
       {{"compression", Type::kText, "none, lz4 or zstd"}},
       [&recording](const Values& values) { return chooseCompression(recording, text(values, 0)); }});
  commands.add({"recording.keep",
                "Keeps the last seconds in memory, to save them when something happens; 0 keeps nothing",
                {{"seconds", Type::kNumber, "0 to 3600"}},
                [&recording](const Values& values) {
                  ControlRecording control;
                  control.set_keep_last(std::get<double>(values[0]));
                  return recording.control(control);
                }});
  commands.add({"recording.trigger",
                "Saves the last seconds when a message arrives on a stream; empty: never",
                {{"stream", Type::kText, "its path; * matches any text: red1/plots/ball-model/*"}},
                [&recording](const Values& values) {
                  ControlRecording control;
                  control.set_trigger(text(values, 0));
                  return recording.control(control);
                }});
  commands.add({"recording.folder",
                "Chooses the folder for new recordings",
                {{"folder", Type::kText, "its path"}},
                [&recording](const Values& values) { return recording.setFolder(text(values, 0)); }});
}

}  // namespace

void addRecordingCommands(CommandTable& commands, OpenPlatform& open) {
  addActions(commands, open);
  addChoices(commands, open.recording());
}

}  // namespace app
