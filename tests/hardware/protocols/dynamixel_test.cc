#include "hardware/protocols/dynamixel.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/support/no_malloc.h"
#include "hardware/support/packet_contents.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

using testing::Bytes;
using testing::PacketContent;
using testing::PacketContents;
using testing::statuses;

Bytes written_by(const DynamixelWriter& writer) {
  return {writer.written().begin(), writer.written().end()};
}

// The bytes that `fill` writes.
template <typename Fill>
Bytes dynamixel_bytes(const Fill& fill) {
  Bytes memory(4096);
  DynamixelWriter writer(memory);
  fill(writer);
  return written_by(writer);
}

// The packets of the protocol's description in the e-Manual of the maker.
const Bytes kDynamixelPing{0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 1, 0x19, 0x4E};
const Bytes kDynamixelPingEveryone{0xFF, 0xFF, 0xFD, 0, 0xFE, 3, 0, 1, 0x31, 0x42};
const Bytes kDynamixelPingStatus{0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 0x55, 0, 6, 4, 0x26, 0x65, 0x5D};
const Bytes kDynamixelRead{0xFF, 0xFF, 0xFD, 0, 1, 7, 0, 2, 0x84, 0, 4, 0, 0x1D, 0x15};
const Bytes kDynamixelReadStatus{0xFF, 0xFF, 0xFD, 0, 1, 8, 0, 0x55, 0, 0xA6, 0, 0, 0, 0x8C, 0xC0};
const Bytes kDynamixelWrite{0xFF, 0xFF, 0xFD, 0, 1, 9, 0, 3, 0x74, 0, 0, 2, 0, 0, 0xCA, 0x89};
const Bytes kDynamixelDone{0xFF, 0xFF, 0xFD, 0, 1, 4, 0, 0x55, 0, 0xA1, 0x0C};
const Bytes kDynamixelRegWrite{0xFF, 0xFF, 0xFD, 0, 1, 9, 0, 4, 0x68, 0, 0xC8, 0, 0, 0, 0xAE, 0x8E};
const Bytes kDynamixelAction{0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 5, 0x02, 0xCE};
const Bytes kDynamixelReboot{0xFF, 0xFF, 0xFD, 0, 1, 3, 0, 8, 0x2F, 0x4E};
const Bytes kDynamixelSyncRead{0xFF, 0xFF, 0xFD, 0, 0xFE, 9, 0,    0x82,
                               0x84, 0,    4,    0, 1,    2, 0xCE, 0xFA};
const Bytes kDynamixelSyncWrite{0xFF, 0xFF, 0xFD, 0, 0xFE, 0x11, 0,    0x83, 0x74, 0, 4,    0,
                                1,    0x96, 0,    0, 0,    2,    0xAA, 0,    0,    0, 0x82, 0x87};

TEST(Dynamixel, InstructionsHaveTheBytesOfTheManual) {
  const Bytes goal{0, 2, 0, 0};
  const Bytes velocity{0xC8, 0, 0, 0};
  const Bytes ids{1, 2};
  EXPECT_EQ(dynamixel_bytes([](auto& to) { to.ping(1); }), kDynamixelPing);
  EXPECT_EQ(dynamixel_bytes([](auto& to) { to.ping(kEveryone); }), kDynamixelPingEveryone);
  EXPECT_EQ(dynamixel_bytes([](auto& to) { to.read(1, 132, 4); }), kDynamixelRead);
  EXPECT_EQ(dynamixel_bytes([&](auto& to) { to.write(1, 116, goal); }), kDynamixelWrite);
  EXPECT_EQ(dynamixel_bytes([&](auto& to) { to.reg_write(1, 104, velocity); }), kDynamixelRegWrite);
  EXPECT_EQ(dynamixel_bytes([](auto& to) { to.action(1); }), kDynamixelAction);
  EXPECT_EQ(dynamixel_bytes([](auto& to) { to.reboot(1); }), kDynamixelReboot);
  EXPECT_EQ(dynamixel_bytes([&](auto& to) { to.sync_read(132, 4, ids); }), kDynamixelSyncRead);
  EXPECT_EQ(dynamixel_bytes([](auto& to) {
              to.begin_sync_write(116, 4);
              to.put8(1);
              to.put32(150);
              to.put8(2);
              to.put32(170);
              to.end();
            }),
            kDynamixelSyncWrite);
}

TEST(Dynamixel, StatusesHaveTheBytesOfTheManual) {
  const Bytes model{6, 4, 0x26};
  const Bytes position{0xA6, 0, 0, 0};
  EXPECT_EQ(dynamixel_bytes([&](auto& to) { to.status(1, 0, model); }), kDynamixelPingStatus);
  EXPECT_EQ(dynamixel_bytes([&](auto& to) { to.status(1, 0, position); }), kDynamixelReadStatus);
  EXPECT_EQ(dynamixel_bytes([](auto& to) { to.status(1, 0, {}); }), kDynamixelDone);
  DynamixelDecoder decoder;
  EXPECT_EQ(statuses(decoder, kDynamixelPingStatus), (PacketContents{{1, 0, model}}));
  EXPECT_EQ(statuses(decoder, kDynamixelReadStatus), (PacketContents{{1, 0, position}}));
  EXPECT_EQ(statuses(decoder, kDynamixelDone), (PacketContents{{1, 0, {}}}));
}

TEST(Dynamixel, AServoFindsTheInstructionAndSkipsAnswersOfOthers) {
  DynamixelDecoder decoder;
  decoder.put(kDynamixelReadStatus);
  decoder.put(kDynamixelSyncWrite);
  decoder.put(kDynamixelDone);
  const auto packet = decoder.next_instruction();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->id, kEveryone);
  EXPECT_EQ(packet->instruction, PacketInstruction::kSyncWrite);
  EXPECT_EQ(packet->error, 0);
  EXPECT_EQ(Bytes(packet->parameters.begin(), packet->parameters.end()),
            (Bytes{0x74, 0, 4, 0, 1, 0x96, 0, 0, 0, 2, 0xAA, 0, 0, 0}));
  EXPECT_FALSE(decoder.next_instruction());
}

TEST(Dynamixel, AHostSkipsTheEchoOfItsInstructions) {
  DynamixelDecoder decoder;
  Bytes bytes = kDynamixelSyncWrite;
  bytes.insert(bytes.end(), kDynamixelSyncRead.begin(), kDynamixelSyncRead.end());
  bytes.insert(bytes.end(), kDynamixelReadStatus.begin(), kDynamixelReadStatus.end());
  EXPECT_EQ(statuses(decoder, bytes).size(), 1u);
}

TEST(Dynamixel, ADataHeaderIsStuffed) {
  const Bytes data{0xFF, 0xFF, 0xFD, 0x00, 0xFF, 0xFF, 0xFD, 0xFD};
  const Bytes bytes = dynamixel_bytes([&](auto& to) { to.status(1, 0, data); });
  const Bytes body(bytes.begin() + 9, bytes.end() - 2);
  EXPECT_EQ(body, (Bytes{0xFF, 0xFF, 0xFD, 0xFD, 0x00, 0xFF, 0xFF, 0xFD, 0xFD, 0xFD}));
  EXPECT_EQ(bytes[5], 14);  // instruction, error, 10 bytes and CRC
  DynamixelDecoder decoder;
  EXPECT_EQ(statuses(decoder, bytes), (PacketContents{{1, 0, data}}));
}

TEST(Dynamixel, PacketsArriveInPieces) {
  DynamixelDecoder decoder;
  for (std::size_t i = 0; i + 1 < kDynamixelReadStatus.size(); ++i) {
    EXPECT_TRUE(statuses(decoder, {kDynamixelReadStatus[i]}).empty());
  }
  EXPECT_EQ(statuses(decoder, {kDynamixelReadStatus.back()}).size(), 1u);
}

TEST(Dynamixel, ACutOrImpossiblePacketDoesNotHideTheNext) {
  const Bytes cut(kDynamixelReadStatus.begin(), kDynamixelReadStatus.begin() + 12);
  const std::vector<Bytes> starts{
      cut,
      {0xFF, 0xFF, 0xFD, 0x00, 1, 0x02, 0x00},        // too short for instruction and CRC
      {0xFF, 0xFF, 0xFD, 0x00, 1, 0xFF, 0xFF, 0x55},  // longer than any packet
      {0xFF, 0xFF, 0xFD, 0x00, 1, 0x00, 0x03, 0x55},  // 775 bytes, which never come
      {0xFF, 0xFF, 0xFD, 0x00, 0xFF, 0x04, 0x00},     // no id
      {0xFF, 0xFF, 0xFD},
      {0xFF},
  };
  for (Bytes bytes : starts) {
    bytes.insert(bytes.end(), kDynamixelPingStatus.begin(), kDynamixelPingStatus.end());
    DynamixelDecoder decoder;
    EXPECT_EQ(statuses(decoder, bytes).size(), 1u);
  }
}

TEST(Dynamixel, AWrongCrcIsRefused) {
  for (std::size_t i = 0; i < kDynamixelPingStatus.size(); ++i) {
    Bytes bytes = kDynamixelPingStatus;
    bytes[i] ^= 0x10;
    DynamixelDecoder decoder;
    EXPECT_TRUE(statuses(decoder, bytes).empty()) << i;
  }
}

TEST(Dynamixel, MemoryThatIsTooSmallIsRefused) {
  Bytes memory(kDynamixelPing.size() - 1);
  DynamixelWriter writer(memory);
  EXPECT_THROW(writer.ping(1), InvalidArgument);
  EXPECT_TRUE(writer.written().empty());
}

TEST(Dynamixel, APacketLongerThanTheLongestIsRefused) {
  DynamixelDecoder decoder;
  Bytes bytes = dynamixel_bytes([](auto& to) { to.status(1, 0, Bytes(1500)); });
  bytes.insert(bytes.end(), kDynamixelDone.begin(), kDynamixelDone.end());
  EXPECT_EQ(statuses(decoder, bytes).size(), 1u);
  EXPECT_EQ(statuses(decoder, dynamixel_bytes([](auto& to) { to.status(1, 0, Bytes(1024 - 11)); }))
                .size(),
            1u);
}

// Bit by bit, as the e-Manual describes the CRC.
unsigned slow_crc(const Bytes& bytes) {
  unsigned crc = 0;
  for (const std::uint8_t byte : bytes) {
    for (int bit = 7; bit >= 0; --bit) {
      const unsigned high = (crc >> 15 & 1) ^ (byte >> bit & 1U);
      crc = ((crc << 1) ^ (high != 0 ? 0x8005U : 0U)) & 0xFFFF;
    }
  }
  return crc;
}

// A whole packet, in the order in which the e-Manual describes its reception.
PacketContent slowly_decoded(Bytes bytes) {
  const unsigned crc = bytes[bytes.size() - 2] + 256U * bytes[bytes.size() - 1];
  bytes.resize(bytes.size() - 2);
  EXPECT_EQ(slow_crc(bytes), crc);
  EXPECT_EQ(bytes[5] + 256U * bytes[6], bytes.size() - 7 + 2);
  Bytes body;
  for (std::size_t i = 7; i < bytes.size(); ++i) {
    const std::size_t n = body.size();
    const bool stuffing = i > 9 && bytes[i] == 0xFD && n >= 3 && bytes[i - 1] == 0xFD &&
                          bytes[i - 2] == 0xFF && bytes[i - 3] == 0xFF;
    if (!stuffing) body.push_back(bytes[i]);
  }
  EXPECT_EQ(body[0], 0x55);
  return {bytes[4], body[1], Bytes(body.begin() + 2, body.end())};
}

Bytes random_status(Random& random, std::size_t most) {
  Bytes parameters(random.below(most));
  for (std::uint8_t& byte : parameters) {
    const std::uint8_t often[] = {0xFF, 0xFF, 0xFD, 0x00};
    byte = random.below(3) == 0 ? testing::random_byte(random) : often[random.below(4)];
  }
  const auto id = static_cast<std::uint8_t>(random.below(253));
  const auto error = static_cast<std::uint8_t>(random.below(256));
  return dynamixel_bytes([&](auto& to) { to.status(id, error, parameters); });
}

TEST(Dynamixel, RandomPacketsAreDecodedAsByASlowDecoder) {
  Random random(1);
  DynamixelDecoder decoder;
  for (int i = 0; i < 3000; ++i) {
    const Bytes bytes = random_status(random, 300);
    ASSERT_EQ(statuses(decoder, bytes), PacketContents{slowly_decoded(bytes)});
  }
}

TEST(Dynamixel, EveryWholePacketOfADamagedStreamIsDecodedAndNoWrongOne) {
  Random random(2);
  std::vector<Bytes> packets;
  PacketContents all;
  for (int i = 0; i < 100'000; ++i) {
    packets.push_back(random_status(random, 24));
    all.push_back(slowly_decoded(packets.back()));
  }
  DynamixelDecoder decoder;
  const auto count =
      testing::count_damage(decoder, packets, all, DynamixelDecoder::kLongest, random);
  EXPECT_GT(count.damaged, 1500u);
  EXPECT_EQ(count.lost, 0u);
  EXPECT_EQ(count.wrong, 0u);
}

TEST(Dynamixel, CodingAllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP();
  DynamixelWriter writer;
  DynamixelDecoder decoder;
  testing::expect_coding_without_allocation(writer, decoder);
}

}  // namespace
}  // namespace somato::wire
