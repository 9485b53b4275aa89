#include "hardware/device_files/bus_scan.h"

#include <algorithm>
#include <array>
#include <span>

#include "hardware/buses/packet_bus.h"

namespace somato::devices {
namespace {

constexpr double kScanAnswerTime = 0.05;  // s; an adapter may collect bytes for 16 ms

bool read_answer(const BusInquiry& inquiry, FoundServo& found) {
  while (const auto packet = inquiry.decoder->next_status()) {
    if (packet->parameters.size() != inquiry.size) continue;
    found.id = packet->id;  // An answer may be late; two servos do not answer at once.
    const auto bytes = packet->parameters.subspan(inquiry.model, 2);
    const bool low_first = inquiry.order == wire::ByteOrder::kLowFirst;
    found.model = static_cast<unsigned>(bytes[low_first ? 0 : 1] | bytes[low_first ? 1 : 0] << 8);
    found.name = inquiry.name_of(*found.model);
    return true;
  }
  return false;
}

Result<std::optional<FoundServo>> ask(const BusInquiry& inquiry, std::uint8_t id,
                                      wire::Exchange& exchange) {
  std::array<std::uint8_t, 32> memory{};
  inquiry.writer->use(memory);
  inquiry.request(*inquiry.writer, id);
  const std::span<const std::uint8_t> request = inquiry.writer->written();
  inquiry.decoder->clear();
  FoundServo found{id, {}, {}};
  std::size_t arrived = 0;
  const auto take = [&](std::span<const std::uint8_t> bytes) {
    arrived += bytes.size();
    inquiry.decoder->put(bytes);
    return read_answer(inquiry, found);
  };
  SOMATO_TRY(const bool answered, exchange.request(request, kScanAnswerTime, 1, take));
  // Some adapters return the request, and a byte of noise is no servo.
  constexpr std::size_t kNoise = 2;
  if (!answered && arrived <= request.size() + kNoise) return std::optional<FoundServo>();
  return std::optional(found);
}

}  // namespace

Result<std::vector<FoundServo>> scan_bus(BusKind kind, wire::Exchange& exchange,
                                         const std::function<bool()>& should_continue) {
  const BusTraits& bus = traits_of(kind);
  if (bus.inquiry == nullptr) {
    return fail(ErrorKind::kUsage, bus.no_scan, {},
                "omit '--scan'; look where the servos are connected");
  }
  const BusInquiry inquiry = bus.inquiry();
  std::vector<FoundServo> servos;
  for (std::size_t id = 0; id < inquiry.ids; ++id) {
    if (!should_continue()) return fail(ErrorKind::kInterrupted, "the scan was interrupted");
    SOMATO_TRY(auto found, ask(inquiry, static_cast<std::uint8_t>(id), exchange));
    const bool is_known = found && std::ranges::any_of(servos, [&](const FoundServo& servo) {
                            return servo.id == found->id;
                          });
    if (found && !is_known) servos.push_back(std::move(*found));
  }
  return servos;
}

}  // namespace somato::devices
