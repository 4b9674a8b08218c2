// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/LogImages.h"

#include <algorithm>

#include "foxglove/Image.pb.h"
#include "logplayer/file/LogFile.h"

namespace widgets {

LogImages::LogImages(LoggedImages images, std::string stream)
    : stream_(std::move(stream)), worker_([this](const LoggedImages& wanted, const std::stop_token& stop) {
        worker_.publish(read(wanted, stop));
      }) {
  worker_.post(std::move(images));
}

std::vector<ColorFramePtr> LogImages::read(const LoggedImages& images, const std::stop_token& stop) const {
  logplayer::LogFile::Options options;
  options.progress = [&stop](double) { return !stop.stop_requested(); };
  const auto log = logplayer::LogFile::open(images.log, options);
  if (!log) return {};
  const std::vector<robotlink::Instant> times = (*log)->times(images.stream);
  const std::size_t count = std::min(kCount, times.size());
  std::vector<ColorFramePtr> frames;
  for (std::size_t i = 0; i < count && !stop.stop_requested(); ++i) {
    const auto message = (*log)->latest(images.stream, times[(2 * i + 1) * times.size() / (2 * count)]);
    auto image = message ? rawImageIn(*message) : nullptr;
    if (!image) continue;
    auto frame = std::make_shared<ColorFrame>(std::move(image), stream_, images.log.filename().string(),
                                              message->time + images.offset);
    if (!frame->view().empty()) frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace widgets
