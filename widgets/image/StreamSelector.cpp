// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/StreamSelector.h"

#include "robotlink/session/Session.h"

namespace widgets {

StreamSelector::StreamSelector(std::string type, QString choice, QWidget* parent)
    : QComboBox(parent), type_(std::move(type)), choice_(std::move(choice)) {
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(14);
  connect(this, QOverload<int>::of(&QComboBox::activated), this,
          [this] { setChoice(currentData().toString()); });
}

bool StreamSelector::refresh(robotlink::Session& session) {
  const auto& store = session.store();
  if (store.listVersion() == listVersion_ && session.selectedRobot() == listedRobot_) return false;
  listVersion_ = store.listVersion();
  listedRobot_ = session.selectedRobot();
  const QString folder = QString::fromStdString(listedRobot_) + QLatin1Char('/');
  QStringList choices, paths;
  for (const auto* stream : store.streams()) {
    if (stream->type != type_) continue;
    const QString path = QString::fromStdString(stream->path);
    paths << path;
    if (path.startsWith(folder)) choices << QStringLiteral("*/") + path.mid(folder.size());
  }
  if (!paths.contains(choice_) && !choices.contains(choice_)) choices.prepend(choice_);
  clear();
  for (const QString& choice : choices + paths) {
    const bool ofSelected = choice.startsWith(QLatin1Char('*'));
    addItem(ofSelected ? tr("Selected robot: %1").arg(choice.mid(2)) : choice, choice);
  }
  setCurrentIndex(findData(choice_));
  return true;
}

std::string StreamSelector::path(const robotlink::Session& session) const {
  QString path = choice_;
  if (path.startsWith(QLatin1Char('*'))) path.replace(0, 1, QString::fromStdString(session.selectedRobot()));
  return path.toStdString();
}

void StreamSelector::setChoice(const QString& choice) {
  if (choice.isEmpty()) return;
  choice_ = choice;
  listVersion_ = ~0ULL;  // lists the choice even if it does not exist
  Q_EMIT choiceChanged();
}

}  // namespace widgets
