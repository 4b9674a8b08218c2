// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/presets/PresetMenu.h"

#include "app/robotcontrol/actions/CommandActions.h"
#include "app/robotcontrol/presets/PresetActions.h"
#include "app/robotcontrol/presets/PresetsDialog.h"

namespace app {

PresetMenu::PresetMenu(CommandActions& actions, PresetActions& presets, QWidget* window)
    : QMenu(tr("Pr&esets"), window), actions_(actions), presets_(presets) {
  setObjectName(QStringLiteral("presetMenu"));
  connect(&presets_, &PresetActions::changed, this, &PresetMenu::fill);
  // Presets may have been saved by another program, or by the view of debug keys.
  connect(this, &QMenu::aboutToShow, this, &PresetMenu::fill);
  fill();
}

void PresetMenu::fill() {
  clear();
  for (const std::string& name : presets_.presets().names()) {
    QAction* load = addAction(QString::fromStdString(name), this,
                              [this, name] { actions_.run(QStringLiteral("preset.load"), {name}); });
    load->setObjectName(QStringLiteral("preset.") + QString::fromStdString(name));
  }
  addSeparator();
  addAction(tr("&Save, compare, delete…"), this, [this] {
    PresetsDialog(presets_, parentWidget()).exec();
  })->setObjectName(QStringLiteral("preset.dialog"));
}

}  // namespace app
