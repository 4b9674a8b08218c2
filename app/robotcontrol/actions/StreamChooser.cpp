// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/StreamChooser.h"

#include <utility>

#include "logplayer/base/RecordedStreams.h"

namespace app {

StreamChooser::StreamChooser(const robotcontrol::StreamSelection& selection, std::vector<std::string> streams,
                             QWidget* parent)
    : StreamPicker(
          texts(), selection, std::move(streams),
          [](const Selection& recorded, const std::string& path) {
            return logplayer::RecordedStreams(recorded).contains(path);
          },
          parent) {}

StreamChooser::Texts StreamChooser::texts() {
  return {.dialog = "streamChooser",
          .patterns = "streamPatterns",
          .problem = "streamProblem",
          .list = "streamList",
          .title = tr("What is recorded"),
          .help = tr("Comma-separated stream paths; * matches any text, - excludes. Empty: all that "
                     "a replay needs. The program's setup is always recorded."),
          .patternsName = tr("Patterns"),
          .placeholder = tr("all that a replay needs"),
          .example = tr("For example red1/*,-*/transforms"),
          .listName = tr("Streams"),
          .listTip = tr("Current streams; check those to record")};
}

}  // namespace app
