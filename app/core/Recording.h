// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "logplayer/record/Recorder.h"
#include "robotlink/base/BoundedQueue.h"
#include "robotlink/session/Settings.h"

namespace app {

/// The workbench's recorder together with its settings: what is recorded, how, and into which folder. They
/// are saved in a file and restored at the next start. Only in the GUI's thread, except for the recorder
/// itself.
class Recording {
 public:
  /// The settings are in `userFolder`/recording.json. Problems with that file are reported by takeWarnings().
  explicit Recording(const std::filesystem::path& userFolder);

  logplayer::Recorder& recorder() { return recorder_; }
  /// A snapshot of settings and progress.
  robotcontrol::RecordingStatus status() const { return recorder_.status(); }

  /// Changes settings, then starts, stops or saves. The settings are saved unless this fails. New files
  /// without an explicit path go into folder().
  robotlink::Result<void> control(const robotcontrol::ControlRecording& control);
  /// The folder of new files: the user's documents, unless another one was chosen.
  std::filesystem::path folder() const;
  /// Chooses the folder of new files. Fails if there is no such folder, or if the choice cannot be saved.
  robotlink::Result<void> setFolder(const std::filesystem::path& folder);

  /// Marks an instant in the current recording. If there is none, saves the last seconds with the mark,
  /// provided that some are kept in memory. Fails if neither is possible.
  robotlink::Result<void> bookmark(const std::string& text, robotlink::Instant time);

  /// Removes and returns the warnings of the recorder, and problems with saving the settings.
  robotlink::Errors takeWarnings();

 private:
  /// Applies the saved settings to the recorder.
  void restore();
  /// Saves the settings of a request.
  void remember(const robotcontrol::ControlRecording& control);

  robotlink::Settings settings_;
  /// Warnings from the recorder's threads.
  robotlink::BoundedQueue<std::string> warnings_{100};
  /// Problems with the settings.
  robotlink::Errors problems_;
  /// The last member, since its threads use warnings_.
  logplayer::Recorder recorder_;
};

/// Returns the desktop's XDG_DOCUMENTS_DIR or else ~/Documents, if it exists, otherwise the home folder.
std::filesystem::path documentsFolder();

}  // namespace app
