#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "somato/core/result.h"

namespace somato::program {

/// The service manager that has started the program, such as systemd, by the protocol of
/// sd_notify(3): each message is a datagram to a local socket.
class ServiceManager {
 public:
  /// From the environment: NOTIFY_SOCKET, and WATCHDOG_USEC with WATCHDOG_PID. Without the first
  /// one there is no manager. Errors (kUsage): an address or a time that the protocol does not
  /// permit.
  static Result<ServiceManager> from_environment();

  /// Sends a message, such as "READY=1", if there is a manager. Errors (kSystem): it cannot be
  /// sent.
  Result<void> notify(const std::string& message) const;

  /// The time without "WATCHDOG=1" after which the manager ends the program; nothing if it waits
  /// for none.
  std::optional<std::chrono::microseconds> patience() const { return patience_; }

 private:
  ServiceManager(std::string address, std::optional<std::chrono::microseconds> patience)
      : address_(std::move(address)), patience_(patience) {}

  std::string address_;  // Empty: no manager. '@' in front: a name of no file.
  std::optional<std::chrono::microseconds> patience_;
};

}  // namespace somato::program
