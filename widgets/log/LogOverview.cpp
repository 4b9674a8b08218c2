// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/log/LogOverview.h"

#include <QCoreApplication>
#include <algorithm>

namespace widgets {

double LogOverview::Stream::rate() const {
  const double span = robotlink::seconds(last - first);
  return count > 1 && span > 0 ? static_cast<double>(count - 1) / span : 0;
}

const LogOverview::Stream* LogOverview::find(const std::string& path) const {
  const auto found =
      std::find_if(streams.begin(), streams.end(), [&](const Stream& s) { return s.path == path; });
  return found == streams.end() ? nullptr : &*found;
}

std::vector<std::string> LogOverview::imageStreams() const {
  std::vector<std::string> paths;
  for (const Stream& stream : streams) {
    const bool image = stream.type == "foxglove.RawImage" || stream.type == "foxglove.CompressedImage";
    if (image && stream.count > 0) paths.push_back(stream.path);
  }
  std::stable_partition(paths.begin(), paths.end(),
                        [](const std::string& path) { return path.ends_with("/camera/image"); });
  return paths;
}

QString LogOverview::stageText() const {
  const auto text = [this](const char* what) {
    return QCoreApplication::translate("LogOverview", "%1: %2 %")
        .arg(QCoreApplication::translate("LogOverview", what))
        .arg(static_cast<int>(progress * 100));
  };
  switch (stage) {
    case Stage::kOpening:
      return failure.isEmpty() ? text(QT_TRANSLATE_NOOP("LogOverview", "opening")) : QString();
    case Stage::kTimes:
      return text(QT_TRANSLATE_NOOP("LogOverview", "reading times"));
    case Stage::kTexts:
      return text(QT_TRANSLATE_NOOP("LogOverview", "reading messages"));
    case Stage::kSizes:
      return text(QT_TRANSLATE_NOOP("LogOverview", "counting sizes"));
    case Stage::kDone:
      break;
  }
  return {};
}

}  // namespace widgets
