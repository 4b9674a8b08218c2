// SPDX-License-Identifier: GPL-3.0-or-later
// The file that window layouts, recent files and the rest of the window's state are kept in: whatever is in
// it, the window opens, shows each of its perspectives, and is saved again.
#include <QApplication>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "tests/TestFolder.h"
#include "tests/fuzz/FuzzTarget.h"

namespace {

/// A home with a window's file in it, for one start of the workbench after the other.
class Home {
 public:
  Home() {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qputenv("XDG_RUNTIME_DIR", folder_.path().c_str());
    qputenv("XDG_CONFIG_HOME", folder_.path().c_str());
    qputenv("ROBOTCONTROL_RESOURCES", ROBOTCONTROL_SOURCE_DIR "/resources");
    static int count = 1;
    static char name[] = "fuzz", *names[] = {name, nullptr};
    application_ = std::make_unique<QApplication>(count, names);
  }

  std::filesystem::path file() const { return folder_ / "window.json"; }
  void start(const char* perspective) {
    app::Workbench workbench(folder_.path());
    app::MainWindow window(workbench, folder_.path());
    window.show();
    if (perspective != nullptr) window.showPerspective(QLatin1String(perspective));
    window.tick();
    QCoreApplication::processEvents();
    window.close();
  }

 private:
  TestFolder folder_;
  std::unique_ptr<QApplication> application_;
};

Home& home() {
  static Home instance;
  return instance;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::ofstream file(home().file(), std::ios::binary);
  file.write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  file.close();
  home().start(nullptr);
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  for (const char* perspective : {"Play", "Log", "Colour"}) {
    std::filesystem::remove(home().file());
    home().start(perspective);
    std::ifstream file(home().file(), std::ios::binary);
    seeds.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return seeds;
}
