// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "logplayer/Recorder.h"

namespace CLI {
class App;
}

namespace app {

/// The options of commands that record what they run: --record FILE and how.
struct RecordOptions {
  std::string file;  ///< empty: nothing is recorded
  std::string streams;
  std::string images = "as-is";
  std::string compression = "none";

  void addTo(CLI::App& command);
  /// A recorder that is recording; null if none was asked for. Fails with a sentence if it cannot be.
  robotlink::Result<std::unique_ptr<logplayer::Recorder>> start() const;
};

/// Ends the recording and says on stderr what became of it; an ExitStatus.
int finishRecording(logplayer::Recorder& recorder);

}  // namespace app
