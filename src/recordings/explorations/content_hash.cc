#include "recordings/explorations/content_hash.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/archives/checksum.h"

namespace somato {
namespace {

// Numbers go in byte by byte, lowest first.
class Hash {
 public:
  void add(std::uint64_t number) {
    for (int shift = 0; shift < 64; shift += 8)
      add_byte(static_cast<std::uint8_t>(number >> shift));
  }
  void add(std::string_view text) {
    add(text.size());
    for (const char c : text) add_byte(static_cast<std::uint8_t>(c));
  }
  void add(double number) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    add(bits);
  }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(std::uint8_t byte) {
    const char one = static_cast<char>(byte);
    value_ = fnv1a64({&one, 1}, value_);
  }

  std::uint64_t value_ = fnv1a64({});
};

void add_channel(Hash& hash, const Channel& channel) {
  hash.add(channel.name);
  hash.add(channel.unit);
  hash.add(std::uint64_t{channel.element_names.size()});
  for (const std::string& name : channel.element_names) hash.add(name);
  hash.add(std::uint64_t{channel.frames.rows()});
  hash.add(std::uint64_t{channel.frames.columns()});
  for (const float value : channel.frames.values()) hash.add(double{value});
  hash.add(std::uint64_t{channel.times.size()});
  for (const double time : channel.times) hash.add(time);
  hash.add(channel.rate);
  hash.add(std::uint64_t{channel.frame_shape().size()});
  for (const std::size_t length : channel.frame_shape()) hash.add(std::uint64_t{length});
  hash.add(std::uint64_t{channel.valid.values().size()});
  for (const std::uint8_t valid : channel.valid.values()) hash.add(std::uint64_t{valid});
}

}  // namespace

std::string content_hash(const Recording& recording) {
  Hash hash;
  for (const Exploration& exploration : recording.explorations) {
    hash.add(std::uint64_t{exploration.labels.size()});
    for (const Label& label : exploration.labels) {
      hash.add(label.name);
      hash.add(label.value);
    }
    hash.add(std::uint64_t{exploration.channels.size()});
    for (const Channel& channel : exploration.channels) add_channel(hash, channel);
  }
  return fmt::format("fnv1a64:{:016x}", hash.value());
}

}  // namespace somato
