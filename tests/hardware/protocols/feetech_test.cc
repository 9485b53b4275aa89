#include "hardware/protocols/feetech.h"

#include <gtest/gtest.h>

#include <algorithm>
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

template <typename Fill>
Bytes feetech_packets(const Fill& fill, ByteOrder order = ByteOrder::kLowFirst) {
  Bytes memory(4096);
  FeetechWriter writer(memory, order);
  fill(writer);
  return {writer.written().begin(), writer.written().end()};
}

// The packets of the maker's description of the protocol.
const Bytes kFeetechPing{0xFF, 0xFF, 1, 2, 1, 0xFB};
const Bytes kFeetechDone{0xFF, 0xFF, 1, 2, 0, 0xFC};
const Bytes kFeetechRead{0xFF, 0xFF, 1, 4, 2, 0x38, 2, 0xBE};
const Bytes kFeetechReadStatus{0xFF, 0xFF, 1, 4, 0, 0x18, 5, 0xDD};
const Bytes kFeetechWrite{0xFF, 0xFF, 1, 9, 3, 0x2A, 0, 8, 0, 0, 0xE8, 3, 0xD5};
const Bytes kFeetechRegWrite{0xFF, 0xFF, 2, 9, 4, 0x2A, 0, 8, 0, 0, 0xE8, 3, 0xD3};
const Bytes kFeetechAction{0xFF, 0xFF, 0xFE, 2, 5, 0xFA};
const Bytes kFeetechReboot{0xFF, 0xFF, 1, 2, 8, 0xF4};
const Bytes kFeetechSyncRead{0xFF, 0xFF, 0xFE, 6, 0x82, 0x38, 8, 1, 2, 0x36};
const Bytes kFeetechSyncWrite{0xFF, 0xFF, 0xFE, 0x20, 0x83, 0x2A, 6, 1,    0, 8,    0, 0,
                              0xE8, 3,    2,    0,    8,    0,    0, 0xE8, 3, 3,    0, 8,
                              0,    0,    0xE8, 3,    4,    0,    8, 0,    0, 0xE8, 3, 0x58};

TEST(Feetech, InstructionsHaveTheBytesOfTheManual) {
  const Bytes data{0, 8, 0, 0, 0xE8, 3};
  const Bytes ids{1, 2};
  EXPECT_EQ(feetech_packets([](auto& to) { to.ping(1); }), kFeetechPing);
  EXPECT_EQ(feetech_packets([](auto& to) { to.read(1, 0x38, 2); }), kFeetechRead);
  EXPECT_EQ(feetech_packets([&](auto& to) { to.write(1, 0x2A, data); }), kFeetechWrite);
  EXPECT_EQ(feetech_packets([&](auto& to) { to.reg_write(2, 0x2A, data); }), kFeetechRegWrite);
  EXPECT_EQ(feetech_packets([](auto& to) { to.action(kEveryone); }), kFeetechAction);
  EXPECT_EQ(feetech_packets([](auto& to) { to.reboot(1); }), kFeetechReboot);
  EXPECT_EQ(feetech_packets([&](auto& to) { to.sync_read(0x38, 8, ids); }), kFeetechSyncRead);
  EXPECT_EQ(feetech_packets([](auto& to) {
              to.begin_sync_write(0x2A, 6);
              for (std::uint8_t id = 1; id <= 4; ++id) {
                to.put8(id);
                to.put16(2048);
                to.put16(0);
                to.put16(1000);
              }
              to.end();
            }),
            kFeetechSyncWrite);
}

TEST(Feetech, StatusesHaveTheBytesOfTheManual) {
  FeetechDecoder decoder;
  const Bytes position{0x18, 5};
  EXPECT_EQ(feetech_packets([](auto& to) { to.status(1, 0, {}); }), kFeetechDone);
  EXPECT_EQ(feetech_packets([&](auto& to) { to.status(1, 0, position); }), kFeetechReadStatus);
  EXPECT_EQ(statuses(decoder, kFeetechReadStatus), (PacketContents{{1, 0, position}}));
  EXPECT_EQ(feetech_word(position, ByteOrder::kLowFirst), 1304);
  // The two answers to kFeetechSyncRead, one after the other.
  const auto both =
      statuses(decoder, {0xFF, 0xFF, 1, 10, 0, 0,    8, 0, 0, 0, 0, 0x79, 0x1E, 0x55,
                         0xFF, 0xFF, 2, 10, 0, 0xFF, 7, 0, 0, 0, 0, 0x77, 0x23, 0x53});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[1], (PacketContent{2, 0, {0xFF, 7, 0, 0, 0, 0, 0x77, 0x23}}));
}

TEST(Feetech, TheSeriesOrderTheBytesOfANumberDifferently) {
  const auto sts = feetech_packets([](auto& to) { to.begin(1, 3), to.put16(0x0203), to.end(); });
  const auto scs = feetech_packets([](auto& to) { to.begin(1, 3), to.put16(0x0203), to.end(); },
                                   ByteOrder::kHighFirst);
  EXPECT_EQ(Bytes(sts.begin() + 5, sts.end() - 1), (Bytes{3, 2}));
  EXPECT_EQ(Bytes(scs.begin() + 5, scs.end() - 1), (Bytes{2, 3}));
  EXPECT_EQ(feetech_word(Bytes{2, 3}, ByteOrder::kHighFirst), 0x0203);
}

TEST(Feetech, NegativeNumbersHaveASignBit) {
  EXPECT_EQ(feetech_signed(0x8003), -3);
  EXPECT_EQ(feetech_signed(0x0FFF), 4095);
  EXPECT_EQ(feetech_unsigned(-3), 0x8003);
  EXPECT_EQ(feetech_unsigned(4095), 4095);
}

TEST(Feetech, TheEchoOfWhatWasSentIsSkippedOnce) {
  FeetechDecoder decoder;
  Bytes sent = kFeetechSyncWrite;
  sent.insert(sent.end(), kFeetechRead.begin(), kFeetechRead.end());
  decoder.expect_echo(sent);
  Bytes bytes = sent;
  bytes.insert(bytes.end(), kFeetechReadStatus.begin(), kFeetechReadStatus.end());
  EXPECT_EQ(statuses(decoder, bytes), (PacketContents{{1, 0, {0x18, 5}}}));
  EXPECT_EQ(statuses(decoder, kFeetechRead).size(), 1u);  // a second time it is no echo
}

TEST(Feetech, AnEchoIsSkippedThoughTheOneBeforeWasLost) {
  FeetechDecoder decoder;
  Bytes sent = kFeetechSyncWrite;
  sent.insert(sent.end(), kFeetechRead.begin(), kFeetechRead.end());
  decoder.expect_echo(sent);
  EXPECT_TRUE(statuses(decoder, kFeetechRead).empty());
}

TEST(Feetech, DataOfAnEchoAreNoAnswer) {
  FeetechDecoder decoder(10);  // made for answers that are shorter than the echo
  const Bytes sent = feetech_packets([](auto& to) {
    to.begin_sync_write(0, 8);
    to.put8(1);
    to.put(kFeetechReadStatus);
    to.end();
  });
  decoder.expect_echo(sent);
  EXPECT_TRUE(statuses(decoder, sent).empty());
}

TEST(Feetech, ACutOrImpossiblePacketDoesNotHideTheNext) {
  const std::vector<Bytes> starts{
      Bytes(kFeetechReadStatus.begin(), kFeetechReadStatus.end() - 2),
      {0xFF, 0xFF, 1, 1, 0},  // too short for a code and a sum
      {0xFF, 0xFF, 1, 200},   // longer than the decoder was made for
      {0xFF, 0xFF},
      {0xFF},
  };
  for (Bytes bytes : starts) {
    bytes.insert(bytes.end(), kFeetechReadStatus.begin(), kFeetechReadStatus.end());
    FeetechDecoder decoder(10);
    EXPECT_EQ(statuses(decoder, bytes).size(), 1u) << bytes.size();
  }
}

TEST(Feetech, AWrongSumIsRefused) {
  for (std::size_t i = 2; i < kFeetechReadStatus.size(); ++i) {
    Bytes bytes = kFeetechReadStatus;
    bytes[i] ^= 0x10;
    FeetechDecoder decoder(10);
    EXPECT_TRUE(statuses(decoder, bytes).empty()) << i;
  }
}

TEST(Feetech, MemoryThatIsTooSmallAndPacketsThatAreTooLongAreRefused) {
  Bytes memory(kFeetechPing.size() - 1);
  FeetechWriter small(memory, ByteOrder::kLowFirst);
  EXPECT_THROW(small.ping(1), InvalidArgument);
  EXPECT_THROW(feetech_packets([](auto& to) { to.write(1, 0, Bytes(253)); }), InvalidArgument);
  EXPECT_NO_THROW(feetech_packets([](auto& to) { to.write(1, 0, Bytes(252)); }));
}

// One of `often` parameters or more is 255.
PacketContent random_content(Random& random, std::size_t size, std::uint64_t often) {
  PacketContent content;
  content.id = static_cast<int>(random.below(254));
  content.error = static_cast<int>(random.below(64));
  content.parameters.resize(size);
  for (std::uint8_t& byte : content.parameters) {
    byte = random.below(often) == 0 ? std::uint8_t{0xFF} : testing::random_byte(random);
  }
  return content;
}

Bytes packet_of(const PacketContent& content) {
  Bytes bytes{0xFF, 0xFF, static_cast<std::uint8_t>(content.id),
              static_cast<std::uint8_t>(content.parameters.size() + 2),
              static_cast<std::uint8_t>(content.error)};
  bytes.insert(bytes.end(), content.parameters.begin(), content.parameters.end());
  int sum = 0;
  for (std::size_t i = 2; i < bytes.size(); ++i) sum += bytes[i];
  bytes.push_back(static_cast<std::uint8_t>(255 - sum % 256));
  return bytes;
}

TEST(Feetech, RandomPacketsAreCodedAsByASlowCoder) {
  Random random(1);
  FeetechDecoder decoder;
  for (int i = 0; i < 3000; ++i) {
    const PacketContent content = random_content(random, random.below(250), 4);
    const Bytes bytes = packet_of(content);
    const auto id = static_cast<std::uint8_t>(content.id);
    const auto code = static_cast<std::uint8_t>(content.error);
    ASSERT_EQ(feetech_packets([&](auto& to) { to.status(id, code, content.parameters); }), bytes);
    ASSERT_EQ(statuses(decoder, bytes), PacketContents{content});
  }
}

// The sum of 8 bits does not notice that a byte 255 is missing if another packet follows: the sum
// becomes data, and the next FF the sum.
TEST(Feetech, AMissingByte255IsNotNoticed) {
  FeetechDecoder decoder;
  Bytes bytes = packet_of({1, 0, {7, 0xFF, 8}});
  const std::uint8_t sum = bytes.back();
  bytes.erase(bytes.begin() + 6);
  bytes.insert(bytes.end(), kFeetechDone.begin(), kFeetechDone.end());
  EXPECT_EQ(statuses(decoder, bytes), (PacketContents{{1, 0, {7, 8, sum}}}));
}

// An accident hides the packets that it covers, so that whole ones are lost.
TEST(Feetech, WholePacketsOfADamagedStreamAreDecodedExceptBehindAccidents) {
  Random random(2);
  std::vector<Bytes> packets;
  PacketContents all;
  for (int i = 0; i < 100'000; ++i) {
    all.push_back(random_content(random, 15, 256));  // the answer of an STS servo in each tick
    packets.push_back(packet_of(all.back()));
  }
  FeetechDecoder decoder(packets[0].size());
  const auto count = testing::count_damage(decoder, packets, all, 64, random);
  EXPECT_GT(count.damaged, 1500u);
  EXPECT_LE(count.lost, 2 * count.wrong);
  EXPECT_LE(count.wrong, 40u);
}

TEST(Feetech, CodingAllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP();
  FeetechWriter writer(ByteOrder::kLowFirst);
  FeetechDecoder decoder;
  testing::expect_coding_without_allocation(writer, decoder);
}

}  // namespace
}  // namespace somato::wire
