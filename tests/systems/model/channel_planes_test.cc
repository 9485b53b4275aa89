#include "systems/model/channel_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/som/som_archive.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/graph/system_model.h"
#include "systems/model/learned_parts.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::hand_recording;
using testing::module;
using testing::trained;

const std::string kMap = "rows = 2\ncolumns = 3\niterations = 20";

std::string map_on(const std::string& input, const std::string& more = "") {
  return module("map", "som", "input = '" + input + "'\n" + kMap + more);
}

std::string one_hot(const std::string& name, const std::string& input, const std::string& bins) {
  return module(name, "one_hot", "input = '" + input + "'\nlow = 0\nhigh = 1\nelements = " + bins);
}

Recording with_units(Recording recording) {
  for (Exploration& exploration : recording.explorations) {
    for (Channel& channel : exploration.channels) {
      if (channel.name == "height") channel.unit = "mm";
      if (channel.name != "joints") continue;
      channel.unit = "deg";
      channel.element_names = {"thumb", "index", "little"};
    }
  }
  return recording;
}

// A map of random weights in place of the trained one: nothing is equal by chance.
System with_random_weights(System system, double low = 0.0) {
  const std::size_t map = *system.find("map");
  const Som& som = *som_of(system, map);
  Random random(11);
  Matrix<float> weights(som.neurons(), som.input_size());
  for (float& weight : weights.values()) {
    weight = static_cast<float>(low + (1.0 - low) * random.uniform());
  }
  Archive archive("map");
  add_som(archive, "", Som(som.parameters(), weights));
  EXPECT_TRUE(system.modules()[map].module->learner()->load(archive, "", "here"));
  return system;
}

struct Problem {
  Recording recording = with_units(hand_recording(5, 3));
  System system;
  std::size_t map = 0;

  explicit Problem(const std::string& text, double low = 0.0)
      : system(with_random_weights(trained(build(text, recording), recording, 5), low)),
        map(*system.find("map")) {}

  const Som& som() const { return *som_of(system, map); }
  std::vector<ChannelPlanes> planes() const { return channel_planes(system, map); }
};

std::vector<std::string> names_of(const std::vector<ChannelPlanes>& planes) {
  std::vector<std::string> names;
  for (const ChannelPlanes& one : planes) names.push_back(one.name);
  return names;
}

using Words = std::vector<std::string>;

TEST(ChannelPlanes, AChannelReadAsItIsHasItsWeightsNamesAndUnit) {
  const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                        map_on("closed"));
  const auto planes = problem.planes();
  ASSERT_EQ(names_of(planes), (Words{"joints"}));
  EXPECT_EQ(planes[0].elements, (Words{"thumb", "index", "little"}));
  EXPECT_EQ(planes[0].unit, "deg");
  EXPECT_EQ(planes[0].value_unit, "deg");
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      EXPECT_EQ(planes[0].values(neuron, joint), double{problem.som().weight(neuron, joint)});
    }
  }
}

// A change of degrees is one in degrees, a sum of them over frames is not.
TEST(ChannelPlanes, ModulesThatPassValuesOnKeepTheirUnitOrNot) {
  const auto unit_through = [&](const std::string& type, const std::string& then,
                                const std::string& settings = {}) {
    return Problem(channels({"joints"}) + module("once", type, "input = 'joints'" + settings) +
                   module("end", then, "input = 'once'") + map_on("end"))
        .planes()
        .front()
        .value_unit;
  };
  for (const std::string type : {"first", "last", "change"}) {
    EXPECT_EQ(unit_through(type, "scale"), "deg") << type;
  }
  EXPECT_EQ(unit_through("tare", "last"), "deg");
  EXPECT_EQ(unit_through("high_pass", "last", "\nrate = 20"), "deg");
  EXPECT_EQ(unit_through("accumulate", "scale"), "");
  EXPECT_EQ(unit_through("last", "normalization"), "");
}

TEST(ChannelPlanes, AMapOfOneNeuronHasThemToo) {
  const Problem problem(
      channels({"joints"}) + module("closed", "last", "input = 'joints'") +
      module("map", "som", "input = 'closed'\nrows = 1\ncolumns = 1\niterations = 20"));
  const auto planes = problem.planes();
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0].values(0, 2), double{problem.som().weight(0, 2)});
}

TEST(ChannelPlanes, WeightsOfLengthOneHaveNoUnit) {
  const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                        map_on("closed", "\nsimilarity = 'dot_product'"));
  EXPECT_EQ(problem.planes().front().unit, "deg");
  EXPECT_EQ(problem.planes().front().value_unit, "");
}

TEST(ChannelPlanes, ElementsThatAreTakenKeepTheirNames) {
  const Problem problem(module("some", "channel", "channel = 'joints'\nelements = ['3', 'thumb']") +
                        module("closed", "last", "input = 'some'") + map_on("closed"));
  EXPECT_EQ(problem.planes().front().elements, (Words{"little", "thumb"}));
}

TEST(ChannelPlanes, AStandardizationIsUndone) {
  const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                        module("standard", "standardization", "input = 'closed'") +
                        map_on("standard"));
  const auto planes = problem.planes();
  const auto standard = standardization_of(problem.system, *problem.system.find("standard"));
  EXPECT_EQ(planes[0].value_unit, "deg");
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      EXPECT_NEAR(planes[0].values(neuron, joint),
                  double{problem.som().weight(neuron, joint)} * standard->deviations[joint] +
                      standard->means[joint],
                  1e-12);
    }
  }
}

TEST(ChannelPlanes, AFactorAndAnOffsetAreUndone) {
  const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                        module("scaled", "scale", "input = 'closed'\nfactor = 4\noffset = -1") +
                        map_on("scaled"));
  EXPECT_NEAR(problem.planes()[0].values(4, 1), (double{problem.som().weight(4, 1)} + 1.0) / 4.0,
              1e-12);
}

TEST(ChannelPlanes, ALogarithmIsUndone) {
  const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                        module("logarithms", "logarithm", "input = 'closed'\nunit = 0.25") +
                        map_on("logarithms"));
  EXPECT_NEAR(problem.planes()[0].values(4, 1),
              0.25 * std::expm1(double{problem.som().weight(4, 1)}), 1e-12);
}

// The whole tensor, element by element: height x wrist x (joint, bin) x touch.
class FullTensor : public ::testing::TestWithParam<double> {
 protected:
  static constexpr std::size_t kHeight = 4;
  static constexpr std::size_t kWrist = 3;
  static constexpr std::size_t kBins = 2;
  static constexpr std::size_t kTouch = 4;

  Problem problem_{channels() + one_hot("height_code", "height", "4") +
                       one_hot("wrist_code", "wrist", "3") + one_hot("joints_code", "joints", "2") +
                       module("crossed", "tensor_product",
                              "inputs = ['height_code', 'wrist_code', 'joints_code', 'touch']") +
                       module("memory", "accumulate", "input = 'crossed'") +
                       module("unit", "normalization", "input = 'memory'") + map_on("unit"),
                   GetParam()};

  template <typename Use>
  void each(const Use& use) const {
    std::size_t element = 0;
    for (std::size_t h = 0; h < kHeight; ++h) {
      for (std::size_t w = 0; w < kWrist; ++w) {
        for (std::size_t j = 0; j < 3; ++j) {
          for (std::size_t b = 0; b < kBins; ++b) {
            for (std::size_t t = 0; t < kTouch; ++t) use(element++, h, w, j, b, t);
          }
        }
      }
    }
  }

  double weight(std::size_t neuron, std::size_t element) const {
    return double{problem_.som().weight(neuron, element)};
  }

  static double mean_of(const std::vector<double>& weights) {
    double sum = 0.0;
    double mean = 0.0;
    for (std::size_t b = 0; b < weights.size(); ++b) {
      const double centre = (static_cast<double>(b) + 0.5) / static_cast<double>(weights.size());
      sum += std::max(0.0, weights[b]);
      mean += std::max(0.0, weights[b]) * centre;
    }
    return mean / sum;
  }

  static void expect_alike(double value, double expected) {
    if (std::isnan(expected)) {
      EXPECT_TRUE(std::isnan(value));
    } else {
      EXPECT_NEAR(value, expected, 1e-9);
    }
  }
};

TEST_P(FullTensor, IsSummedOverAllThatAnElementIsCrossedWith) {
  const auto planes = problem_.planes();
  ASSERT_EQ(names_of(planes), (Words{"height", "wrist", "joints", "touch"}));
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    std::vector<double> touch(kTouch);
    std::vector<double> height(kHeight);
    std::vector<double> wrist(kWrist);
    Matrix<double> joints(3, kBins);
    each([&](std::size_t e, std::size_t h, std::size_t w, std::size_t j, std::size_t b,
             std::size_t t) {
      const double one = weight(neuron, e);
      touch[t] += one;
      height[h] += one;
      wrist[w] += one;
      joints(j, b) += one;
    });
    expect_alike(planes[0].values(neuron, 0), mean_of(height));
    expect_alike(planes[1].values(neuron, 0), mean_of(wrist));
    for (std::size_t j = 0; j < 3; ++j) {
      expect_alike(planes[2].values(neuron, j),
                   mean_of({joints.row(j).begin(), joints.row(j).end()}));
    }
    for (std::size_t t = 0; t < kTouch; ++t) {
      EXPECT_NEAR(planes[3].values(neuron, t), touch[t], 1e-9);
    }
  }
  EXPECT_EQ(planes[0].value_unit, "mm");
  EXPECT_EQ(planes[2].value_unit, "deg");
  EXPECT_EQ(planes[3].value_unit, "");
  EXPECT_EQ(planes[3].shape, (std::vector<std::size_t>{2, 2}));
}

INSTANTIATE_TEST_SUITE_P(WeightsFrom, FullTensor, ::testing::Values(0.0, -1.0));

// The trained map only has weights of the elements that occurred.
TEST(ChannelPlanes, ElementsWithoutWeightsCountAsZeros) {
  const Recording recording = with_units(hand_recording(4, 3));
  const System system =
      trained(build(channels() + one_hot("height_code", "height", "50") +
                        one_hot("wrist_code", "wrist", "40") +
                        module("crossed", "tensor_product",
                               "inputs = ['height_code', 'wrist_code', 'touch']") +
                        module("memory", "accumulate", "input = 'crossed'") + map_on("memory"),
                    recording),
              recording, 4);
  const std::size_t map = *system.find("map");
  const Som& som = *som_of(system, map);
  ASSERT_FALSE(som.elements().all());
  const auto planes = channel_planes(system, map);
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    for (std::size_t t = 0; t < 4; ++t) {
      double sum = 0.0;
      for (std::size_t e = t; e < som.input_size(); e += 4) sum += double{som.weight(neuron, e)};
      EXPECT_NEAR(planes[2].values(neuron, t), sum, 1e-6);
    }
  }
}

TEST(ChannelPlanes, ATMpsomDistributesWeightsLikeItsInputs) {
  const Problem problem(
      channels({"wrist", "touch"}) + one_hot("code", "wrist", "7") +
      module("felt", "t_mpsom", "inputs = ['code', 'touch']\nshape = [9, 8]\niterations = 30") +
      module("memory", "accumulate", "input = 'felt'") + map_on("memory"));
  const auto planes = problem.planes();
  ASSERT_EQ(names_of(planes), (Words{"wrist", "touch"}));
  const auto map = t_mpsom_of(problem.system, *problem.system.find("felt"));
  const Matrix<float> weights = map->weights(1);
  const Matrix<float> arbor = map->arbor(1);
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    std::vector<double> expected(4);
    double all = 0.0;
    double dealt = 0.0;
    for (std::size_t n = 0; n < 72; ++n) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 4; ++k) sum += double{weights(n, k)} * double{arbor(n, k)};
      const double weight = double{problem.som().weight(neuron, n)};
      all += weight;
      for (std::size_t k = 0; k < 4; ++k) {
        expected[k] += weight * double{weights(n, k)} * double{arbor(n, k)} / sum;
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(planes[1].values(neuron, k), expected[k], 1e-4);
      dealt += planes[1].values(neuron, k);
    }
    EXPECT_NEAR(dealt, all, 1e-4);
  }
}

TEST(ChannelPlanes, ShortInputsThatAreNoChannelsHaveAllTheirElementsFirst) {
  const Problem problem(channels({"height", "wrist"}) + one_hot("a", "height", "4") +
                        one_hot("b", "wrist", "3") +
                        module("both", "concatenation", "inputs = ['a', 'b']") +
                        module("memory", "accumulate", "input = 'both'") + map_on("memory"));
  const auto planes = problem.planes();
  ASSERT_EQ(names_of(planes), (Words{"memory", "height", "wrist"}));
  ASSERT_EQ(planes[0].values.columns(), 7U);
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    for (std::size_t element = 0; element < 7; ++element) {
      EXPECT_EQ(planes[0].values(neuron, element), double{problem.som().weight(neuron, element)});
    }
  }
}

TEST(ChannelPlanes, EndAtWhatIsNoChannelAnyMore) {
  const Problem problem(
      channels({"wrist", "joints"}) + module("reading", "last", "input = 'wrist'") +
      module("bits", "number_code", "input = 'reading'\nlow = 0\nhigh = 1\nbits = 5") +
      module("closed", "last", "input = 'joints'") +
      module("both", "concatenation", "inputs = ['bits', 'closed']") + map_on("both"));
  const auto planes = problem.planes();
  ASSERT_EQ(names_of(planes), (Words{"bits", "joints"}));
  EXPECT_EQ(planes[0].elements, (Words{"1", "2", "3", "4", "5"}));
  EXPECT_EQ(planes[1].values(3, 2), double{problem.som().weight(3, 7)});
}

TEST(ChannelPlanes, ManyElementsAreMeansOfNeighbours) {
  const Problem problem(
      channels({"wrist"}) + module("reading", "last", "input = 'wrist'") +
      module("bits", "number_code",
             "input = 'reading'\nlow = 0\nhigh = 1\nbits = 300\ncode = 'thermometer'") +
      map_on("bits"));
  const auto planes = problem.planes();
  ASSERT_EQ(planes[0].elements.size(), 100U);
  EXPECT_EQ(planes[0].elements.front(), "1-3");
  EXPECT_EQ(planes[0].elements[1], "4-6");
  EXPECT_EQ(planes[0].elements.back(), "298-300");
  for (std::size_t neuron = 0; neuron < 6; ++neuron) {
    for (std::size_t group = 0; group < 100; ++group) {
      double sum = 0.0;
      for (std::size_t e = 3 * group; e < 3 * group + 3; ++e) {
        sum += double{problem.som().weight(neuron, e)};
      }
      EXPECT_NEAR(planes[0].values(neuron, group), sum / 3, 1e-9);
    }
  }
}

// Each concatenation of a signal with itself doubles the number of paths back, and all are
// followed.
TEST(ChannelPlanes, WaysBackAreAsLongAsTheSystem) {
  std::string text = channels({"wrist"}) + module("m0", "last", "input = 'wrist'");
  for (int i = 1; i <= 7; ++i) {
    const std::string before = "'m" + std::to_string(i - 1) + "'";
    text += module("m" + std::to_string(i), "concatenation",
                   "inputs = [" + before + ", " + before + "]");
  }
  const Problem problem(text + map_on("m7"));
  const auto planes = problem.planes();
  ASSERT_EQ(planes.size(), 128U);
  for (std::size_t way = 0; way < 128; ++way) {
    EXPECT_EQ(planes[way].name, "wrist");
    EXPECT_EQ(planes[way].values(3, 0), double{problem.som().weight(3, way)}) << way;
  }
}

// Each module doubles the ways back: 2^12 of them.
TEST(ChannelPlanes, TooManyPathsBackAreNotFollowed) {
  std::string text = channels({"wrist"}) + module("m0", "last", "input = 'wrist'");
  for (int i = 1; i <= 12; ++i) {
    const std::string before = "'m" + std::to_string(i - 1) + "'";
    text += module("m" + std::to_string(i), "concatenation",
                   "inputs = [" + before + ", " + before + "]");
  }
  const Problem problem(text + map_on("m12"));
  EXPECT_EQ(names_of(problem.planes()), (Words{"m12"}));
}

TEST(ChannelPlanes, AreOfMaps) {
  const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                        map_on("closed"));
  EXPECT_THROW(channel_planes(problem.system, *problem.system.find("closed")), InvalidArgument);
}

}  // namespace
}  // namespace somato
