// Writes sensor frames (docs/formats/sensor-frames.md) on a microcontroller. Plain C++11 without
// libraries: the tests of Somato compile this file too.
#pragma once

#include <stddef.h>
#include <stdint.h>

// A frame with kCount values of 16 bits. It needs 2 * kCount + 11 bytes of memory.
template <size_t kCount>
class SensorFrameWriter {
 public:
  // Begins a frame: its number, and micros().
  void begin(uint16_t sequence, uint32_t microseconds) {
    size_ = 0;
    put(1, 1);  // The type of the values: int16.
    put(sequence, 2);
    put(microseconds, 4);
  }

  // Adds a value; kCount of them are required.
  void add(int16_t value) {
    if (size_ < kHead + 2 * kCount) put(static_cast<uint16_t>(value), 2);
  }

  // Gives all bytes of the frame to `write`, a function of one byte.
  template <typename Write>
  void send(Write write) {
    put(checksum(), 4);
    write(static_cast<uint8_t>(0));
    size_t begin = 0;
    do {
      begin = send_block(begin, write);
    } while (begin <= size_);
    write(static_cast<uint8_t>(0));
  }

 private:
  static const size_t kHead = 7;
  static const size_t kLongestBlock = 254;

  // Sends the bytes up to the next zero, at most 254, after their number plus 1. Returns where the
  // next block begins; beyond the end if there is none.
  template <typename Write>
  size_t send_block(size_t begin, Write write) {
    size_t end = begin;
    while (end < size_ && bytes_[end] != 0 && end - begin < kLongestBlock) ++end;
    write(static_cast<uint8_t>(end - begin + 1));
    for (size_t i = begin; i < end; ++i) write(bytes_[i]);
    const bool is_longest = end - begin == kLongestBlock;
    return is_longest && end < size_ ? end : end + 1;
  }

  void put(uint32_t number, size_t count) {
    for (; count > 0; --count, number >>= 8) bytes_[size_++] = static_cast<uint8_t>(number & 0xFF);
  }

  // CRC-32, bit by bit: a table would occupy 1 KiB.
  uint32_t checksum() const {
    uint32_t remainder = 0xFFFFFFFF;
    for (size_t i = 0; i < size_; ++i) {
      remainder ^= bytes_[i];
      for (int bit = 0; bit < 8; ++bit) {
        remainder = (remainder >> 1) ^ ((remainder & 1) ? 0xEDB88320UL : 0UL);
      }
    }
    return ~remainder;
  }

  uint8_t bytes_[kHead + 2 * kCount + 4];
  size_t size_ = 0;
};
