// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/PropertiesView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "robotcontrol/World.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/world/ObjectPose.h"
#include "widgets/world/SceneSelection.h"

namespace widgets {
namespace {

const ViewRegistration kPropertiesRegistration{
    {"scene-properties", QT_TRANSLATE_NOOP("View", "Properties"),
     QT_TRANSLATE_NOOP("View", "Pose, mass, size, friction and noise of the selected object of the scene"),
     "settings", false, create<PropertiesView>}};

/// Asks to place a model at a pose of which a number was changed.
robotcontrol::Request requestFor(const std::string& model, const ObjectPose& pose, int index) {
  robotcontrol::Request request;
  auto& details = *request.mutable_place_model();
  details.set_model(model);
  details.mutable_pose_in_field()->set_x(pose[0]);
  details.mutable_pose_in_field()->set_y(pose[1]);
  details.mutable_pose_in_field()->set_heading(pose[5]);
  // Otherwise it keeps its height and how it is tilted.
  if (index >= 2 && index <= 4) {
    details.set_height(pose[2]);
    details.set_roll(pose[3]);
    details.set_pitch(pose[4]);
  }
  return request;
}

}  // namespace

PropertiesView::PropertiesView(ViewContext& context, QWidget* parent)
    : View(context, parent), selection_(sceneSelection(context)) {
  setObjectName(QStringLiteral("propertiesView"));
  createActions();
  createViews();
  connectSignals();
  keep("columns", table_->horizontalHeader());
  showEdits();
  tick();
}

PropertiesView::~PropertiesView() = default;

void PropertiesView::createActions() {
  save_ =
      makeAction(this, "save",
                 {"propertiesSave", tr("Save to file"),
                  tr("Writes only the changed properties into the files of the scene"), tr("Ctrl+Return")});
  discard_ = makeAction(this, "undo", {"propertiesDiscard", tr("Discard"), tr("Discards unsaved changes")});
  keepPose_ =
      makeAction(this, "goal",
                 {"propertiesKeepPose", tr("Keep pose"),
                  tr("Makes the model's present pose its initial one, saved with the other changes")});
}

void PropertiesView::createViews() {
  title_ = new QLabel(this);
  describe(*title_, {"propertiesObject", tr("Selected object"), {}});
  title_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  table_ = makeTable(this, {"propertiesTable", tr("Properties"), {}}, &model_);
  table_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  using enum ColumnKind;
  new ColumnFit(*table_, {kName, kText, kNumber});
  hint_ = new EmptyHint(table_);
  outcome_ = makeNote(this, "propertiesOutcome", tr("Result of the changes"));
  auto* row = new QHBoxLayout;
  row->addWidget(title_, 1);
  for (QAction* action : {keepPose_, discard_, save_}) row->addWidget(makeLabeledButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addLayout(row);
  layout->addWidget(table_, 1);
  layout->addWidget(outcome_);
}

void PropertiesView::connectSignals() {
  connect(&selection_, &SceneSelection::changed, this, &PropertiesView::tick);
  connect(&model_, &PropertiesModel::poseEdited, this, &PropertiesView::place);
  connect(&model_, &PropertiesModel::editsChanged, this, &PropertiesView::showEdits);
  connect(save_, &QAction::triggered, this, &PropertiesView::save);
  connect(&model_, &PropertiesModel::refused, this,
          [this](const QString& reason) { showOutcome(*outcome_, reason, true); });
  connect(discard_, &QAction::triggered, this, [this] {
    model_.forgetTaken();
    if (edits().canChange()) return report(edits().undo(), tr("Undone."));
    model_.clearEdits();
    tick();
  });
  connect(&edits(), &SceneEdits::historyChanged, this, &PropertiesView::showEdits);
  connect(&sceneBench(context()), &SceneBench::filesChanged, this, &PropertiesView::showEdits);
  connect(keepPose_, &QAction::triggered, this, &PropertiesView::keepPose);
}

SceneEdits& PropertiesView::edits() const {
  return sceneEdits(context());
}

void PropertiesView::report(const robotlink::Result<void>& done, const QString& text) {
  showOutcome(*outcome_, done ? text : QString::fromStdString(done.error().describe()), !done);
}

const robotcontrol::WorldObject* PropertiesView::object() const {
  if (!objects_) return nullptr;
  const auto found =
      std::ranges::find(objects_->objects(), selection_.object(), &robotcontrol::WorldObject::path);
  return found == objects_->objects().end() ? nullptr : &*found;
}

std::vector<const robotcontrol::WorldObject*> PropertiesView::parts(
    const robotcontrol::WorldObject& object) const {
  using robotcontrol::WorldObject;
  std::vector<const WorldObject*> parts;
  if (!object.parent().empty()) return parts;
  for (const WorldObject& other : objects_->objects()) {
    const auto kind = other.kind();
    if (other.model() == object.path() &&
        (kind == WorldObject::LINK || kind == WorldObject::SHAPE || kind == WorldObject::SOLID))
      parts.push_back(&other);
  }
  if (std::ranges::count(parts, WorldObject::LINK, &WorldObject::kind) != 1) parts.clear();
  return parts;
}

std::optional<ObjectPose> PropertiesView::pose(const robotcontrol::WorldObject& object) {
  const auto pose = worldPose(object, scene_);
  return pose ? std::optional(objectPose(*pose)) : std::nullopt;
}

void PropertiesView::tick() {
  const auto& store = session().store();
  const auto* message = store.latest(robotlink::streams::kObjects, session().timeline().newest());
  const robotlink::PackagePtr value = message == nullptr ? nullptr : message->value;
  if (value != objects_) {
    objects_ = std::dynamic_pointer_cast<const robotcontrol::WorldObjects>(value);
    if (!edits().isBusy()) model_.forgetTaken();
  }
  scene_.update(store, session().timeline().shown());
  const auto* shown = object();
  title_->setText(shown == nullptr ? QString() : QString::fromStdString(shown->path()));
  const bool canWrite = edits().canChange() || context().writeScene != nullptr;
  keepPose_->setEnabled(shown != nullptr && shown->is_movable() && canWrite);
  hint_->setHint(shown != nullptr ? QString()
                 : objects_
                     ? tr("Nothing is selected: click an object in the view Scene tree, or a robot in Scene.")
                     : tr("No objects: start a simulation (File > Open scene…)."));
  // A number that is being typed must not be replaced.
  if (table_->findChild<QLineEdit*>() != nullptr && table_->findChild<QLineEdit*>()->hasFocus()) return;
  if (shown == nullptr) return model_.show(nullptr, std::nullopt, canWrite);
  model_.show(shown, pose(*shown), canWrite, parts(*shown));
}

void PropertiesView::place(int index, double value) {
  const auto* moved = object();
  auto wanted = moved == nullptr ? std::nullopt : pose(*moved);
  if (!wanted) return;
  (*wanted)[static_cast<std::size_t>(index)] = value;
  const ObjectPose before = *pose(*moved);
  const std::string& model = moved->model();
  const robotcontrol::Request request = requestFor(model, *wanted, index);
  edits().addRequests(tr("Move %1").arg(QString::fromStdString(model)), requestFor(model, before, index),
                      request);
  ask(session(), {}, request, this, [this](bool accepted, const QString& reason) {
    showOutcome(*outcome_, accepted ? QString() : tr("It cannot be placed there: %1").arg(reason), !accepted);
  });
}

void PropertiesView::keepPose() {
  const auto* kept = object();
  const auto now = kept == nullptr ? std::nullopt : pose(*kept);
  if (!now) return;
  if (edits().canChange())
    return edits().setPose(kept->path(), *now, told(tr("This is now its initial pose; save to keep that.")));
  const auto initial =
      std::ranges::find(kept->properties(), "initial_pose", &robotcontrol::WorldProperty::name);
  if (initial == kept->properties().end() || initial->file().empty()) {
    showOutcome(*outcome_, tr("The scene's file does not set the initial pose of %1.").arg(title_->text()),
                true);
    return;
  }
  model_.addEdit({initial->file(), {initial->element().begin(), initial->element().end()}, poseText(*now)});
  tick();
}

void PropertiesView::save() {
  if (edits().canChange()) {
    report(sceneBench(context()).saveAll(), tr("Saved."));
    return showEdits();
  }
  if (!context().writeScene) return;
  const auto done = context().writeScene(model_.edits());
  if (done) model_.clearEdits();
  showOutcome(*outcome_,
              done ? tr("Saved. It takes effect when the scene is opened again.")
                   : QString::fromStdString(done.error().describe()),
              !done);
  tick();
}

void PropertiesView::applyEdits() {
  const auto changes = model_.takeEdits();
  edits().change(changes, tr("Change %1").arg(title_->text()),
                 told(tr("The simulation uses it now; save to keep it.")));
  tick();
}

SceneEdits::Told PropertiesView::told(const QString& text) {
  // The view may be closed meanwhile.
  return [view = QPointer<PropertiesView>(this), text](const robotlink::Result<std::string>& object) {
    const bool isDropped = !object && object.error().id == SceneEdits::kDropped;
    if (!view || isDropped) return;
    if (!object) view->model_.forgetTaken();
    view->report(object.map([](const std::string&) {}), text);
  };
}

void PropertiesView::showEdits() {
  const bool hasEdits = !model_.edits().empty(), canChange = edits().canChange();
  if (hasEdits && canChange) return applyEdits();
  save_->setEnabled(canChange ? sceneBench(context()).hasUnsaved()
                              : hasEdits && context().writeScene != nullptr);
  discard_->setEnabled(canChange ? edits().canUndo() : hasEdits);
  discard_->setText(canChange ? tr("Undo") : tr("Discard"));
  discard_->setToolTip(canChange ? tr("Undoes: %1").arg(edits().undoTitle())
                                 : tr("Discards unsaved changes"));
}

}  // namespace widgets
