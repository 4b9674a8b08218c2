// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>
#include <optional>
#include <vector>

#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/sceneedit/XmlPlace.h"

namespace widgets {

/// Something that may be written at a place of a scene file.
struct SceneProposal {
  /// How it is listed.
  QString shown;
  /// What replaces XmlPlace::prefix, and by how many characters the cursor then stands before its end.
  QString text;
  int back = 0;
  /// What it means.
  QString help = {};
};

/// What may be written at a place, in the order of the specification; only what begins with the prefix.
/// `file`: whose text it is, for the models that it can include.
std::vector<SceneProposal> sceneProposals(const SceneLanguage& language, const XmlPlace& place,
                                          const std::filesystem::path& file);

/// What the word at a position means: an element or an attribute, with type and default. Empty: nothing is
/// known about it.
QString sceneHelpAt(const SceneLanguage& language, const QString& text, int position);

}  // namespace widgets
