// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/SerialPorts.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/TestFolder.h"

namespace robotlink::arcos {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

/// A folder as /sys/class/tty is.
struct SerialPortsTest : testing::Test {
  /// Returns the USB device's folder.
  fs::path addUsb(const std::string& tty) {
    const fs::path usb = folder / ("usb-" + tty);
    fs::create_directories(usb / "1-1:1.0" / tty);
    fs::create_directories(folder / "tty" / tty);
    fs::create_directory_symlink(usb / "1-1:1.0" / tty, folder / "tty" / tty / "device");
    return usb;
  }
  void addBuiltIn(const std::string& tty, const std::string& type) {
    fs::create_directories(folder / "tty" / tty / "device");
    write(folder / "tty" / tty / "type", type);
  }
  static void write(const fs::path& file, const std::string& text) { std::ofstream(file) << text << "\n"; }
  std::vector<SerialPort> ports() const { return serialPorts(folder / "tty"); }

  TestFolder folder;
};

TEST_F(SerialPortsTest, adaptersSayWhatTheyAre) {
  const fs::path usb = addUsb("ttyUSB0");
  write(usb / "product", "FT232R USB UART");
  write(usb / "manufacturer", "FTDI");
  write(usb / "serial", "A50285BI");
  EXPECT_THAT(ports(), ElementsAre(SerialPort{"/dev/ttyUSB0", "FTDI FT232R USB UART (A50285BI)"}));
}

TEST_F(SerialPortsTest, aMakerIsNotNamedTwice) {
  const fs::path usb = addUsb("ttyACM0");
  write(usb / "product", "Arduino Uno");
  write(usb / "manufacturer", "Arduino");
  EXPECT_THAT(ports(), ElementsAre(SerialPort{"/dev/ttyACM0", "Arduino Uno"}));
}

TEST_F(SerialPortsTest, adaptersComeFirstAndByNumberAndPortsWithoutHardwareNotAtAll) {
  addBuiltIn("ttyS0", "4");
  addBuiltIn("ttyS1", "0");
  addUsb("ttyUSB10");
  addUsb("ttyUSB2");
  fs::create_directories(folder / "tty" / "rfcomm0");
  fs::create_directories(folder / "tty" / "tty1");
  EXPECT_THAT(ports(), ElementsAre(SerialPort{"/dev/ttyUSB2", "USB serial adapter"},
                                   SerialPort{"/dev/ttyUSB10", "USB serial adapter"},
                                   SerialPort{"/dev/rfcomm0", "Bluetooth serial port"},
                                   SerialPort{"/dev/ttyS0", "built-in serial port"}));
}

TEST_F(SerialPortsTest, aMachineWithoutPortsHasNone) {
  EXPECT_THAT(ports(), IsEmpty());
}

}  // namespace
}  // namespace robotlink::arcos
