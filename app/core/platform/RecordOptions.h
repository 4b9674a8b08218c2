// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>

#include "app/core/platform/ExitStatus.h"
#include "logplayer/record/Recorder.h"

namespace CLI {
class App;
}

namespace app {

/// The options of commands that can record what they run: --record FILE and its format. Filled by the command
/// line parser.
struct RecordOptions {
  /// Empty: nothing is recorded.
  std::string file;
  /// A selection as in logplayer::readSelection(); empty: the default.
  std::string streams;
  /// Encoding of images: "as-is", "jpeg" or "png".
  std::string images = "as-is";
  /// Compression of the file: "none", "lz4" or "zstd".
  std::string compression = "none";

  void addTo(CLI::App& command);
  /// Starts the recording and returns the recorder; null if no file was given.
  robotlink::Result<std::unique_ptr<logplayer::Recorder>> start() const;
};

/// The coding of images, and the compression of a log file, by the name that users write; unset: there is
/// none of that name.
std::optional<robotcontrol::ControlRecording::ImageCoding> imageCodingNamed(const std::string& name);
std::optional<robotcontrol::ControlRecording::Compression> compressionNamed(const std::string& name);

/// Ends the recording and prints the result.
ExitStatus finishRecording(logplayer::Recorder& recorder, std::ostream& out);

}  // namespace app
