// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <mutex>

#include "colortool/ColorImage.h"
#include "colortool/Samples.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Image.h"

namespace foxglove {
class RawImage;
}

namespace widgets {

/// A camera image as the colour views share it: immutable, so any thread may look at it.
class ColorFrame {
 public:
  /// `stream`: its path; the robot's name, in front, is the camera. `source`: the log it is from, "" if none.
  ColorFrame(std::shared_ptr<const foxglove::RawImage> image, std::string stream, std::string source,
             robotlink::Instant time);

  /// A picture of a file. `camera`: a robot's name, "" if it is not known.
  static std::shared_ptr<const ColorFrame> ofFile(std::shared_ptr<const foxglove::RawImage> image,
                                                  const std::filesystem::path& file,
                                                  const std::string& camera);
  /// The file that a picture is from; empty: it is no picture of a file.
  const std::filesystem::path& file() const { return file_; }
  /// The file that samples name a picture by; empty if the name is that of another kind of image.
  static std::filesystem::path fileOfName(const std::string& name);

  const robotlink::ImageView& view() const { return view_; }
  int width() const { return view_.width; }
  int height() const { return view_.height; }
  const std::string& stream() const { return stream_; }
  robotlink::Instant time() const { return time_; }
  const std::shared_ptr<const foxglove::RawImage>& message() const { return image_; }
  /// The image as samples name it: stream, time and, so that another run's image at the same time is another
  /// one, a number that stands for its bytes. Its id is 0.
  const colortool::SampleImage& place() const { return place_; }
  /// "red1/camera/image  12.340 s", or the name of the file.
  QString title() const;
  /// The same as short as can be: "12.340 s", or the name of the file.
  QString label() const;
  /// All colours; made when first asked for (some 4 ns a pixel).
  const colortool::ColorImage& colors() const;

 private:
  std::shared_ptr<const foxglove::RawImage> image_;
  robotlink::ImageView view_;
  std::string stream_;
  std::filesystem::path file_;
  robotlink::Instant time_;
  colortool::SampleImage place_;
  mutable std::once_flag colorsMade_;
  mutable colortool::ColorImage colors_;
};
using ColorFramePtr = std::shared_ptr<const ColorFrame>;

}  // namespace widgets
