// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/Shortcuts.h"

#include <qtadvanceddocking/DockWidget.h>
#include <QAction>
#include <QCoreApplication>
#include <QEvent>
#include <QShortcut>
#include <QWidget>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/robotcontrol/actions/WindowKeys.h"
#include "robotlink/session/VersionedFile.h"
#include "widgets/View.h"

namespace app {
namespace {

using robotlink::failure;
using robotlink::Result;

/// The property of an action that has the key as it is shipped, once it has another one.
constexpr char kShippedKey[] = "shippedShortcut";
/// The property of an action whose tooltip ended with a shortcut that was removed.
constexpr char kTipHadKey[] = "toolTipHadShortcut";

const robotlink::VersionedFormat& shortcutFormat() {
  static const robotlink::VersionedFormat instance{"robotcontrol-shortcuts", 1, "shortcuts"};
  return instance;
}

/// The view to which an object belongs; null if it belongs to the window.
const widgets::View* viewAround(const QObject* object) {
  while (object != nullptr && qobject_cast<const widgets::View*>(object) == nullptr)
    object = object->parent();
  return static_cast<const widgets::View*>(object);
}

/// The kind of a view; empty without one.
QString viewKindOf(const widgets::View* view) {
  const QObject* object = view;
  while (object != nullptr && qobject_cast<const ads::CDockWidget*>(object) == nullptr)
    object = object->parent();
  return object != nullptr ? object->objectName().section(QLatin1Char('#'), 0, 0) : QString();
}

/// The title of a view's kind ("Image"), whatever it shows now; the same as in the menu.
QString viewTitle(const QString& kind) {
  const widgets::ViewType* type = widgets::ViewRegistry::find(kind.toStdString());
  return type != nullptr ? QCoreApplication::translate("View", type->title) : kind;
}

QString shortcutId(const QAction& action) {
  if (action.objectName().isEmpty()) return {};
  return QStringLiteral("%1/%2").arg(viewKindOf(viewAround(&action)), action.objectName());
}

QString shortcutId(const WindowKeys::Binding& binding) {
  return QStringLiteral("keys/") + binding.shipped.toString(QKeySequence::PortableText);
}

QKeySequence shippedKey(const QAction& action) {
  const QVariant shipped = action.property(kShippedKey);
  return shipped.isValid() ? shipped.value<QKeySequence>() : action.shortcut();
}

void addShortcut(std::vector<Shortcut>& all, Shortcut shortcut) {
  const auto same = [&](const Shortcut& other) {
    return other.key == shortcut.key && other.text == shortcut.text && other.view == shortcut.view;
  };
  const bool hadKey = !shortcut.key.isEmpty() || !shortcut.shipped.isEmpty();
  if (hadKey && std::ranges::none_of(all, same)) all.push_back(std::move(shortcut));
}

/// Says in the tooltip of an action another key than before.
void setKeyInTip(QAction& action, const QString& before, const QString& key) {
  const QString said = QStringLiteral(" (%1)");
  QString tip = action.toolTip();
  if (key.isEmpty() && !before.isEmpty() && tip.endsWith(said.arg(before))) {
    tip.chop(said.arg(before).size());
    action.setProperty(kTipHadKey, true);
  } else if (!before.isEmpty()) {
    tip.replace(before, key);
  } else if (!key.isEmpty() && action.property(kTipHadKey).toBool()) {
    tip += said.arg(key);
  }
  if (tip != action.toolTip()) action.setToolTip(tip);
}

/// Sets the key of an action, and says it in the tooltip instead of the one before.
void setActionKey(QAction& action, const QKeySequence& key) {
  if (!action.property(kShippedKey).isValid()) action.setProperty(kShippedKey, action.shortcut());
  setKeyInTip(action, action.shortcut().toString(QKeySequence::NativeText),
              key.toString(QKeySequence::NativeText));
  action.setShortcut(key);
}

}  // namespace

Shortcuts::Shortcuts(WindowKeys& keys, std::filesystem::path file, QWidget& window)
    : QObject(&window), keys_(keys), file_(std::move(file)), window_(window) {
  load();
  apply();
  qApp->installEventFilter(this);
}

void Shortcuts::load() {
  const auto contents = robotlink::readVersioned(file_, shortcutFormat());
  if (!contents) {
    problem_ = robotlink::keepAside(file_, contents.error());
    return;
  }
  for (const auto& [id, key] : contents->items()) {
    if (!key.is_string()) continue;
    chosen_[QString::fromStdString(id)] =
        QKeySequence::fromString(QString::fromStdString(key.get<std::string>()), QKeySequence::PortableText);
  }
}

Result<void> Shortcuts::save() const {
  nlohmann::json contents = nlohmann::json::object();
  for (const auto& [id, key] : chosen_)
    contents[id.toStdString()] = key.toString(QKeySequence::PortableText).toStdString();
  return robotlink::writeVersioned(file_, shortcutFormat(), contents);
}

std::vector<Shortcut> Shortcuts::all() const {
  std::vector<Shortcut> all;
  for (const auto& binding : keys_.bindings())
    addShortcut(all, {binding.key, binding.text, {}, nullptr, shortcutId(binding), binding.shipped});
  for (QAction* action : window_.findChildren<QAction*>()) {
    const QString text = action->text().remove(QLatin1Char('&')),
                  view = viewTitle(viewKindOf(viewAround(action)));
    const QString id = shortcutId(*action);
    // A removed key can be given again.
    if (action->shortcuts().isEmpty()) addShortcut(all, {{}, text, view, action, id, shippedKey(*action)});
    bool isFirst = true;
    for (const QKeySequence& key : action->shortcuts()) {
      addShortcut(all,
                  {key, text, view, action, isFirst ? id : QString(), isFirst ? shippedKey(*action) : key});
      isFirst = false;
    }
  }
  for (auto* shortcut : window_.findChildren<QShortcut*>()) {
    const widgets::View* view = viewAround(shortcut);
    if (const QString text = shortcut->whatsThis(); view != nullptr && !text.isEmpty())
      addShortcut(all, {shortcut->key(), text, viewTitle(viewKindOf(view)), shortcut, {}, shortcut->key()});
  }
  return all;
}

std::optional<Shortcut> Shortcuts::conflict(const Shortcut& shortcut, const QKeySequence& key) const {
  if (key.isEmpty()) return std::nullopt;
  for (const Shortcut& other : all()) {
    const bool isItself = !shortcut.id.isEmpty() && other.id == shortcut.id;
    const bool meet = other.view.isEmpty() || shortcut.view.isEmpty() || other.view == shortcut.view;
    if (!isItself && meet && other.key == key) return other;
  }
  return std::nullopt;
}

Result<void> Shortcuts::assign(const Shortcut& shortcut, const QKeySequence& key) {
  if (shortcut.id.isEmpty())
    return failure("shortcut.fixed",
                   tr("The key of \"%1\" cannot be changed.").arg(shortcut.text).toStdString());
  if (shortcut.owner == nullptr && key.count() > 1)
    return failure("shortcut.single", tr("\"%1\" needs a single key.").arg(shortcut.text).toStdString());
  if (const auto other = conflict(shortcut, key)) {
    const QString where = other->view.isEmpty() ? tr("everywhere") : tr("in the view %1").arg(other->view);
    return failure("shortcut.conflict",
                   tr("%1 is the key of \"%2\" already, %3; give that another one first.")
                       .arg(key.toString(QKeySequence::NativeText), other->text, where)
                       .toStdString());
  }
  if (key == shortcut.shipped) {
    chosen_.erase(shortcut.id);
  } else {
    chosen_[shortcut.id] = key;
  }
  set(shortcut, key);
  apply();
  return save();
}

Result<void> Shortcuts::resetAll() {
  for (const Shortcut& shortcut : all()) {
    if (chosen_.contains(shortcut.id)) set(shortcut, shortcut.shipped);
  }
  chosen_.clear();
  return save();
}

void Shortcuts::set(const Shortcut& shortcut, const QKeySequence& key) {
  if (shortcut.owner == nullptr) {
    for (std::size_t i = 0; i < keys_.bindings().size(); ++i) {
      if (shortcutId(keys_.bindings()[i]) == shortcut.id) keys_.setKey(i, key);
    }
    return;
  }
  // All views of a kind have the same keys.
  for (QAction* action : window_.findChildren<QAction*>(shortcut.owner->objectName())) {
    if (shortcutId(*action) == shortcut.id && action->shortcut() != key) setActionKey(*action, key);
  }
}

void Shortcuts::apply() {
  if (chosen_.empty() || std::exchange(isApplying_, true)) return;
  for (const Shortcut& shortcut : all()) {
    const auto chosen = chosen_.find(shortcut.id);
    if (chosen != chosen_.end() && shortcut.key != chosen->second) set(shortcut, chosen->second);
  }
  isApplying_ = false;
}

bool Shortcuts::eventFilter(QObject* watched, QEvent* event) {
  // Its actions are there when a view is polished, which is before it is shown.
  if (event->type() == QEvent::Polish && qobject_cast<widgets::View*>(watched) != nullptr) apply();
  return false;
}

}  // namespace app
