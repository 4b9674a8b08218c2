// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "logplayer/record/Recorder.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/session/Settings.h"

namespace app {

/// The recorder of a workbench, with what a person chose for it: what is recorded, how, and where, kept from
/// one start to the next. The GUI's thread, but for the recorder itself.
class Recording {
 public:
  /// What was chosen is kept in `userFolder`/recording.json.
  explicit Recording(const std::filesystem::path& userFolder);

  logplayer::Recorder& recorder() { return recorder_; }
  robotcontrol::RecordingStatus status() const { return recorder_.status(); }

  /// What is set, and could be, is remembered. Without a path new files go into folder().
  robotlink::Result<void> control(const robotcontrol::ControlRecording& control);
  /// Where new files go: the user's documents, until another folder is chosen.
  std::filesystem::path folder() const;
  robotlink::Result<void> setFolder(const std::filesystem::path& folder);

  /// Marks an instant in the recording that runs; if none does, saves the last seconds with the mark, if some
  /// are kept. Fails if neither is so.
  robotlink::Result<void> bookmark(const std::string& text, robotlink::Instant time);

  /// What the recorder had to say since the last call, and what could not be remembered.
  robotlink::Errors takeWarnings();

 private:
  void restore();
  void remember(const robotcontrol::ControlRecording& control);

  robotlink::Settings settings_;
  robotlink::BoundedQueue<std::string> warnings_{100};
  robotlink::Errors problems_;
  logplayer::Recorder recorder_;  // last: it warns
};

/// $XDG_DOCUMENTS_DIR as the desktop has it, else ~/Documents if there is one, else the home.
std::filesystem::path documentsFolder();

}  // namespace app
