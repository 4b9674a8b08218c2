// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterPanel.h"

#include <QAction>
#include <QBoxLayout>
#include <QFileDialog>
#include <QLabel>
#include <QToolButton>
#include <QTreeView>
#include <QUndoCommand>
#include <functional>

#include "widgets/ColumnFit.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/Requests.h"
#include "widgets/TypedStreams.h"
#include "widgets/solutions/ParameterDelegate.h"
#include "widgets/solutions/ParameterFile.h"
#include "widgets/solutions/ParameterSlider.h"

namespace widgets {
namespace {

/// An edit of a parameter message: the message before and after it.
class EditParameters final : public QUndoCommand {
 public:
  using Apply = std::function<void(const QByteArray&)>;
  EditParameters(const QString& what, QByteArray before, QByteArray after, Apply apply)
      : QUndoCommand(what), before_(std::move(before)), after_(std::move(after)), apply_(std::move(apply)) {}
  void undo() override { apply_(before_); }
  void redo() override { apply_(after_); }

 private:
  QByteArray before_;
  QByteArray after_;
  Apply apply_;
};

}  // namespace

ParameterPanel::ParameterPanel(robotlink::Session& session, QWidget* parent)
    : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("parameterPanel"));
  createActions();
  createViews();
  connectSignals();
  show({}, {}, {}, false);
}

void ParameterPanel::createActions() {
  undoAction_ = makeAction(this, "undo",
                           {"parametersUndo", tr("Undo"), tr("Undoes the last edit"), QKeySequence::Undo});
  redoAction_ =
      makeAction(this, "redo", {"parametersRedo", tr("Redo"), tr("Redoes the edit"), QKeySequence::Redo});
  reset_ = makeAction(this, "reset",
                      {"parametersReset", tr("Reset to default"),
                       tr("Resets the current parameter, or group, to its default"), tr("Ctrl+Backspace")});
  resetAll_ = makeAction(
      this, "clear", {"parametersResetAll", tr("Reset all"), tr("Resets every parameter to its default")});
  refresh_ = makeAction(
      this, "refresh",
      {"parametersRefresh", tr("Read again"), tr("Requests the robot's values again"), tr("Shift+F5")});
  save_ = makeAction(this, "save",
                     {"parametersSave", tr("Save"),
                      tr("Saves changes to the file that the program reads when it starts; its "
                         "comments stay")});
  saveAs_ = makeAction(this, "export",
                       {"parametersSaveAs", tr("Save to another file…"),
                        tr("Saves the parameters to a file that you choose")});
}

void ParameterPanel::createViews() {
  title_ = new QLabel(this);
  describe(*title_, {"parametersTitle", tr("Parameters of"), {}});
  tree_ = makeTree(this, {"parametersTree", tr("Parameters"), {}}, &model_);
  tree_->setItemDelegate(new ParameterDelegate(tree_));
  tree_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked |
                         QAbstractItemView::AnyKeyPressed);
  new ColumnFit(*tree_, {ColumnKind::kName, ColumnKind::kName, ColumnKind::kName, ColumnKind::kName});
  hint_ = new EmptyHint(tree_);
  state_ = makeNote(this, "parametersState", tr("State of the parameters"));
  auto* top = makeToolRow(this, 0);
  top->addWidget(title_, 1);
  for (QAction* action : {undoAction_, redoAction_, reset_, resetAll_, refresh_, save_, saveAs_})
    top->addWidget(makeButton(this, action));
  auto* layout = makeColumn(this, {}, 4);
  layout->addWidget(top->parentWidget());
  layout->addWidget(tree_, 1);
  slider_ = new ParameterSlider(this);
  layout->addWidget(slider_);
  layout->addWidget(state_);
}

void ParameterPanel::connectSignals() {
  connect(&model_, &QAbstractItemModel::modelReset, tree_, &QTreeView::expandAll);
  connect(&model_, &ParameterModel::edited, this,
          [this](const QByteArray& before, const QByteArray& after, const QString& what) {
            undo_.push(
                new EditParameters(what, before, after, [this](const QByteArray& value) { apply(value); }));
          });
  connect(tree_, &QTreeView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() == ParameterModel::kValue && index.flags().testFlag(Qt::ItemIsEditable))
      tree_->edit(index);
  });
  connect(undoAction_, &QAction::triggered, &undo_, &QUndoStack::undo);
  connect(redoAction_, &QAction::triggered, &undo_, &QUndoStack::redo);
  connect(&undo_, &QUndoStack::canUndoChanged, undoAction_, &QAction::setEnabled);
  connect(&undo_, &QUndoStack::canRedoChanged, redoAction_, &QAction::setEnabled);
  connect(reset_, &QAction::triggered, this, [this] {
    if (tree_->currentIndex().isValid()) model_.reset(tree_->currentIndex());
  });
  connect(resetAll_, &QAction::triggered, this, [this] { model_.reset({}); });
  connect(refresh_, &QAction::triggered, this, &ParameterPanel::askForValues);
  connect(save_, &QAction::triggered, this, &ParameterPanel::save);
  connect(saveAs_, &QAction::triggered, this, &ParameterPanel::saveAs);
  connect(tree_->selectionModel(), &QItemSelectionModel::currentRowChanged, slider_, &ParameterSlider::show);
  connect(&model_, &QAbstractItemModel::modelReset, slider_,
          [this] { slider_->show(tree_->currentIndex()); });
  connect(&model_, &QAbstractItemModel::modelReset, this, &ParameterPanel::showChanges);
  connect(&model_, &QAbstractItemModel::dataChanged, this, &ParameterPanel::showChanges);
}

void ParameterPanel::showChanges() {
  save_->setEnabled(model_.isChanged());
  saveAs_->setEnabled(model_.rowCount() > 0);
}

void ParameterPanel::save() {
  const auto* values = dynamic_cast<const robotcontrol::ParameterValues*>(shown_.get());
  if (values == nullptr) return;
  const auto file = parameterFileHere(session_, robot_, *values);
  if (file) return saveTo(*file, true);
  showOutcome(*state_, QString::fromStdString(file.error().text), true);
  saveAs();
}

void ParameterPanel::saveAs() {
  const QString name = QString::fromStdString(task_ + "." + solution_ + ".textproto");
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save parameters"), name, tr("Parameters (*.textproto)"));
  if (!file.isEmpty()) saveTo(file.toStdString(), false);
}

void ParameterPanel::saveTo(const std::filesystem::path& file, bool own) {
  if (const auto saved = saveParameters(model_, file); !saved)
    return showOutcome(*state_, tr("Not saved: %1").arg(QString::fromStdString(saved.error().describe())),
                       true);
  const QString done = tr("Saved: %1").arg(QString::fromStdString(file.string()));
  const auto* values = dynamic_cast<const robotcontrol::ParameterValues*>(shown_.get());
  if (!own || values == nullptr) return showOutcome(*state_, done, false);
  ask(session_, robot_, savedParameters(model_, *values), this,
      [this, done, isShown = whetherShown()](bool accepted, const QString& reason) {
        if (isShown()) showOutcome(*state_, accepted ? done : tr("Refused: %1").arg(reason), !accepted);
      });
}

void ParameterPanel::show(const std::string& robot, const std::string& task, const std::string& solution,
                          bool hasParameters) {
  robot_ = robot;
  task_ = task;
  solution_ = hasParameters ? solution : std::string();
  shown_ = nullptr;
  model_.clear();
  undo_.clear();
  showOutcome(*state_, {}, false);
  undoAction_->setEnabled(false);
  redoAction_->setEnabled(false);
  for (QAction* action : {reset_, resetAll_, refresh_}) action->setEnabled(!solution_.empty());
  showChanges();
  title_->setText(solution.empty() ? tr("Parameters")
                                   : QStringLiteral("<b>%1</b> / %2")
                                         .arg(QString::fromStdString(task).toHtmlEscaped(),
                                              QString::fromStdString(solution).toHtmlEscaped()));
  if (solution.empty()) {
    hint_->setHint(tr("Choose a solution to see its parameters."));
  } else if (!hasParameters) {
    hint_->setHint(tr("This solution has no parameters."));
  } else {
    hint_->setHint(tr("Asking the robot for the parameters…"));
    askForValues();
  }
}

void ParameterPanel::askForValues() {
  robotcontrol::Request request;
  request.mutable_get_parameters()->set_task(task_);
  request.mutable_get_parameters()->set_solution(solution_);
  ask(session_, robot_, std::move(request), this,
      [this, isShown = whetherShown()](bool accepted, const QString& reason) {
        if (!accepted && isShown()) showOutcome(*state_, tr("Not reported: %1").arg(reason), true);
      });
}

std::function<bool()> ParameterPanel::whetherShown() const {
  return [this, robot = robot_, task = task_, solution = solution_] {
    return robot == robot_ && task == task_ && solution == solution_;
  };
}

void ParameterPanel::tick() {
  if (solution_.empty()) return;
  for (const auto* message :
       latestOfType(session_.store(), robot_, "robotcontrol.ParameterValues", session_.timeline().newest())) {
    if (message == nullptr || message->value == shown_) continue;
    const auto* values = dynamic_cast<const robotcontrol::ParameterValues*>(message->value.get());
    if (values == nullptr || values->task() != task_ || values->solution() != solution_) continue;
    const bool first = shown_ == nullptr;
    shown_ = message->value;
    const bool isSaved =
        values->has_defaults() && model_.defaults().toStdString() != values->defaults().data();
    if (!first && values->value().type() == model_.typeName() && !isSaved) {
      // Setting only the values keeps the tree, the undo stack and an open editor.
      model_.setValue(QByteArray::fromStdString(values->value().data()));
    } else if (model_.setParameters(*values)) {
      hint_->setHint({});
      tree_->resizeColumnToContents(ParameterModel::kField);
    } else {
      hint_->setHint(tr("These parameters are of the type %1, which cannot be read here.")
                         .arg(QString::fromStdString(values->value().type())));
    }
  }
}

bool ParameterPanel::undo() {
  if (!undo_.canUndo()) return false;
  undo_.undo();
  return true;
}

bool ParameterPanel::redo() {
  if (!undo_.canRedo()) return false;
  undo_.redo();
  return true;
}

void ParameterPanel::apply(const QByteArray& value) {
  const QByteArray before = model_.value();
  model_.setValue(value);
  robotcontrol::Request request;
  auto& set = *request.mutable_set_parameters();
  set.set_task(task_);
  set.set_solution(solution_);
  set.mutable_value()->set_type(model_.typeName());
  set.mutable_value()->set_data(value.toStdString());
  showOutcome(*state_, tr("Sending…"), false);
  ask(session_, robot_, std::move(request), this,
      [this, before, isShown = whetherShown(), name = QString::fromStdString(solution_)](
          bool accepted, const QString& reason) {
        if (!isShown()) {
          if (!accepted)
            showOutcome(*state_, tr("The parameters of %1 were refused: %2").arg(name, reason), true);
          return;
        }
        if (accepted) return showOutcome(*state_, tr("Set."), false);
        model_.setValue(before);
        undo_.clear();
        showOutcome(*state_, tr("Refused: %1").arg(reason), true);
      });
}

}  // namespace widgets
