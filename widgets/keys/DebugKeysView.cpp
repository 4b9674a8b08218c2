// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/keys/DebugKeysView.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>
#include <algorithm>

#include "robotlink/debugging/Streams.h"
#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/keys/KeyDelegate.h"
#include "widgets/keys/KeyFilter.h"

namespace widgets {
namespace {

const ViewRegistration kDebugKeysViewRegistration{
    {"debug-keys", QT_TRANSLATE_NOOP("View", "Debug keys"),
     QT_TRANSLATE_NOOP("View", "Switches what the robot's processes publish: drawings, images, plots."),
     "keys", false, create<DebugKeysView>}};

}  // namespace

DebugKeysView::DebugKeysView(ViewContext& context, QWidget* parent)
    : View(context, parent), filter_(new KeyFilter(this)) {
  setObjectName(QStringLiteral("debugKeysView"));
  createActions();
  createViews();
  connectSignals();
  keep("search", search_);
  keep("activeOnly", activeOnly_);
  listPresets();
  showState();
}

void DebugKeysView::createActions() {
  activeOnly_ = makeToggle(this, "filter",
                           {"keysActiveOnly", tr("Only keys that are on"),
                            tr("Shows only the keys that are not off"), tr("Ctrl+Shift+A")});
  allOff_ = makeAction(this, "clear",
                       {"keysAllOff", tr("All off"), tr("Switches every key off"), tr("Ctrl+Shift+K")});
  inAllRobots_ =
      makeAction(this, "robot",
                 {"keysInAllRobots", tr("In all robots"),
                  tr("Copies the mode of this key, or of all keys below this row, to the other robots")});
  savePreset_ =
      makeAction(this, "save",
                 {"keysSavePreset", tr("Save preset"),
                  tr("Saves the keys that are on under the name in the field"), tr("Ctrl+Shift+P")});
  removePreset_ =
      makeAction(this, "remove", {"keysRemovePreset", tr("Delete preset"), tr("Deletes the named preset")});
}

void DebugKeysView::createViews() {
  search_ = makeSearchField(this, {"keysSearch", tr("Search keys"),
                                   tr("Words that the key's name contains; just type in the list")});
  presets_ = new QComboBox(this);
  describe(*presets_, {"keysPresets", tr("Preset"),
                       tr("A named set of keys: choose one to switch to it, or type a new name and save")});
  presets_->setEditable(true);
  presets_->setInsertPolicy(QComboBox::NoInsert);
  presets_->lineEdit()->setObjectName(QStringLiteral("keysPresetName"));
  presets_->lineEdit()->setPlaceholderText(tr("Preset"));
  filter_->setSourceModel(&model_);
  tree_ = makeTree(this, {"keysTree", tr("Debug keys"), {}}, filter_);
  tree_->setItemDelegate(new KeyDelegate(tree_));
  tree_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
  tree_->setContextMenuPolicy(Qt::ActionsContextMenu);
  tree_->addAction(inAllRobots_);
  auto* fit = new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kNumber, ColumnKind::kNumber});
  fit->expect(KeyTreeModel::kMode, tr("every n-th"));
  hint_ = new EmptyHint(tree_);
  state_ = makeNote(this, "keysState", tr("State of the debug keys"));

  auto* top = new QHBoxLayout;
  top->addWidget(search_, 1);
  top->addWidget(makeButton(this, activeOnly_));
  top->addWidget(makeButton(this, allOff_));
  auto* middle = new QHBoxLayout;
  middle->addWidget(presets_, 1);
  middle->addWidget(makeButton(this, savePreset_));
  middle->addWidget(makeButton(this, removePreset_));
  auto* layout = makeColumn(this, {4, 4, 4, 4}, 4);
  layout->addLayout(top);
  layout->addLayout(middle);
  layout->addWidget(tree_, 1);
  layout->addWidget(state_);
}

void DebugKeysView::connectSignals() {
  tree_->installEventFilter(this);
  connect(search_, &QLineEdit::textChanged, this, &DebugKeysView::search);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    tree_->setFocus();
    if (!tree_->currentIndex().isValid()) tree_->setCurrentIndex(filter_->index(0, 0));
  });
  connect(activeOnly_, &QAction::toggled, this, [this](bool on) {
    filter_->setActiveOnly(on);
    if (filter_->filters()) tree_->expandAll();
    showState();
  });
  connect(allOff_, &QAction::triggered, this, &DebugKeysView::allOff);
  connect(inAllRobots_, &QAction::triggered, this, &DebugKeysView::setInAllRobots);
  connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() != KeyTreeModel::kName && index.flags().testFlag(Qt::ItemIsEditable))
      tree_->edit(index);
  });
  connect(&model_, &KeyTreeModel::keyChosen, this, &DebugKeysView::request);
  connect(presets_, QOverload<int>::of(&QComboBox::activated), this,
          [this](int index) { loadPreset(presets_->itemText(index)); });
  connect(savePreset_, &QAction::triggered, this, &DebugKeysView::savePreset);
  connect(removePreset_, &QAction::triggered, this, &DebugKeysView::removePreset);
}

void DebugKeysView::tick() {
  const std::string& robot = session().selectedRobot();
  inAllRobots_->setEnabled(session().robots().size() > 1);
  // Switching acts on the robot now, whatever instant the data views show.
  const auto now = session().timeline().newest();
  const auto tables = latestTable(session().store(), robot, robotlink::streams::kKeys, now);
  const auto subscribers = latestTable(session().store(), robot, robotlink::streams::kSubscribers, now);
  auto values = valuesOf(tables);
  for (auto& value : valuesOf(subscribers)) values.push_back(std::move(value));
  if (robot == robot_ && values == shown_) return;
  const std::size_t before = robot == robot_ ? model_.keys().size() : 0;
  if (robot != robot_) model_.forget();
  robot_ = robot;
  shown_ = std::move(values);
  auto keys = robot.empty() ? std::vector<KeyEntry>() : mergeKeys(tables);
  addClients(keys, subscribers);
  model_.setKeys(std::move(keys));
  if (model_.keys().size() != before || filter_->filters()) tree_->expandAll();
  showState();
}

void DebugKeysView::search(const QString& text) {
  filter_->setWords(text);
  if (filter_->filters()) tree_->expandAll();
  showState();
}

void DebugKeysView::showState() {
  const auto& keys = model_.keys();
  const auto on = std::count_if(keys.begin(), keys.end(), [this](const KeyEntry& key) {
    return model_.shownValue(key).kind != KeyValue::Kind::kOff;
  });
  allOff_->setEnabled(on > 0);
  // The column of numbers is hidden while no key has one, so that names have more room.
  tree_->setColumnHidden(KeyTreeModel::kNumber,
                         std::none_of(keys.begin(), keys.end(), [this](const KeyEntry& key) {
                           return hasNumber(model_.shownValue(key).kind);
                         }));
  QStringList said;
  if (!notice_.isEmpty()) said << notice_;
  if (!keys.empty()) said << tr("%1 of %2 keys are on").arg(on).arg(keys.size());
  state_->setText(said.join(QLatin1Char('\n')));
  if (session().selectedRobot().empty()) {
    hint_->setHint(tr("No robot. Start a simulation or connect to a robot, and choose it in the toolbar."));
  } else if (keys.empty()) {
    hint_->setHint(tr("The robot has not reported its debug keys yet. Start its program."));
  } else {
    hint_->setHint(filter_->rowCount() > 0 ? QString()
                                           : tr("No key matches. Clear the search or the filter."));
  }
}

void DebugKeysView::request(const QString& key, const KeyValue& value) {
  robotcontrol::Request request;
  request.mutable_set_key()->set_name(key.toStdString());
  assign(*request.mutable_set_key()->mutable_mode(), value);
  ask(session(), robot_, std::move(request), this,
      [this, robot = robot_, key](bool accepted, const QString& reason) {
        if (accepted) return;
        if (robot == robot_) model_.refuse(key.toStdString(), reason);
        notify(tr("%1 was refused: %2").arg(key, reason));
      });
  notify({});
}

void DebugKeysView::toggle(const QModelIndex& index) {
  if (!index.isValid()) return;
  const bool on = index.data(KeyTreeModel::kActiveRole).toBool();
  const QModelIndex source = filter_->mapToSource(index.siblingAtColumn(0));
  for (const std::string& key : model_.keysBelow(source)) {
    model_.choose(key, {on ? KeyValue::Kind::kOff : KeyValue::Kind::kAlways, 0});
  }
}

void DebugKeysView::allOff() {
  const std::vector<KeyEntry> keys = model_.keys();
  for (const KeyEntry& key : keys) {
    if (model_.shownValue(key).kind != KeyValue::Kind::kOff) model_.choose(key.name, {});
  }
}

void DebugKeysView::setInAllRobots() {
  const QModelIndex current = tree_->currentIndex();
  if (!current.isValid()) return;
  notify({});
  for (const std::string& name : model_.keysBelow(filter_->mapToSource(current.siblingAtColumn(0)))) {
    const auto key = std::ranges::find(model_.keys(), name, &KeyEntry::name);
    robotcontrol::Request request;
    request.mutable_set_key()->set_name(name);
    assign(*request.mutable_set_key()->mutable_mode(), model_.shownValue(*key));
    for (const std::string& robot : session().robots()) {
      if (robot == robot_) continue;
      ask(session(), robot, request, this, [this, robot, name](bool accepted, const QString& reason) {
        if (accepted) return;
        notify(tr("%1 of %2 was refused: %3")
                   .arg(QString::fromStdString(name), QString::fromStdString(robot), reason));
      });
    }
  }
}

bool DebugKeysView::eventFilter(QObject* watched, QEvent* event) {
  if (watched != tree_ || event->type() != QEvent::KeyPress) return View::eventFilter(watched, event);
  // Keys that an editor in the tree has not used are not meant for the tree.
  const QWidget* focused = QApplication::focusWidget();
  if (focused != tree_ && tree_->isAncestorOf(focused)) return View::eventFilter(watched, event);
  auto* key = static_cast<QKeyEvent*>(event);
  if (key->key() == Qt::Key_Space || key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
    toggle(tree_->currentIndex());
    return true;
  }
  const QString text = key->text();
  const bool plain = (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
  if (!plain || text.isEmpty() || !text.at(0).isPrint()) return View::eventFilter(watched, event);
  search_->setFocus();
  search_->setText(search_->text() + text);
  return true;
}

}  // namespace widgets
