#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/random.h"

namespace somato::testing {

using Bytes = std::vector<std::uint8_t>;

/// Packets in a stream with noise between them and damaged bytes, and which packets stayed whole.
struct DamagedStream {
  Bytes bytes;
  std::vector<bool> whole;
};

inline std::uint8_t random_byte(Random& random) {
  return static_cast<std::uint8_t>(random.next() >> 24);
}

/// Noise with many of the bytes that headers consist of.
inline void append_noise(Bytes& bytes, Random& random) {
  for (std::uint64_t left = 1 + random.below(30); left > 0; --left) {
    const std::uint8_t parts[] = {0xFF, 0xFF, 0xFD, 0x00};
    bytes.push_back(random.below(2) == 0 ? parts[random.below(4)] : random_byte(random));
  }
}

/// Each byte of the packets is changed or dropped with the probability `rate`; before every fifth
/// packet or so there is noise. The stream ends with `end` zeros.
inline DamagedStream damaged_stream(const std::vector<Bytes>& packets, double rate, std::size_t end,
                                    Random& random) {
  DamagedStream stream;
  for (const Bytes& packet : packets) {
    if (random.below(5) == 0) append_noise(stream.bytes, random);
    bool whole = true;
    for (const std::uint8_t byte : packet) {
      const bool hit = random.uniform() < rate;
      whole = whole && !hit;
      if (hit && random.below(2) == 0) continue;
      const auto change = static_cast<std::uint8_t>(hit ? 1 + random.below(255) : 0);
      stream.bytes.push_back(static_cast<std::uint8_t>(byte ^ change));
    }
    stream.whole.push_back(whole);
  }
  stream.bytes.insert(stream.bytes.end(), end, 0);
  return stream;
}

/// The fate of the packets of a damaged stream.
struct DamageCount {
  std::size_t damaged = 0;   ///< Packets that did not stay whole.
  std::size_t lost = 0;      ///< Whole packets that were not found.
  std::size_t restored = 0;  ///< Damaged ones that noise made whole again, with the right content.
  std::size_t wrong = 0;     ///< Found, but never sent.
};

/// Compares what a decoder found with what was sent, both in their order.
template <typename Content>
DamageCount compare_with_sent(const std::vector<Content>& found, const std::vector<Content>& sent,
                              const std::vector<bool>& whole) {
  DamageCount count;
  std::size_t at = 0;
  std::size_t whole_found = 0;
  for (const Content& content : found) {
    std::size_t same = at;
    while (same < sent.size() && same < at + 20 && !(sent[same] == content)) ++same;
    if (same == sent.size() || same == at + 20) {
      ++count.wrong;
      continue;
    }
    ++(whole[same] ? whole_found : count.restored);
    at = same + 1;
  }
  const auto all_whole = static_cast<std::size_t>(std::count(whole.begin(), whole.end(), true));
  count.damaged = sent.size() - all_whole;
  count.lost = all_whole - whole_found;
  return count;
}

}  // namespace somato::testing
