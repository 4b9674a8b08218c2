// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/ImageStreamView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <algorithm>

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/image/CompareRow.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageClasses.h"
#include "widgets/image/ImageHint.h"
#include "widgets/image/ImagePixels.h"
#include "widgets/image/RawPicture.h"
#include "widgets/image/StreamSelector.h"
#include "widgets/picture/MeasureTool.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {
namespace {

const ViewRegistration kImageStreamViewRegistration{
    {"image", QT_TRANSLATE_NOOP("View", "Image"),
     QT_TRANSLATE_NOOP("View", "Images with the drawings of what the program sees in them"), "image", true,
     create<ImageStreamView>}};

constexpr char kDefaultChoice[] = "*/camera/image";

}  // namespace

ImageStreamView::ImageStreamView(ViewContext& context, QWidget* parent)
    : PictureView(context, "image", "picture.png", parent) {
  createActions();
  createViews();
  connectSignals();
  keep("stream", streams_);
  keep(
      "second", [this] { return second_->save(); },
      [this](const QJsonValue& value) { second_->restore(value); }, Names::kObjects);
  keep("compare", compare_);
  keep("gray", gray_);
  keep("stereogram", stereogram_);
  tick();
}

ImageStreamView::~ImageStreamView() = default;

void ImageStreamView::createActions() {
  fit_ = makeFit(tr("Fits the whole image into the view"));
  oneToOne_ = makeAction(this, "one-to-one",
                         {"imageOneToOne", tr("1:1"), tr("Shows the image pixel by pixel"), Qt::Key_A});
  freeze_ = makeFreeze();
  compare_ = makeToggle(
      this, "two-pictures",
      {"imageCompare", tr("Compare"),
       tr("Compares with a second image: another camera or robot, the logged one, or another time"),
       Qt::Key_C});
  createModes();
  copyImage_ = makeAction(
      this, "copy",
      {"imageCopyImage", tr("Copy image only"), tr("Copies the image in its own size, without drawings")});
  saveImage_ = makeAction(this, "save",
                          {"imageSaveImage", tr("Save image only..."),
                           tr("Saves the image in its own size, without drawings, as PNG")});
}

void ImageStreamView::createViews() {
  canvas_ = new ImageCanvas(this);
  createMeasure();
  const Side side = makeDrawings({QStringLiteral("image")});
  QHBoxLayout* row = makeToolRow(this);
  streams_ = new StreamSelector("foxglove.RawImage", QLatin1String(kDefaultChoice), row->parentWidget());
  describe(*streams_, {"imageStream", tr("Image stream"), tr("Which images are shown")});
  row->addWidget(streams_, 1);
  addButtons(row, {fit_, oneToOne_, zoomOut(), zoomIn(), freeze_, compare_, gray_, stereogram_,
                   measure_->toggle(), side.toggle});
  second_ = new CompareRow(this);
  second_->hide();
  assemble({row->parentWidget(), second_}, canvas_, side, {measure_->bar(), createFooter()});
}

QWidget* ImageStreamView::createFooter() {
  QHBoxLayout* footer = makeFooter(this);
  time_ = addLabel(footer, "imageTime", tr("Time of the image"));
  state_ = addLabel(footer, "imageState", tr("Whether the image is live, frozen or old"));
  pixel_ = addFiguresLabel(footer, "imagePixel", tr("Pixel under the cursor"));
  zoom_ = addLabel(footer, "imageZoom", tr("Zoom"));
  return footer->parentWidget();
}

void ImageStreamView::connectSignals() {
  connect(fit_, &QAction::triggered, this, [this] { canvas_->setViewport({}); });
  connect(oneToOne_, &QAction::triggered, this, [this] { canvas_->zoomBy(1 / canvas_->zoom()); });
  connect(freeze_, &QAction::toggled, this, [this](bool frozen) {
    frozenAt_ = frozen ? std::optional(session().timeline().shown()) : std::nullopt;
    tick();
  });
  connect(streams_, &StreamSelector::choiceChanged, this, [this] {
    freeze_->setChecked(false);
    tick();
  });
  connect(drawings(), &DrawingsModel::shownChanged, this, &ImageStreamView::showMessage);
  connect(compare_, &QAction::toggled, this, &ImageStreamView::compare);
  connect(second_, &CompareRow::changed, this, [this] {
    secondPixels_ = {};
    showMessage();
  });
  connect(canvas_, &ImageCanvas::viewportChanged, this, &ImageStreamView::updateStatus);
  connect(canvas_, &ImageCanvas::pixelChanged, this, &ImageStreamView::updatePixel);
  connect(copyImage_, &QAction::triggered, this, [this] { copyPicture(firstPixels_); });
  connect(saveImage_, &QAction::triggered, this,
          [this] { savePictureAs(this, firstPixels_, QStringLiteral("image.png")); });
  addToContextMenu(canvas_, {copyImage_, saveImage_, measure_->copy()});
}

void ImageStreamView::tick() {
  streams_->refresh(session());
  if (const std::string path = streams_->path(session()); !path.empty())
    Q_EMIT titleChanged(tr("Image: %1").arg(QString::fromStdString(path)));
  drawings()->refresh(session(), robotOfStream());
  if (measure_->isOn()) subscription_.want(session(), robotOfStream(), {robotlink::kCameraPose.name});
  ports_.want(session(), {streams_->path(session())});
  const auto* message = session().store().latest(streams_->path(session()), instant());
  // A frozen image stays, even if the history no longer reaches back to it.
  if (!frozenAt_ || message != nullptr) {
    message_ = message == nullptr ? nullptr : message->value;
    imageTime_ = message == nullptr ? robotlink::Instant() : message->time;
    showMessage();
  }
  updateStatus();
}

std::string ImageStreamView::robot() const {
  return drawingRobot(streams_->path(session()));
}

robotlink::Instant ImageStreamView::instant() const {
  return frozenAt_.value_or(session().timeline().shown());
}

void ImageStreamView::showMessage() {
  auto image = std::dynamic_pointer_cast<const foxglove::RawImage>(message_);
  auto drawings = image ? drawingsOf(robot(), instant(), imageTime_) : std::vector<CurrentDrawing>();
  bool same = image == image_ && drawings == shownDrawings_;
  image_ = std::move(image);
  canvas_->setHint(imageHint(context(), streams_->path(session())));
  if (compare_->isChecked()) {
    const bool isOther = second_->update(session(), image_ ? imageTime_ : instant());
    auto seconds = second_->image() ? drawingsOf(second_->robot(), second_->time(), second_->time())
                                    : std::vector<CurrentDrawing>();
    same = same && !isOther && seconds == secondDrawings_ && !secondPixels_.isNull();
    secondDrawings_ = std::move(seconds);
  }
  if (same) return;
  shownDrawings_ = std::move(drawings);
  std::vector<robotlink::PackagePtr> keep;
  ImagePicture picture = pictureOf(image_.get(), streams_->path(session()), imageTime_, shownDrawings_, keep);
  showComparison(picture);
  canvas_->setPicture(std::move(picture), std::move(keep));
  measure_->refresh();
}

void ImageStreamView::updateStatus() {
  canvas_->setFrozen(frozenAt_.has_value());
  time_->setText(image_ ? timeText(imageTime_) : tr("no image yet"));
  const bool faded = image_ && std::ranges::any_of(shownDrawings_, &CurrentDrawing::old);
  QStringList state{image_ ? staleText() : QString(),
                    faded ? tr("faded: drawn in earlier images") : QString()};
  state.removeAll(QString());
  state_->setText(state.join(QStringLiteral(", ")));
  state_->setVisible(!state_->text().isEmpty());
  zoom_->setText(image_ ? tr("%1 %").arg(qRound(canvas_->zoom() * 100)) : QString());
}

QString ImageStreamView::staleText() const {
  if (frozenAt_) return tr("frozen");
  if (!session().timeline().live()) return tr("history");
  const double age = robotlink::seconds(session().timeline().shown() - imageTime_);
  return age > 0.5 ? tr("%1 s old").arg(age, 0, 'f', 1) : QString();
}

void ImageStreamView::updatePixel() {
  const auto at = canvas_->pixelUnderCursor();
  if (!at || !image_) return pixel_->clear();
  const auto pixel = rawPixel(*image_, at->x(), at->y());
  const QString text =
      pixel ? describe(*pixel, classNameOf(*pixel, classes(), context().field.get())) : QString();
  pixel_->setText(text + secondPixelText(*at));
}

std::vector<std::string> ImageStreamView::classes() const {
  return image_ ? classNames(session().store(), streams_->path(session()), *image_, imageTime_)
                : std::vector<std::string>();
}

QJsonObject ImageStreamView::saveState() const {
  const ImageViewport& viewport = canvas_->viewport();
  QJsonObject state = PictureView::saveState();
  state[QStringLiteral("fit")] = viewport.fit;
  state[QStringLiteral("zoom")] = viewport.zoom;
  state[QStringLiteral("center")] = QJsonArray{viewport.center.x(), viewport.center.y()};
  return state;
}

void ImageStreamView::restoreState(const QJsonObject& state) {
  PictureView::restoreState(state);
  const QJsonArray center = state[QStringLiteral("center")].toArray();
  canvas_->setViewport({state[QStringLiteral("fit")].toBool(true),
                        std::clamp(state[QStringLiteral("zoom")].toDouble(1), ImageViewport::kMinZoom,
                                   ImageViewport::kMaxZoom),
                        {center.at(0).toDouble(), center.at(1).toDouble()}});
}

}  // namespace widgets
