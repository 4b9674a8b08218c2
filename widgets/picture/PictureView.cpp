// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/picture/PictureView.h"

#include <QAction>
#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "robotlink/base/Spelling.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/ShownText.h"
#include "widgets/SplitterState.h"
#include "widgets/WrittenPicture.h"
#include "widgets/drawings/DrawingPose.h"
#include "widgets/drawings/DrawingsModel.h"
#include "widgets/drawings/DrawingsPanel.h"
#include "widgets/picture/PoseMenu.h"
#include "widgets/picture/ViewPicture.h"

namespace widgets {
namespace {

constexpr int kPictureWidth = 420, kDrawingsWidth = 230;  // pixels, before the user divides the view
const double kPictureZoomStep = std::sqrt(2.0);

}  // namespace

PictureView::PictureView(ViewContext& context, const char* name, const char* file, QWidget* parent)
    : View(context, parent), name_(name), file_(QString::fromLatin1(file)) {
  setObjectName(QString::fromLatin1(named("View")));
  zoomIn_ =
      makeAction(this, "zoom-in", {named("ZoomIn").constData(), tr("Zoom in"), tr("Zooms in"), Qt::Key_Plus});
  zoomOut_ = makeAction(this, "zoom-out",
                        {named("ZoomOut").constData(), tr("Zoom out"), tr("Zooms out"), Qt::Key_Minus});
  copy_ = makeAction(
      this, "copy",
      {named("Copy").constData(), tr("Copy picture"), tr("Copies this picture"), QKeySequence::Copy});
  copyNumbers_ = makeAction(this, "copy",
                            {named("CopyNumbers").constData(), tr("Copy numbers"),
                             tr("Copies the numbers that are shown here, with tabs between the columns")});
  save_ = makeAction(this, "save",
                     {named("Save").constData(), tr("Save picture..."), tr("Saves this picture as PNG"),
                      QKeySequence(QStringLiteral("Ctrl+Shift+E"))});
  export_ = makeAction(this, "video",
                       {named("Export").constData(), tr("Video or images…"),
                        tr("Writes this picture over time, as a video or as a series of images")});
  connect(export_, &QAction::triggered, this, &View::exportWanted);
  connect(zoomIn_, &QAction::triggered, this, [this] { zoomBy_(kPictureZoomStep); });
  connect(zoomOut_, &QAction::triggered, this, [this] { zoomBy_(1 / kPictureZoomStep); });
  connect(copy_, &QAction::triggered, this, [this] { copyPicture(rendered_()); });
  connect(copyNumbers_, &QAction::triggered, this, [this] {
    if (const auto table = numbers()) QGuiApplication::clipboard()->setText(*table);
  });
  connect(save_, &QAction::triggered, this, [this] { savePictureAs(this, rendered_(), file_); });
}

QAction* PictureView::makeFit(const QString& toolTip) {
  return makeAction(this, "fit", {named("Fit").constData(), tr("Fit"), toolTip, Qt::Key_F});
}

QAction* PictureView::makeFreeze() {
  return makeToggle(this, "lock",
                    {named("Freeze").constData(), tr("Freeze"),
                     tr("Freezes this image while the robot continues"), Qt::Key_H});
}

PictureView::Side PictureView::makeDrawings(const QStringList& kinds) {
  drawings_ = new DrawingsModel(kinds, this);
  keep(
      "drawings", [this] { return drawings_->saveState(); },
      [this](const QJsonValue& value) { drawings_->restoreState(value.toObject()); });
  QAction* toggle = makeToggle(
      this, "layers",
      {named("Drawings").constData(), tr("Drawings"), tr("Shows the list of drawings"), Qt::Key_D});
  return {new DrawingsPanel(*drawings_, this), toggle, kDrawingsWidth};
}

robotlink::Result<void> PictureView::showDrawing(const std::string& name, bool shown) {
  if (drawings_ == nullptr)
    return robotlink::failure("view.drawings", "this view has no list of drawings", {}, {name});
  tick();  // lists what there is now
  if (drawings_->setShown(QString::fromStdString(name), shown)) return {};
  std::vector<std::string> known;
  for (const QString& each : drawingNames()) known.push_back(each.toStdString());
  return robotlink::failure("view.drawing",
                            "there is no drawing " + name + robotlink::suggestion(name, known), {}, {name});
}

QStringList PictureView::drawingNames() const {
  return drawings_ == nullptr ? QStringList() : drawings_->names();
}

void PictureView::addPoses(QHBoxLayout* row) {
  QAction* open =
      makeAction(this, "point",
                 {named("Pose").constData(), tr("Pose of drawings"),
                  tr("Chooses at which pose of the robot its drawings are placed: the true one or "
                     "an estimate")});
  QToolButton* button = makeButton(row->parentWidget(), open);
  poses_ = new PoseMenu(QString::fromLatin1(named("PoseMenu")), this);
  button->setMenu(poses_);
  button->setPopupMode(QToolButton::InstantPopup);
  connect(open, &QAction::triggered, button, &QToolButton::showMenu);
  connect(poses_, &PoseMenu::choiceChanged, this, &PictureView::tick);
  row->addWidget(button);
  keep("pose", poses_, Names::kNone);
}

robotlink::Result<void> PictureView::choosePose(const std::string& pose) {
  if (poses_ == nullptr)
    return robotlink::failure("view.poses", "this view places no drawings at robots", {}, {pose});
  tick();  // lists what there is now
  std::vector<std::string> known{"default"};
  for (const QString& each : poseNames()) known.push_back(each.toStdString());
  if (std::ranges::find(known, pose) == known.end())
    return robotlink::failure("view.pose", "there is no pose " + pose + robotlink::suggestion(pose, known),
                              {}, {pose});
  poses_->setChoice(pose == "default" ? QString::fromLatin1(kUsualPose) : QString::fromStdString(pose));
  return {};
}

QStringList PictureView::poseNames() const {
  return poses_ == nullptr ? QStringList() : poses_->choices();
}

void PictureView::place(std::initializer_list<QWidget*> above, QWidget* canvas, const Side& side,
                        std::initializer_list<QWidget*> below) {
  const bool halves = side.width == 0;
  QSplitter* splitter = makeSplitter(this, named("Splitter").constData(), Qt::Horizontal,
                                     {{canvas, 1}, {side.widget, halves ? 1 : 0}});
  splitter->setCollapsible(0, false);
  if (halves) splitter->setCollapsible(1, false);
  splitter->setSizes({kPictureWidth, halves ? kPictureWidth : side.width});
  keep("splitter", splitter);
  if (side.toggle != nullptr) {
    side.widget->setVisible(side.toggle->isChecked());
    connect(side.toggle, &QAction::toggled, side.widget, &QWidget::setVisible);
    keep("panel", side.toggle);
  }
  auto* layout = makeColumn(this);
  for (QWidget* row : above) layout->addWidget(row);
  layout->addWidget(splitter, 1);
  for (QWidget* row : below) layout->addWidget(row);
}

void PictureView::addToContextMenu(QWidget* canvas, std::initializer_list<QAction*> others) {
  canvas->setContextMenuPolicy(Qt::ActionsContextMenu);
  canvas->addActions({copy_, copyNumbers_, save_, export_});
  for (QAction* action : others) canvas->addAction(action);
}

QString PictureView::timeText(robotlink::Instant time) const {
  return tr("%1 s").arg(robotlink::seconds(session().timeline().sinceOrigin(time)), 0, 'f', 3);
}

QLabel* PictureView::addWideLabel(QHBoxLayout* row, const char* name, const QString& text) {
  QLabel* label = addLabel(row, name, text);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->setStretchFactor(label, 1);
  return label;
}

QLabel* PictureView::addFiguresLabel(QHBoxLayout* row, const char* name, const QString& text) {
  QLabel* label = addWideLabel(row, name, text);
  label->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  return label;
}

QSize PictureView::shownPictureSize() const {
  return canvas_->size();
}

robotlink::Result<void> PictureView::saveTo(const QString& file) {
  const std::string suffix = robotlink::fileSuffix(file.toStdString());
  if (suffix == ".svg") return writeVectorPicture(*canvas_, file);
  if (suffix == ".csv" || suffix == ".txt" || suffix == ".tsv") {
    const auto table = numbers();
    if (!table)
      return robotlink::failure("view.save", "this view shows no numbers; save it as .png or .svg",
                                {file.toStdString(), 0, 0});
    const QString text = suffix == ".csv" ? csvOfTabs(*table) : *table;
    return robotlink::writeFileAtomically(file.toStdString(), text.toStdString());
  }
  return writePicture(rendered_(), file);
}

bool PictureView::savePicture(const QString& file) {
  return widgets::savePicture(this, rendered_(), file);
}

}  // namespace widgets
