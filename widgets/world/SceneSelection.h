// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <string>

namespace widgets {

struct ViewContext;

/// The object of the scene that is selected in a window, by its path ("red1/joint:headPan"): what the scene
/// tree, the properties and the three-dimensional scene have in common. GUI thread.
class SceneSelection final : public QObject {
  Q_OBJECT
 public:
  using QObject::QObject;

  /// Empty: none.
  const std::string& object() const { return object_; }
  void select(const std::string& object);

 Q_SIGNALS:
  /// Emitted when another object is selected, or none.
  void changed();

 private:
  std::string object_;
};

/// The selection of a window; created on first use.
SceneSelection& sceneSelection(ViewContext& context);

}  // namespace widgets
