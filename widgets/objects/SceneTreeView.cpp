// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/objects/SceneTreeView.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QInputDialog>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSortFilterProxyModel>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "robotcontrol/World.pb.h"
#include "robotlink/commands/CommandTable.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/objects/ActuatorPanel.h"
#include "widgets/ports/PortNumber.h"
#include "widgets/world/SceneSelection.h"

namespace widgets {
namespace {

const ViewRegistration kSceneTreeRegistration{
    {"scene-tree", QT_TRANSLATE_NOOP("View", "Scene tree"),
     QT_TRANSLATE_NOOP(
         "View", "All objects of a simulated scene, with the values of sensors and sliders for actuators"),
     "layers", false, create<SceneTreeView>}};

/// The maximum number of values of one sensor that are plotted, the first ones.
constexpr int kMaxCurves = 12;
constexpr int kMaxLevels = 100;
constexpr int kTicksUntilHiddenShown = 10;

/// Returns the number of values of a port; images count as none.
int valueCount(const robotcontrol::WorldPort& port) {
  return port.type() == "image" ? 0 : numberCount(port);
}

bool isSensor(const robotcontrol::WorldObject* object) {
  return object != nullptr && object->has_port() && !object->port().is_actuator();
}

}  // namespace

SceneTreeView::SceneTreeView(ViewContext& context, QWidget* parent)
    : View(context, parent), selection_(sceneSelection(context)), filtered_(new QSortFilterProxyModel(this)) {
  setObjectName(QStringLiteral("sceneTreeView"));
  createActions();
  createSceneActions();
  createEditActions();
  createViews();
  connectSignals();
  keep("search", search_);
  keep("columns", tree_->header());
  keep(
      "unfolded",
      [this] {
        QJsonArray paths;
        // Without a scene, the objects that were unfolded before are kept.
        for (const std::string& path : objects_ ? unfolded() : wanted_)
          paths.append(QString::fromStdString(path));
        return QJsonValue(paths);
      },
      [this](const QJsonValue& value) {
        for (const auto& path : value.toArray()) wanted_.insert(path.toString().toStdString());
        if (objects_) unfold(wanted_);
      },
      Names::kObjects);
  tick();
}

SceneTreeView::~SceneTreeView() = default;

void SceneTreeView::createActions() {
  plot_ = makeAction(
      this, "plots",
      {"sceneTreePlot", tr("Plot"),
       tr("Adds the values of the sensor to the view Plots, the first twelve of many"), tr("Ctrl+Alt+L")});
  columns_ = makeAction(this, "samples",
                        {"sceneTreeColumns", tr("Column graph"),
                         tr("Shows the values of the sensor as columns"), tr("Ctrl+Alt+G")});
  image_ = makeAction(
      this, "image", {"sceneTreeImage", tr("Image"), tr("Shows the images of the camera"), tr("Ctrl+Alt+I")});
  gray_ = makeAction(this, "image",
                     {"sceneTreeGray", tr("Monochrome image"), tr("Shows the images of the camera in gray")});
  stereogram_ = makeAction(this, "two-pictures",
                           {"sceneTreeStereogram", tr("Stereogram"),
                            tr("Shows depths as a random-dot stereogram: focus behind it to see them")});
  properties_ = makeAction(
      this, "settings",
      {"sceneTreeProperties", tr("Properties"), tr("Shows the properties of the object"), tr("Alt+Return")});
  copyPath_ = makeAction(
      this, "copy",
      {"sceneTreeCopyPath", tr("Copy path"), tr("Copies the path of the object"), QKeySequence::Copy});
}

void SceneTreeView::createEditActions() {
  goToText_ = makeAction(
      this, "labels",
      {"sceneTreeGoToText", tr("Go to its text"), tr("Shows the object in the scene editor"), tr("Ctrl+G")});
  duplicate_ = makeAction(this, "copy",
                          {"sceneTreeDuplicate", tr("Duplicate"),
                           tr("Adds another one beside it to the scene's text"), tr("Ctrl+D")});
  erase_ = makeAction(
      this, "remove",
      {"sceneTreeErase", tr("Delete"), tr("Removes the object from the scene's text"), QKeySequence::Delete});
  rename_ = makeAction(
      this, "edit",
      {"sceneTreeRename", tr("Rename…"), tr("Renames the object in the scene's text"), Qt::Key_F2});
  connect(goToText_, &QAction::triggered, this, [this] { runForObject("scene.edit", {}); });
  connect(duplicate_, &QAction::triggered, this, [this] { runForObject("scene.copy", {}); });
  connect(erase_, &QAction::triggered, this, [this] { runForObject("scene.erase", {}); });
  connect(rename_, &QAction::triggered, this, &SceneTreeView::rename);
}

void SceneTreeView::rename() {
  const auto* object = selected();
  if (object == nullptr) return;
  const QString before = QString::fromStdString(object->name());
  bool accepted = false;
  const QString name = QInputDialog::getText(this, tr("Rename"), tr("New name of %1:").arg(before),
                                             QLineEdit::Normal, before, &accepted);
  if (accepted && name != before) runForObject("scene.rename", {name.toStdString()});
}

void SceneTreeView::createSceneActions() {
  alone_ =
      makeAction(this, "scene",
                 {"sceneTreeAlone", tr("Show in 3-D"),
                  tr("Opens a view that shows only this object and everything in it"), tr("Ctrl+Alt+3")});
  around_ = makeAction(this, "scene",
                       {"sceneTreeAround", tr("Show in 3-D with surroundings"),
                        tr("Opens a view of the scene that looks at this object and follows it")});
  hide_ = makeAction(this, "clear",
                     {"sceneTreeHide", tr("Hide in 3-D"),
                      tr("Hides the object and everything in it in views of the scene"), tr("Ctrl+Alt+H")});
  showAgain_ = makeAction(this, "eye",
                          {"sceneTreeShowAgain", tr("Show again in 3-D"),
                           tr("Shows the object again in views of the scene"), tr("Ctrl+Alt+Shift+H")});
  follow_ = makeAction(
      this, "follow", {"sceneTreeFollow", tr("Follow"), tr("The camera of the scene moves with the object")});
  turnWith_ = makeAction(this, "behind",
                         {"sceneTreeTurnWith", tr("Follow and turn with it"),
                          tr("The camera of the scene moves and turns with the object")});
  lookOut_ = makeAction(this, "eye",
                        {"sceneTreeLookOut", tr("First person"),
                         tr("Shows the scene from the object's camera, or from the object itself")});
  const auto runs = [this](QAction* action, const char* command, std::vector<std::string> words) {
    connect(action, &QAction::triggered, this, [=, this] { runForObject(command, words); });
  };
  runs(alone_, "scene.open", {"alone"});
  runs(around_, "scene.open", {"around"});
  runs(hide_, "scene.hide", {""});
  runs(showAgain_, "scene.show", {""});
  runs(follow_, "scene.follow", {"position", ""});
  runs(turnWith_, "scene.follow", {"heading", ""});
  runs(lookOut_, "scene.follow", {"first-person", ""});
}

void SceneTreeView::addSceneEntries(QMenu& menu) {
  menu.addActions({alone_, around_, hide_, showAgain_});
  QMenu* drawn = menu.addMenu(tr("Drawn"));
  const std::pair<const char*, QString> kinds[] = {{"view", tr("As the view")},
                                                   {"shaded", tr("Shaded")},
                                                   {"flat", tr("Flat")},
                                                   {"hidden-lines", tr("Edges, hidden ones left out")},
                                                   {"wire", tr("Wire frame")}};
  for (const auto& [kind, text] : kinds)
    drawn->addAction(text, this,
                     [this, kind = kind] {
                       runForObject("scene.draw", {kind, ""});
                     })
        ->setObjectName(QStringLiteral("sceneTreeDrawn-") + QLatin1String(kind));
  QMenu* through = menu.addMenu(tr("Seen through"));
  for (const int percent : {0, 25, 50, 75, 90}) {
    const QString text = percent == 0 ? tr("Not at all") : tr("%1 %").arg(percent);
    through->addAction(text, this, [this, percent] { showOpacity(1 - percent / 100.0); })
        ->setObjectName(QStringLiteral("sceneTreeThrough-%1").arg(percent));
  }
  menu.addActions({follow_, turnWith_, lookOut_});
}

void SceneTreeView::showOpacity(double opacity) {
  const auto* object = selected();
  if (object == nullptr) return;
  report(context().commands.run("scene.opacity", {object->path(), opacity, std::string()}));
}

void SceneTreeView::runForObject(const char* command, std::vector<std::string> words) {
  const auto* object = selected();
  if (object == nullptr) return;
  words.insert(words.begin(), object->path());
  run(command, words);
  showHidden();
}

void SceneTreeView::createViews() {
  filtered_->setSourceModel(&model_);
  filtered_->setRecursiveFilteringEnabled(true);
  filtered_->setFilterRole(SceneTreeModel::kFilterRole);
  filtered_->setFilterCaseSensitivity(Qt::CaseInsensitive);
  search_ = makeSearchField(
      this, {"sceneTreeSearch", tr("Search objects"),
             tr("Shows only objects whose path, kind or type contains this"), QKeySequence::Find});
  tree_ = makeTree(this, {"sceneTree", tr("Objects of the scene"), {}}, filtered_);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  using enum ColumnKind;
  new ColumnFit(*tree_, {kName, kNumber, kText});
  hint_ = new EmptyHint(tree_);
  outcome_ = makeNote(this, "sceneTreeOutcome", tr("What went wrong"));
  outcome_->hide();
  actuators_ = new ActuatorPanel(session(), model_, this);
  auto* row = new QHBoxLayout;
  row->addWidget(search_, 1);
  for (QAction* action : {alone_, plot_, columns_, image_, properties_})
    row->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {4, 4, 4, 0}, 4);
  layout->addLayout(row);
  auto* splitter = makeSplitter(this, "sceneTreeSplitter", Qt::Vertical, {{tree_, 3}, {actuators_, 2}});
  keep("splitter", splitter);
  layout->addWidget(splitter, 1);
  layout->addWidget(outcome_);
}

void SceneTreeView::connectSignals() {
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    filtered_->setFilterFixedString(text);
    if (!text.isEmpty()) tree_->expandAll();
  });
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    tree_->setFocus();
    if (!tree_->currentIndex().isValid()) tree_->setCurrentIndex(filtered_->index(0, 0));
  });
  connect(tree_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          [this](const QModelIndex& current) {
            if (!current.isValid()) return;
            selection_.select(current.data(SceneTreeModel::kPathRole).toString().toStdString());
            showSelected();
          });
  connect(&selection_, &SceneSelection::changed, this, &SceneTreeView::followSelection);
  connect(tree_, &QTreeView::customContextMenuRequested, this, &SceneTreeView::showMenu);
  connect(tree_, &QTreeView::activated, this, [this] {
    if (image_->isEnabled()) return image_->trigger();
    if (plot_->isEnabled()) plot_->trigger();
  });
  connect(plot_, &QAction::triggered, this, &SceneTreeView::plot);
  connect(columns_, &QAction::triggered, this, &SceneTreeView::showColumns);
  connect(image_, &QAction::triggered, this, [this] { showImage("color"); });
  connect(gray_, &QAction::triggered, this, [this] { showImage("gray"); });
  connect(stereogram_, &QAction::triggered, this, [this] { showImage("stereogram"); });
  connect(properties_, &QAction::triggered, this, [this] { run("view.show", {"scene-properties"}); });
  connect(copyPath_, &QAction::triggered, this, [this] {
    if (!selection_.object().empty())
      QApplication::clipboard()->setText(QString::fromStdString(selection_.object()));
  });
}

void SceneTreeView::tick() {
  showObjects();
  const auto* message = session().store().latest(robotlink::streams::kPorts, session().timeline().shown());
  model_.setReadings(message == nullptr
                         ? nullptr
                         : std::dynamic_pointer_cast<const robotcontrol::PortReadings>(message->value));
  readShown();
  // Objects hidden by other views are looked up less often: in a large scene that takes a while.
  if (++ticks_ % kTicksUntilHiddenShown == 0) showHidden();
  actuators_->refresh();
  hint_->setHint(
      model_.rowCount() == 0
          ? tr("No objects: start a simulation (File > Open scene…). Real robots and logs have none.")
      : filtered_->rowCount() == 0 ? tr("Nothing matches. Clear the search.")
                                   : QString());
}

void SceneTreeView::showObjects() {
  const auto* message = session().store().latest(robotlink::streams::kObjects, session().timeline().newest());
  robotlink::PackagePtr value = message == nullptr ? nullptr : message->value;
  if (value == objects_) return;
  std::set<std::string> open = unfolded();
  open.insert(wanted_.begin(), wanted_.end());
  objects_ = std::move(value);
  model_.setObjects(std::dynamic_pointer_cast<const robotcontrol::WorldObjects>(objects_));
  unfold(open);
  followSelection();
  showSelected();
}

void SceneTreeView::readShown() {
  std::vector<std::string> ports;
  const int bottom = tree_->viewport()->height();
  for (QModelIndex row = tree_->indexAt({0, 0}); row.isValid(); row = tree_->indexBelow(row)) {
    if (tree_->visualRect(row).top() > bottom) break;
    const auto* object = model_.object(filtered_->mapToSource(row));
    // Images are rendered only for their viewers.
    if (isSensor(object) && object->port().type() != "image") ports.push_back(object->port().path());
  }
  subscription_.want(session(), ports);
}

void SceneTreeView::followSelection() {
  if (selection_.object().empty() && tree_->currentIndex().isValid()) {
    // The selection is cleared, so that a click on the same row selects it again.
    tree_->selectionModel()->clear();
    return showSelected();
  }
  const QModelIndex index = filtered_->mapFromSource(model_.indexOf(selection_.object()));
  if (!index.isValid() || index == tree_->currentIndex().siblingAtColumn(0)) return;
  tree_->setCurrentIndex(index);
  tree_->scrollTo(index);
}

const robotcontrol::WorldObject* SceneTreeView::selected() const {
  return model_.object(filtered_->mapToSource(tree_->currentIndex()));
}

void SceneTreeView::showSelected() {
  const auto* object = selected();
  const bool hasImages = isSensor(object) && !object->port().image_stream().empty();
  const bool hasValues = isSensor(object) && !hasImages && valueCount(object->port()) > 0;
  plot_->setEnabled(hasValues);
  columns_->setEnabled(hasValues);
  for (QAction* action : {image_, gray_}) action->setEnabled(hasImages);
  stereogram_->setEnabled(hasImages && object->port().type() == "depth");
  for (QAction* action : {goToText_, properties_, copyPath_}) action->setEnabled(object != nullptr);
  const bool isSomewhere = object != nullptr && hasPlace(*object);
  for (QAction* action : {alone_, around_, hide_, follow_, turnWith_, lookOut_})
    action->setEnabled(isSomewhere);
  showHidden();
  // Parts of other objects are changed in the text of these.
  const bool isWhole = object != nullptr && object->parent().empty();
  for (QAction* action : {duplicate_, erase_, rename_}) action->setEnabled(isWhole);
  std::vector<std::string> actuators;
  for (const auto* actuator :
       model_.actuatorsOf(filtered_->mapToSource(tree_->currentIndex()).siblingAtColumn(0)))
    actuators.push_back(actuator->path());
  actuators_->show(std::move(actuators));
}

bool SceneTreeView::hasPlace(const robotcontrol::WorldObject& object) const {
  const auto* at = &object;
  for (int level = 0; at != nullptr && level < kMaxLevels; ++level) {
    if (at->has_pose_in_frame()) return true;
    at = model_.object(at->parent());
  }
  return false;
}

void SceneTreeView::showHidden() {
  const auto* object = selected();
  const auto* command = context().commands.find("scene.show");
  const bool isAsked = object != nullptr && command != nullptr && command->offer;
  const auto hidden = isAsked ? command->offer({}) : std::vector<std::string>();
  showAgain_->setEnabled(isAsked && std::ranges::find(hidden, object->path()) != hidden.end());
}

void SceneTreeView::showMenu(const QPoint& at) {
  QMenu menu(this);
  menu.setObjectName(QStringLiteral("sceneTreeMenu"));
  menu.addActions({plot_, columns_, image_, gray_, stereogram_});
  menu.addSeparator();
  showHidden();
  if (selected() != nullptr && hasPlace(*selected())) addSceneEntries(menu);
  menu.addSeparator();
  menu.addActions({duplicate_, erase_, rename_});
  menu.addSeparator();
  menu.addActions({goToText_, properties_, copyPath_});
  menu.exec(tree_->viewport()->mapToGlobal(at));
}

void SceneTreeView::plot() {
  const auto* object = selected();
  if (!isSensor(object)) return;
  const robotcontrol::WorldPort port = object->port();
  subscription_.want(session(), {port.path()});
  for (int i = 0; i < std::min(valueCount(port), kMaxCurves); ++i)
    if (!run("plots.add", {std::string(robotlink::streams::kPorts) + ": " + portField(port.path(), i)}))
      return;
}

void SceneTreeView::showColumns() {
  const auto* object = selected();
  if (isSensor(object)) run("columns.show", {object->port().path()});
}

void SceneTreeView::showImage(const char* mode) {
  const auto* object = selected();
  if (!isSensor(object)) return;
  const robotcontrol::WorldPort port = object->port();
  if (run("image.stream", {"image", port.image_stream()})) run("image.show", {"image", mode});
}

bool SceneTreeView::run(const char* command, const std::vector<std::string>& words) {
  return report(context().commands.run(command, robotlink::CommandTable::Values(words.begin(), words.end())));
}

bool SceneTreeView::report(const robotlink::Result<void>& done) {
  outcome_->setVisible(!done);
  if (!done) showOutcome(*outcome_, QString::fromStdString(done.error().describe()), true);
  return done.has_value();
}

std::set<std::string> SceneTreeView::unfolded() const {
  std::set<std::string> paths;
  std::vector<QModelIndex> open{QModelIndex()};
  while (!open.empty()) {
    const QModelIndex parent = open.back();
    open.pop_back();
    for (int row = 0; row < filtered_->rowCount(parent); ++row) {
      const QModelIndex index = filtered_->index(row, 0, parent);
      if (!tree_->isExpanded(index)) continue;
      paths.insert(index.data(SceneTreeModel::kPathRole).toString().toStdString());
      open.push_back(index);
    }
  }
  return paths;
}

void SceneTreeView::unfold(const std::set<std::string>& paths) {
  for (const std::string& path : paths) {
    const QModelIndex index = filtered_->mapFromSource(model_.indexOf(path));
    if (index.isValid()) tree_->expand(index);
  }
}

}  // namespace widgets
