// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QJsonObject>
#include <QString>
#include <QWidget>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace robotlink {
class CommandTable;
class Session;
struct FieldDescription;
struct RobotDescription;
}  // namespace robotlink

namespace widgets {

class ColorBench;
class OpenLogs;

/// What a view may use. All of it outlives the view.
struct ViewContext {
  robotlink::Session& session;
  robotlink::CommandTable& commands;
  std::shared_ptr<const robotlink::FieldDescription> field;  ///< null: none is known
  std::map<std::string, std::shared_ptr<const robotlink::RobotDescription>>
      robots;                               ///< by robot's name, "red1"
  std::shared_ptr<OpenLogs> logs = {};      ///< those of the replay; see openLogs()
  std::shared_ptr<ColorBench> colors = {};  ///< the colour table that is being made; see colorBench()
};

/// A dockable view of a session: everything it shows comes from the session's streams, everything it does is
/// a request.
///
/// tick() is called 30 times a second while the view is visible, after the session took in what is new; a
/// view looks at the session then and updates once. What the user chose (robot, stream, zoom, filter)
/// survives in saveState(). GUI thread.
class View : public QWidget {
  Q_OBJECT
 public:
  explicit View(ViewContext& context, QWidget* parent = nullptr);

  virtual void tick() = 0;
  /// What the user chose here, to be kept over restarts and perspectives. Unknown or missing entries must be
  /// harmless in restoreState().
  virtual QJsonObject saveState() const { return {}; }
  virtual void restoreState(const QJsonObject& state) { (void)state; }

 Q_SIGNALS:
  /// What the dock shows above the view changed: "Image: red1/camera".
  void titleChanged(const QString& title);

 protected:
  ViewContext& context() const { return context_; }
  robotlink::Session& session() const { return context_.session; }

 private:
  ViewContext& context_;
};

/// A kind of view.
struct ViewType {
  const char* id;     ///< "image"; part of saved window layouts: never changed
  const char* title;  ///< "Image", translated when shown
  const char* help;   ///< one sentence, for menus and tooltips
  const char* icon;   ///< name of an icon of resources/icons
  bool several;       ///< more than one may be open at a time
  std::function<View*(ViewContext&, QWidget*)> create;
};

/// All kinds of views, filled before main() starts. A view registers itself with one line in its .cpp:
///
///     const ViewRegistration kRegistration{{"image", QT_TR_NOOP("Image"), QT_TR_NOOP("..."), "image", true,
///     create<ImageView>}};
class ViewRegistry {
 public:
  static const std::vector<ViewType>& all();
  static const ViewType* find(const std::string& id);
};
class ViewRegistration {
 public:
  explicit ViewRegistration(ViewType type);
};

template <typename V>
View* create(ViewContext& context, QWidget* parent) {
  return new V(context, parent);
}

}  // namespace widgets
