// SPDX-License-Identifier: GPL-3.0-or-later
// The file that window layouts, recent files and the rest of the window's state are kept in: whatever is in
// it, the window opens, shows each of its perspectives, and is saved again.
#include <fstream>

#include "app/core/Workbench.h"
#include "app/robotcontrol/MainWindow.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/fuzz/OffscreenApplication.h"

namespace window_file_fuzz {

namespace {

/// A home with a window's file in it, for one start of the workbench after the other.
class Home {
 public:
  std::filesystem::path file() const { return application_.folder() / "window.json"; }
  void start(const char* perspective) {
    app::Workbench workbench(application_.folder());
    app::MainWindow window(workbench, application_.folder());
    window.show();
    if (perspective != nullptr) window.showPerspective(QLatin1String(perspective));
    window.tick();
    QCoreApplication::processEvents();
    window.close();
  }

 private:
  OffscreenApplication application_;
};

Home& home() {
  static Home instance;
  return instance;
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
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

const FuzzRegistration kTarget({"window_file", &fuzzSeeds, &runInput});

}  // namespace window_file_fuzz
