// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/drive/LinkWords.h"

#include <QCoreApplication>

#include "robotcontrol/Driving.pb.h"

namespace widgets {
namespace {

using robotcontrol::LinkStatus;

constexpr double kSilence = 3;     // s without a status, after which it is reported as old
constexpr double kLongGap = 0.25;  // s; ARIA's clients warn of longer gaps

struct LinkText {
  Q_DECLARE_TR_FUNCTIONS(LinkWords)
};

void nameState(LinkWords& words, const LinkStatus& status) {
  switch (status.state()) {
    case LinkStatus::CONNECTING:
      words.state = LinkText::tr("connecting…");
      words.meaning = Meaning::kNote;
      return;
    case LinkStatus::CONNECTED:
      words.state = LinkText::tr("connected");
      words.meaning = Meaning::kGood;
      return;
    case LinkStatus::LOST:
      words.state = LinkText::tr("lost");
      words.meaning = Meaning::kBad;
      return;
    case LinkStatus::LISTENING:
      words.state = LinkText::tr("waits for a client");
      words.meaning = Meaning::kNote;
      return;
    default:
      words.state = LinkText::tr("closed");
      words.meaning = Meaning::kMuted;
  }
}

}  // namespace

LinkWords linkWords(const LinkStatus& status, double age) {
  LinkWords words;
  nameState(words, status);
  if (age > kSilence) {
    words.state = LinkText::tr("%1; nothing new for %2 s").arg(words.state).arg(age, 0, 'f', 0);
    if (words.meaning == Meaning::kGood) words.meaning = Meaning::kWarning;
  }
  QStringList names;
  for (const std::string* name : {&status.robot_name(), &status.robot_class(), &status.robot_subclass()}) {
    if (!name->empty()) names << QString::fromStdString(*name);
  }
  words.robot = names.join(QStringLiteral(", "));
  if (!status.client().empty()) {
    words.client = LinkText::tr("%1, %2 commands/s")
                       .arg(QString::fromStdString(status.client()))
                       .arg(status.commands_per_second(), 0, 'f', 1);
  }
  words.longGap = status.state() == LinkStatus::CONNECTED && status.longest_gap() > kLongGap;
  return words;
}

}  // namespace widgets
