#include "hardware/lines/serial_port.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <pty.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

namespace somato::wire {
namespace {

struct Speed {
  std::size_t baud;
  speed_t code;
};

constexpr std::array<Speed, 18> kSpeeds{{{2400, B2400},
                                         {4800, B4800},
                                         {9600, B9600},
                                         {19200, B19200},
                                         {38400, B38400},
                                         {57600, B57600},
                                         {115200, B115200},
                                         {230400, B230400},
                                         {460800, B460800},
                                         {500000, B500000},
                                         {576000, B576000},
                                         {921600, B921600},
                                         {1000000, B1000000},
                                         {1152000, B1152000},
                                         {1500000, B1500000},
                                         {2000000, B2000000},
                                         {3000000, B3000000},
                                         {4000000, B4000000}}};

tl::unexpected<Error> port_error(std::string what, const std::string& port, std::string advice) {
  return fail(ErrorKind::kSystem, std::move(what), port, std::move(advice));
}

tl::unexpected<Error> cannot_open(const std::string& port) {
  const std::string what = fmt::format("cannot open the port: {}", std::strerror(errno));
  switch (errno) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return port_error(what, port, "connect the device, and look for its port with: ls /dev/tty*");
    case EACCES:
      return port_error(what, port,
                        "give yourself access, on Debian with: sudo adduser $USER dialout, and log "
                        "in again");
    default:
      return port_error(what, port, "check the port in the device file");
  }
}

tl::unexpected<Error> hung_up_at(const std::string& port) {
  return port_error("the line has hung up", port, "check the cable and the power of the device");
}

Result<speed_t> speed_of(const std::string& port, std::size_t baud) {
  for (const Speed& speed : kSpeeds) {
    if (speed.baud == baud) return speed.code;
  }
  std::string known;
  for (const Speed& speed : kSpeeds) known += fmt::format(" {}", speed.baud);
  return port_error(fmt::format("{} is no speed of a serial port", baud), port,
                    "use one of these:" + known);
}

Result<void> configure(int descriptor, speed_t speed, const std::string& port) {
  termios settings{};
  if (tcgetattr(descriptor, &settings) != 0) {
    return port_error("this is no serial port", port, "give the path of a serial port");
  }
  cfmakeraw(&settings);
  settings.c_cflag |= static_cast<tcflag_t>(CLOCAL | CREAD);
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS | HUPCL);
  settings.c_cc[VMIN] = 0;
  settings.c_cc[VTIME] = 0;
  cfsetispeed(&settings, speed);
  cfsetospeed(&settings, speed);
  if (tcsetattr(descriptor, TCSANOW, &settings) == 0) return {};
  return port_error(fmt::format("the port refuses its settings: {}", std::strerror(errno)), port,
                    "use another speed");
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (is_open()) close(number_);
}

Result<Descriptor> open_serial_port(const std::string& port, std::size_t baud) {
  SOMATO_TRY(const auto speed, speed_of(port, baud));
  Descriptor opened(open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!opened.is_open()) return cannot_open(port);
  if (isatty(opened.number()) != 1) {
    if (errno == EIO) return hung_up_at(port);
    return port_error("this is no serial port", port, "give the path of a serial port");
  }
  // Two processes would each read a part of the answers.
  if (flock(opened.number(), LOCK_EX | LOCK_NB) != 0) {
    return port_error("another process uses the port", port, "end it first");
  }
  SOMATO_TRY_VOID(configure(opened.number(), speed, port));
  tcflush(opened.number(), TCIOFLUSH);
  return opened;
}

Result<PseudoTerminal> open_pseudo_terminal() {
  int device = -1;
  int host = -1;
  std::array<char, 256> name{};
  if (openpty(&device, &host, name.data(), nullptr, nullptr) != 0) {
    return port_error(fmt::format("cannot open a pseudo-terminal: {}", std::strerror(errno)), {},
                      "close other programs that use pseudo-terminals");
  }
  PseudoTerminal terminal{Descriptor(device), name.data()};
  const Descriptor first_host(host);
  SOMATO_TRY_VOID(configure(host, B115200, terminal.port));
  fcntl(device, F_SETFL, fcntl(device, F_GETFL) | O_NONBLOCK);
  fcntl(device, F_SETFD, FD_CLOEXEC);
  return terminal;
}

Result<std::size_t> read_available(int descriptor, std::span<std::uint8_t> bytes,
                                   const std::string& port) {
  const ssize_t count = read(descriptor, bytes.data(), bytes.size());
  if (count >= 0) return static_cast<std::size_t>(count);
  if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return 0;
  if (errno == EIO || errno == ENXIO || errno == ENODEV) return hung_up_at(port);
  return port_error(fmt::format("cannot read: {}", std::strerror(errno)), port,
                    "check the cable and the power of the device");
}

Result<std::size_t> write_available(int descriptor, std::span<const std::uint8_t> bytes,
                                    const std::string& port) {
  if (bytes.empty()) return 0;
  const ssize_t count = write(descriptor, bytes.data(), bytes.size());
  if (count >= 0) return static_cast<std::size_t>(count);
  if (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR) return 0;
  if (errno == EIO || errno == ENXIO || errno == ENODEV) return hung_up_at(port);
  return port_error(fmt::format("cannot write: {}", std::strerror(errno)), port,
                    "check the cable and the power of the device");
}

}  // namespace somato::wire
