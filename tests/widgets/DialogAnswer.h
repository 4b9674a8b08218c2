// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QTest>
#include <QTimer>
#include <functional>

/// Operates the dialog that the next action opens, while that action waits for it. If the dialog is still
/// open afterwards, it is canceled, so that the test fails instead of blocking.
class DialogAnswer {
 public:
  explicit DialogAnswer(std::function<void(QDialog&)> act) {
    timer_.callOnTimeout([this, act = std::move(act)] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      if (dialog == nullptr) return;
      timer_.stop();
      asked_ = true;
      act(*dialog);
      if (dialog->isVisible()) dialog->reject();
    });
    timer_.start(1);
  }
  /// Enters a file name in a file dialog and presses its button.
  static DialogAnswer file(const QString& name) {
    return DialogAnswer([name](QDialog& dialog) {
      auto* field = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      if (field == nullptr) qFatal("%s is no dialog for files", qPrintable(dialog.windowTitle()));
      field->setText(name);
      press(dialog, QDialogButtonBox::AcceptRole);
    });
  }
  static void press(QDialog& dialog, QDialogButtonBox::ButtonRole role) {
    auto* box = dialog.findChild<QDialogButtonBox*>();
    if (box == nullptr) qFatal("the dialog has no buttons");
    for (QAbstractButton* button : box->buttons()) {
      if (box->buttonRole(button) == role) return QTest::mouseClick(button, Qt::LeftButton);
    }
    qFatal("the dialog has no such button");
  }
  /// Whether a dialog was opened.
  bool asked() const { return asked_; }

 private:
  QTimer timer_;
  bool asked_ = false;
};
