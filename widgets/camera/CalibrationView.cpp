// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/CalibrationView.h"

#include <QAction>
#include <QComboBox>
#include <QHBoxLayout>
#include <QJsonArray>
#include <QLabel>
#include <QMouseEvent>
#include <QPointer>
#include <QTabWidget>

#include "robotcontrol/Requests.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/drawing/Drawings.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/Requests.h"
#include "widgets/camera/LensPanel.h"
#include "widgets/camera/PlacePanel.h"
#include "widgets/camera/SettingsPanel.h"
#include "widgets/image/CompareRow.h"
#include "widgets/image/ImageCanvas.h"
#include "widgets/image/ImageHint.h"
#include "widgets/image/ImagePixels.h"
#include "widgets/image/RawPicture.h"
#include "widgets/image/StreamSelector.h"
#include "widgets/solutions/ParameterEdits.h"

namespace widgets {
namespace {

const ViewRegistration kCalibrationViewRegistration{
    {"camera", QT_TRANSLATE_NOOP("View", "Camera"),
     QT_TRANSLATE_NOOP("View",
                       "Calibrates a camera: its lens with a chessboard, its pose with a board or field "
                       "marks; and sets its exposure, gain and white balance"),
     "camera", false, create<CalibrationView>}};

constexpr char kDefaultStream[] = "*/camera/image";
constexpr char kTask[] = "camera-pose";
/// The distance that the mouse may move between press and release of a click, pixels.
constexpr double kClickPixels = 4;
constexpr int kCalibrationPanelWidth = 380;

using robotlink::Vector2;

}  // namespace

CalibrationView::CalibrationView(ViewContext& context, QWidget* parent)
    : PictureView(context, "camera", "camera.png", parent),
      parameters_(new ParameterEdits(context.session, this)),
      finder_([this](Search wanted, const auto&) { search(std::move(wanted)); }),
      fitter_([this](const Question& asked, const auto&) { compute(asked); }) {
  marks_ = new MarkModel(this);
  canvas_ = new ImageCanvas(this);
  canvas_->installEventFilter(this);
  QHBoxLayout* row = makeToolRow(this);
  streams_ = new StreamSelector("foxglove.RawImage", QLatin1String(kDefaultStream), row->parentWidget());
  describe(*streams_, {"cameraStream", tr("Image stream"), tr("Which camera is calibrated")});
  row->addWidget(streams_, 1);
  QAction* fit = makeFit(tr("Fits the whole image into the view"));
  connect(fit, &QAction::triggered, this, [this] { canvas_->setViewport({}); });
  addButtons(row, {fit, zoomOut(), zoomIn()});
  QHBoxLayout* footer = makeFooter(this);
  time_ = addLabel(footer, "cameraTime", tr("Time of the image"));
  state_ = addWideLabel(footer, "cameraState", tr("What the camera sees"));
  Side side;
  side.widget = createTabs();
  side.width = kCalibrationPanelWidth;
  assemble({row->parentWidget()}, canvas_, side, {footer->parentWidget()});
  addToContextMenu(canvas_);
  connectSignals();
  keepChoices();
  placeByMarks();
  tick();
}

CalibrationView::~CalibrationView() = default;

void CalibrationView::search(Search wanted) {
  auto corners = robotlink::findChessboard(robotlink::imageView(*wanted.image), wanted.board);
  finder_.publish({std::move(wanted), std::move(corners)});
}

void CalibrationView::compute(const Question& asked) {
  Answer answer;
  if (const auto& views = asked.lens)
    answer.lens = robotlink::fitLens(views->views(), views->board(), views->width(), views->height());
  else if (!asked.corners.empty())
    answer.place = robotlink::fitPlaceAboveBoard(asked.corners, asked.board, asked.knownLens);
  else
    answer.place = robotlink::fitPlace(asked.points, asked.pixels, asked.knownLens);
  fitter_.publish(std::move(answer));
}

QTabWidget* CalibrationView::createTabs() {
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName(QStringLiteral("cameraTabs"));
  lensPanel_ = new LensPanel(tabs_);
  placePanel_ = new PlacePanel(*marks_, tabs_);
  tabs_->addTab(makeScrollArea(tabs_, lensPanel_), tr("Lens"));
  tabs_->addTab(makeScrollArea(tabs_, placePanel_), tr("Place"));
  settingsPanel_ = new SettingsPanel(tabs_);
  tabs_->addTab(makeScrollArea(tabs_, settingsPanel_), tr("Settings"));
  return tabs_;
}

void CalibrationView::connectSignals() {
  connect(streams_, &StreamSelector::choiceChanged, this, [this] {
    views_.clear();
    fitLens();
  });
  for (QAction* take : {lensPanel_->take, placePanel_->take}) addAction(take);
  connect(lensPanel_->take, &QAction::triggered, this, &CalibrationView::takeView);
  connect(lensPanel_->remove, &QAction::triggered, this, [this] {
    if (lensPanel_->selected() >= 0) views_.remove(static_cast<std::size_t>(lensPanel_->selected()));
    fitLens();
  });
  connect(lensPanel_->clear, &QAction::triggered, this, [this] {
    views_.clear();
    fitLens();
  });
  connect(lensPanel_->use, &QAction::triggered, this, [this] {
    if (!lensFit_) return;
    useAsParameters({{"horizontal_angle", lensFit_->lens.horizontalAngle()},
                     {"vertical_angle", lensFit_->lens.verticalAngle()}},
                    lensPanel_->outcome());
  });
  connect(placePanel_->choice(), QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    isShown_ = false;
    placePanel_->show({}, tr("Nothing is computed yet."));
    placeByMarks();
  });
  connect(placePanel_->take, &QAction::triggered, this, &CalibrationView::placeByBoard);
  connect(placePanel_->remove, &QAction::triggered, this, [this] {
    marks_->pick(placePanel_->selected(), std::nullopt);
    placeByMarks();
  });
  connect(placePanel_->clear, &QAction::triggered, this, [this] {
    marks_->clear();
    placeByMarks();
  });
  connect(placePanel_->use, &QAction::triggered, this, [this] {
    const auto& fit = placePanel_->fit();
    if (!fit) return;
    useAsParameters({{"height", fit->height()}, {"tilt", fit->tilt()}, {"roll", fit->roll()}},
                    placePanel_->outcome());
  });
  connect(settingsPanel_, &SettingsPanel::wanted, this, &CalibrationView::setCamera);
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { isShown_ = false; });
}

void CalibrationView::keepChoices() {
  keep("stream", streams_);
  keep(
      "board",
      [this] {
        const auto board = lensPanel_->board();
        return QJsonArray{board.columns, board.rows, board.square};
      },
      [this](const QJsonValue& value) {
        const QJsonArray board = value.toArray();
        if (board.size() == 3)
          lensPanel_->setBoard({board[0].toInt(), board[1].toInt(), board[2].toDouble()});
      });
  keep("placeBy", placePanel_->choice());
  keep(
      "marks", [this] { return marks_->save(); },
      [this](const QJsonValue& value) {
        marks_->restore(value.toObject());
        placeByMarks();
      });
  keep(
      "tab", [this] { return tabs_->currentIndex(); },
      [this](const QJsonValue& value) { tabs_->setCurrentIndex(value.toInt()); });
}

std::string CalibrationView::robot() const {
  return drawingRobot(streams_->path(session()));
}

bool CalibrationView::shows(const QWidget* panel) const {
  return tabs_->currentWidget()->isAncestorOf(panel);
}

bool CalibrationView::picksMarks() const {
  return shows(placePanel_) && placePanel_->by() == PlacePanel::By::kMarks;
}

bool CalibrationView::looksForBoard() const {
  return shows(lensPanel_) || (shows(placePanel_) && !picksMarks());
}

void CalibrationView::subscribe() {
  subscription_.want(session(), robot(), {robotlink::kCameraPose.name, robotlink::kCameraImage.name});
  if (!shows(settingsPanel_)) return;
  settingsSubscription_.want(session(), robot(), {robotlink::kCameraSettings.name});
  settingsPanel_->show(session().store().latestAs<robotcontrol::CameraSettings>(
      robot() + "/" + robotlink::kCameraSettings.name, session().timeline().shown()));
}

void CalibrationView::setCamera(const QString& setting, double value) {
  robotcontrol::Request request;
  request.mutable_set_camera()->set_setting(setting.toStdString());
  request.mutable_set_camera()->set_value(value);
  QLabel& outcome = settingsPanel_->outcome();
  ask(session(), robot(), std::move(request), this, [&outcome](bool accepted, const QString& reason) {
    showOutcome(outcome, accepted ? QString() : tr("Refused: %1").arg(reason), !accepted);
  });
}

/// The view may be there before the field.
void CalibrationView::followField() {
  if (context().field == field_) return;
  field_ = context().field;
  marks_->setMarks(field_ ? fieldMarks(*field_) : std::vector<FieldMark>());
  placeByMarks();
}

void CalibrationView::tick() {
  followField();
  if (streams_->refresh(session()))
    Q_EMIT titleChanged(tr("Camera: %1").arg(QString::fromStdString(streams_->path(session()))));
  subscribe();
  const auto* message = session().store().latest(streams_->path(session()), session().timeline().shown());
  auto image =
      message == nullptr ? nullptr : std::dynamic_pointer_cast<const foxglove::RawImage>(message->value);
  if (image != image_) {
    image_ = std::move(image);
    isShown_ = false;
    time_->setText(image_ ? timeText(message->time) : QString());
  }
  takeFound();
  takeAnswer();
  if (waitsForLens_ && lens()) placeByMarks();
  if (image_ && looksForBoard() && (image_ != searched_ || lensPanel_->board() != searchedBoard_))
    finder_.postIfFree({image_, lensPanel_->board()});
  if (!isShown_) showImage();
}

void CalibrationView::takeFound() {
  auto found = finder_.take();
  if (!found) return;
  searched_ = found->search.image;
  searchedBoard_ = found->search.board;
  problem_ = found->corners ? QString() : QString::fromStdString(found->corners.error().text);
  corners_ = found->corners && *found->corners ? **found->corners : Corners();
  isShown_ = false;
  if (shows(lensPanel_) && lensPanel_->automatic->isChecked() && !corners_.empty() && views_.isNew(corners_))
    takeView();
}

void CalibrationView::takeView() {
  if (corners_.empty() || searched_ == nullptr) {
    showOutcome(lensPanel_->outcome(), tr("The whole board is not seen."), true);
    return;
  }
  showOutcome(lensPanel_->outcome(), {}, false);
  views_.add(corners_, searchedBoard_, static_cast<int>(searched_->width()),
             static_cast<int>(searched_->height()));
  fitLens();
}

void CalibrationView::fitLens() {
  lensFit_.reset();
  lensPanel_->show(views_, lensFit_);
  isShown_ = false;
  if (views_.views().size() >= robotlink::kMinBoardViews) fitter_.post({.lens = views_});
}

std::optional<robotlink::LensModel> CalibrationView::lens() const {
  if (!image_) return std::nullopt;
  const auto width = static_cast<int>(image_->width()), height = static_cast<int>(image_->height());
  if (lensFit_ && lensFit_->lens.width == width && lensFit_->lens.height == height) return lensFit_->lens;
  const auto* pose = session().store().latestAs<robotcontrol::CameraPose>(
      robot() + "/" + robotlink::kCameraPose.name, session().timeline().shown());
  if (pose == nullptr || pose->horizontal_angle() <= 0) return std::nullopt;
  return robotlink::LensModel::fromAngle(width, height, pose->horizontal_angle());
}

void CalibrationView::placeByBoard() {
  const auto known = lens();
  if (!known) return placePanel_->show({}, tr("Calibrate the lens first: its opening angle is not known."));
  if (corners_.empty()) return placePanel_->show({}, tr("The whole board is not seen."));
  fitter_.post({.knownLens = *known, .board = searchedBoard_, .corners = corners_});
}

void CalibrationView::placeByMarks() {
  isShown_ = waitsForLens_ = false;
  if (placePanel_->by() != PlacePanel::By::kMarks) return;
  Question question;
  for (const PickedMark& mark : marks_->marks()) {
    if (!mark.pixel) continue;
    question.points.push_back(mark.mark.place);
    question.pixels.emplace_back(mark.pixel->x(), mark.pixel->y());
  }
  if (question.points.size() < robotlink::kMinPlacePoints)
    return placePanel_->show(
        {}, tr("Select a mark and click it in the image; you need at least %1, not all on one line.")
                .arg(robotlink::kMinPlacePoints));
  const auto known = lens();
  waitsForLens_ = !known;
  if (!known) return placePanel_->show({}, tr("Calibrate the lens first: its opening angle is not known."));
  question.knownLens = *known;
  fitter_.post(std::move(question));
}

void CalibrationView::takeAnswer() {
  auto answer = fitter_.take();
  if (!answer) return;
  if (answer->lens) {
    const auto& fit = *answer->lens;
    // Views may have been removed meanwhile.
    if (fit && fit->viewErrors.size() == views_.views().size()) lensFit_ = *fit;
    lensPanel_->show(views_, lensFit_);
    if (!fit) showOutcome(lensPanel_->outcome(), QString::fromStdString(fit.error().text), true);
  }
  if (answer->place) {
    const auto& fit = *answer->place;
    placePanel_->show(fit ? std::optional(*fit) : std::nullopt,
                      fit ? QString() : QString::fromStdString(fit.error().text));
    if (fit && placePanel_->by() == PlacePanel::By::kMarks) marks_->setErrors(fit->errors);
  }
}

void CalibrationView::showImage() {
  isShown_ = true;
  canvas_->setHint(hint());
  ImagePicture picture;
  std::vector<robotlink::PackagePtr> keep;
  if (image_) {
    picture.pixels = rawPicture(*image_);
    auto annotations = std::make_shared<foxglove::ImageAnnotations>();
    robotlink::ImageDrawing drawing(*annotations);
    if (looksForBoard()) {
      for (const Corners& view : views_.views())
        if (shows(lensPanel_) && !view.empty()) drawing.dot(view.front(), robotlink::colors::kSkyBlue, 4);
      for (std::size_t i = 1; i < corners_.size(); ++i)
        drawing.line(corners_[i - 1], corners_[i], robotlink::colors::kGreen);
      for (const Vector2& corner : corners_) drawing.dot(corner, robotlink::colors::kRed, 5);
    } else if (picksMarks()) {
      for (const PickedMark& mark : marks_->marks()) {
        if (!mark.pixel) continue;
        const Vector2 at(mark.pixel->x(), mark.pixel->y());
        drawing.dot(at, robotlink::colors::kPink, 6);
        drawing.text(at, mark.mark.name().toStdString(), robotlink::colors::kPink);
      }
    }
    picture.drawings.push_back({annotations.get()});
    keep = {annotations};
  }
  canvas_->setPicture(std::move(picture), std::move(keep));
  state_->setText(!looksForBoard()      ? QString()
                  : !problem_.isEmpty() ? problem_
                  : corners_.empty()    ? tr("no board is seen")
                                        : tr("a board is seen"));
}

QString CalibrationView::hint() const {
  if (session().robots().empty())
    return tr("No camera. Open one with Robot > Open a Camera…, or a robot or a log that has images.");
  return imageHint(context(), streams_->path(session()));
}

bool CalibrationView::eventFilter(QObject* watched, QEvent* event) {
  const bool picks = watched == canvas_ && image_ != nullptr && picksMarks();
  if (picks && event->type() == QEvent::MouseButtonPress) {
    const auto* press = static_cast<QMouseEvent*>(event);
    pressed_ = press->button() == Qt::LeftButton ? std::optional(press->localPos()) : std::nullopt;
  } else if (picks && event->type() == QEvent::MouseButtonRelease && pressed_) {
    const QPointF at = static_cast<QMouseEvent*>(event)->localPos();
    const QPointF way = at - *std::exchange(pressed_, std::nullopt);
    // A longer way moves the picture.
    if (std::hypot(way.x(), way.y()) <= kClickPixels) pickAt(at);
  }
  return PictureView::eventFilter(watched, event);
}

void CalibrationView::pickAt(const QPointF& canvas) {
  const QPointF pixel = canvas_->imageAt(canvas);
  if (!QRectF(0, 0, image_->width(), image_->height()).contains(pixel)) return;
  const int row = placePanel_->selected();
  if (row < 0) return showOutcome(placePanel_->outcome(), tr("Select a mark first."), true);
  showOutcome(placePanel_->outcome(), {}, false);
  marks_->pick(row, pixel);
  placePanel_->select(marks_->nextFree(row));
  placeByMarks();
}

void CalibrationView::useAsParameters(const std::map<std::string, double>& values, QLabel& outcome) {
  if (robot() != session().selectedRobot())
    return showOutcome(outcome, tr("Select %1 first.").arg(QString::fromStdString(robot())), true);
  const auto set = std::make_shared<QStringList>();
  showOutcome(outcome, tr("Sending…"), false);
  for (const auto& [name, value] : values) {
    // Only the robot knows which of them its active solution has.
    parameters_->requestValue(
        kTask, name, [self = QPointer(this), name = name, value = value, set, &outcome](const auto& known) {
          if (!self) return;
          if (!known) {
            if (set->isEmpty())
              showOutcome(outcome,
                          tr("The robot's solution of camera-pose has no parameter for it; “mounted” has."),
                          true);
            return;
          }
          if (const auto sent = self->parameters_->set(kTask, name, std::to_string(value)); !sent)
            return showOutcome(outcome, QString::fromStdString(sent.error().text), true);
          *set << QString::fromStdString(name);
          showOutcome(outcome, tr("Set: %1. Save them in Solutions.").arg(set->join(QStringLiteral(", "))),
                      false);
        });
  }
}

}  // namespace widgets
