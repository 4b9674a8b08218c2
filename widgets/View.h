// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QJsonObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

class QAction;
class QColor;
class QComboBox;
class QHeaderView;
class QLineEdit;
class QSplitter;

namespace robotlink {
class CommandTable;
class Session;
struct FieldDescription;
struct RobotDescription;
}  // namespace robotlink

// The base class of all dockable views and the registry of their types.
namespace widgets {

class ColorBench;
class CommandLog;
class GamepadSettings;
class ManualSteering;
class MotionBench;
class OpenLogs;
class SceneBench;
class SceneLanguage;
class SceneSelection;
struct RobotBody;
struct SceneFileEdit;

/// The objects that a view may use. All of them outlive the view.
struct ViewContext {
  robotlink::Session& session;
  robotlink::CommandTable& commands;
  /// The field's description; null: none is known.
  std::shared_ptr<const robotlink::FieldDescription> field;
  /// Descriptions by the robot's name ("red1").
  std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>> robots;
  /// The open logs of the replay; created on first use by openLogs().
  std::shared_ptr<OpenLogs> logs = {};
  /// The color table being trained; created on first use by colorBench().
  std::shared_ptr<ColorBench> colors = {};
  /// Manual control of the selected robot; created on first use by manualSteering().
  std::shared_ptr<ManualSteering> steering = {};
  /// The motion that is being edited; created on first use by motionBench().
  std::shared_ptr<MotionBench> motions = {};
  /// The scene files that are being edited; created on first use by sceneBench().
  std::shared_ptr<SceneBench> scenes = {};
  /// The simulator's knowledge of scene files; null: none.
  std::shared_ptr<const SceneLanguage> sceneLanguage = {};
  /// The commands that were typed; created on first use by commandLog().
  std::shared_ptr<CommandLog> commandLog = {};
  /// The selected object of the scene; created on first use by sceneSelection().
  std::shared_ptr<SceneSelection> selection = {};
  /// The bindings of gamepads; null: as shipped.
  std::shared_ptr<GamepadSettings> gamepad = {};
  /// Returns the body of a kind of robot (the name of its description) in the color of its team; null if it
  /// is not known. May take some 100 ms, so its result is to be kept. Empty: none is known.
  std::function<std::shared_ptr<const RobotBody>(const std::string& kind, const QColor& team)> bodyOf = {};
  /// Returns the name of the process layout that a robot runs; empty: it is not known. Empty: none is.
  std::function<std::string(const std::string& robot)> layoutOf = {};
  /// Writes changes into the files of the open scene, and nothing else of them; fails, naming the file and
  /// the reason, if that is impossible. Empty: nothing can be written.
  std::function<robotlink::Result<void>(const std::vector<SceneFileEdit>& edits)> writeScene = {};
};

/// A dockable view of a session. Everything it shows comes from the session's streams, everything it does is
/// a request, so that simulated, remote and replayed robots are treated alike.
///
/// tick() is called 30 times a second while the view is visible, after the session has processed what is new;
/// the view reads the session's history then and updates once. What the user chose (robot, stream, zoom,
/// filter) is kept by saveState(). GUI thread.
class View : public QWidget {
  Q_OBJECT
 public:
  /// `context` must outlive the view.
  explicit View(ViewContext& context, QWidget* parent = nullptr);
  /// Ends all connections from what is in the view to the view.
  ~View() override;

  /// Updates what is shown. Must not block.
  virtual void tick() = 0;
  /// The user's choices, to be kept over restarts and in perspectives (saved window layouts): what keep() has
  /// added.
  virtual QJsonObject saveState() const;
  /// Applies what saveState() returned, possibly in another version: unknown or missing entries must be
  /// harmless.
  virtual void restoreState(const QJsonObject& state);
  /// Has what was chosen by the names of objects go on with others: `renamed` gets the saved values that name
  /// objects, and returns them with the new names.
  using Renamed = std::function<QJsonValue(const QJsonValue&)>;
  virtual void followNames(const Renamed& renamed);
  /// Writes what the view shows to a file, after its suffix: .png, a picture; .svg, a picture of lines and
  /// texts; .csv, its table or numbers; .tsv, its numbers with tabs; .txt, its text, or its table with
  /// tabs. Others are refused, unless the view has more. Opens no dialog.
  virtual robotlink::Result<void> saveTo(const QString& file);

  /// The view's contents as numbers: a table with tabs between the columns and the titles first; by default
  /// its table, else its lines of text, else its named values. Unset if it shows none of these.
  virtual std::optional<QString> numbers();

  /// The picture of the view in a video: by default all of it.
  virtual QImage shownPicture();
  /// The size of that in device-independent pixels; it grows and shrinks with the view.
  virtual QSize shownPictureSize() const { return size(); }
  /// Whether shownPicture() shows what the last tick() has read, for views that draw in another thread.
  virtual bool isPictureReady() const { return true; }

 Q_SIGNALS:
  /// The title of the dock changed: "Image: red1/camera".
  void titleChanged(const QString& title);
  /// The user wants the view as a video or as a series of images.
  void exportWanted();

 protected:
  ViewContext& context() const { return context_; }
  robotlink::Session& session() const { return context_.session; }

  using Save = std::function<QJsonValue()>;
  using Restore = std::function<void(const QJsonValue&)>;
  /// Whether the texts of an entry name objects of the scene, streams or values of these; others stay as they
  /// are when an object is renamed.
  enum class Names : bool { kNone, kObjects };
  /// Adds an entry to the saved state. `restore` gets an undefined value if a state has no such entry.
  /// Entries are restored in the order in which they were added.
  void keep(const char* name, Save save, Restore restore, Names names = Names::kNone);
  /// Adds the state of a control, which must live as long as the view. Where a state has no such entry the
  /// control keeps its present one.
  void keep(const char* name, QAction* toggle);
  void keep(const char* name, QLineEdit* text, Names names = Names::kNone);
  /// Keeps the index of the entry, which must mean the same in all versions.
  void keep(const char* name, QComboBox* choice);
  /// Keeps what the user did with a splitter or the columns of a table; nothing changes without an entry.
  void keep(const char* name, QSplitter* splitter);
  void keep(const char* name, QHeaderView* columns);
  /// A control with a choice of its own, such as RobotChoice, usually of a robot or a stream.
  template <typename Control>
  requires requires(Control& control) { control.setChoice(control.choice()); }
  void keep(const char* name, Control* control, Names names = Names::kObjects) {
    keep(
        name, [control] { return QJsonValue(control->choice()); },
        [control, usual = control->choice()](const QJsonValue& value) {
          control->setChoice(value.toString(usual));
        },
        names);
  }

 private:
  /// An entry of the saved state.
  struct Kept {
    QString name;
    Save save;
    Restore restore;
    Names names;
  };

  ViewContext& context_;
  std::vector<Kept> kept_;
};

/// A kind of view, as menus and saved window layouts know it.
struct ViewType {
  /// "image"; part of saved window layouts, so it must never change.
  const char* id;
  /// "Image"; translated when it is shown.
  const char* title;
  /// A sentence for menus and tooltips.
  const char* help;
  /// Name of an icon in resources/icons.
  const char* icon;
  /// Whether more than one may be open at a time.
  bool several;
  /// Creates a view; the parent owns it.
  std::function<View*(ViewContext&, QWidget*)> create;
};

/// All kinds of views. The registry is filled before main() starts and read-only afterward. A view registers
/// itself with one line in its .cpp:
///
///     const ViewRegistration kRegistration{{"image", QT_TR_NOOP("Image"), QT_TR_NOOP("..."), "image", true,
///     create<ImageStreamView>}};
class ViewRegistry {
 public:
  /// In the order of registration, which is unspecified between source files.
  static const std::vector<ViewType>& all();
  /// Null if there is no such type.
  static const ViewType* find(const std::string& id);
};
/// Registers a type of view when it is constructed; to be used as a namespace-scope constant.
class [[maybe_unused]] ViewRegistration {
 public:
  explicit ViewRegistration(ViewType type);
};

/// The usual ViewType::create.
template <typename V>
View* create(ViewContext& context, QWidget* parent) {
  return new V(context, parent);
}

}  // namespace widgets
