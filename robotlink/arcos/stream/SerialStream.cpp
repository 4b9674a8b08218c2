// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/SerialStream.h"

#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/serial_port.hpp>
#include <cerrno>

#include "robotlink/arcos/stream/DescriptorStream.h"
#include "robotlink/arcos/stream/SerialPorts.h"

namespace robotlink::arcos {
namespace {

namespace asio = boost::asio;
using asio::serial_port;
using boost::system::error_code;

class SerialStream final : public DescriptorStream {
 public:
  SerialStream(int descriptor, const SerialAddress& address)
      : DescriptorStream(descriptor, toString(address)), device_(address.device) {}

 private:
  std::string describeLoss(int) const override {
    return device_ + " is gone: was its cable or its adapter unplugged? Plug it in and connect again";
  }
  ssize_t writeSome(std::span<const std::uint8_t> bytes) override {
    return ::write(descriptor(), bytes.data(), bytes.size());
  }

  const std::string device_;
};

std::string portsFound() {
  std::string text;
  for (const SerialPort& port : serialPorts()) text += (text.empty() ? "" : ", ") + port.device;
  return text.empty() ? "no serial port was found on this machine" : "found on this machine: " + text;
}

tl::unexpected<Error> notOpened(const std::string& device, const error_code& error) {
  switch (error.value()) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return failure("stream.no-device",
                     "there is no " + device + ": is its cable plugged in? (" + portsFound() + ")", {},
                     {device});
    case EACCES:
    case EPERM:
      return failure("stream.not-allowed",
                     "you may not open " + device +
                         ": become a member of its group (sudo adduser $USER dialout) and log in again",
                     {}, {device});
    case ENOTTY:
    case EISDIR:
      return failure("stream.not-serial", device + " is not a serial port (" + portsFound() + ")", {},
                     {device});
    default:
      return failure("stream.not-opened", device + " cannot be opened as a serial line: " + error.message(),
                     {}, {device});
  }
}

error_code configure(serial_port& port, int baud) {
  error_code error;
  if (port.set_option(serial_port::baud_rate(static_cast<unsigned>(baud)), error)) return error;
  if (port.set_option(serial_port::character_size(8), error)) return error;
  if (port.set_option(serial_port::parity(serial_port::parity::none), error)) return error;
  if (port.set_option(serial_port::stop_bits(serial_port::stop_bits::one), error)) return error;
  port.set_option(serial_port::flow_control(serial_port::flow_control::none), error);
  return error;
}

}  // namespace

Result<std::unique_ptr<ByteStream>> openSerial(const SerialAddress& address) {
  asio::io_context context;
  serial_port port(context);
  error_code error;
  if (port.open(address.device, error)) return notOpened(address.device, error);
  if (::flock(port.native_handle(), LOCK_EX | LOCK_NB) != 0) {
    return failure("stream.in-use",
                   address.device + " is used by another program: end that one, or use another port", {},
                   {address.device});
  }
  if (const error_code unfit = configure(port, address.baud)) return notOpened(address.device, unfit);
  // Discards old data of the line.
  ::tcflush(port.native_handle(), TCIOFLUSH);
  const int descriptor = ::dup(port.native_handle());
  if (descriptor < 0) return notOpened(address.device, error_code(errno, boost::system::system_category()));
  return std::make_unique<SerialStream>(descriptor, address);
}

}  // namespace robotlink::arcos
