// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/overview/RobotsView.h"

#include <QListView>
#include <QScrollBar>
#include <QStyle>
#include <algorithm>

#include "robotlink/packages/Packages.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/ShownText.h"
#include "widgets/TypedStreams.h"
#include "widgets/overview/RobotCardDelegate.h"

namespace widgets {
namespace {

const ViewRegistration kRobotsViewRegistration{
    {"robots", QT_TRANSLATE_NOOP("View", "Robots"),
     QT_TRANSLATE_NOOP("View", "Shows all robots with image, state, battery and link; a click selects one."),
     "robot", false, create<RobotsView>}};

constexpr int kCardImageHeight = 300;

/// The stream of a robot's images: those of its camera, else the first that has images; null if none has.
const robotlink::StreamStore::Stream* imagesOf(const robotlink::StreamStore& store,
                                               const std::string& robot) {
  if (const auto* camera = store.find(robot + '/' + robotlink::kCameraImage.name)) return camera;
  for (const auto* stream : store.streams(robot + '/')) {
    if (stream->type != "foxglove.RawImage" && stream->type != "foxglove.CompressedImage") continue;
    store.noteRead(*stream);
    return stream;
  }
  return nullptr;
}

}  // namespace

RobotsView::RobotsView(ViewContext& context, QWidget* parent)
    : View(context, parent), delegate_(new RobotCardDelegate(model_, this)) {
  setObjectName(QStringLiteral("robotsView"));
  list_ = new QListView(this);
  describe(*list_, {"robotsList", tr("Robots"), {}});
  list_->setModel(&model_);
  list_->setItemDelegate(delegate_);
  list_->setFlow(QListView::LeftToRight);
  list_->setWrapping(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setMovement(QListView::Static);
  list_->setUniformItemSizes(true);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  list_->setSelectionMode(QAbstractItemView::SingleSelection);
  list_->setFrameShape(QFrame::NoFrame);
  list_->viewport()->setBackgroundRole(QPalette::Window);
  list_->setMouseTracking(true);
  hint_ = new EmptyHint(list_);
  makeColumn(this)->addWidget(list_);
  setFocusProxy(list_);
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) {
            if (isFollowing_ || !current.isValid()) return;
            session().selectRobot(model_.row(current.row()).robot);
            tick();
          });
}

RobotsView::~RobotsView() {
  subscription_.release(session());
}

void RobotsView::hideEvent(QHideEvent* event) {
  subscription_.release(session());
  View::hideEvent(event);
}

void RobotsView::resizeEvent(QResizeEvent* event) {
  View::resizeEvent(event);
  fit();
}

void RobotsView::fit() {
  // The list leaves room for its scroll bar, whether or not that is there.
  const int bar = style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, list_->verticalScrollBar());
  const QSize room = list_->contentsRect().size() - QSize(2 + bar, 2);
  if (delegate_->fit(model_.rowCount(), room, list_->fontMetrics())) list_->doItemsLayout();
}

void RobotsView::addImage(RobotCard& card) {
  const auto& store = session().store();
  const auto* stream = imagesOf(store, card.robot);
  const auto* message =
      stream == nullptr ? nullptr : store.latest(stream->path, session().timeline().shown());
  if (message == nullptr) {
    card.noImage = stream == nullptr ? tr("no camera image") : tr("no image at this time");
    return;
  }
  card.image = thumbnails_.of(stream->path, message->value, kCardImageHeight);
  if (card.image.isNull()) card.noImage = tr("the image cannot be shown");
}

void RobotsView::followSelection() {
  const int row = model_.rowOf(session().selectedRobot());
  if (row == list_->currentIndex().row()) return;
  isFollowing_ = true;
  list_->setCurrentIndex(model_.index(row, 0));
  isFollowing_ = false;
}

std::optional<QString> RobotsView::numbers() {
  TabTable table({QStringLiteral("robot"), QStringLiteral("kind"), QStringLiteral("state"),
                  QStringLiteral("behavior"), QStringLiteral("battery"), QStringLiteral("link")});
  for (int row = 0; row < model_.rowCount(); ++row) {
    const RobotCard& card = model_.row(row);
    const bool hasBattery = card.battery.state != BatteryLevel::State::kUnknown;
    table.add({QString::fromStdString(card.robot), card.kind, card.state.text, card.behavior.text,
               hasBattery ? card.battery.text() : QString(), card.link.text});
  }
  return table.text();
}

void RobotsView::tick() {
  thumbnails_.tick();
  std::vector<RobotCard> cards;
  for (const std::string& robot : session().robots()) {
    if (isVisible()) {
      subscription_.want(session(), robot,
                         {robotlink::kCameraImage.name, robotlink::kDriveState.name,
                          robotlink::kLinkStatus.name, robotlink::kBodyReadings.name});
    }
    cards.push_back(robotCard(context(), robot, session().timeline().shown()));
    addImage(cards.back());
  }
  isFollowing_ = true;
  model_.setCards(std::move(cards));
  isFollowing_ = false;
  fit();
  followSelection();
  hint_->setHint(model_.rowCount() > 0 ? QString()
                 : hasForeignStreams(session().store())
                     ? tr("There is no description of this log's robot. Its contents are shown in the "
                          "views Data, Plots, "
                          "Field and Scene.")
                     : tr("There is no robot.\nStart a simulation, connect to a robot, or open "
                          "a log with File > Open log…"));
}

}  // namespace widgets
