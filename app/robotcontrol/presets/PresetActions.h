// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/session/Presets.h"
#include "robotlink/session/Session.h"

namespace widgets {
class ParameterEdits;
}

namespace app {

/// Saves, loads and compares presets of the selected robot and the window, and attaches the commands that do
/// so. Loading runs the commands that a person would type. Later results, such as a refusal by the robot,
/// are passed to the session's refusal handler. GUI thread; everything must outlive it.
class PresetActions final : public QObject {
  Q_OBJECT
 public:
  /// The part of a preset about views, as it is now, and how it is shown.
  struct Views {
    std::function<robotlink::Preset::Values()> now;
    std::function<robotlink::Result<void>(const robotlink::Preset::Values&)> show;
  };
  PresetActions(robotlink::CommandTable& commands, robotlink::Session& session,
                widgets::ParameterEdits& parameters, std::filesystem::path folder, Views views,
                QObject* parent);

  const robotlink::Presets& presets() const { return presets_; }
  /// Keyed by the name of a preset, or the path of a file.
  robotlink::Result<robotlink::Preset> named(const std::string& name) const;
  /// Calls `done` with the present choices, once the robot has reported those that are requested.
  void capture(const std::vector<robotlink::Preset::Part>& parts,
               std::function<void(robotlink::Result<robotlink::Preset>)> done);
  robotlink::Result<void> save(const std::string& name, const std::vector<robotlink::Preset::Part>& parts);
  robotlink::Result<void> remove(const std::string& name) { return changing(presets_.remove(name)); }
  robotlink::Result<void> rename(const std::string& from, const std::string& to) {
    return changing(presets_.rename(from, to));
  }
  /// Begins to load a preset, once the robot has reported what it has.
  robotlink::Result<void> load(const robotlink::Preset& preset);
  /// Calls `done` with what differs between a preset and what is chosen now, a line each.
  void compare(const robotlink::Preset& preset,
               std::function<void(robotlink::Result<std::vector<std::string>>)> done);

 Q_SIGNALS:
  /// Presets were saved, renamed or removed.
  void changed();

 private:
  void attach();
  /// Calls `done` once the robot's program has reported all its keys and solutions, or has refused to.
  void requestTables(std::function<void(const robotlink::Result<void>&)> done);
  void captureNow(const std::vector<robotlink::Preset::Part>& parts,
                  std::function<void(robotlink::Result<robotlink::Preset>)> done);
  robotlink::Result<void> loadNow(const robotlink::Preset& preset);
  robotlink::Result<void> changing(robotlink::Result<void> done);
  void loadKeys(const robotlink::Preset::Values& wanted, robotlink::Errors& errors);
  void loadSolutions(const robotlink::Preset::Values& wanted, robotlink::Errors& errors);
  void loadParameters(const robotlink::Preset::Values& wanted, robotlink::Errors& errors);
  void loadCamera(const robotlink::Preset::Values& wanted, robotlink::Errors& errors);
  void run(const std::string& command, const std::vector<std::string>& arguments, robotlink::Errors& errors);

  robotlink::CommandTable& commands_;
  robotlink::Session& session_;
  widgets::ParameterEdits& parameters_;
  robotlink::Presets presets_;
  Views views_;
};

}  // namespace app
