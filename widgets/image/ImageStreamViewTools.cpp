// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ImageStreamView that shows images in other ways, compares two images and measures in them.
#include <QAction>
#include <QColor>
#include <algorithm>
#include <cmath>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotcontrol/World.pb.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/image/CompareRow.h"
#include "widgets/image/FloorPoint.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageClasses.h"
#include "widgets/image/ImageComparison.h"
#include "widgets/image/ImageStreamView.h"
#include "widgets/image/RawPicture.h"
#include "widgets/image/Stereogram.h"
#include "widgets/image/StreamSelector.h"
#include "widgets/picture/MeasureTool.h"

namespace widgets {
namespace {

/// Smaller differences of colors are those of JPEG and rounding.
constexpr int kDifferenceTolerance = 4;

QString lettersOf(std::size_t index) {
  return QString(QLatin1Char(static_cast<char>('A' + index)));
}

/// Whether an image has distances.
bool isDepth(const foxglove::RawImage& image) {
  return image.encoding() == "32FC1" || image.encoding() == "16UC1";
}

QString degreesText(double degrees) {
  return QStringLiteral("%1°").arg(degrees, 0, 'f', 1);
}

}  // namespace

std::vector<CurrentDrawing> ImageStreamView::drawingsOf(const std::string& robot, robotlink::Instant at,
                                                        robotlink::Instant imageTime) const {
  auto drawings = currentDrawings(session(), robot, this->drawings()->shown(), at);
  for (CurrentDrawing& drawing : drawings) drawing.old = drawing.old || drawing.time < imageTime;
  return drawings;
}

ImagePicture ImageStreamView::pictureOf(const foxglove::RawImage* image, const std::string& path,
                                        robotlink::Instant time, const std::vector<CurrentDrawing>& drawings,
                                        std::vector<robotlink::PackagePtr>& keep) const {
  ImagePicture picture;
  if (image == nullptr) return picture;
  picture.pixels = rawPicture(
      *image, classColors(classNames(session().store(), path, *image, time), context().field.get()));
  if (gray_->isChecked()) picture.pixels = inGray(picture.pixels);
  if (stereogram_->isChecked() && isDepth(*image)) picture.pixels = stereogram(picture.pixels);
  for (const CurrentDrawing& drawing : drawings) {
    const auto* annotations = dynamic_cast<const foxglove::ImageAnnotations*>(drawing.message.get());
    if (annotations == nullptr) continue;
    picture.drawings.push_back({annotations, drawing.old, drawing.id, drawing.robot});
    keep.push_back(drawing.message);
  }
  return picture;
}

std::vector<std::string> ImageStreamView::streamChoices() const {
  std::vector<std::string> choices;
  const std::string folder = session().selectedRobot() + "/";
  const auto* objects = session().store().latestAs<robotcontrol::WorldObjects>(robotlink::streams::kObjects,
                                                                               session().timeline().newest());
  if (objects != nullptr) {
    // Images that are sent once they are requested.
    for (const auto& object : objects->objects())
      if (!object.port().image_stream().empty()) choices.push_back(object.port().image_stream());
  }
  for (const auto* stream : session().store().streams()) {
    if (stream->type != "foxglove.RawImage") continue;
    choices.push_back(stream->path);
    if (folder.size() > 1 && stream->path.starts_with(folder))
      choices.push_back("*/" + stream->path.substr(folder.size()));
  }
  return choices;
}

void ImageStreamView::createModes() {
  gray_ = makeToggle(this, "color-pixels",
                     {"imageGray", tr("Monochrome"), tr("Shows the brightness of the pixels"), Qt::Key_G});
  stereogram_ =
      makeToggle(this, "eye",
                 {"imageStereogram", tr("Stereogram"),
                  tr("Shows distances as a random-dot stereogram: focus behind the picture to see the depth"),
                  Qt::Key_S});
  for (QAction* mode : {gray_, stereogram_})
    connect(mode, &QAction::toggled, this, &ImageStreamView::showAgain);
}

void ImageStreamView::setMode(const std::string& mode) {
  gray_->setChecked(mode == "gray");
  stereogram_->setChecked(mode == "stereogram");
}

void ImageStreamView::showAgain() {
  shownDrawings_.clear();
  secondPixels_ = {};
  image_.reset();
  tick();
}

robotlink::Result<void> ImageStreamView::requireStream(const std::string& stream) const {
  const auto known = streamChoices();
  if (std::ranges::find(known, stream) != known.end()) return {};
  return robotlink::failure("image.stream",
                            "there are no images of " + stream + robotlink::suggestion(stream, known), {},
                            {stream});
}

robotlink::Result<void> ImageStreamView::showStream(const std::string& stream) {
  if (auto known = requireStream(stream); !known) return known;
  streams_->setChoice(QString::fromStdString(stream));
  return {};
}

robotlink::Result<void> ImageStreamView::compareWith(const std::string& stream, const std::string& mode) {
  using Mode = CompareRow::Mode;
  if (auto known = requireStream(stream); !known) return known;
  second_->choose(QString::fromStdString(stream), mode == "blend"        ? Mode::kBlend
                                                  : mode == "difference" ? Mode::kDifference
                                                                         : Mode::kSideBySide);
  compare_->setChecked(true);
  return {};
}

void ImageStreamView::endComparison() {
  compare_->setChecked(false);
}

void ImageStreamView::compare(bool on) {
  if (on) second_->propose(streams_->choice());
  second_->setVisible(on);
  secondPixels_ = {};
  secondDrawings_.clear();
  showMessage();
  // The image may be the same as before, but is no longer compared.
  if (!on) {
    canvas_->setSecond({}, {});
    canvas_->setCaptions({}, {});
    shownDrawings_.clear();
    image_.reset();
    showMessage();
  }
}

void ImageStreamView::showComparison(ImagePicture& first) {
  firstPixels_ = first.pixels;
  if (!compare_->isChecked()) return;
  std::vector<robotlink::PackagePtr> keep;
  ImagePicture second =
      pictureOf(second_->image().get(), second_->path(), second_->time(), secondDrawings_, keep);
  second.drawnOn = second.pixels.size();
  if (!first.pixels.isNull() && !second.pixels.isNull() && second.pixels.size() != first.pixels.size())
    second.pixels = second.pixels.scaled(first.pixels.size());
  secondPixels_ = second.pixels;
  const QString shift =
      tr("%1 at %2").arg(QString::fromStdString(second_->path()), timeText(second_->time()));
  const QString missing = tr("%1: no image of that time here").arg(QString::fromStdString(second_->path()));
  const QString text = second.pixels.isNull() ? missing
                       : second_->isHeld()    ? tr("held: %1").arg(shift)
                                              : shift;
  const auto mode = second_->mode();
  if (mode == CompareRow::Mode::kSideBySide) {
    canvas_->setCaptions(
        tr("%1 at %2").arg(QString::fromStdString(streams_->path(session())), timeText(imageTime_)), text);
    return canvas_->setSecond(std::move(second), std::move(keep));
  }
  canvas_->setSecond({}, {});
  if (second.pixels.isNull() || first.pixels.isNull()) return canvas_->setCaptions(text, {});
  if (mode == CompareRow::Mode::kBlend) {
    first.pixels = blended(first.pixels, second.pixels, second_->share());
    return canvas_->setCaptions(tr("%1 % of %2").arg(std::lround(100 * second_->share())).arg(text), {});
  }
  const auto statistics = statisticsOf(first.pixels, second.pixels, kDifferenceTolerance);
  first.pixels = difference(first.pixels, second.pixels, second_->gain());
  canvas_->setCaptions(tr("%1 % of the pixels differ from %2, by at most %3")
                           .arg(100 * statistics.share, 0, 'f', 1)
                           .arg(text)
                           .arg(statistics.largest),
                       {});
}

QString ImageStreamView::secondPixelText(const QPoint& at) const {
  if (!compare_->isChecked() || !secondPixels_.rect().contains(at) || !firstPixels_.rect().contains(at))
    return {};
  const QColor other = secondPixels_.pixelColor(at), own = firstPixels_.pixelColor(at);
  return tr("   second R %1  G %2  B %3   Δ %4 %5 %6")
      .arg(other.red(), 3)
      .arg(other.green(), 3)
      .arg(other.blue(), 3)
      .arg(other.red() - own.red())
      .arg(other.green() - own.green())
      .arg(other.blue() - own.blue());
}

void ImageStreamView::createMeasure() {
  const auto toCanvas = [this] { return canvas_->transform(); };
  const auto place = [this](const QPointF& at) -> std::optional<QPointF> {
    const QPointF point = canvas_->imageAt(at);
    const QPointF pixel(std::floor(point.x()), std::floor(point.y()));
    if (!QRectF(QPointF(), QSizeF(firstPixels_.size())).contains(pixel + QPointF(0.5, 0.5)))
      return std::nullopt;
    return pixel + QPointF(0.5, 0.5);
  };
  measure_ = new MeasureTool(*this, *canvas_, "image",
                             {toCanvas, place, [this](const auto& points) { return measured(points); }});
  canvas_->setMeasure(measure_);
  connect(measure_, &MeasureTool::toggled, this, &ImageStreamView::tick);
}

std::string ImageStreamView::robotOfStream() const {
  const std::string path = streams_->path(session());
  return path.substr(0, path.find('/'));
}

std::optional<robotlink::Vector2> ImageStreamView::onFloor(const QPointF& point) const {
  if (!image_) return std::nullopt;
  const auto* camera = session().store().latestAs<robotcontrol::CameraPose>(
      robotOfStream() + '/' + robotlink::kCameraPose.name, imageTime_);
  return camera == nullptr ? std::nullopt : floorPoint(*camera, QSizeF(firstPixels_.size()), point);
}

QString ImageStreamView::endText(const QString& name, const QPointF& point) const {
  const QPoint pixel(static_cast<int>(std::floor(point.x())), static_cast<int>(std::floor(point.y())));
  const QColor color = firstPixels_.rect().contains(pixel) ? firstPixels_.pixelColor(pixel) : QColor();
  QString text = tr("%1 (%2, %3) %4").arg(name).arg(pixel.x()).arg(pixel.y()).arg(color.name());
  if (const auto floor = onFloor(point))
    text +=
        tr(" on the floor (%1, %2) mm").arg(std::lround(1e3 * floor->x())).arg(std::lround(1e3 * floor->y()));
  return text;
}

MeasureText ImageStreamView::measured(const std::vector<QPointF>& points) const {
  MeasureText text;
  QStringList parts;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const QPointF by = points[i + 1] - points[i];
    QString segment = tr("%1 px").arg(std::hypot(by.x(), by.y()), 0, 'f', 1);
    const auto from = onFloor(points[i]), to = onFloor(points[i + 1]);
    if (from && to) segment += tr(", %1 mm").arg(std::lround(1e3 * (*to - *from).norm()));
    text.segments << segment;
    parts << tr("%1%2 %3 (%4, %5), %6")
                 .arg(lettersOf(i), lettersOf(i + 1), segment)
                 .arg(by.x())
                 .arg(by.y())
                 .arg(degreesText(directionDeg(points[i], points[i + 1], true)));
  }
  if (points.size() > 2) {
    text.angle = degreesText(angleAt(points) * 180 / robotlink::kPi);
    parts << tr("angle at B %1").arg(text.angle);
  }
  for (std::size_t i = 0; i < points.size(); ++i) parts << endText(lettersOf(i), points[i]);
  text.line = parts.join(QStringLiteral("; "));
  return text;
}

std::optional<QString> ImageStreamView::numbers() {
  if (!image_ || image_->width() == 0 || image_->height() > kMaxPixels / image_->width()) return std::nullopt;
  QString table;
  for (int y = 0; y < static_cast<int>(image_->height()); ++y) {
    for (int x = 0; x < static_cast<int>(image_->width()); ++x) {
      const auto pixel = rawPixel(*image_, x, y);
      if (!pixel) return std::nullopt;
      if (x > 0) table += QLatin1Char('\t');
      if (pixel->depth)
        table += std::isfinite(*pixel->depth) ? QString::number(*pixel->depth, 'g', 7) : QString();
      else if (pixel->value)
        table += QString::number(*pixel->value);
      else
        table += QStringLiteral("%1\t%2\t%3").arg(pixel->rgb.r).arg(pixel->rgb.g).arg(pixel->rgb.b);
    }
    table += QLatin1Char('\n');
  }
  return table;
}

}  // namespace widgets
