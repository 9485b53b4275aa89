#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "somato/core/random.h"

namespace somato::testing {

/// A stream of frames as a bad line delivers it: one byte in 1,000 changed or dropped, and before
/// one frame in 50 up to 40 random bytes.
class DamagedSensorStream {
 public:
  explicit DamagedSensorStream(std::uint64_t seed) : random_(seed) {}

  void add(std::span<const std::uint8_t> frame, std::span<const float> values) {
    if (random_.below(50) == 0) add_garbage();
    bool whole = true;
    for (const std::uint8_t byte : frame) whole = add_byte(byte) && whole;
    sent_.insert(key_of(values));
    if (whole) whole_.insert(key_of(values));
  }

  std::span<const std::uint8_t> bytes() const { return bytes_; }

  /// Counts what a decoder accepted.
  void accept(std::span<const float> values) {
    const std::string key = key_of(values);
    if (!sent_.contains(key)) ++wrong_;
    whole_.erase(key);
    ++accepted_;
  }

  std::size_t sent() const { return sent_.size(); }
  std::size_t accepted() const { return accepted_; }
  std::size_t wrong() const { return wrong_; }        ///< Accepted, but never sent.
  std::size_t lost() const { return whole_.size(); }  ///< Arrived whole, but not accepted.

 private:
  static std::string key_of(std::span<const float> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
  }

  std::uint8_t random_byte() { return static_cast<std::uint8_t>(random_.below(256)); }

  void add_garbage() {
    for (std::uint64_t left = 1 + random_.below(40); left > 0; --left) {
      bytes_.push_back(random_byte());
    }
  }

  bool add_byte(std::uint8_t byte) {
    if (random_.below(1000) > 0) {
      bytes_.push_back(byte);
      return true;
    }
    if (random_.below(2) == 0)
      bytes_.push_back(byte ^ static_cast<std::uint8_t>(1 + random_.below(255)));
    return false;
  }

  Random random_;
  std::vector<std::uint8_t> bytes_;
  std::set<std::string> sent_;
  std::set<std::string> whole_;
  std::size_t accepted_ = 0;
  std::size_t wrong_ = 0;
};

}  // namespace somato::testing
