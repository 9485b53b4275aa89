// A chain of emulated servos and a bus of ours, or an emulated skin and its decoder, for the tests
// of foreign libraries: reads one command a line, and answers each by one line. Bytes are written
// in hexadecimal.
//
// usage: peer_chain dynamixel|sts|scs SERVOS
//        peer_chain skin MAGNETOMETERS

#include <fmt/format.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "hardware/boards/dynamixel_servos.h"
#include "hardware/boards/feetech_servos.h"
#include "hardware/buses/dynamixel_bus.h"
#include "hardware/buses/feetech_bus.h"
#include "hardware/protocols/anyskin_frame.h"
#include "hardware/support/board_line.h"

namespace somato {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Span = std::span<const std::uint8_t>;
using wire::FeetechSeries;

std::string hex_of(Span bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

Bytes bytes_of(const std::string& hex) {
  Bytes bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

// The words of a command.
struct Words {
  std::istringstream in;

  template <typename T>
  T next() {
    T value{};
    in >> value;
    return value;
  }
  std::uint8_t byte() { return static_cast<std::uint8_t>(next<int>()); }
  template <typename T>
  T number() {
    return static_cast<T>(next<int>());
  }
  Bytes bytes() { return bytes_of(next<std::string>()); }
};

// Writes the request that the words describe by `writer`.
std::string encoded(wire::PacketWriter& writer, Words& words) {
  Bytes memory(2048);
  writer.use(memory);
  const auto what = words.next<std::string>();
  const bool everyone = what == "sync_read" || what == "sync_write";
  const std::uint8_t id = everyone ? std::uint8_t{0} : words.byte();
  if (what == "ping") writer.ping(id);
  if (what == "action") writer.action(id);
  if (what == "reboot") writer.reboot(id);
  const auto address = words.number<std::uint16_t>();
  if (what == "write") writer.write(id, address, words.bytes());
  if (what == "reg_write") writer.reg_write(id, address, words.bytes());
  const auto size = words.number<std::uint16_t>();
  if (what == "read") writer.read(id, address, size);
  if (what == "sync_read") writer.sync_read(address, size, words.bytes());
  if (what == "sync_write") {
    writer.begin_sync_write(address, size);
    writer.put(words.bytes());
    writer.end();
  }
  return hex_of(writer.written());
}

std::string known_models() {
  std::string text;
  for (const auto& model : devices::dynamixel_models()) {
    text += fmt::format("{} {} {} ", model.name, model.number, model.current_unit);
  }
  return text;
}

// One chain, the bus that drives it, and the commands of a test.
struct Peer {
  Peer(std::unique_ptr<emulation::ServoChain> chain, std::unique_ptr<devices::PacketBus> driver,
       std::unique_ptr<wire::PacketWriter> encoder)
      : servos(std::move(chain)),
        bus(std::move(driver)),
        writer(std::move(encoder)),
        line(*servos) {}

  std::string send(const Bytes& bytes) {
    const std::size_t before = line.sent.size();
    if (!line.write(0, bytes)) return "failed";
    wait(0.02);
    return hex_of(Span(line.sent).subspan(before));
  }

  void wait(double seconds) {
    const double until = line.now() + seconds;
    while (line.now() < until) line.wait(until);
  }

  std::string start() {
    const std::size_t before = line.written.size();
    wire::Exchange exchange(line, 0);
    const auto started = bus->start(exchange);
    return started ? hex_of(Span(line.written).subspan(before)) : to_string(started.error());
  }

  std::string tick(Words& words) {
    const auto seconds = words.next<double>();
    std::vector<double> positions(bus->reports().size());
    for (double& position : positions) position = std::stod(words.next<std::string>());  // or nan
    return hex_of(bus->tick(positions, seconds));
  }

  std::string driven(std::size_t servo) const {
    const auto position = servos->driven_position(servo);
    return position ? fmt::format("{}", *position) : "off";
  }

  std::string obey(Words words) {
    const auto what = words.next<std::string>();
    if (what == "send") return send(words.bytes());
    if (what == "wait") return wait(words.next<double>()), "";
    if (what == "encode") return encoded(*writer, words);
    if (what == "start") return start();
    if (what == "tick") return tick(words);
    if (what == "relax") return hex_of(bus->relax_bytes());
    if (what == "models") return known_models();
    const auto servo = words.next<std::size_t>();
    if (what == "driven") return driven(servo);
    if (what == "overload") return servos->overload(servo), "";
    const auto position = words.next<double>();
    if (what == "measure") return servos->set_measured(servo, position, words.next<double>()), "";
    return "unknown command";
  }

  std::unique_ptr<emulation::ServoChain> servos;
  std::unique_ptr<devices::PacketBus> bus;
  std::unique_ptr<wire::PacketWriter> writer;
  testing::BoardLine line;
};

template <typename Obeying>
void serve(Obeying peer) {
  for (std::string command; std::getline(std::cin, command);) {
    std::cout << peer.obey({std::istringstream(command)}) << std::endl;
  }
}

void serve_dynamixel(std::uint8_t count) {
  std::vector<emulation::EmulatedDynamixel> made;
  std::vector<devices::PacketServo> declared;
  for (std::uint8_t id = 1; id <= count; ++id) {
    made.push_back({.id = id});
    declared.push_back({id, "XC330-M288"});
  }
  serve(Peer(std::make_unique<emulation::DynamixelServos>(made),
             std::make_unique<devices::DynamixelBus>(declared),
             std::make_unique<wire::DynamixelWriter>()));
}

void serve_feetech(FeetechSeries series, std::uint8_t count) {
  const bool sts = series == FeetechSeries::kSts;
  std::vector<emulation::EmulatedFeetech> made;
  std::vector<devices::PacketServo> declared;
  for (std::uint8_t id = 1; id <= count; ++id) {
    made.push_back({.id = id, .model = static_cast<std::uint16_t>(sts ? 777 : 1284)});
    declared.push_back({id, sts ? "STS3215" : "SCS0009"});
  }
  serve(Peer(std::make_unique<emulation::FeetechServos>(series, made),
             std::make_unique<devices::FeetechBus>(declared),
             std::make_unique<wire::FeetechWriter>(wire::feetech_order(series))));
}

// Writes and reads the frames of a skin. Numbers are written with all their digits.
struct SkinPeer {
  explicit SkinPeer(std::size_t count) : magnetometers(count), decoder(count) {}

  std::string frame(Words& words) const {
    std::vector<float> values(4 * magnetometers);
    for (float& value : values) value = std::stof(words.next<std::string>());
    Bytes bytes(wire::anyskin_frame_bytes(magnetometers));
    wire::encode_anyskin_frame(values, bytes);
    return hex_of(bytes);
  }

  // The values of all frames that the bytes complete.
  std::string read(const Bytes& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
      if (!decoder.take(byte)) continue;
      for (const float value : decoder.values()) text += fmt::format("{:.9g} ", value);
    }
    return text;
  }

  std::string obey(Words words) {
    const auto what = words.next<std::string>();
    if (what == "frame") return frame(words);
    if (what == "read") return read(words.bytes());
    return "unknown command";
  }

  std::size_t magnetometers;
  wire::AnySkinDecoder decoder;
};

}  // namespace
}  // namespace somato

int main(int count, char** arguments) {
  if (count != 3) return 2;
  const std::string kind = arguments[1];
  const auto servos = static_cast<std::uint8_t>(std::stoi(arguments[2]));
  if (kind == "skin") somato::serve(somato::SkinPeer(servos));
  if (kind == "dynamixel") somato::serve_dynamixel(servos);
  if (kind == "sts") somato::serve_feetech(somato::FeetechSeries::kSts, servos);
  if (kind == "scs") somato::serve_feetech(somato::FeetechSeries::kScs, servos);
  return 0;
}
