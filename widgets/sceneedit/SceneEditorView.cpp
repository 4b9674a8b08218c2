// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneEditorView.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPlainTextDocumentLayout>
#include <QSplitter>
#include <QTabBar>
#include <QTableView>
#include <QTextBlock>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"
#include "widgets/Controls.h"
#include "widgets/EmptyHint.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneDialogs.h"
#include "widgets/sceneedit/SceneFileObjects.h"
#include "widgets/sceneedit/SceneProblemModel.h"
#include "widgets/sceneedit/SceneTextEdit.h"
#include "widgets/text/FindBar.h"
#include "widgets/world/SceneSelection.h"

namespace widgets {
namespace {

const ViewRegistration kSceneEditorRegistration{
    {"scene-editor", QT_TRANSLATE_NOOP("View", "Scene editor"),
     QT_TRANSLATE_NOOP(
         "View", "Edits the files of simulated scenes, and applies the changes to the running simulation."),
     "edit", false, create<SceneEditorView>}};

/// The words of a line, without the blanks before them.
QTextCursor wordsOfLine(QTextDocument& document, int line) {
  const QTextBlock block = document.findBlockByNumber(std::clamp(line, 1, document.blockCount()) - 1);
  const QString text = block.text();
  int begin = 0;
  while (begin < text.size() && text[begin].isSpace()) ++begin;
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + (begin < text.size() ? begin : 0));
  cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
  return cursor;
}

}  // namespace

SceneEditorView::SceneEditorView(ViewContext& context, QWidget* parent)
    : View(context, parent), bench_(sceneBench(context)) {
  setObjectName(QStringLiteral("sceneEditorView"));
  createFileActions();
  createEditActions();
  createSceneActions();
  createViews();
  connectActions();
  connectBench();
  keep("halves", halves_);
  keep("columns", problems_->horizontalHeader());
  showFiles();
  showCurrent();
  showPlace();
  // The title's signal would be lost before the view is in its dock.
  QMetaObject::invokeMethod(this, &SceneEditorView::showState, Qt::QueuedConnection);
}

// The documents belong to the bench, which stays.
SceneEditorView::~SceneEditorView() {
  disconnect(&bench_, nullptr, this, nullptr);
  disconnect(text_, nullptr, this, nullptr);
}

void SceneEditorView::createFileActions() {
  new_ = makeAction(this, "file-new",
                    {"sceneNew", tr("New…"), tr("Starts a room with walls, light, and a robot")});
  open_ = makeAction(this, "open", {"sceneOpen", tr("Open…"), tr("Opens a scene, a model or a map")});
  save_ = makeAction(this, "save", {"sceneSave", tr("Save"), tr("Saves the file"), QKeySequence::Save});
  saveAs_ = makeAction(this, "save", {"sceneSaveAs", tr("Save as…"), tr("Saves the text to another file")});
  discard_ =
      makeAction(this, "reset",
                 {"sceneDiscard", tr("Discard changes"),
                  tr("Goes back to the saved text, also in the simulation; undo restores the changes")});
}

void SceneEditorView::createEditActions() {
  undo_ = makeAction(this, "undo", {"sceneUndo", tr("Undo"), tr("Undoes the last edit")});
  redo_ = makeAction(this, "redo", {"sceneRedo", tr("Redo"), tr("Redoes the edit")});
  find_ = makeAction(
      this, "search",
      {"sceneFind", tr("Find and replace"), tr("Finds and replaces text in the file"), QKeySequence::Find});
  indent_ =
      makeAction(this, "layers", {"sceneIndent", tr("Indent all"), tr("Indents all lines by their nesting")});
  propose_ = makeAction(this, "labels",
                        {"scenePropose", tr("What can be written here"),
                         tr("Lists elements or attributes for the cursor: Ctrl+Space")});
}

void SceneEditorView::createSceneActions() {
  run_ = makeAction(this, "play",
                    {"sceneRun", tr("Save and run"),
                     tr("Saves the file; the running simulation continues with it, or the scene is opened"),
                     tr("Ctrl+Return")});
  goTo_ = makeAction(this, "goal",
                     {"sceneGoTo", tr("Go to the selected object"),
                      tr("Goes to the text of the object that is selected in the scene"), tr("Ctrl+G")});
  select_ =
      makeAction(this, "scene",
                 {"sceneSelect", tr("Select in the scene"),
                  tr("Selects the object around the cursor in the views of the scene"), tr("Ctrl+Shift+G")});
  openIncluded_ = makeAction(this, "open",
                             {"sceneOpenIncluded", tr("Open the included model"),
                              tr("Opens the file of the <include> at the cursor"), Qt::Key_F2});
}

QWidget* SceneEditorView::createTools() {
  QHBoxLayout* row = makeToolRow(this);
  QWidget* parent = row->parentWidget();
  include_ = new QMenu(tr("Include"), parent);
  include_->setObjectName(QStringLiteral("sceneIncludeMenu"));
  more_ = new QMenu(tr("More"), parent);
  more_->setObjectName(QStringLiteral("sceneMoreMenu"));
  more_->setToolTipsVisible(true);
  more_->addActions({saveAs_, discard_});
  more_->addSeparator();
  more_->addActions({propose_, indent_, openIncluded_});
  addButtons(row, {new_, open_, save_, undo_, redo_, find_});
  row->addWidget(
      makeMenuButton(parent, {"sceneInclude", tr("Include"), tr("Adds a model to the scene")}, include_));
  row->addWidget(makeMenuButton(
      parent, {"sceneMore", tr("More"), tr("Save as, discard changes, indent, included models")}, more_));
  row->addSpacing(8);
  row->addWidget(makeLabeledButton(parent, run_));
  addButtons(row, {goTo_, select_});
  object_ = new QLabel(parent);
  describe(*object_, {"sceneObject", tr("The object around the cursor"), {}});
  object_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  object_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(object_, 1);
  return parent;
}

QWidget* SceneEditorView::createProblems() {
  below_ = new QWidget(this);
  auto* column = makeColumn(below_);
  model_ = new SceneProblemModel(this);
  problems_ = makeTable(below_, {"sceneProblems", tr("Problems of the file"), {}}, model_);
  problems_->setSelectionMode(QAbstractItemView::SingleSelection);
  problems_->horizontalHeader()->setStretchLastSection(true);
  problems_->setColumnWidth(SceneProblemModel::kLine, textWidth(*problems_, QStringLiteral("99999")));
  count_ = makeNote(below_, "sceneProblemCount", tr("Number of problems"));
  count_->setContentsMargins(6, 2, 6, 2);
  column->addWidget(count_);
  column->addWidget(problems_, 1);
  return below_;
}

void SceneEditorView::createViews() {
  tabs_ = new QTabBar(this);
  describe(*tabs_, {"sceneTabs", tr("Open scene files"), {}});
  tabs_->setTabsClosable(true);
  tabs_->setExpanding(false);
  tabs_->setDrawBase(false);
  text_ = new SceneTextEdit(context().sceneLanguage, this);
  nothing_ = new QTextDocument(this);
  nothing_->setDocumentLayout(new QPlainTextDocumentLayout(nothing_));
  findBar_ = new FindBar(*text_, this);
  auto* above = new QWidget(this);
  auto* column = makeColumn(above);
  column->addWidget(text_, 1);
  column->addWidget(findBar_);
  auto* layout = makeColumn(this);
  layout->addWidget(createTools());
  layout->addWidget(tabs_);
  halves_ = makeSplitter(this, "sceneHalves", Qt::Vertical, {{above, 4}, {createProblems(), 1}});
  halves_->setCollapsible(0, false);
  connect(halves_, &QSplitter::splitterMoved, this, [this] { isDivided_ = true; });
  layout->addWidget(halves_, 1);
  state_ = makeNote(this, "sceneState", tr("What was done"));
  state_->setContentsMargins(6, 2, 6, 2);
  layout->addWidget(state_);
  hint_ = new EmptyHint(text_->viewport());
}

void SceneEditorView::connectActions() {
  connect(new_, &QAction::triggered, this, [this] { newScene(bench_, this); });
  connect(open_, &QAction::triggered, this, [this] { openScene(bench_, this); });
  connect(save_, &QAction::triggered, this, [this] { saveScene(bench_, this); });
  connect(saveAs_, &QAction::triggered, this, [this] { saveSceneAs(bench_, this); });
  connect(discard_, &QAction::triggered, this, [this] { discardScene(bench_, this); });
  connect(undo_, &QAction::triggered, text_, &QPlainTextEdit::undo);
  connect(redo_, &QAction::triggered, text_, &QPlainTextEdit::redo);
  connect(find_, &QAction::triggered, findBar_, &FindBar::open);
  connect(indent_, &QAction::triggered, text_, &SceneTextEdit::indentAll);
  connect(propose_, &QAction::triggered, text_, &SceneTextEdit::propose);
  connect(run_, &QAction::triggered, this, &SceneEditorView::saveAndRun);
  connect(goTo_, &QAction::triggered, this, &SceneEditorView::goToSelected);
  connect(select_, &QAction::triggered, this, &SceneEditorView::selectInScene);
  connect(openIncluded_, &QAction::triggered, this,
          [this] { showFailure(bench_.openIncluded(text_->textCursor().position())); });
  connect(include_, &QMenu::aboutToShow, this, &SceneEditorView::fillIncludeMenu);
  connect(text_, &QPlainTextEdit::cursorPositionChanged, this, &SceneEditorView::showObject);
  connect(text_, &SceneTextEdit::placeChanged, this, [this] {
    SceneFile* file = bench_.current();
    if (file != nullptr && &file->document() == text_->document()) file->setPlace(text_->place());
  });
  connect(text_, &QPlainTextEdit::undoAvailable, undo_, &QAction::setEnabled);
  connect(text_, &QPlainTextEdit::redoAvailable, redo_, &QAction::setEnabled);
  connect(tabs_, &QTabBar::currentChanged, this, [this](int index) {
    const auto& files = bench_.files();
    if (!isShowingFiles_ && index >= 0 && index < static_cast<int>(files.size()))
      bench_.setCurrent(files[static_cast<std::size_t>(index)]);
  });
  connect(tabs_, &QTabBar::tabCloseRequested, this, &SceneEditorView::closeTab);
  connect(problems_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    showFailure(bench_.goTo(SceneProblem(model_->row(index.row()))));
  });
  connect(problems_, &QTableView::activated, this, [this](const QModelIndex& index) {
    showFailure(bench_.goTo(SceneProblem(model_->row(index.row()))));
  });
}

void SceneEditorView::connectBench() {
  connect(&bench_, &SceneBench::filesChanged, this, &SceneEditorView::showFiles);
  connect(&bench_, &SceneBench::currentChanged, this, &SceneEditorView::showCurrent);
  connect(&bench_, &SceneBench::problemsChanged, this, &SceneEditorView::showProblems);
  connect(&bench_, &SceneBench::reported, this, &SceneEditorView::report);
  connect(&bench_, &SceneBench::lineWanted, this, [this](int line) {
    text_->goToLine(line);
    text_->setFocus();
  });
  connect(&bench_, &SceneBench::placeWanted, this, &SceneEditorView::showPlace);
  connect(&sceneSelection(context()), &SceneSelection::changed, this, &SceneEditorView::showState);
}

// ---- What is shown

void SceneEditorView::showFiles() {
  isShowingFiles_ = true;
  const auto& files = bench_.files();
  while (tabs_->count() > static_cast<int>(files.size())) tabs_->removeTab(tabs_->count() - 1);
  while (tabs_->count() < static_cast<int>(files.size())) tabs_->addTab(QString());
  for (int i = 0; i < tabs_->count(); ++i) {
    const SceneFile& file = *files[static_cast<std::size_t>(i)];
    tabs_->setTabText(i, file.title());
    tabs_->setTabToolTip(i, QString::fromStdString(file.path().string()));
    if (&file == bench_.current()) tabs_->setCurrentIndex(i);
  }
  isShowingFiles_ = false;
  tabs_->setVisible(!files.empty());
  showState();
}

void SceneEditorView::showCurrent() {
  SceneFile* file = bench_.current();
  if (file != nullptr) {
    // Showing another document resets the place to its first line.
    const TextPlace place = file->place();
    text_->showDocument(&file->document(), file->isXml(), file->path());
    text_->setPlace(place);
  } else {
    text_->showDocument(nothing_, false, {});
  }
  text_->setReadOnly(file == nullptr);
  showFiles();
  showProblems();
}

void SceneEditorView::showProblems() {
  const SceneFile* file = bench_.current();
  const std::vector<SceneProblem> none;
  const auto& problems = file != nullptr ? file->problems() : none;
  model_->show(problems, palette());
  std::vector<TextMark> marks;
  int errors = 0, warnings = 0;
  for (const SceneProblem& problem : problems) {
    ++(problem.isWarning ? warnings : errors);
    if (!problem.file.empty() || problem.line <= 0) continue;
    marks.push_back({wordsOfLine(*text_->document(), problem.line), QString::fromStdString(problem.text),
                     problem.isWarning ? Meaning::kWarning : Meaning::kBad});
  }
  text_->setMarks(std::move(marks));
  const QString found = tr("Errors: %1, warnings: %2").arg(errors).arg(warnings);
  showOutcome(*count_, file != nullptr ? found : QString(), errors > 0);
  fitProblems();
}

void SceneEditorView::fitProblems() {
  const int rows = model_->rowCount(), line = problems_->verticalHeader()->defaultSectionSize();
  const int head = problems_->horizontalHeader()->sizeHint().height() + 2 * problems_->frameWidth();
  problems_->setVisible(rows > 0);
  problems_->setMinimumHeight(head + line);
  const int needed = count_->sizeHint().height() + (rows > 0 ? head + rows * line : 0);
  below_->setMaximumHeight(needed);
  if (rows == std::exchange(listedProblems_, rows) || rows == 0 || isDivided_) return;
  // A third at most, until the user divides the view; before it has a size, that is its share.
  const QList<int> sizes = halves_->sizes();
  const int whole = sizes[0] + sizes[1];
  const int share = std::min(needed, whole / 3);
  halves_->setSizes(whole > 0 ? QList<int>{whole - share, share} : QList<int>{2000, 1000});
}

void SceneEditorView::showState() {
  const SceneFile* file = bench_.current();
  const bool hasFile = file != nullptr;
  for (QAction* action : {save_, saveAs_, discard_, find_, indent_, propose_, run_, select_, openIncluded_})
    action->setEnabled(hasFile);
  undo_->setEnabled(hasFile && text_->document()->isUndoAvailable());
  redo_->setEnabled(hasFile && text_->document()->isRedoAvailable());
  include_->setEnabled(hasFile && file->isXml());
  const QString selected = QString::fromStdString(sceneSelection(context()).object());
  goTo_->setToolTip(selected.isEmpty() ? tr("Nothing is selected in the scene; goes to the scene's file")
                                       : tr("Goes to the text of %1").arg(selected));
  hint_->setHint(hasFile ? QString()
                         : tr("No scene file. Open one, start one with New, or go to the scene that is "
                              "simulated."));
  showObject();
  Q_EMIT titleChanged(hasFile ? tr("Scene editor: %1").arg(file->title()) : tr("Scene editor"));
}

void SceneEditorView::showFailure(const robotlink::Result<void>& done) {
  if (!done) report(QString::fromStdString(done.error().describe()), true);
}

void SceneEditorView::report(const QString& text, bool bad) {
  showOutcome(*state_, text, bad);
}

// ---- What is done

std::optional<SceneObject> SceneEditorView::objectAtCursor() const {
  const SceneFile* file = bench_.current();
  if (file == nullptr || !file->isXml()) return std::nullopt;
  return sceneObjectAt(file->text(), text_->textCursor().position(), file->instance());
}

void SceneEditorView::showPlace() {
  const auto place = bench_.takePlace();
  if (!place) return;
  text_->select(place->first, place->second);
  text_->setFocus();
}

void SceneEditorView::showObject() {
  const auto object = objectAtCursor();
  object_->setText(object ? object->path : QString());
}

void SceneEditorView::fillIncludeMenu() {
  include_->clear();
  const SceneFile* file = bench_.current();
  if (file == nullptr || context().sceneLanguage == nullptr) return;
  const auto path = file->path().empty() ? bench_.folder() / "unnamed.sdf" : file->path();
  for (const SceneModelChoice& model : context().sceneLanguage->models(path)) {
    const QString uri = QString::fromStdString(model.uri), name = QString::fromStdString(model.name);
    QAction* action = include_->addAction(model.isRobot ? tr("%1 (robot)").arg(name) : name, this,
                                          [this, uri, name] { addInclude(uri, name); });
    action->setObjectName(QStringLiteral("include.") + name);
  }
  if (include_->isEmpty()) include_->addAction(tr("There are no models"))->setEnabled(false);
}

void SceneEditorView::addInclude(const QString& uri, const QString& name) {
  const QString text = text_->toPlainText();
  int position = -1;
  const QString added = withInclude(text, uri, freeObjectName(text, name), &position);
  if (position < 0) return report(tr("A model can only be included in a world or a model"), true);
  text_->replaceText(added);
  text_->select(position, added.indexOf(QLatin1String("</include>"), position) + 10);
  text_->setFocus();
}

void SceneEditorView::saveAndRun() {
  SceneFile* file = bench_.current();
  if (file == nullptr || (file->path().empty() && !saveSceneAs(bench_, this))) return;
  if (!mayOverwriteScene(bench_, *file, this)) return;
  showFailure(bench_.run());
}

void SceneEditorView::closeTab(int index) {
  const auto& files = bench_.files();
  if (index < 0 || index >= static_cast<int>(files.size())) return;
  SceneFile* file = files[static_cast<std::size_t>(index)];
  bench_.setCurrent(file);
  if (mayLoseScene(bench_, this)) bench_.close(*file);
}

void SceneEditorView::goToSelected() {
  showFailure(bench_.goTo(QString::fromStdString(sceneSelection(context()).object())));
}

void SceneEditorView::selectInScene() {
  const auto object = objectAtCursor();
  if (!object) return report(tr("There is no object around the cursor"), true);
  sceneSelection(context()).select(object->selection.toStdString());
}

robotlink::Result<void> SceneEditorView::saveTo(const QString& file) {
  if (robotlink::fileSuffix(file.toStdString()) != ".sdf" || bench_.current() == nullptr)
    return View::saveTo(file);
  return robotlink::writeFileAtomically(file.toStdString(), text_->toPlainText().toStdString());
}

}  // namespace widgets
