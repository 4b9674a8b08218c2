// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/WindowKeys.h"

#include <qtadvanceddocking/FloatingDockContainer.h>
#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPointer>
#include <QSlider>
#include <QTabBar>
#include <QTextEdit>

#include "widgets/View.h"

namespace app {
namespace {

/// The key sequence of an event ("Ctrl+Left"), independent of the part of the keyboard. On some keyboards
/// digits and punctuation are typed with Shift.
QKeySequence sequenceOf(const QKeyEvent& event) {
  auto modifiers = event.modifiers() & ~(Qt::KeypadModifier | Qt::GroupSwitchModifier);
  const int key = event.key();
  if ((key >= Qt::Key_0 && key <= Qt::Key_9) || key == Qt::Key_Period || key == Qt::Key_Comma)
    modifiers &= ~Qt::ShiftModifier;
  return {static_cast<int>(modifiers) | key};
}

/// Whether a widget shows contents, rather than being a control, so that the keys of its view are useful
/// while it has the focus.
bool isContent(const QWidget& widget) {
  return widget.isVisible() && widget.isEnabled() && (widget.focusPolicy() & Qt::ClickFocus) != 0 &&
         !isTextField(widget) && qobject_cast<const QAbstractButton*>(&widget) == nullptr &&
         qobject_cast<const QComboBox*>(&widget) == nullptr &&
         qobject_cast<const QAbstractSlider*>(&widget) == nullptr &&
         qobject_cast<const QTabBar*>(&widget) == nullptr;
}

template <typename T>
T* ancestor(QWidget* widget) {
  while (widget != nullptr && qobject_cast<T*>(widget) == nullptr) widget = widget->parentWidget();
  return static_cast<T*>(widget);
}

int areaOf(const QWidget& widget) {
  return widget.width() * widget.height();
}

/// The larger of `best` (which may be null) and the largest content of a view.
QWidget* largestContent(widgets::View& view, QWidget* best) {
  for (QWidget* widget : view.findChildren<QWidget*>()) {
    if (isContent(*widget) && (best == nullptr || areaOf(*widget) > areaOf(*best))) best = widget;
  }
  return best;
}

}  // namespace

bool isTextField(const QWidget& widget) {
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return !line->isReadOnly();
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->isEditable();
  if (const auto* text = qobject_cast<const QTextEdit*>(&widget)) return !text->isReadOnly();
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(&widget)) return !text->isReadOnly();
  return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
}

WindowKeys::WindowKeys(QWidget& window) : QObject(&window), window_(window) {
  setObjectName(QStringLiteral("windowKeys"));
  qApp->installEventFilter(this);
}

void WindowKeys::add(Binding binding) {
  binding.shipped = binding.key;
  bindings_.push_back(std::move(binding));
}

bool WindowKeys::ofWindow(const QWidget& widget) const {
  if (widget.window() == &window_) return qobject_cast<const QMenuBar*>(&widget) == nullptr;
  if (qobject_cast<const ads::CFloatingDockContainer*>(widget.window()) == nullptr) return false;
  const QWidget* parent = widget.window();
  while (parent != nullptr && parent != &window_) parent = parent->parentWidget();
  return parent != nullptr;
}

const WindowKeys::Binding* WindowKeys::find(const QWidget& focus, const QKeyEvent& event) const {
  if (QApplication::activePopupWidget() != nullptr || QApplication::activeModalWidget() != nullptr ||
      !ofWindow(focus))
    return nullptr;
  const QKeySequence key = sequenceOf(event);
  for (const Binding& binding : bindings_) {
    if (binding.key != key || (isTextField(focus) && !binding.inTextFields)) continue;
    if (!binding.applies || binding.applies()) return &binding;
  }
  return nullptr;
}

/// Return presses a focused button, like Space, which may be used to play a log.
bool WindowKeys::pressButton(QWidget& focus, const QKeyEvent& event) const {
  auto* button = qobject_cast<QAbstractButton*>(&focus);
  if (button == nullptr || !ofWindow(focus) || event.modifiers() != Qt::NoModifier ||
      event.key() != Qt::Key_Return)
    return false;
  button->click();
  return true;
}

void WindowKeys::leaveField(QWidget& focus, const QKeyEvent& event) {
  const bool ends = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
  if (!ends || qobject_cast<QAbstractSpinBox*>(&focus) == nullptr || !ofWindow(focus) ||
      ancestor<QAbstractItemView>(&focus) != nullptr)
    return;
  const auto leave = [this, field = QPointer<QWidget>(&focus)] {
    if (!field || !field->hasFocus()) return;
    auto* view = ancestor<widgets::View>(field);
    QWidget* content = view == nullptr ? nullptr : largestContent(*view, nullptr);
    content == nullptr ? focusContent() : content->setFocus(Qt::OtherFocusReason);
  };
  QMetaObject::invokeMethod(this, leave, Qt::QueuedConnection);
}

bool WindowKeys::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &window_ && event->type() == QEvent::WindowActivate) focusContent();
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride) return false;
  auto* focus = qobject_cast<QWidget*>(watched);
  const auto& key = *static_cast<QKeyEvent*>(event);
  const Binding* binding = focus != nullptr ? find(*focus, key) : nullptr;
  if (focus != nullptr && event->type() == QEvent::KeyPress) leaveField(*focus, key);
  if (binding == nullptr)
    return event->type() == QEvent::KeyPress && focus != nullptr && pressButton(*focus, key);
  event->accept();
  // Accepting ShortcutOverride makes Qt deliver the key as a key press and disables all shortcuts for it.
  if (event->type() == QEvent::KeyPress && (binding->repeats || !key.isAutoRepeat())) binding->run();
  return true;
}

void WindowKeys::focusContent() {
  QWidget* focus = window_.focusWidget();
  if (focus != nullptr && focus->isVisible() && ancestor<widgets::View>(focus) != nullptr) return;
  QWidget* best = nullptr;
  for (widgets::View* view : window_.findChildren<widgets::View*>()) {
    if (view->isVisible() && view->window() == &window_) best = largestContent(*view, best);
  }
  if (best != nullptr)
    best->setFocus(Qt::OtherFocusReason);
  else if (focus != nullptr)
    focus->clearFocus();
}

}  // namespace app
