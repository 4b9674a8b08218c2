// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorImageView.h"

#include <QAction>
#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

#include "colortool/table/ColorTable.h"
#include "foxglove/Image.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Theme.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFiles.h"
#include "widgets/color/ColorSender.h"
#include "widgets/color/image/ColorEffectRow.h"
#include "widgets/color/image/ColorStrip.h"
#include "widgets/color/image/ColorToolRow.h"
#include "widgets/image/ImageHint.h"
#include "widgets/image/ImagePixels.h"
#include "widgets/image/StreamSelector.h"
#include "widgets/log/OpenLogs.h"

namespace widgets {
namespace {

const ViewRegistration kColorImageViewRegistration{
    {"color-image", QT_TRANSLATE_NOOP("View", "Color image"),
     QT_TRANSLATE_NOOP("View", "Draw strokes in images and see how the color table classifies them"), "brush",
     false, create<ColorImageView>}};

constexpr char kDefaultColorChoice[] = "*/camera/image";
/// Below this height the strip is low, so that the image has the room, pixels.
constexpr int kLowView = 480;

}  // namespace

ColorImageView::ColorImageView(ViewContext& context, QWidget* parent)
    : PictureView(context, "color", "picture.png", parent), bench_(colorBench(context)) {
  setObjectName(QStringLiteral("colorImageView"));
  createActions();
  createViews();
  connectSignals();
  keepChoices();
  applyTool();
  // A picture of a file is in no stream, so it has to be pinned to be shown again.
  if (bench_.frame() && !bench_.frame()->file().empty()) {
    pinned_ = bench_.frame();
    freeze_->setChecked(true);
  }
  tick();
  // The bench may have results already, which no signal announces while the timeline is paused.
  showFrame();
  showColors();
}

ColorImageView::~ColorImageView() = default;

void ColorImageView::createActions() {
  fit_ = makeFit(tr("Fits the whole image into the view"));
  oneToOne_ =
      makeAction(this, "one-to-one", {"colorOneToOne", tr("1:1"), tr("Shows the image pixel by pixel")});
  freeze_ = makeFreeze();
  collect_ = makeAction(
      this, "add",
      {"colorCollect", tr("Collect"), tr("Adds this image to the strip, to return to it later"), Qt::Key_C});
  twoPictures_ = makeToggle(
      this, "two-pictures",
      {"colorTwoPictures", tr("Two pictures"), tr("Shows the classified image next to it"), Qt::Key_T}, true);
  showStrokes_ =
      makeToggle(this, "eye",
                 {"colorShowStrokes", tr("Strokes"), tr("Shows the strokes in the image"), Qt::Key_V}, true);
  cancel_ =
      makeAction(this, "close",
                 {"colorCancel", tr("Cancel"), tr("Cancels the stroke or the selection"), Qt::Key_Escape});
  send_ = makeAction(this, "send",
                     {"colorSend", tr("Send"), tr("Sends the table to the selected robot's program"),
                      QKeySequence(QStringLiteral("Ctrl+Return"))});
  autoSend_ =
      makeToggle(this, "auto-send",
                 {"colorAutoSend", tr("Send always"), tr("Sends each new table to the robot at once")});
  createPictureActions();
}

void ColorImageView::createPictureActions() {
  showStrip_ = makeToggle(
      this, "down", {"colorShowStrip", tr("Strip"), tr("Shows the collected images below this one")}, true);
  openPictures_ = makeAction(this, "image",
                             {"colorOpenPictures", tr("Open pictures…"),
                              tr("Adds pictures to the strip, to paint in: PNG, JPEG, .yuyv")});
  openFolder_ = makeAction(this, "open",
                           {"colorOpenFolder", tr("Open a folder of pictures…"),
                            tr("Adds all pictures of a folder to the strip, to paint in")});
  connect(openPictures_, &QAction::triggered, this, [this] { openPictures(false); });
  connect(openFolder_, &QAction::triggered, this, [this] { openPictures(true); });
}

void ColorImageView::openPictures(bool folder) {
  ColorFiles& files = colorFiles(context());
  std::vector<std::filesystem::path> chosen;
  if (folder) {
    const QString name = QFileDialog::getExistingDirectory(this, tr("Folder of pictures"), files.folder());
    if (!name.isEmpty()) chosen.emplace_back(name.toStdString());
  } else {
    const QStringList names = QFileDialog::getOpenFileNames(
        this, tr("Open pictures"), files.folder(), tr("Pictures (*.png *.jpg *.jpeg *.yuyv);;All files (*)"));
    for (const QString& name : names) chosen.emplace_back(name.toStdString());
  }
  files.openPictures(chosen);
}

void ColorImageView::resizeEvent(QResizeEvent* event) {
  View::resizeEvent(event);
  strip_->setLow(height() < kLowView);
}

void ColorImageView::createViews() {
  left_ = new ColorCanvas(QStringLiteral("colorLeft"), this);
  right_ = new ColorCanvas(QStringLiteral("colorRight"), this);
  strip_ = new ColorStrip(bench_, this);
  toolRow_ = new ColorToolRow(bench_, this);
  effect_ = new ColorEffectRow(bench_, this);

  assemble({createStreamRow(), toolRow_, effect_}, left_, {right_}, {strip_, createFooter()});
}

QWidget* ColorImageView::createStreamRow() {
  QHBoxLayout* row = makeToolRow(this);
  streams_ = new StreamSelector("foxglove.RawImage", QLatin1String(kDefaultColorChoice), row->parentWidget());
  describe(*streams_, {"colorStream", tr("Image stream"), tr("Which images are shown")});
  row->addWidget(streams_, 1);
  addButtons(row, {openPictures_, openFolder_});
  addButtons(
      row, {freeze_, collect_, fit_, oneToOne_, zoomOut(), zoomIn(), showStrokes_, showStrip_, twoPictures_});
  rightLayer_ = new QComboBox(row->parentWidget());
  describe(*rightLayer_, {"colorRightLayer", tr("Right picture"), tr("What the right picture shows")});
  rightLayer_->addItems({tr("Classes"), tr("Classes by the reference"), tr("Difference"), tr("Ambiguity")});
  row->addWidget(rightLayer_);
  addButtons(row, {send_, autoSend_});
  return row->parentWidget();
}

QWidget* ColorImageView::createFooter() {
  QHBoxLayout* footer = makeFooter(this);
  time_ = addLabel(footer, "colorTime", tr("Time of the image"));
  state_ = addLabel(footer, "colorState", tr("Whether the image is live, frozen or from the strip"));
  pixel_ = addFiguresLabel(footer, "colorPixel",
                           tr("Pixel under the cursor: position, color, class, confidence, cell"));
  zoom_ = addLabel(footer, "colorZoom", tr("Zoom"));
  return footer->parentWidget();
}

void ColorImageView::connectSignals() {
  connectCanvas(left_, right_);
  connectCanvas(right_, left_);
  connect(fit_, &QAction::triggered, this, [this] {
    for (ColorCanvas* canvas : {left_, right_}) canvas->setViewport({});
    updateStatus();
  });
  connect(oneToOne_, &QAction::triggered, this, [this] { left_->zoomBy(1 / left_->zoom()); });
  connect(freeze_, &QAction::toggled, this, [this](bool frozen) {
    pinned_ = frozen ? (pinned_ ? pinned_ : bench_.frame()) : nullptr;
    if (!frozen) strip_->showCurrent(nullptr);
    tick();
  });
  connect(collect_, &QAction::triggered, &bench_, [this] { bench_.collect(); });
  connect(twoPictures_, &QAction::toggled, right_, &QWidget::setVisible);
  connect(showStrip_, &QAction::toggled, strip_, &ColorStrip::setWanted);
  connect(showStrokes_, &QAction::toggled, this, &ColorImageView::showMarks);
  connect(cancel_, &QAction::triggered, this, &ColorImageView::cancelGesture);
  const auto pin = [this](const ColorFramePtr& frame) {
    pinned_ = frame;
    freeze_->setChecked(frame != nullptr);
    pinned_ = frame;
    tick();
  };
  connect(strip_, &ColorStrip::chosen, this, pin);
  connect(&bench_, &ColorBench::frameWanted, this, pin);
  connect(streams_, &StreamSelector::choiceChanged, this, [this] {
    freeze_->setChecked(false);
    tick();
  });
  connect(toolRow_, &ColorToolRow::toolChanged, this, &ColorImageView::applyTool);
  connect(toolRow_, &ColorToolRow::opacityChanged, this, &ColorImageView::applyLayers);
  ColorSender& sender = colorSender(bench_);
  connect(send_, &QAction::triggered, &sender, &ColorSender::send);
  connect(autoSend_, &QAction::toggled, &sender, &ColorSender::setAutoSend);
  connect(&sender, &ColorSender::changed, this, &ColorImageView::showSending);
  connect(rightLayer_, qOverload<int>(&QComboBox::currentIndexChanged), this, &ColorImageView::showColors);
  connect(&bench_, &ColorBench::frameChanged, this, &ColorImageView::showFrame);
  connect(&bench_, &ColorBench::colorsChanged, this, &ColorImageView::showColors);
  connect(&bench_, &ColorBench::referenceChanged, this, &ColorImageView::showColors);
  connect(&bench_, &ColorBench::followWanted, freeze_, [this] { freeze_->setChecked(false); });
  connect(&bench_, &ColorBench::differenceWanted, this, [this] {
    twoPictures_->setChecked(true);
    rightLayer_->setCurrentIndex(static_cast<int>(RightLayer::kDifference));
  });
  connect(&bench_, &ColorBench::selectionChanged, this, &ColorImageView::showSelection);
  connect(&bench_, &ColorBench::samplesChanged, this, &ColorImageView::showMarks);
}

void ColorImageView::connectCanvas(ColorCanvas* canvas, ColorCanvas* other) {
  connect(canvas, &ColorCanvas::viewportChanged, this, [this, other](const ImageViewport& viewport) {
    other->setViewport(viewport);
    updateStatus();
  });
  connect(canvas, &ColorCanvas::cursorMoved, this, [this, other](std::optional<QPointF> at) {
    cursor_ = at;
    other->setOtherCursor(at);
    updatePixel();
  });
  connect(canvas, &ColorCanvas::gestureBegan, this, &ColorImageView::beginGesture);
  connect(canvas, &ColorCanvas::gestureMoved, this, &ColorImageView::moveGesture);
  connect(canvas, &ColorCanvas::gestureEnded, this, &ColorImageView::endGesture);
  connect(canvas, &ColorCanvas::radiusWanted, this, [this](double by) { toolRow_->scaleRadius(by); });
  connect(canvas, &ColorCanvas::menuWanted, this, [this, canvas](const QPoint& pixel, const QPoint& global) {
    openMenu(canvas == right_, pixel, global);
  });
}

// The images and layers that are shown.

void ColorImageView::tick() {
  if (streams_->refresh(session()))
    Q_EMIT titleChanged(tr("Color image: %1").arg(QString::fromStdString(streams_->path(session()))));
  if (!gesture_) bench_.setFrame(shownFrame());
  colorSender(bench_).tick();
  left_->setHint(imageHint(context(), streams_->path(session())));
  updateStatus();
}

ColorFramePtr ColorImageView::shownFrame() {
  if (pinned_) return pinned_;
  const std::string path = streams_->path(session());
  const auto* message = session().store().latest(path, session().timeline().shown());
  if (message == nullptr) {
    // The store may have no image although the bench has one of this stream; while the session is paused none
    // would arrive, so the bench's image is shown.
    const ColorFramePtr& last = bench_.frame();
    const bool still = last && last->file().empty() && last->stream() == path &&
                       last->time() <= session().timeline().shown();
    return still ? last : nullptr;
  }
  auto image = std::dynamic_pointer_cast<const foxglove::RawImage>(message->value);
  if (!image) return nullptr;
  const ColorFramePtr& now = bench_.frame();
  if (now && now->message() == image && now->stream() == path) return now;
  const auto* log = openLogs(context()).current();
  const std::string source = log == nullptr ? "" : std::filesystem::path(log->path).filename().string();
  auto frame = std::make_shared<const ColorFrame>(std::move(image), path, source, message->time);
  return frame->view().empty() ? nullptr : frame;
}

void ColorImageView::showFrame() {
  const ColorFramePtr& frame = bench_.frame();
  leftLayers_ = {};
  if (frame)
    leftLayers_.picture = toQImage(frame->view());
  else
    rightLayers_ = {};
  rightLayers_.shade = {};
  showMarks();
  showSelection();
}

void ColorImageView::showMarks() {
  const ColorFramePtr& frame = bench_.frame();
  auto marks = std::make_shared<std::vector<StrokeMark>>();
  if (frame && showStrokes_->isChecked()) *marks = strokeMarks(bench_.samples(), frame->place());
  leftLayers_.marks = rightLayers_.marks = std::move(marks);
  applyLayers();
}

void ColorImageView::showSelection() {
  leftLayers_.shade =
      bench_.frame() && bench_.hasSelection() ? selectionShade(seen(), bench_.selection()) : QImage();
  applyLayers();
}

robotlink::ImageView ColorImageView::seen() const {
  const LearnedColors* colors = bench_.colors();
  return colors != nullptr && colors->frame == bench_.frame() ? colors->seen() : bench_.frame()->view();
}

void ColorImageView::showColors() {
  const LearnedColors* colors = bench_.colors();
  // A result for another image must not be shown over this one.
  if (colors == nullptr || colors->frame != bench_.frame() || !colors->classes) return;
  const std::vector<robotlink::Rgb> classColors = bench_.classColors();
  leftLayers_.over = toQImage(colors->classes->view(), classColors, std::move(leftLayers_.over));
  rightLayers_.picture = rightImage();
  showSelection();
  updatePixel();
}

QImage ColorImageView::rightImage() const {
  const LearnedColors& colors = *bench_.colors();
  const auto layer = static_cast<RightLayer>(rightLayer_->currentIndex());
  if (layer == RightLayer::kMargins)
    return colors.margins ? marginImage(colors.seen(), *colors.margins) : rightLayers_.picture;
  const bool compares = layer == RightLayer::kReference || layer == RightLayer::kDifference;
  if (!compares || !bench_.reference()) return leftLayers_.over;
  robotlink::Image classes;
  bench_.reference()->classify(colors.seen(), classes);
  if (layer == RightLayer::kReference) return toQImage(classes.view(), bench_.classColors());
  return differenceImage(leftLayers_.picture, *colors.classes, classes, bench_.classColors());
}

QString ColorImageView::rightCaption() const {
  switch (static_cast<RightLayer>(rightLayer_->currentIndex())) {
    case RightLayer::kClasses:
      return bench_.samples().strokes.empty() ? tr("Choose a class and paint in the left picture")
                                              : QString();
    case RightLayer::kReference:
      return bench_.reference() ? tr("By %1").arg(bench_.referenceName())
                                : tr("There is no table to compare with yet");
    case RightLayer::kDifference:
      return bench_.reference() ? tr("Different from %1; magenta: no class now").arg(bench_.referenceName())
                                : tr("There is no table to compare with yet");
    case RightLayer::kMargins:
      return tr("Bright: another class is nearly as likely");
  }
  return {};
}

void ColorImageView::applyLayers() {
  leftLayers_.opacity = toolRow_->opacity();
  left_->setLayers(leftLayers_);
  right_->setLayers(rightLayers_);
  right_->setCaption(rightCaption());
}

void ColorImageView::showSending() {
  const ColorSender& sender = colorSender(bench_);
  const bool good = sender.state() == ColorSender::State::kConfirmed;
  const bool bad = sender.state() == ColorSender::State::kFailed;
  QLabel* note = toolRow_->note();
  note->setText(good ? QStringLiteral("✓ %1").arg(sender.text()) : sender.text());
  setMeaning(*note, good ? std::optional(Meaning::kGood) : bad ? std::optional(Meaning::kBad) : std::nullopt);
  note->setToolTip(sender.text());
  autoSend_->setChecked(sender.autoSend());
}

void ColorImageView::updateStatus() {
  const ColorFramePtr& frame = bench_.frame();
  time_->setText(!frame                  ? tr("no image yet")
                 : frame->file().empty() ? timeText(frame->time())
                                         : frame->label());
  state_->setText(!frame                                     ? QString()
                  : pinned_                                  ? tr("frozen")
                  : !session().timeline().live()             ? tr("history")
                  : openLogs(context()).current() == nullptr ? tr("live")
                                                             : QString());
  zoom_->setText(frame ? tr("%1 %").arg(qRound(left_->zoom() * 100)) : QString());
}

std::optional<QString> ColorImageView::numbers() {
  const ColorFramePtr& frame = bench_.frame();
  if (!frame) return std::nullopt;
  const LearnedColors* colors = bench_.colors();
  const bool hasClasses = colors != nullptr && colors->frame == frame;
  QString table = QStringLiteral("x\ty\tY\tCb\tCr");
  table += hasClasses ? QStringLiteral("\tclass\n") : QStringLiteral("\n");
  const robotlink::ImageView image = seen();
  constexpr int kCharactersOfRow = 32;
  table.reserve(kCharactersOfRow * image.width * image.height);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const robotlink::YCbCr color = robotlink::pixelYCbCr(image, x, y);
      for (const int number : {x, y, int{color.y}, int{color.cb}, int{color.cr}})
        table += QString::number(number) + QLatin1Char('\t');
      if (hasClasses)
        table += QString::fromStdString(colors->samples.classes.name(colors->table->classOf(color)));
      else
        table.chop(1);
      table += QLatin1Char('\n');
    }
  }
  return table;
}

QString ColorImageView::marginText(std::size_t cell) const {
  const LearnedColors* colors = bench_.colors();
  if (colors == nullptr || !colors->margins) return {};
  return tr(" %1 % sure").arg(qRound((*colors->margins)[cell] / 2.55), 3);
}

void ColorImageView::updatePixel() {
  const ColorFramePtr& frame = bench_.frame();
  const LearnedColors* colors = bench_.colors();
  const int x = cursor_ ? static_cast<int>(std::floor(cursor_->x())) : -1,
            y = cursor_ ? static_cast<int>(std::floor(cursor_->y())) : -1;
  const auto pixel = frame ? pixelAt(frame->view(), x, y) : std::nullopt;
  if (!pixel) {
    bench_.setPointed(std::nullopt);
    return pixel_->clear();
  }
  QString text = widgets::describe(*pixel);
  if (colors != nullptr && colors->frame == frame) {
    const robotlink::YCbCr color = robotlink::pixelYCbCr(colors->seen(), x, y);
    bench_.setPointed(color);
    const std::size_t cell = colortool::ColorTable::cellOf(color);
    const std::uint8_t colorClass = colors->table->classOf(color);
    text += QStringLiteral("   %1").arg(QString::fromStdString(colors->samples.classes.name(colorClass))) +
            marginText(cell) + QStringLiteral("   ") +
            tr("cell %1 %2 %3").arg(color.y >> 2).arg(color.cb >> 2).arg(color.cr >> 2);
  }
  pixel_->setText(text);
}

void ColorImageView::keepChoices() {
  keep(
      "tools", [this] { return toolRow_->saveState(); },
      [this](const QJsonValue& value) { toolRow_->restoreState(value.toObject()); });
  keep("two", twoPictures_);
  keep("strokes", showStrokes_);
  keep("strip", showStrip_);
  keep("right", rightLayer_);
  keep("stream", streams_);
}

}  // namespace widgets
