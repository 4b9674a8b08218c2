// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorFrame.h"

#include <cstring>

#include "foxglove/Image.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "widgets/TypedStreams.h"

namespace widgets {
namespace {

/// FNV-1a over words of eight bytes; only tells images apart.
std::uint32_t fingerprint(const robotlink::ImageView& image) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto rowBytes = static_cast<std::size_t>(image.width * robotlink::bytesPerPixel(image.format));
  for (int y = 0; y < robotlink::rowsOf(image.format, image.height); ++y) {
    const std::uint8_t* row = image.row(y);
    for (std::size_t i = 0; i + 8 <= rowBytes; i += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, row + i, 8);
      hash = (hash ^ word) * 0x100000001b3U;
    }
  }
  return static_cast<std::uint32_t>(hash ^ (hash >> 32U));
}

}  // namespace

ColorFrame::ColorFrame(std::shared_ptr<const foxglove::RawImage> image, std::string stream,
                       std::string source, robotlink::Instant time)
    : image_(std::move(image)),
      view_(robotlink::imageView(*image_)),
      stream_(std::move(stream)),
      time_(time) {
  place_.name = QStringLiteral("%1%2 %3 s [%4]")
                    .arg(QString::fromStdString(source.empty() ? source : source + " "),
                         QString::fromStdString(stream_))
                    .arg(robotlink::seconds(time_), 0, 'f', 3)
                    .arg(fingerprint(view_), 8, 16, QLatin1Char('0'))
                    .toStdString();
  place_.camera = robotlink::streams::robotOf(stream_);
  place_.width = view_.width;
  place_.height = view_.height;
}

std::shared_ptr<const ColorFrame> ColorFrame::ofFile(std::shared_ptr<const foxglove::RawImage> image,
                                                     const std::filesystem::path& file,
                                                     const std::string& camera) {
  auto frame = std::make_shared<ColorFrame>(std::move(image), camera + "/file", "", robotlink::Instant{});
  std::error_code error;
  frame->file_ = std::filesystem::absolute(file, error);
  frame->place_.camera = camera;
  frame->place_.name = QStringLiteral("%1 [%2]")
                           .arg(QString::fromStdString(frame->file_.string()))
                           .arg(fingerprint(frame->view_), 8, 16, QLatin1Char('0'))
                           .toStdString();
  return frame;
}

std::filesystem::path ColorFrame::fileOfName(const std::string& name) {
  constexpr std::size_t kFingerprint = 11;  // " [0a1b2c3d]"
  if (name.size() <= kFingerprint || name.front() != '/' || name[name.size() - kFingerprint] != ' ')
    return {};
  const std::filesystem::path file = name.substr(0, name.size() - kFingerprint);
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) ? file : std::filesystem::path();
}

QString ColorFrame::label() const {
  if (!file_.empty()) return QString::fromStdString(file_.filename().string());
  return QStringLiteral("%1 s").arg(robotlink::seconds(time_), 0, 'f', 3);
}

QString ColorFrame::title() const {
  if (!file_.empty()) return label();
  return QStringLiteral("%1  %2 s")
      .arg(QString::fromStdString(stream_))
      .arg(robotlink::seconds(time_), 0, 'f', 3);
}

const colortool::ColorImage& ColorFrame::colors() const {
  std::call_once(colorsMade_, [this] { colors_ = colortool::ColorImage::of(view_); });
  return colors_;
}

}  // namespace widgets
