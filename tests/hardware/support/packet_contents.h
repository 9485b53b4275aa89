#pragma once

#include <vector>

#include "hardware/protocols/packets.h"
#include "hardware/support/damaged_streams.h"

namespace somato::testing {

/// The content of an answer of a servo.
struct PacketContent {
  int id = 0;
  int error = 0;
  Bytes parameters;
  bool operator==(const PacketContent&) const = default;
};

using PacketContents = std::vector<PacketContent>;

/// The answers that `bytes` complete.
inline PacketContents statuses(wire::PacketDecoder& decoder, const Bytes& bytes) {
  PacketContents all;
  decoder.put(bytes);
  while (const auto packet = decoder.next_status()) {
    all.push_back(
        {packet->id, packet->error, Bytes(packet->parameters.begin(), packet->parameters.end())});
  }
  return all;
}

}  // namespace somato::testing
