// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace widgets {

class SceneBench;
class SceneFile;

// Dialogs about scene files. Each returns whether it was done; failures are reported by the bench.

/// Asks for the properties of a new room, and opens its text in the editor.
bool newScene(SceneBench& bench, QWidget* parent);
bool openScene(SceneBench& bench, QWidget* parent);
/// Saves the current file, and asks for a name if it has none.
bool saveScene(SceneBench& bench, QWidget* parent);
/// Asks whether a file that another program has changed is to be overwritten, or read again, if so it is;
/// true: it may be saved.
bool mayOverwriteScene(SceneBench& bench, SceneFile& file, QWidget* parent);
/// Goes back to what is saved, which can be undone; asks before it closes a text that has no file.
bool discardScene(SceneBench& bench, QWidget* parent);
bool saveSceneAs(SceneBench& bench, QWidget* parent);
/// Saves all changed files, and asks for the names that are missing.
bool saveAllScenes(SceneBench& bench, QWidget* parent);
/// Asks whether the unsaved changes of the current file, or of all, shall be saved; false: the user wants to
/// continue editing.
bool mayLoseScene(SceneBench& bench, QWidget* parent);
bool mayLoseScenes(SceneBench& bench, QWidget* parent);

}  // namespace widgets
