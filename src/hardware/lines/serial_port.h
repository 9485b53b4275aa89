#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "somato/core/result.h"

namespace somato::wire {

/// An open file descriptor, closed with the object.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();

  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

/// Opens a serial port with 8 data bits, no parity, 1 stop bit and no flow control, for reading and
/// writing without waiting, and for this process only. Errors (kSystem) say what to do: the port is
/// missing, belongs to another user, is used by another process, is no serial port, or does not
/// know this speed.
Result<Descriptor> open_serial_port(const std::string& port, std::size_t baud);

/// A pseudo-terminal: the side of the device, and the path of the port that a host opens.
struct PseudoTerminal {
  Descriptor device;
  std::string port;
};

/// Opens a pseudo-terminal that passes bytes on unchanged. The device's side neither waits nor sees
/// a hang-up before the first host. Errors: kSystem.
Result<PseudoTerminal> open_pseudo_terminal();

/// Reads what is there, at most `bytes.size()`, without waiting. Errors (kSystem): the other side
/// has hung up; those of the system.
Result<std::size_t> read_available(int descriptor, std::span<std::uint8_t> bytes,
                                   const std::string& port);

/// Writes what is accepted without waiting. Errors as read_available().
Result<std::size_t> write_available(int descriptor, std::span<const std::uint8_t> bytes,
                                    const std::string& port);

}  // namespace somato::wire
