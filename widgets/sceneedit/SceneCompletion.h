// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/sceneedit/XmlPlace.h"

namespace widgets {

/// A text that may be written at a place of a scene file.
struct SceneProposal {
  /// The text in the list.
  QString shown;
  /// The replacement for XmlPlace::prefix, and the number of characters from the cursor to its end afterward.
  QString text;
  int back = 0;
  /// Its meaning.
  QString help = {};
};

/// The texts allowed at a place, in the order of the specification; only those that begin with the prefix.
/// `file`: the file with the text, for the models that it can include.
std::vector<SceneProposal> sceneProposals(const SceneLanguage& language, const XmlPlace& place,
                                          const std::filesystem::path& file);

/// The meaning of the word at a position: element or attribute, with type and default. Empty: nothing is
/// known about it.
QString sceneHelpAt(const SceneLanguage& language, const QString& text, int position);

}  // namespace widgets
