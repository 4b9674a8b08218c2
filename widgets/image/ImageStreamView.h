// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"
#include "robotlink/process/Link.h"
#include "widgets/PackageSubscription.h"
#include "widgets/drawings/CurrentDrawings.h"
#include "widgets/picture/PictureView.h"
#include "widgets/ports/PortSubscription.h"

class QAction;
class QLabel;
namespace foxglove {
class RawImage;
}

namespace widgets {

class CompareRow;
class ImageCanvas;
class MeasureTool;
class StreamSelector;
struct ImagePicture;
struct MeasureText;

/// Shows any stream of images with the drawings that belong to it, chosen by name. Zoom, pan, color of the
/// pixel under the cursor; the picture can be frozen, copied and saved, compared with a second one, and
/// measured. Follows the session's timeline.
///
/// The stream is chosen by its path; "*/camera/image" stands for that of the session's selected robot.
/// Registered as "image". GUI thread.
class ImageStreamView final : public PictureView {
  Q_OBJECT
 public:
  explicit ImageStreamView(ViewContext& context, QWidget* parent = nullptr);
  ~ImageStreamView() override;

  /// The values of the pixels, a line for each row: depths in m, gray values or class numbers; of colors
  /// three columns for each pixel, red, green, blue. Unset without an image, or if it is larger than
  /// kMaxPixels.
  std::optional<QString> numbers() override;
  static constexpr int kMaxPixels = 2 << 20;

  /// Shows the newest image not later than the shown instant, and its drawings.
  void tick() override;
  /// Chooses the stream by its path or "*/camera/image". Fails if there are no such images (yet).
  robotlink::Result<void> showStream(const std::string& stream);
  /// Compares with such a stream; `mode`: "side-by-side", "blend" or "difference". Fails as showStream().
  robotlink::Result<void> compareWith(const std::string& stream, const std::string& mode);
  void endComparison();
  /// Sets how images are shown: "color", "gray", or "stereogram", which is for depths only.
  void setMode(const std::string& mode);
  /// The streams that these functions accept.
  std::vector<std::string> streamChoices() const;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 private:
  /// Fit, freeze, and copying and saving without drawings.
  void createActions();
  void createViews();
  /// Time, pixel, state and zoom.
  QWidget* createFooter();
  void connectSignals();

  /// ImageStreamViewTools.cpp: modes, comparing and measuring.
  void createModes();
  /// Converts an image again that is shown already.
  void showAgain();
  void createMeasure();
  /// Fails if there are no such images, and names those that there are.
  robotlink::Result<void> requireStream(const std::string& stream) const;
  /// Shows or hides the second image.
  void compare(bool on);
  /// Passes the second image to the canvas, next to the first or within it.
  void showComparison(ImagePicture& first);
  /// A stream's image with its drawings, and the messages that own these.
  ImagePicture pictureOf(const foxglove::RawImage* image, const std::string& path, robotlink::Instant time,
                         const std::vector<CurrentDrawing>& drawings,
                         std::vector<robotlink::PackagePtr>& keep) const;
  /// The drawings of a robot that are checked in the list.
  std::vector<CurrentDrawing> drawingsOf(const std::string& robot, robotlink::Instant at,
                                         robotlink::Instant imageTime) const;
  /// The text about the pixel under the cursor in the second image.
  QString secondPixelText(const QPoint& at) const;
  MeasureText measured(const std::vector<QPointF>& points) const;
  /// "A (12, 34) #ff8000", and the place on the floor where the camera's pose is known.
  QString endText(const QString& name, const QPointF& point) const;
  std::optional<robotlink::Vector2> onFloor(const QPointF& point) const;

  /// The robot of the chosen stream as named where its drawings are, "red1" or "red1/logged", and its
  /// name.
  std::string robot() const;
  std::string robotOfStream() const;
  /// The instant that is shown: the timeline's, or that of freezing.
  robotlink::Instant instant() const;
  /// Converts the image and passes it to the canvas.
  void showMessage();
  /// Updates time, state and zoom in the footer.
  void updateStatus();
  /// Updates the value of the pixel under the cursor.
  void updatePixel();
  /// Says how old the image is if nothing newer arrives; empty if it is current.
  QString staleText() const;
  /// Names of the classes that the image consists of; empty: it consists of colors.
  std::vector<std::string> classes() const;

  ImageCanvas* canvas_ = nullptr;
  StreamSelector* streams_ = nullptr;
  CompareRow* second_ = nullptr;
  MeasureTool* measure_ = nullptr;
  QLabel *time_ = nullptr, *pixel_ = nullptr, *state_ = nullptr, *zoom_ = nullptr;
  QAction *fit_ = nullptr, *oneToOne_ = nullptr, *freeze_ = nullptr, *compare_ = nullptr;
  QAction *gray_ = nullptr, *stereogram_ = nullptr;
  QAction *copyImage_ = nullptr, *saveImage_ = nullptr;

  /// The message that is shown, and the same as an image.
  robotlink::PackagePtr message_;
  std::shared_ptr<const foxglove::RawImage> image_;
  robotlink::Instant imageTime_;
  /// Unset: not frozen.
  std::optional<robotlink::Instant> frozenAt_;
  /// The drawings in the picture, to detect changes.
  std::vector<CurrentDrawing> shownDrawings_;
  /// The same of the second image, while it is compared with.
  std::vector<CurrentDrawing> secondDrawings_;
  /// The first image without drawings, before it is joined with the second one; and that.
  QImage firstPixels_, secondPixels_;
  /// Requests the camera's pose while something is measured.
  PackageSubscription subscription_;
  /// Requests the images of cameras of the scene that no robot sends.
  PortSubscription ports_;
};

}  // namespace widgets
