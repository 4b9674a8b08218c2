// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/PictureReading.h"

#include <utility>

#include "foxglove/Image.pb.h"
#include "logplayer/images/PictureFile.h"
#include "robotlink/packages/Conversions.h"

namespace widgets {

using robotlink::Result;

PictureReading::PictureReading(std::vector<std::filesystem::path> filesOrFolders, std::string camera,
                               std::size_t mostBytes)
    : camera_(std::move(camera)),
      mostBytes_(mostBytes),
      worker_(
          [this](const auto& given, const std::stop_token& stop) { worker_.publish(readAll(given, stop)); }) {
  worker_.post(std::move(filesOrFolders));
}

Result<PictureReading::Read> PictureReading::readAll(const std::vector<std::filesystem::path>& filesOrFolders,
                                                     const std::stop_token& stop) {
  const auto files = logplayer::pictureFiles(filesOrFolders);
  if (!files) return tl::unexpected(files.error());
  Read read;
  std::size_t bytes = 0;
  for (const auto& file : *files) {
    if (stop.stop_requested()) break;
    if (bytes > mostBytes_) {
      ++read.leftOut;
      continue;
    }
    const auto image = logplayer::readPicture(file);
    if (!image) {
      read.problems.push_back(image.error());
      continue;
    }
    bytes += image->data.size();
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, image->view(), {}, "camera");
    read.frames.push_back(ColorFrame::ofFile(message, file, camera_));
  }
  if (!read.frames.empty() || read.problems.empty()) return read;
  return tl::unexpected(read.problems.front());
}

}  // namespace widgets
