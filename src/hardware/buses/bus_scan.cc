#include "hardware/buses/bus_scan.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "hardware/buses/dynamixel_bus.h"
#include "hardware/buses/feetech_bus.h"

namespace somato::devices {
namespace {

constexpr double kScanAnswerTime = 0.05;  // s; an adapter may collect bytes for 16 ms
// As far as the model. A request of two bytes would have an echo that looks like its answer.
constexpr std::uint8_t kFeetechIdentity = wire::feetech::kModel + 2;

// The request for the model, and where it is in the answer.
class Inquiry {
 public:
  explicit Inquiry(BusKind kind) : kind_(kind) {
    const auto series =
        kind == BusKind::kScs ? wire::FeetechSeries::kScs : wire::FeetechSeries::kSts;
    order_ = is_dynamixel() ? wire::ByteOrder::kLowFirst : wire::feetech_order(series);
    if (is_dynamixel()) {
      writer_ = std::make_unique<wire::DynamixelWriter>();
      decoder_ = std::make_unique<wire::DynamixelDecoder>();
    } else {
      writer_ = std::make_unique<wire::FeetechWriter>(order_);
      decoder_ = std::make_unique<wire::FeetechDecoder>();
    }
  }

  Result<std::optional<FoundServo>> ask(std::uint8_t id, wire::Exchange& exchange) {
    std::array<std::uint8_t, 32> memory{};
    writer_->use(memory);
    if (is_dynamixel()) {
      writer_->ping(id);
    } else {
      writer_->read(id, 0, kFeetechIdentity);
    }
    const std::span<const std::uint8_t> request = writer_->written();
    decoder_->clear();
    FoundServo found{id, {}, {}};
    std::size_t arrived = 0;
    const auto take = [&](std::span<const std::uint8_t> bytes) {
      arrived += bytes.size();
      decoder_->put(bytes);
      return read_answer(found);
    };
    SOMATO_TRY(const bool answered, exchange.request(request, kScanAnswerTime, 1, take));
    // Some adapters return the request, and a byte of noise is no servo.
    constexpr std::size_t kNoise = 2;
    if (!answered && arrived <= request.size() + kNoise) return std::optional<FoundServo>();
    return std::optional(found);
  }

 private:
  bool is_dynamixel() const { return kind_ == BusKind::kDynamixel; }

  bool read_answer(FoundServo& found) {
    const std::size_t size = is_dynamixel() ? 3 : kFeetechIdentity;
    const std::size_t place = is_dynamixel() ? 0 : wire::feetech::kModel;
    while (const auto packet = decoder_->next_status()) {
      if (packet->parameters.size() != size) continue;
      found.id = packet->id;  // An answer may be late; two servos do not answer at once.
      const auto number = packet->parameters.subspan(place, 2);
      found.model = wire::feetech_word(number, order_);
      found.name = name_of(*found.model);
      return true;
    }
    return false;
  }

  std::string name_of(unsigned model) const {
    const auto find = [&](const auto& models) {
      const auto known =
          std::ranges::find_if(models, [&](const auto& one) { return one.number == model; });
      return known == models.end() ? std::string() : std::string(known->name);
    };
    if (model == 0) return {};
    return is_dynamixel() ? find(dynamixel_models()) : find(feetech_models());
  }

  BusKind kind_;
  wire::ByteOrder order_ = wire::ByteOrder::kLowFirst;
  std::unique_ptr<wire::PacketWriter> writer_;
  std::unique_ptr<wire::PacketDecoder> decoder_;
};

}  // namespace

std::vector<std::size_t> speeds_of(BusKind kind) {
  switch (kind) {
    case BusKind::kSsc32:
      return {2400, 9600, 38400, 115200};
    case BusKind::kDynamixel:
      return {57600, 1000000, 115200, 2000000, 3000000, 4000000, 9600};
    case BusKind::kSts:
    case BusKind::kScs:
      break;
  }
  return {1000000, 500000, 115200, 57600, 38400};
}

Result<std::vector<FoundServo>> scan_bus(BusKind kind, wire::Exchange& exchange,
                                         const std::function<bool()>& should_continue) {
  if (kind == BusKind::kSsc32) {
    return fail(ErrorKind::kUsage,
                "the servos of an SSC-32 have channels and no ids, and no answer", {},
                "omit '--scan'; look where the servos are connected");
  }
  Inquiry inquiry(kind);
  std::vector<FoundServo> servos;
  const std::size_t ids = kind == BusKind::kDynamixel ? 253 : 254;
  for (std::size_t id = 0; id < ids; ++id) {
    if (!should_continue()) return fail(ErrorKind::kInterrupted, "the scan was interrupted");
    SOMATO_TRY(auto found, inquiry.ask(static_cast<std::uint8_t>(id), exchange));
    const bool is_known = found && std::ranges::any_of(servos, [&](const FoundServo& servo) {
                            return servo.id == found->id;
                          });
    if (found && !is_known) servos.push_back(std::move(*found));
  }
  return servos;
}

}  // namespace somato::devices
