// SPDX-License-Identifier: GPL-3.0-or-later
// The views of robots on wheels, tested in one program: what they are linked with is the same.
#include <QApplication>

#include "tests/widgets/drive/DriveWorld.h"

int main(int argc, char** argv) {
  QApplication application(argc, argv);
  Bench::prepare(ROBOTCONTROL_SOURCE_DIR);
  int failures = 0;
  for (const auto run :
       {runRadarTests, runBaseStateTests, runMapTests, runDrivingTests, runPacketTests, runConnectTests})
    failures += run(argc, argv);
  Bench::tidyUp();
  return failures;
}
