// A system that learned from explorations through serial lines recognizes others frame by frame,
// and so does a system that learned from the simulated body itself.

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "base/files/embedded.h"
#include "bodies/explorers/simulated_body.h"
#include "hardware/device_files/device_text.h"
#include "hardware/devices/device_explorer.h"
#include "hardware/support/emulated_device.h"
#include "hardware/support/lent_lines.h"
#include "somato/bodies/explore_by.h"
#include "systems/support/systems.h"
#include "views/live/view_systems.h"
#include "views/session/system_reading.h"

namespace somato::emulation {
namespace {

using devices::BusKind;
using testing::module;
using testing::value_or_throw;

// Things that a body explores with some servos, and a system that distinguishes them.
struct RecognizingCase {
  ExploringBody body = ExploringBody::kLucs2;
  BusKind bus = BusKind::kSsc32;
  std::vector<std::size_t> things;  // Numbers in its own table.
  std::string system;
};

std::string last_of(const char* channel) {
  return testing::channels({channel}) +
         module("last", "last", std::string("input = '") + channel + "'") +
         module("map", "som",
                "input = 'last'\nrows = 4\ncolumns = 4\niterations = 300\n"
                "similarity = 'euclidean'");
}

std::string spectrum_of_sound() {
  return testing::channels({"sound"}) +
         module("spectrum", "spectrum", "input = 'sound'\nsegment_length = 4096\nbands = 0") +
         module("map", "som", "input = 'spectrum'\nrows = 4\ncolumns = 4\niterations = 300");
}

std::vector<RecognizingCase> recognizing_cases() {
  return {{ExploringBody::kLucs2, BusKind::kSsc32, {0, 1}, last_of("joints")},
          {ExploringBody::kLucs3, BusKind::kDynamixel, {0, 3}, last_of("joints")},
          {ExploringBody::kTexture, BusKind::kSts, {2, 5}, spectrum_of_sound()},
          {ExploringBody::kHardness, BusKind::kScs, {1, 3, 7}, last_of("potentiometer")}};
}

// Hand II grasps from one pose.
ExploringParameters one_grasp() {
  ExploringParameters parameters;
  parameters.plan.heights = {126.0};
  parameters.plan.wrist_angles = {0.0};
  parameters.plan.grasps = 1;
  return parameters;
}

devices::DeviceFile device_of(const RecognizingCase& given) {
  const std::string name = choice_name(given.body);
  const std::string text(somato::detail::embedded_text("devices/" + name + ".toml"));
  return *devices::parse_device_file(*devices::with_bus(text, name, given.bus), name);
}

// The things of a simulated body's own table, explored by it and through the lines of boards.
class Explorers {
 public:
  explicit Explorers(const RecognizingCase& given)
      : given_(given),
        table_(*default_things(given.body)),
        direct_(*simulated_explorer(given.body, table_, one_grasp(), 1)),
        device_(device_of(given), body_before(0, 0)) {
    devices::DeviceExploring exploring;
    exploring.plan = one_grasp().plan;
    devices::DeviceSurroundings surroundings;
    surroundings.open_lines = [this]() -> Result<std::unique_ptr<wire::Lines>> {
      return std::make_unique<testing::LentLines>(device_.lines);
    };
    surroundings.place = [this](const ExploredThing& thing, std::size_t trial) -> Result<void> {
      device_.body.replace(body_before(number_of(thing.name), trial));
      return {};
    };
    through_lines_ = *devices::DeviceExplorer::create(device_.file, direct_->things(), exploring,
                                                      std::move(surroundings));
  }

  Explorer& direct() { return *direct_; }
  Explorer& through_lines() { return *through_lines_; }

  // The trials from `first` to before `end` of all things.
  Recording explored_by(Explorer& explorer, std::size_t first, std::size_t end) const {
    Recording recording;
    for (const std::size_t thing : given_.things) {
      for (std::size_t trial = first; trial < end; ++trial) {
        recording.explorations.push_back(value_or_throw(explorer.explore(thing, trial)));
      }
    }
    return recording;
  }

 private:
  std::unique_ptr<Body> body_before(std::size_t thing, std::size_t trial) const {
    return *simulated_body(given_.body, table_, one_grasp(), 1, thing, trial);
  }

  std::size_t number_of(const std::string& name) const {
    std::size_t number = 0;
    while (direct_->things()[number].name != name) ++number;
    return number;
  }

  RecognizingCase given_;
  ObjectTable table_;
  std::unique_ptr<SimulatedExplorer> direct_;
  testing::EmulatedDevice device_;
  std::unique_ptr<Explorer> through_lines_;
};

std::string label_of(const RecognizingCase& given) {
  const bool is_hand = given.body == ExploringBody::kLucs2 || given.body == ExploringBody::kLucs3;
  return is_hand ? "object" : "material";
}

std::shared_ptr<const SystemModel> learned_from(const RecognizingCase& given,
                                                const Recording& recording) {
  ViewSystem system = testing::view_system(given.system);
  system.label = label_of(given);
  return value_or_throw(live::train_visibly(
      system, recording, 1, [](const auto&) { return true; }, [] { return true; }));
}

// The last reading of an exploration that is followed frame by frame.
std::string read_live(const std::shared_ptr<const SystemModel>& model,
                      const Exploration& exploration) {
  auto reader = value_or_throw(live::SystemReading::build(model));
  reader.start();
  std::vector<std::size_t> frames(exploration.channels.size(), 0);
  std::size_t longest = 0;
  for (const Channel& channel : exploration.channels) {
    longest = std::max(longest, channel.frames.rows());
  }
  const std::size_t step = std::max<std::size_t>(1, longest / 32);
  for (std::size_t frame = step; frame < longest + step; frame += step) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      frames[i] = std::min(frame, exploration.channels[i].frames.rows());
    }
    EXPECT_TRUE(reader.follow(exploration, frames));
  }
  const auto reading = value_or_throw(reader.read());
  if (!reading || reading->candidates.empty()) return "nothing";
  return model->answer->classes[reading->candidates.front().number];
}

std::string case_name(const ::testing::TestParamInfo<RecognizingCase>& info) {
  return choice_name(info.param.body) + "_" + choice_name(info.param.bus);
}

class Recognition : public ::testing::TestWithParam<RecognizingCase> {};

INSTANTIATE_TEST_SUITE_P(Bodies, Recognition, ::testing::ValuesIn(recognizing_cases()), case_name);

TEST_P(Recognition, WorksThroughLinesAsInTheSimulation) {
  Explorers explorers(GetParam());
  const auto of_lines =
      learned_from(GetParam(), explorers.explored_by(explorers.through_lines(), 0, 1));
  const auto of_simulation =
      learned_from(GetParam(), explorers.explored_by(explorers.direct(), 0, 1));
  const Recording others = explorers.explored_by(explorers.through_lines(), 1, 2);
  for (const Exploration& exploration : others.explorations) {
    const std::string thing = *find_label(exploration, label_of(GetParam()));
    EXPECT_EQ(read_live(of_lines, exploration), thing);
    EXPECT_EQ(read_live(of_simulation, exploration), thing) << "learned from the simulation";
  }
}

}  // namespace
}  // namespace somato::emulation
