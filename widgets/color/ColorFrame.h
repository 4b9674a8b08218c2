// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <mutex>

#include "colortool/image/ColorImage.h"
#include "colortool/samples/Samples.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Image.h"

namespace foxglove {
class RawImage;
}

namespace widgets {

/// A camera image, or a picture of a file, as the color views share it. Immutable; any thread may read it.
class ColorFrame {
 public:
  /// `stream`: path of its stream, whose first part, the robot's name, identifies the camera. `source`: the
  /// log that it is from; empty: none. `time`: on the session's timeline.
  ColorFrame(std::shared_ptr<const foxglove::RawImage> image, std::string stream, std::string source,
             robotlink::Instant time);

  /// A picture of a file. `camera`: name of the robot whose corrections apply; empty: unknown.
  static std::shared_ptr<const ColorFrame> ofFile(std::shared_ptr<const foxglove::RawImage> image,
                                                  const std::filesystem::path& file,
                                                  const std::string& camera);
  /// The absolute path of the picture's file; empty: it is not from a file.
  const std::filesystem::path& file() const { return file_; }
  /// The file that an image's name in samples refers to; empty if it is another kind of image or the file
  /// does not exist.
  static std::filesystem::path fileOfName(const std::string& name);

  /// The pixels; valid as long as this object.
  const robotlink::ImageView& view() const { return view_; }
  int width() const { return view_.width; }
  int height() const { return view_.height; }
  const std::string& stream() const { return stream_; }
  robotlink::Instant time() const { return time_; }
  const std::shared_ptr<const foxglove::RawImage>& message() const { return image_; }
  /// The image as samples refer to it, with id 0. Its name is made of source, stream and time and ends with a
  /// fingerprint of the pixels, which tells images of different runs at the same time apart.
  const colortool::SampleImage& place() const { return place_; }
  /// "red1/camera/image  12.340 s", or the name of the file.
  QString title() const;
  /// The name of the frame as short as possible: "12.340 s", or the name of the file.
  QString label() const;
  /// The colors of all pixels, computed on the first call (about 4 ns per pixel). Thread-safe.
  const colortool::ColorImage& colors() const;

 private:
  std::shared_ptr<const foxglove::RawImage> image_;
  robotlink::ImageView view_;
  std::string stream_;
  std::filesystem::path file_;
  robotlink::Instant time_;
  colortool::SampleImage place_;
  /// Guards the computation of colors_.
  mutable std::once_flag colorsMade_;
  mutable colortool::ColorImage colors_;
};
using ColorFramePtr = std::shared_ptr<const ColorFrame>;

}  // namespace widgets
