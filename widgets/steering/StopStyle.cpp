// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/steering/StopStyle.h"

#include <QCoreApplication>

namespace widgets {

QString stopStyle(const QString& widgetClass) {
  return QStringLiteral(
             "%1 { background: #c62828; color: white; font-weight: bold; border: 2px solid #8e1b1b; "
             "border-radius: 5px;"
             " padding: 2px 12px; }"
             "%1:hover { background: #d83a3a; } %1:pressed { background: #8e1b1b; }"
             "%1:checked { background: #ffd54f; color: #5d1212; border-color: #c62828; }"
             "%1:focus { border-color: white; }"
             "%1:disabled { background: #808388; color: #e4e6ea; border-color: #6a6d72; }")
      .arg(widgetClass);
}

QString stopText(bool engaged) {
  return engaged ? QCoreApplication::translate("Stop", "STOPPED: click to release")
                 : QCoreApplication::translate("Stop", "STOP");
}

}  // namespace widgets
