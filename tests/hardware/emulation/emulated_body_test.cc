#include "hardware/emulation/emulated_body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "base/files/embedded.h"
#include "bodies/explorers/simulated_body.h"
#include "bodies/support/fake_hand.h"
#include "hardware/device_files/device_text.h"
#include "hardware/devices/device_explorer.h"
#include "hardware/support/emulated_device.h"
#include "hardware/support/every_bus.h"
#include "hardware/support/lent_lines.h"
#include "somato/bodies/explore_by.h"

namespace somato::emulation {
namespace {

using devices::BusKind;
using devices::DeviceBody;
using testing::EmulatedDevice;
using testing::LentLines;

devices::DeviceFile device(const std::string& body, BusKind bus) {
  const std::string text(somato::detail::embedded_text("devices/" + body + ".toml"));
  return *devices::parse_device_file(*devices::with_bus(text, body, bus), body);
}

ObjectTable things_of(ExploringBody body) {
  return *default_things(body);
}

using Explored = std::function<Result<Exploration>(Body& body)>;

// The same thing explored by the simulated body itself, and through serial lines.
struct Pair {
  Exploration direct;
  Exploration emulated;
};

Pair explore_both(ExploringBody body, BusKind bus, std::size_t thing, const Explored& explore) {
  const auto make = [&] { return *simulated_body(body, things_of(body), {}, 1, thing, 0); };
  const auto simulated = make();
  auto direct = explore(*simulated);
  EmulatedDevice emulated(device(choice_name(body), bus), make());
  auto started = DeviceBody::start(emulated.file, emulated.lines);
  if (!started) throw std::runtime_error(to_string(started.error()));
  auto through_lines = explore(**started);
  if (!direct) throw std::runtime_error(to_string(direct.error()));
  if (!through_lines) throw std::runtime_error(to_string(through_lines.error()));
  EXPECT_TRUE(emulated.state) << to_string(emulated.state.error());
  return {std::move(*direct), std::move(*through_lines)};
}

std::vector<float> last_frame(const Exploration& exploration, const std::string& channel) {
  const Matrix<float>& frames = (*find_channel(exploration, channel))->frames;
  const auto row = frames.row(frames.rows() - 1);
  return {row.begin(), row.end()};
}

class EmulatedBodies : public ::testing::TestWithParam<BusKind> {};

// Hand III closes on an object: its joints end where they end without serial lines, within four
// standard deviations of the difference of two readings (0.2 deg each) and the servos' play.
TEST_P(EmulatedBodies, HandThreeFeelsTheSameShape) {
  const Pair pair = explore_both(ExploringBody::kLucs3, GetParam(), 3,
                                 [](Body& body) { return explore_by_closing(body, {}); });
  const std::vector<float> direct = last_frame(pair.direct, "joints");
  const std::vector<float> emulated = last_frame(pair.emulated, "joints");
  ASSERT_EQ(emulated.size(), 11U);
  for (std::size_t i = 0; i < direct.size(); ++i) EXPECT_NEAR(emulated[i], direct[i], 3.0) << i;
}

// Its noise is 0.006 mm, its stroke of 10 mm has 2^18 counts; the force varies by 1 %.
TEST_P(EmulatedBodies, TheHardnessProbeMeetsTheSameResistance) {
  for (const std::size_t material : {0U, 2U, 7U}) {
    const Pair pair = explore_both(ExploringBody::kHardness, GetParam(), material,
                                   [](Body& body) { return explore_by_pressing(body); });
    const float direct = last_frame(pair.direct, "potentiometer")[0];
    EXPECT_NEAR(last_frame(pair.emulated, "potentiometer")[0], direct, 4.0 * 0.006 * 26214.4);
  }
}

double power(const Exploration& exploration) {
  double sum = 0.0;
  for (const float value : exploration.channels.front().frames.values()) {
    sum += static_cast<double>(value) * static_cast<double>(value);
  }
  return sum / static_cast<double>(exploration.channels.front().frames.rows());
}

TEST_P(EmulatedBodies, TheTextureProbeHearsTheSameMaterial) {
  std::vector<double> ratios;
  for (const std::size_t material : {1U, 4U}) {
    const Pair pair = explore_both(ExploringBody::kTexture, GetParam(), material,
                                   [](Body& body) { return explore_by_stroking(body); });
    ASSERT_EQ(pair.emulated.channels.front().frames.rows(), 8192U);
    EXPECT_NEAR(power(pair.emulated) / power(pair.direct), 1.0, 0.15);
  }
}

INSTANTIATE_TEST_SUITE_P(Buses, EmulatedBodies, ::testing::ValuesIn(testing::every_bus()),
                         testing::name_of_bus);

// Hand II grasps from one pose: as many segments touch, and with as much force.
TEST(EmulatedBody, HandTwoTouchesTheSameObject) {
  ExplorationPlan plan;
  plan.heights = {126.0};
  plan.wrist_angles = {0.0};
  plan.grasps = 1;
  const Pair pair = explore_both(ExploringBody::kLucs2, BusKind::kSsc32, 1,
                                 [&](Body& body) { return explore_by_grasping(body, plan, {}); });
  const auto touched = [](const Exploration& exploration) {
    std::size_t count = 0;
    for (const float force : last_frame(exploration, "touch")) count += force > 0.3F ? 1 : 0;
    return static_cast<double>(count);
  };
  EXPECT_GE(touched(pair.direct), 3.0);
  EXPECT_NEAR(touched(pair.emulated), touched(pair.direct), 3.0);
  const std::vector<float> direct = last_frame(pair.direct, "joints");
  const std::vector<float> emulated = last_frame(pair.emulated, "joints");
  for (std::size_t i = 0; i < direct.size(); ++i) EXPECT_NEAR(emulated[i], direct[i], 6.0) << i;
}

// A sound device whose samples are late at first, and less and less so.
class LateSound : public LentLines {
 public:
  using LentLines::LentLines;

  Result<std::size_t> read(std::size_t line, std::span<std::uint8_t> bytes) override {
    const auto count = LentLines::read(line, bytes);
    if (line != 1 || !count) return count;
    for (const std::uint8_t byte : bytes.first(*count)) waiting_.emplace_back(now(), byte);
    const double latency = std::max(0.01, 0.3 - 0.1 * now());
    std::size_t given = 0;
    while (given < bytes.size() && !waiting_.empty() && waiting_[0].first <= now() - latency) {
      bytes[given++] = waiting_.front().second;
      waiting_.pop_front();
    }
    return given;
  }

 private:
  std::deque<std::pair<double, std::uint8_t>> waiting_;
};

TEST(EmulatedBody, AStrokeIsWholeThoughItsSamplesAreLate) {
  EmulatedDevice emulated(
      device("texture", BusKind::kSts),
      *simulated_body(ExploringBody::kTexture, things_of(ExploringBody::kTexture), {}, 1, 0, 0));
  LateSound lines(emulated.lines);
  const auto body = DeviceBody::start(emulated.file, lines);
  ASSERT_TRUE(body) << to_string(body.error());
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE((*body)->begin());
    const auto explored = explore_by_stroking(**body);
    ASSERT_TRUE(explored) << to_string(explored.error());
    EXPECT_EQ(explored->channels.front().frames.rows(), 8192U);
    ASSERT_TRUE((*body)->go_to_rest());
  }
}

// A host to which the system gives no time for five periods, whenever it has sent something.
class PausingHost : public LentLines {
 public:
  using LentLines::LentLines;

  Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override {
    const auto count = LentLines::write(line, bytes);
    const double until = now() + (bytes.empty() ? 0.0 : 0.1);
    while (now() < until) wait(until);
    return count;
  }
};

// The servo and the sound wait for the host.
TEST(EmulatedBody, AStrokeIsWholeThoughItsHostPauses) {
  EmulatedDevice emulated(
      device("texture", BusKind::kSts),
      *simulated_body(ExploringBody::kTexture, things_of(ExploringBody::kTexture), {}, 1, 0, 0));
  PausingHost lines(emulated.lines);
  const auto body = DeviceBody::start(emulated.file, lines);
  ASSERT_TRUE(body) << to_string(body.error());
  const auto explored = explore_by_stroking(**body);
  ASSERT_TRUE(explored) << to_string(explored.error());
  EXPECT_EQ(explored->channels.front().frames.rows(), 8192U);
}

// A skin without servos records while others touch it.
TEST(EmulatedBody, ASkinHolds) {
  devices::DeviceFile file = *devices::own_device_file("anyskin");
  file.settings.duration = 1.0;
  auto skin = std::make_unique<FakeHand>("skin");
  ChannelDescription field;
  field.name = "skin";
  field.element_names = file.sensors[0].elements;
  float pressed = 0.0F;
  skin->add_sensor(field, [&](const std::vector<double>&) {
    return std::vector<float>(15, 40.0F + (pressed += 0.5F));
  });
  EmulatedDevice emulated(file, std::move(skin));
  ExploredThing finger;
  finger.name = "finger";
  devices::DeviceSurroundings surroundings;
  surroundings.open_lines = [&]() -> Result<std::unique_ptr<wire::Lines>> {
    return std::make_unique<LentLines>(emulated.lines);
  };
  const auto explorer =
      devices::DeviceExplorer::create(file, {finger}, {}, std::move(surroundings));
  ASSERT_TRUE(explorer) << to_string(explorer.error());
  const auto explored = (*explorer)->explore(0, 0, {});
  ASSERT_TRUE(explored) << to_string(explored.error());
  const Matrix<float>& frames = explored->channels[0].frames;
  EXPECT_EQ(explored->channels[0].unit, "uT");
  EXPECT_EQ(frames.columns(), 15U);
  EXPECT_NEAR(static_cast<double>(frames.rows()), 50.0, 1.0);  // 1 s, every 20 ms
  for (std::size_t row = 1; row < frames.rows(); ++row)
    EXPECT_GT(frames(row, 7), frames(row - 1, 7));
}

// More values than those of the sensor would stand in another sensor, or behind the frame.
TEST(EmulatedBody, RefusesABodyWithOtherElements) {
  const devices::DeviceFile file = *devices::own_device_file("anyskin");
  for (const std::size_t elements : {14U, 16U}) {
    auto skin = std::make_unique<FakeHand>("skin");
    ChannelDescription field;
    field.name = "skin";
    skin->add_sensor(field, [elements](const std::vector<double>&) {
      return std::vector<float>(elements, 40.0F);
    });
    EmulatedBody body(file, std::move(skin));
    EXPECT_THROW((void)body.advance(0.1), InvalidArgument) << elements;
  }
}

// A servo whose gear is stuck stays; the driver does not know.
TEST(EmulatedBody, AStuckJointStays) {
  EmulatedDevice emulated(
      device("lucs3", BusKind::kSsc32),
      *simulated_body(ExploringBody::kLucs3, things_of(ExploringBody::kLucs3), {}, 1, 0, 0));
  const std::size_t index = 4;  // index_proximal
  emulated.body.set_stuck(index, true);
  auto body = DeviceBody::start(emulated.file, emulated.lines);
  ASSERT_TRUE(body) << to_string(body.error());
  const auto explored = explore_by_closing(**body, {});
  ASSERT_TRUE(explored) << to_string(explored.error());
  EXPECT_NEAR(last_frame(*explored, "joints")[3], 0.0, 1.0);
  EXPECT_GT(last_frame(*explored, "joints")[5], 20.0);
}

}  // namespace
}  // namespace somato::emulation
