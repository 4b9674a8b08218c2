// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

#include "widgets/View.h"
#include "widgets/sceneedit/SceneFileObjects.h"

class QLabel;
class QMenu;
class QSplitter;
class QTabBar;
class QTableView;
class QTextDocument;

namespace widgets {

class EmptyHint;
class FindBar;
class SceneBench;
class SceneProblemModel;
class SceneTextEdit;

/// The scene files that are edited, a tab for each: the text with its errors underlined, a list of these, and
/// the way to the simulation and back.
///
/// Registered as "scene-editor". GUI thread.
class SceneEditorView final : public View {
  Q_OBJECT
 public:
  explicit SceneEditorView(ViewContext& context, QWidget* parent = nullptr);
  ~SceneEditorView() override;
  void tick() override {}
  /// Also saves the text as .sdf; it still counts as unsaved.
  robotlink::Result<void> saveTo(const QString& file) override;

 private:
  void createFileActions();
  void createEditActions();
  void createSceneActions();
  QWidget* createTools();
  QWidget* createProblems();
  void createViews();
  void connectActions();
  void connectBench();

  void showFiles();
  void showCurrent();
  void showProblems();
  /// Gives the table of problems the room that it needs: none without problems.
  void fitProblems();
  void showState();
  void showFailure(const robotlink::Result<void>& done);
  void report(const QString& text, bool bad);
  void fillIncludeMenu();
  void addInclude(const QString& uri, const QString& name);
  void saveAndRun();
  void closeTab(int index);
  void goToSelected();
  void selectInScene();
  std::optional<SceneObject> objectAtCursor() const;
  void showObject();
  /// Selects where SceneBench::goTo() has led.
  void showPlace();

  SceneBench& bench_;
  QAction *new_ = nullptr, *open_ = nullptr, *save_ = nullptr, *saveAs_ = nullptr, *discard_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr, *find_ = nullptr, *indent_ = nullptr, *propose_ = nullptr;
  QAction *run_ = nullptr, *goTo_ = nullptr, *select_ = nullptr, *openIncluded_ = nullptr;
  QMenu *more_ = nullptr, *include_ = nullptr;
  QTabBar* tabs_ = nullptr;
  SceneTextEdit* text_ = nullptr;
  /// The document that is shown while no file is open.
  QTextDocument* nothing_ = nullptr;
  FindBar* findBar_ = nullptr;
  /// The text above, and its problems below.
  QSplitter* halves_ = nullptr;
  QWidget* below_ = nullptr;
  QTableView* problems_ = nullptr;
  int listedProblems_ = 0;
  /// Whether the user has divided the view.
  bool isDivided_ = false;
  SceneProblemModel* model_ = nullptr;
  QLabel *count_ = nullptr, *object_ = nullptr, *state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  bool isShowingFiles_ = false;
};

}  // namespace widgets
