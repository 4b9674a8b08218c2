// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/CutStreams.h"

#include <utility>

namespace widgets {
namespace {

logplayer::StreamFilter filterOf(const StreamPicker::Selection& selection) {
  return {{selection.include().begin(), selection.include().end()},
          {selection.exclude().begin(), selection.exclude().end()}};
}

}  // namespace

CutStreams::CutStreams(std::vector<std::string> paths, QWidget* parent)
    : StreamPicker(
          texts(), {}, std::move(paths),
          [](const Selection& selection, const std::string& path) { return filterOf(selection).has(path); },
          parent) {}

logplayer::StreamFilter CutStreams::filter() const {
  return filterOf(selection());
}

CutStreams::Texts CutStreams::texts() {
  return {.dialog = "cutStreamsDialog",
          .patterns = "cutPatterns",
          .problem = "cutProblem",
          .list = "cutStreamList",
          .title = tr("Streams of the new log"),
          .help = tr("Comma-separated stream paths; * matches any text, - excludes. Empty: all streams."),
          .patternsName = tr("Patterns"),
          .placeholder = tr("all streams"),
          .example = tr("For example red1/*,-*/camera/image"),
          .listName = tr("Streams"),
          .listTip = tr("Checked streams are written into the new log"),
          .nothing = tr("No stream is left.")};
}

}  // namespace widgets
