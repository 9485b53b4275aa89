#include "hardware/emulation/sensor_board.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "hardware/protocols/anyskin_frame.h"
#include "somato/core/check.h"

namespace somato::emulation {
namespace {

std::vector<std::uint8_t> sent_until(SensorBoard& board, double now) {
  std::vector<std::uint8_t> sent;
  board.advance(now, sent);
  return sent;
}

std::string line_at(SensorBoard& board, double now) {
  const std::vector<std::uint8_t> sent = sent_until(board, now);
  return {sent.begin(), sent.end()};
}

TEST(SensorBoard, SendsAtItsRate) {
  SensorBoard board({devices::FrameFormat::kLines, 1, 100.0});
  board.set_values(std::vector<float>{5.0F});
  EXPECT_EQ(line_at(board, 0.009), "");
  EXPECT_EQ(line_at(board, 0.010), "5\n");
  EXPECT_EQ(line_at(board, 0.019), "");
  EXPECT_EQ(line_at(board, 0.040), "5\n5\n5\n");
  for (int i = 5; i <= 1000; ++i) ASSERT_EQ(line_at(board, i * 0.01), "5\n") << i;
}

TEST(SensorBoard, ReportsStuckAndDeadElements) {
  SensorBoard board({devices::FrameFormat::kLines, 3, 1.0});
  board.set_values(std::vector<float>{1.0F, 2.0F, 3.0F});
  board.stick(0);
  board.kill(2);
  board.set_values(std::vector<float>{7.0F, 8.0F, 9.0F});
  EXPECT_EQ(line_at(board, 1.0), "1,8,0\n");
  board.repair(0);
  board.repair(2);
  EXPECT_EQ(line_at(board, 2.0), "7,8,9\n");
}

TEST(SensorBoard, SendsItsOwnFrames) {
  SensorBoard board({devices::FrameFormat::kFrames, 2, 50.0, 25.0F, wire::SensorValueType::kInt16});
  board.set_values(std::vector<float>{-12.4F, 1e6F});
  wire::SensorFrameDecoder decoder(2);
  int frames = 0;
  for (const std::uint8_t byte : sent_until(board, 0.061)) frames += decoder.take(byte) ? 1 : 0;
  EXPECT_EQ(frames, 3);
  EXPECT_EQ(decoder.frame().sequence, 2);
  EXPECT_EQ(decoder.frame().microseconds, 60'000U);
  EXPECT_EQ(decoder.frame().values[0], -12.0F);
  EXPECT_EQ(decoder.frame().values[1], 32767.0F);
  board.restart();
  for (const std::uint8_t byte : sent_until(board, 0.082)) frames += decoder.take(byte) ? 1 : 0;
  EXPECT_EQ(frames, 4);
  EXPECT_EQ(decoder.frame().sequence, 0);
  EXPECT_EQ(decoder.frame().microseconds, 20'000U);
}

TEST(SensorBoard, SendsTemperaturesWithAnySkin) {
  SensorBoard board({devices::FrameFormat::kAnyskin, 3, 1.0, 24.5F});
  board.set_values(std::vector<float>{1.0F, -2.5F, 0.0F});
  EXPECT_EQ(sent_until(board, 1.0),
            (std::vector<std::uint8_t>{0, 0, 0xC4, 0x41, 0, 0, 0x80, 0x3F, 0, 0, 0x20, 0xC0, 0, 0,
                                       0, 0, 13, 10}));
}

TEST(SensorBoard, RejectsImpossibleSettings) {
  EXPECT_THROW(SensorBoard({devices::FrameFormat::kLines, 0, 1.0}), InvalidArgument);
  EXPECT_THROW(SensorBoard({devices::FrameFormat::kLines, 1, 0.0}), InvalidArgument);
  EXPECT_THROW(SensorBoard({devices::FrameFormat::kAnyskin, 4, 1.0}), InvalidArgument);
  EXPECT_THROW(SensorBoard({devices::FrameFormat::kFrames, 1025, 1.0}), InvalidArgument);
}

}  // namespace
}  // namespace somato::emulation
