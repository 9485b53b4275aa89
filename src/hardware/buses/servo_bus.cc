#include "hardware/buses/servo_bus.h"

#include <fmt/format.h>

namespace somato::devices {

Error ServoBus::explain(std::uint8_t error) const {
  return {ErrorKind::kData,
          fmt::format("reports the hardware error {:#04x} (overload, heat or voltage)",
                      unsigned{error}),
          {},
          "remove the load, let the servo cool, and run 'somato device check FILE --reboot'"};
}

}  // namespace somato::devices
