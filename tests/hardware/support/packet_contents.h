#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/protocols/packets.h"
#include "hardware/support/damaged_streams.h"
#include "somato/core/random.h"

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

/// Damages a stream of `packets`, which contain `all`, ends it with `end` zeros, and compares what
/// `decoder` finds in pieces of random size.
inline DamageCount count_damage(wire::PacketDecoder& decoder, const std::vector<Bytes>& packets,
                                const PacketContents& all, std::size_t end, Random& random) {
  const DamagedStream stream = damaged_stream(packets, 0.001, end, random);
  PacketContents found;
  for (auto at = stream.bytes.begin(); at < stream.bytes.end();) {
    const auto left = stream.bytes.end() - at;
    const auto next = at + std::min(static_cast<std::ptrdiff_t>(1 + random.below(200)), left);
    const PacketContents some = statuses(decoder, Bytes(at, next));
    found.insert(found.end(), some.begin(), some.end());
    at = next;
  }
  const DamageCount count = compare_with_sent(found, all, stream.whole);
  const auto record = [](const char* name, std::size_t value) {
    ::testing::Test::RecordProperty(name, static_cast<int>(value));
  };
  record("damaged", count.damaged);
  record("decoded", found.size());
  record("lost", count.lost);
  record("restored", count.restored);
  record("wrong", count.wrong);
  return count;
}

/// Checks that requests and answers are written and found without allocation.
inline void expect_coding_without_allocation(wire::PacketWriter& writer,
                                             wire::PacketDecoder& decoder) {
  std::array<std::uint8_t, 256> memory{};
  const Bytes ids{1, 2, 3};
  const AllocationCounter counter;
  std::size_t found = 0;
  for (int i = 0; i < 100; ++i) {
    writer.use(memory);
    writer.sync_read(132, 4, ids);
    decoder.expect_echo(writer.written());
    writer.status(1, 0, ids);
    decoder.put(writer.written());
    while (decoder.next_status()) ++found;
  }
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_EQ(found, 100u);
}

}  // namespace somato::testing
