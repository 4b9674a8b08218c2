// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

namespace widgets {

/// A named object of a scene file: a model, an included model, a link, joint, sensor, light, visual or
/// collision. Positions are those of XmlText.h.
struct SceneObject {
  /// The names of the objects around it and its own: "red1/head/camera".
  QString path;
  /// The name in the views of the simulated scene: "red1/link:head", "red1/joint:neck", "red1/camera/image".
  QString selection;
  QString element, name;
  /// The URI that an <include> includes; empty for all others.
  QString uri;
  int begin = 0, end = 0;
};

/// All objects of a text, outer ones before those in them. Included models without a name have the last part
/// of their URI as their name.
std::vector<SceneObject> sceneObjects(const QString& text);

/// The location of an object in a text.
struct FoundSceneObject {
  SceneObject object;
  /// The part of its path that is in the file that the object includes, not in this one; empty: it was found.
  QString rest;
};
/// The object of a path, or else the included model that has it; an empty path in the result: neither is
/// there. Paths are those of SceneObject::path or SceneObject::selection; objects between may be left out,
/// and names may also be separated by "::". `instance`: as which model of the scene the file's own one is
/// known; empty: by its own name.
FoundSceneObject findSceneObject(const QString& text, const QString& path, const QString& instance = {});
/// The innermost object around a position, in whose paths the file's own model is called `instance` unless
/// that is empty; nothing if there is none.
std::optional<SceneObject> sceneObjectAt(const QString& text, int position, const QString& instance = {});

/// The text with an <include> added at the end of its world, or of its model if it has no world; as it is if
/// it has neither. `position`: where the new element begins.
QString withInclude(const QString& text, const QString& uri, const QString& name, int* position);
/// The text with elements added in the same place; `xml` ends with a line break. The name of no other object
/// is checked.
QString withElements(const QString& text, const QString& xml, int* position);
/// The text without one of its objects and the lines that only it was in.
QString withoutObject(const QString& text, const SceneObject& object);
/// The text of an object, from its first tag to its last, called otherwise; as it is if it has no name.
QString renamedObject(const QString& element, const QString& name);
/// `name` if no object is called so, otherwise with the first number that makes it new: p3at, p3at2.
QString freeObjectName(const QString& text, const QString& name);
/// The name of a copy of an object: with the next number that makes it new, p3at1: p3at2, box: box2.
QString copiedObjectName(const QString& text, const QString& name);

}  // namespace widgets
