// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <map>
#include <optional>
#include <string>

#include "widgets/scene/render/SceneFrame.h"

namespace widgets {

class SceneObjects;

/// The look of an object in a view, as far as the user has chosen.
struct ObjectLook {
  /// Unset: as its parent, and finally as the view.
  std::optional<bool> isShown = {};
  std::optional<Surface> surface = {};
  /// From kMinOpacity to 1.
  std::optional<float> opacity = {};

  static constexpr float kMinOpacity = 0.05F;
  bool operator==(const ObjectLook&) const = default;
};

/// The user's choices for the objects of a scene in one view: parts that are hidden, drawn in another
/// way, or seen through. Of an object and all that it belongs to the nearest choice counts. GUI thread.
class ObjectLooks {
 public:
  /// The maximum number of choices that are kept; the oldest by path are dropped.
  static constexpr std::size_t kMaxLooks = 2000;

  bool empty() const { return looks_.empty(); }
  /// Hides an object with all that belongs to it; what was chosen for those is forgotten.
  void hide(const std::string& path, const SceneObjects& objects);
  /// Shows an object with all that belongs to it, even if it belongs to something that is hidden.
  void show(const std::string& path, const SceneObjects& objects);
  /// Shows everything again; surfaces and opacities stay.
  void showAll();
  /// Unset: as its parent.
  void setSurface(const std::string& path, std::optional<Surface> surface);
  /// 1: not seen through. Clamped.
  void setOpacity(const std::string& path, float opacity);
  /// Forgets all choices.
  void clear();

  /// The look that counts for an object; all but hidden objects have isShown.
  ObjectLook of(const std::string& path, const SceneObjects& objects) const;
  bool isHidden(const std::string& path, const SceneObjects& objects) const;
  /// The number of objects that the user has hidden.
  int hiddenCount() const;

  /// For saved window layouts, and back; what is damaged is left out.
  QJsonArray state() const;
  void restore(const QJsonArray& state);

 private:
  /// Forgets whether what belongs to an object is shown.
  void forgetShownWithin(const std::string& path, const SceneObjects& objects);
  void drop(const std::string& path);

  std::map<std::string, ObjectLook> looks_;
};

/// The names of surfaces in commands and saved layouts: shaded, flat, hidden-lines, wire.
const char* nameOfSurface(Surface surface);
std::optional<Surface> surfaceNamed(const std::string& name);

}  // namespace widgets
