// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

class QToolBar;
class QWidget;

namespace widgets {

struct ViewContext;

/// A toolbar of a plug-in. It is shown in the window beside those of the workbench, and can be hidden and
/// moved as they can.
struct ToolBarType {
  /// "ball-counter"; part of saved window layouts, so it must never change.
  const char* id;
  /// "Ball counter"; translated when it is shown.
  const char* title;
  /// Creates the toolbar; the parent owns it. The context outlives it.
  std::function<QToolBar*(ViewContext&, QWidget* parent)> create;
};

/// All registered toolbars, in the order of registration.
const std::vector<ToolBarType>& registeredToolBars();

/// Registers a toolbar when it is constructed, while a plug-in is loaded.
class [[maybe_unused]] ToolBarRegistration {
 public:
  explicit ToolBarRegistration(ToolBarType type);
};

}  // namespace widgets
