// SPDX-License-Identifier: GPL-3.0-or-later
// What views keep of themselves in window layouts: each gets any JSON object, and what it makes of it is kept
// and given back.
#include <QJsonDocument>
#include <memory>
#include <vector>

#include "robotlink/commands/CommandTable.h"
#include "robotlink/session/Session.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/fuzz/OffscreenApplication.h"
#include "widgets/View.h"

namespace view_state_fuzz {

namespace {

/// All views, on a session without anything in it.
class Views {
 public:
  Views() {
    session_.setRobots({"red1"});
    session_.selectRobot("red1");
    for (const widgets::ViewType& type : widgets::ViewRegistry::all()) {
      views_.emplace_back(type.create(context_, nullptr));
      views_.back()->resize(300, 200);
      views_.back()->show();
    }
  }

  const std::vector<std::unique_ptr<widgets::View>>& all() const { return views_; }
  void tick() {
    session_.tick();
    for (const auto& view : views_) view->tick();
    QCoreApplication::processEvents();
  }

 private:
  OffscreenApplication application_;
  robotlink::Session session_;
  robotlink::CommandTable commands_;
  widgets::ViewContext context_{session_, commands_, nullptr, {}};
  std::vector<std::unique_ptr<widgets::View>> views_;
};

std::unique_ptr<Views>& instance() {
  static std::unique_ptr<Views> instance;
  return instance;
}

Views& views() {
  if (instance() == nullptr) instance() = std::make_unique<Views>();
  return *instance();
}

/// The scene is drawn in a thread.
void endViews() {
  instance().reset();
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const auto text = QByteArray(reinterpret_cast<const char*>(data), static_cast<int>(size));
  const QJsonObject state = QJsonDocument::fromJson(text).object();
  for (const auto& view : views().all()) view->restoreState(state);
  views().tick();
  for (const auto& view : views().all()) {
    const QJsonObject kept = view->saveState();
    view->restoreState(QJsonDocument::fromJson(QJsonDocument(kept).toJson()).object());
  }
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  QJsonObject all;
  for (const auto& view : views().all()) {
    const QJsonObject state = view->saveState();
    for (const QString& name : state.keys()) all.insert(name, state[name]);
    if (!state.isEmpty()) seeds.push_back(QJsonDocument(state).toJson().toStdString());
  }
  seeds.push_back(QJsonDocument(all).toJson().toStdString());
  return seeds;
}

const FuzzRegistration kTarget({"view_state", &fuzzSeeds, &runInput, nullptr, &endViews});

}  // namespace view_state_fuzz
