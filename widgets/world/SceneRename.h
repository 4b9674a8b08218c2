// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonValue>
#include <QString>
#include <optional>
#include <string>

namespace robotcontrol {
class WorldObjects;
}

namespace widgets {

/// The path of a model or a lamp of a scene that has another name now. A plain value.
struct SceneRename {
  std::string from, to;
  bool operator==(const SceneRename&) const = default;
};

/// Finds out which object was renamed between two lists of the objects of a scene: the only one of the scene
/// itself that has gone, if the only new one is of the same kind and type. Unset: none was.
std::optional<SceneRename> renameBetween(const robotcontrol::WorldObjects& before,
                                         const robotcontrol::WorldObjects& now);

/// A text that names an object, or parts of it, by its new path: "red1", "red1/laser",
/// "ports: readings[port=\"red1/laser\"]". Other texts stay as they are.
QString withRename(QString text, const SceneRename& rename);
/// A saved value that names objects with that done to all its texts.
QJsonValue withRename(const QJsonValue& state, const SceneRename& rename);

}  // namespace widgets
