#include "somato/graph/system_contributions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "maps/som/som_archive.h"
#include "somato/graph/answers.h"
#include "somato/graph/evaluation.h"
#include "systems/support/systems.h"

namespace somato::contributions_test {
namespace {

using testing::build;
using testing::channels;
using testing::hand_recording;
using testing::module;
using testing::trained;

using Words = std::vector<std::string>;
using Numbers = std::vector<std::size_t>;

constexpr std::size_t kNeurons = 6;

std::string map_on(const std::string& input, const std::string& more = "") {
  return module("map", "som",
                "input = '" + input + "'\nrows = 2\ncolumns = 3\niterations = 20\n" + more);
}

// The map has random weights in place of the trained ones; its neurons have two classes in turn.
std::shared_ptr<const SystemModel> model_of(const std::string& text, const Recording& recording,
                                            std::size_t classes = 2) {
  System system = trained(build(text, recording), recording, 5);
  const std::size_t map = *system.find("map");
  const Som& som = *som_of(system, map);
  Random random(21);
  Matrix<float> weights(som.neurons(), som.input_size());
  for (float& weight : weights.values()) weight = static_cast<float>(random.uniform());
  Archive archive("map");
  add_som(archive, "", Som(som.parameters(), weights));
  EXPECT_TRUE(system.modules()[map].module->learner()->load(archive, "", "here"));
  std::vector<std::optional<std::size_t>> labels(kNeurons);
  for (std::size_t neuron = 0; neuron < kNeurons; ++neuron) labels[neuron] = neuron % classes;
  return std::make_shared<SystemModel>(SystemModel{
      std::move(system), SystemAnswer{"map", "object", {"ball", "cube"}, NeuronLabels(labels)}});
}

struct Problem {
  Recording recording;
  std::shared_ptr<const SystemModel> model;
  ContributionReader reader;
  Samples inputs;

  explicit Problem(const std::string& text, Recording hand = hand_recording(6, 4))
      : recording(std::move(hand)),
        model(model_of(text, recording)),
        reader(testing::value_or_throw(ContributionReader::build(model))),
        inputs(testing::value_or_throw(inputs_to_answer(*model, recording))) {}

  // One after the other, by the weights of the map.
  double weight(std::size_t neuron, std::size_t element) const {
    return double{reader.som().weight(neuron, element)};
  }

  std::vector<float> input(std::size_t exploration) const {
    std::vector<float> values(inputs.size());
    write_dense(inputs[exploration], values);
    return values;
  }

  double distance(std::size_t exploration, std::size_t neuron) const {
    double sum = 0.0;
    const std::vector<float> x = input(exploration);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double apart = double{x[i]} - weight(neuron, i);
      sum += apart * apart;
    }
    return std::sqrt(sum);
  }

  // The contribution of an element of the map's input, by its definition.
  double of_element(std::size_t exploration, DecidingNeurons two, std::size_t element) const {
    const double x = input(exploration)[element];
    const double a = x - weight(two.nearest, element);
    const double b = x - weight(two.other, element);
    return (b * b - a * a) /
           (distance(exploration, two.nearest) + distance(exploration, two.other));
  }

  // The nearest neuron, and the nearest of the other class.
  DecidingNeurons neurons_for(std::size_t exploration) const {
    std::size_t nearest = 0;
    for (std::size_t n = 1; n < kNeurons; ++n) {
      if (distance(exploration, n) < distance(exploration, nearest)) nearest = n;
    }
    std::size_t other = 1 - nearest % 2;
    for (std::size_t n = other; n < kNeurons; n += 2) {
      if (distance(exploration, n) < distance(exploration, other)) other = n;
    }
    return {nearest, other};
  }

  // Every exploration is checked against the definitions of neurons and distances.
  void check_sums() const {
    const auto deciding = reader.deciding(inputs, 2);
    const auto all = reader.read(inputs, 3);
    for (std::size_t i = 0; i < inputs.count(); ++i) {
      const DecidingNeurons two = neurons_for(i);
      EXPECT_EQ(deciding[i].nearest, two.nearest);
      EXPECT_EQ(deciding[i].other, two.other);
      const InputContributions read = reader.read(inputs[i], deciding[i]);
      EXPECT_EQ(read.nearest, two.nearest % 2);
      EXPECT_EQ(read.other, two.other % 2);
      EXPECT_NEAR(read.of_nearest, distance(i, two.nearest), 1e-9);
      EXPECT_NEAR(sum_of(read), distance(i, two.other) - distance(i, two.nearest), 1e-9);
      EXPECT_EQ(reader.read(inputs[i]).values, read.values);
      EXPECT_EQ(all[i].values, read.values);
    }
  }

  static double sum_of(const InputContributions& read) {
    double sum = 0.0;
    for (const auto& values : read.values) {
      sum = std::accumulate(values.begin(), values.end(), sum);
    }
    return sum;
  }

  Words names() const {
    Words names;
    for (const ContributionSource& source : reader.sources()) names.push_back(source.name);
    return names;
  }
};

Recording with_units() {
  Recording recording = hand_recording(6, 4);
  for (Exploration& exploration : recording.explorations) {
    for (Channel& channel : exploration.channels) {
      channel.unit = channel.name == "joints" ? "deg" : "N";
      if (channel.name == "joints") channel.element_names = {"thumb", "index", "little"};
    }
  }
  return recording;
}

TEST(ContributionReader, GivesTheElementsOfConcatenatedChannels) {
  const Problem problem(
      channels({"joints", "touch"}) + module("closed", "last", "input = 'joints'") +
          module("felt", "mean", "input = 'touch'") +
          module("both", "concatenation", "inputs = ['closed', 'felt']") + map_on("both"),
      with_units());
  ASSERT_EQ(problem.names(), (Words{"joints", "touch"}));
  const auto& sources = problem.reader.sources();
  EXPECT_TRUE(sources[0].is_channel);
  EXPECT_EQ(sources[0].elements, (Words{"thumb", "index", "little"}));
  EXPECT_EQ(sources[1].elements, (Words{"1", "2", "3", "4"}));
  EXPECT_EQ(sources[1].shape, (Numbers{2, 2}));
  problem.check_sums();
  const DecidingNeurons two = problem.neurons_for(3);
  const InputContributions read = problem.reader.read(problem.inputs[3]);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(read.values[0][i], problem.of_element(3, two, i), 1e-9);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(read.values[1][i], problem.of_element(3, two, 3 + i), 1e-9);
  }
}

TEST(ContributionReader, SharesThoseOfAProductEquallyBetweenItsFactors) {
  const Problem problem(
      channels({"wrist", "joints", "touch"}) +
      module("code", "one_hot", "input = 'joints'\nlow = 0\nhigh = 1\nelements = 5") +
      module("crossed", "tensor_product", "inputs = ['wrist', 'code', 'touch']") +
      module("memory", "accumulate", "input = 'crossed'") + map_on("memory"));
  ASSERT_EQ(problem.names(), (Words{"wrist", "joints", "touch"}));
  problem.check_sums();
  for (std::size_t i = 0; i < problem.inputs.count(); ++i) {
    const DecidingNeurons two = problem.neurons_for(i);
    std::vector<double> joints(3);
    std::vector<double> touch(4);
    double wrist = 0.0;
    for (std::size_t e = 0; e < 3 * 5 * 4; ++e) {
      const double third = problem.of_element(i, two, e) / 3.0;
      joints[e / 4 / 5] += third;
      touch[e % 4] += third;
      wrist += third;
    }
    const InputContributions read = problem.reader.read(problem.inputs[i]);
    EXPECT_NEAR(read.values[0][0], wrist, 1e-9);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(read.values[1][j], joints[j], 1e-9);
    for (std::size_t t = 0; t < 4; ++t) EXPECT_NEAR(read.values[2][t], touch[t], 1e-9);
  }
}

// The sum is preserved by each type of module that is traced.
TEST(ContributionReader, SumsAreThoseOfTheDistancesThroughEveryModule) {
  const std::vector<std::pair<std::string, std::string>> of_frames{{"first", ""},
                                                                   {"last", ""},
                                                                   {"mean", ""},
                                                                   {"change", ""},
                                                                   {"accumulate", ""},
                                                                   {"leaky_accumulate", ""},
                                                                   {"resampling", "points = 3"}};
  for (const auto& [type, settings] : of_frames) {
    const Problem problem(channels({"touch"}) +
                          module("once", type, "input = 'touch'\n" + settings) + map_on("once"));
    EXPECT_EQ(problem.names(), (Words{"touch"})) << type;
    problem.check_sums();
  }
  Problem(channels({"sound"}) +
          module("power", "spectrum", "input = 'sound'\nsegment_length = 4\nbands = 2\nhigh = 30") +
          map_on("power"))
      .check_sums();
  const std::vector<std::pair<std::string, std::string>> of_values{
      {"scale", "factor = 3\noffset = 1"},
      {"logarithm", ""},
      {"standardization", ""},
      {"normalization", ""},
      {"one_hot", "low = 0\nhigh = 1\nelements = 4"},
      {"number_code", "low = 0\nhigh = 1\nbits = 5"}};
  for (const auto& [type, settings] : of_values) {
    const Problem problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                          module("code", type, "input = 'closed'\n" + settings) + map_on("code"));
    EXPECT_EQ(problem.names(), (Words{"joints"})) << type;
    problem.check_sums();
  }
}

TEST(ContributionReader, SumsBinsDigitsAndPointsOfAnElement) {
  const auto per_element = [](const Problem& problem, const auto& belongs) {
    const DecidingNeurons two = problem.neurons_for(2);
    std::vector<double> sums(problem.reader.sources()[0].places.size());
    for (std::size_t e = 0; e < problem.inputs.size(); ++e) {
      sums[belongs(e)] += problem.of_element(2, two, e);
    }
    const auto values = problem.reader.read(problem.inputs[2]).values[0];
    for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(values[i], sums[i], 1e-9);
  };
  per_element(
      Problem(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
              module("code", "number_code", "input = 'closed'\nlow = 0\nhigh = 1\nbits = 5") +
              map_on("code")),
      [](std::size_t e) { return e / 5; });
  per_element(Problem(channels({"joints"}) +
                      module("way", "resampling", "input = 'joints'\npoints = 6") + map_on("way")),
              [](std::size_t e) { return e % 3; });
}

TEST(ContributionReader, EndsAtACodeThatCannotBeTraced) {
  const Problem problem(
      channels({"wrist", "touch"}) +
      module("code", "one_hot", "input = 'wrist'\nlow = 0\nhigh = 1") +
      module("felt", "t_mpsom", "inputs = ['code', 'touch']\nshape = [3, 4]\niterations = 30") +
      module("memory", "accumulate", "input = 'felt'") + module("now", "last", "input = 'touch'") +
      module("both", "concatenation", "inputs = ['memory', 'now']") + map_on("both"));
  ASSERT_EQ(problem.names(), (Words{"touch", "felt"}));  // channels first
  const ContributionSource& felt = problem.reader.sources()[1];
  EXPECT_FALSE(felt.is_channel);
  EXPECT_EQ(felt.elements.size(), 12U);
  EXPECT_EQ(felt.shape, (Numbers{3, 4}));
  problem.check_sums();
}

TEST(ContributionReader, SumsThePathsToTheSameElement) {
  const Problem problem(module("some", "channel", "channel = 'joints'\nelements = ['3', '1']") +
                        channels({"joints"}) + module("closed", "last", "input = 'some'") +
                        module("moved", "change", "input = 'joints'") +
                        module("both", "concatenation", "inputs = ['closed', 'moved']") +
                        map_on("both"));
  ASSERT_EQ(problem.names(), (Words{"joints"}));
  EXPECT_EQ(problem.reader.sources()[0].places, (Numbers{0, 1, 2}));
  problem.check_sums();
  const DecidingNeurons two = problem.neurons_for(1);
  const auto values = problem.reader.read(problem.inputs[1]).values[0];
  EXPECT_NEAR(values[0], problem.of_element(1, two, 1) + problem.of_element(1, two, 2), 1e-9);
  EXPECT_NEAR(values[1], problem.of_element(1, two, 3), 1e-9);
  EXPECT_NEAR(values[2], problem.of_element(1, two, 0) + problem.of_element(1, two, 4), 1e-9);
}

TEST(ContributionReader, NamesOnlyTheElementsThatAreRead) {
  const Problem problem(
      module("some", "channel", "channel = 'joints'\nelements = ['little', '1']") +
          module("closed", "last", "input = 'some'") + map_on("closed"),
      with_units());
  EXPECT_EQ(problem.reader.sources()[0].places, (Numbers{0, 2}));
  EXPECT_EQ(problem.reader.sources()[0].elements, (Words{"thumb", "little"}));
  const DecidingNeurons two = problem.neurons_for(0);
  const auto values = problem.reader.read(problem.inputs[0]).values[0];
  EXPECT_NEAR(values[0], problem.of_element(0, two, 1), 1e-9);
  EXPECT_NEAR(values[1], problem.of_element(0, two, 0), 1e-9);
}

// A value that is always the same does not decide.
TEST(ContributionReader, AConstantElementContributesNothing) {
  Recording recording = hand_recording(6, 4);
  for (Exploration& exploration : recording.explorations) {
    Matrix<float>& joints = exploration.channels[2].frames;
    for (std::size_t frame = 0; frame < joints.rows(); ++frame) joints(frame, 1) = 0.25F;
  }
  for (const std::string similarity : {"euclidean", "manhattan"}) {
    auto model = std::make_shared<SystemModel>();
    model->system =
        trained(build(channels({"joints"}) + module("closed", "last", "input = 'joints'") +
                          map_on("closed", "similarity = '" + similarity + "'"),
                      recording),
                recording, 6);
    model->answer =
        SystemAnswer{"map", "object", {"ball", "cube"}, NeuronLabels({0, 1, 0, 1, 0, 1})};
    const auto reader = ContributionReader::build(model).value();
    const Samples inputs = inputs_to_answer(*model, recording).value();
    for (std::size_t i = 0; i < inputs.count(); ++i) {
      EXPECT_NEAR(reader.read(inputs[i]).values[0][1], 0.0, 1e-14) << similarity;
      EXPECT_NE(reader.read(inputs[i]).values[0][2], 0.0) << similarity;
    }
  }
}

TEST(ContributionReader, HasTheUnitOfTheChannelsIfAllHaveIt) {
  const auto unit_of = [](const std::string& text) {
    return Problem(text, with_units()).reader.unit();
  };
  const std::string joints = channels({"joints"}) + module("closed", "last", "input = 'joints'");
  EXPECT_EQ(unit_of(joints + map_on("closed")), "deg");
  EXPECT_EQ(unit_of(joints + map_on("closed", "similarity = 'cosine'")), "");
  EXPECT_EQ(unit_of(joints + map_on("closed", "similarity = 'dot_product'")), "");
  EXPECT_EQ(unit_of(joints + module("s", "standardization", "input = 'closed'") + map_on("s")), "");
  EXPECT_EQ(
      unit_of(channels({"joints", "touch"}) + module("closed", "last", "input = 'joints'") +
              module("felt", "last", "input = 'touch'") +
              module("both", "concatenation", "inputs = ['closed', 'felt']") + map_on("both")),
      "");
}

TEST(ContributionReader, NeedsAnAnswerOfTwoClasses) {
  const Recording recording = hand_recording(6, 4);
  const std::string text =
      channels({"joints"}) + module("closed", "last", "input = 'joints'") + map_on("closed");
  const auto refused = ContributionReader::build(model_of(text, recording, 1));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_NE(refused.error().what.find("two classes"), std::string::npos);
  auto mute = std::make_shared<SystemModel>();
  mute->system = trained(build(text, recording), recording, 5);
  EXPECT_EQ(ContributionReader::build(mute).error().what, "the system has no output map");
}

}  // namespace
}  // namespace somato::contributions_test
