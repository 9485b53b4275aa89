#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/mcap/mcap_compression.h"

namespace somato::testing {

/// A record: its opcode, its content, and the place behind it.
struct WalkedRecord {
  int opcode = 0;
  std::string_view content;
  std::size_t end = 0;
};

template <typename T>
T number_at(std::string_view bytes, std::size_t place) {
  T number{};
  std::memcpy(&number, bytes.substr(place, sizeof number).data(), sizeof number);
  return number;
}

/// The records that stand one after the other from `place` on.
inline std::vector<WalkedRecord> walk(std::string_view bytes, std::size_t place) {
  std::vector<WalkedRecord> records;
  while (place + 9 <= bytes.size()) {
    const auto length = number_at<std::uint64_t>(bytes, place + 1);
    if (length > bytes.size() - place - 9) break;
    records.push_back({static_cast<unsigned char>(bytes[place]), bytes.substr(place + 9, length),
                       place + 9 + length});
    place = records.back().end;
    if (records.back().opcode == 2) break;
  }
  return records;
}

/// A message of a recording file, and how many bytes of the file must be there for it to be saved.
struct WalkedMessage {
  std::string topic;
  std::string data;
  std::size_t needs = 0;
};

/// All messages of a whole file, worked out from its bytes without the reader under test.
inline std::vector<WalkedMessage> walk_messages(std::string_view file) {
  std::vector<WalkedMessage> messages;
  std::map<int, std::string> topics;
  for (const WalkedRecord& record : walk(file, 8)) {
    if (record.opcode != 6) continue;
    const auto unpacked_size = number_at<std::uint64_t>(record.content, 16);
    const auto name_size = number_at<std::uint32_t>(record.content, 28);
    const std::string_view name = record.content.substr(32, name_size);
    const std::string_view packed = record.content.substr(32 + name_size + 8);
    const std::string chunk = unpack(name, packed, unpacked_size).value();
    const std::size_t start = record.end - packed.size();
    for (const WalkedRecord& inner : walk(chunk, 0)) {
      const int id = number_at<std::uint16_t>(inner.content, 0);
      if (inner.opcode == 4) {
        const auto size = number_at<std::uint32_t>(inner.content, 4);
        topics[id] = inner.content.substr(8, size);
      }
      if (inner.opcode == 5) {
        messages.push_back({topics[id], std::string(inner.content.substr(22)),
                            name.empty() ? start + inner.end : record.end});
      }
    }
  }
  return messages;
}

}  // namespace somato::testing
