#include "somato/graph/system_training.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/support/temporary_folder.h"
#include "somato/graph/system_model.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"
#include "systems/support/systems.h"
#include "systems/support/t_mpsom_training.h"

namespace somato {
namespace {

using testing::build;
using testing::channels;
using testing::dense;
using testing::first_explorations;
using testing::frames_of;
using testing::hand_recording;
using testing::module;
using testing::output_of;
using testing::trained;
using testing::try_train;

constexpr const char* kThreeByTwo = "\nrows = 3\ncolumns = 2";

const Som& map_of(const System& system, const std::string& name) {
  return *som_of(system, *system.find(name));
}

std::string saved_bytes(const System& system) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("a"), system));
  return bytes_of(folder.file("a"));
}

Samples last_joints(const Recording& recording, std::size_t count) {
  Matrix<float> rows(count, 3);
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix<float>& frames = frames_of(recording, "joints", i);
    for (std::size_t j = 0; j < 3; ++j) rows(i, j) = frames(frames.rows() - 1, j);
  }
  return Samples(std::move(rows));
}

Samples all_joints(const Recording& recording, std::size_t count) {
  std::vector<Signal> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const Matrix<float>& joints = frames_of(recording, "joints", i);
    for (std::size_t f = 0; f < joints.rows(); ++f) {
      frames.push_back(Signal::dense({joints.row(f).begin(), joints.row(f).end()}));
    }
  }
  return Samples::from_signals(frames);
}

TEST(SystemTraining, ASingleMapIsTrainedAsWithoutASystem) {
  const Recording recording = hand_recording(9, 5);
  for (const std::string more :
       {"", "training = \"batch\"\nepochs = 5\n", "similarity = \"dot_product\"\niterations = 77\n",
        "arithmetic = \"inner_products\"\ndraws = \"without_replacement\"\n",
        "initial_weights = \"linear\"\nneighbourhood = \"triangular\"\niterations = 20\n"
        "tolerance = 0.01\n"}) {
    const System system = trained(
        build(channels() + module("closed", "last", "input = \"joints\"") +
                  module("map", "som", "input = \"closed\"\nrows = 4\ncolumns = 3\n" + more),
              recording),
        recording, 6, 1234);
    const SomParameters parameters =
        read_parameters<SomParameters>(
            *parse_toml("rows = 4\ncolumns = 3\nseed = 1234\n" + more, "t"))
            .value();
    const Som expected = train_som(parameters, last_joints(recording, 6)).value();
    EXPECT_EQ(map_of(system, "map").weights(), expected.weights()) << more;
    EXPECT_EQ(parameters_to_toml(map_of(system, "map").parameters()),
              parameters_to_toml(expected.parameters()));
  }
}

std::string coded_map(const std::string& more) {
  return channels({"joints"}) +
         module("code", "one_hot", "input = \"joints\"\nelements = 5\noutside = \"clamp\"") +
         module("sum", "accumulate", "input = \"code\"") +
         module("map", "som", "input = \"sum\"" + std::string(kThreeByTwo) + "\n" + more);
}

// The test inputs do not affect training; but the map knows them by their products.
TEST(SystemTraining, AMapKnowsWhatItIsTestedWith) {
  const Recording recording = hand_recording(9, 5);
  const std::string text = coded_map("arithmetic = \"inner_products\"\n");
  const System expected = trained(build(text, recording), recording, 6, 4);
  System system = build(text, recording);
  Activations activations(system.modules().size(), 9);
  const std::vector<std::size_t> tested{6, 8};
  SystemTraining training;
  training.seed = 4;
  training.tested = tested;
  ASSERT_TRUE(
      train_system(system, recording, testing::first_explorations(6), training, activations));
  const ExplorationValues& inputs = activations.values_of(*system.find("sum"));
  EXPECT_EQ(inputs.explorations, (std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 8}));
  const Som& som = map_of(system, "map");
  EXPECT_TRUE(som.knows(inputs.samples));
  SomWorkspace workspace;
  EXPECT_NEAR(som.distance(inputs.samples, 7, 2, workspace),
              som.distance(inputs.samples[7], 2, workspace), 1e-5);
  EXPECT_EQ(saved_bytes(system), saved_bytes(expected));
}

TEST(SystemTraining, ShowsTheMomentsOfMapsThatLearnByThemselves) {
  const Recording recording = hand_recording(9, 5);
  const std::string text =
      coded_map("") + module("second", "som", "input = \"map\"" + std::string(kThreeByTwo));
  const System expected = trained(build(text, recording), recording, 6, 4);
  System system = build(text, recording);
  std::map<std::size_t, LaneMatrix<float>> last;
  SystemTraining training;
  training.seed = 4;
  training.observer = [&](std::size_t module, const TrainingMoment& moment) {
    last[module] = moment.map().weights();
    return true;
  };
  ASSERT_TRUE(try_train(system, recording, 6, training));
  EXPECT_EQ(saved_bytes(system), saved_bytes(expected));
  ASSERT_EQ(last.size(), 2U);
  EXPECT_EQ(last[*system.find("map")], map_of(system, "map").weights());
  EXPECT_EQ(last[*system.find("second")], map_of(system, "second").weights());
  training.observer = [](std::size_t, const TrainingMoment& moment) { return moment.step < 5; };
  EXPECT_EQ(try_train(system, recording, 6, training).error().kind, ErrorKind::kInterrupted);
}

TEST(SystemTraining, ShowsNoMomentsOfMapsThatLearnTogetherOrFromFrames) {
  const Recording recording = hand_recording(9, 5);
  SystemTraining training;
  training.observer = [](std::size_t, const TrainingMoment&) { return false; };
  const std::string map = std::string(kThreeByTwo);
  System frames =
      build(channels({"joints"}) + module("a", "som", "input = \"joints\"" + map), recording);
  EXPECT_TRUE(try_train(frames, recording, 6, training));
  System both = build(coded_map("") + module("second", "som", "input = \"map\"" + map) +
                          "[[phase]]\nlearn = [\"map\", \"second\"]\ndraws = 9\n",
                      recording);
  EXPECT_TRUE(try_train(both, recording, 6, training));
}

TEST(SystemTraining, APhaseSetsDrawsAndOrderOfASingleMap) {
  const Recording recording = hand_recording(9, 5);
  const System system =
      trained(build(channels() + module("closed", "last", "input = \"joints\"") +
                        module("map", "som", "input = \"closed\"\nrows = 4\ncolumns = 3") +
                        "[[phase]]\nlearn = \"map\"\ndraws = 33\norder = \"without_replacement\"\n",
                    recording),
              recording, 6, 5);
  SomParameters parameters;
  parameters.rows = 4;
  parameters.columns = 3;
  parameters.iterations = 33;
  parameters.draws = Draws::kWithoutReplacement;
  parameters.seed = 5;
  EXPECT_EQ(map_of(system, "map").weights(),
            train_som(parameters, last_joints(recording, 6))->weights());
}

TEST(SystemTraining, ATMpsomLearnsFramesAsEver) {
  const Recording recording = hand_recording(6, 5);
  const System system =
      trained(build(channels() +
                        module("map", "t_mpsom",
                               "inputs = [\"joints\", \"touch\"]\nshape = [4, 3]\n"
                               "combination = \"added\"") +
                        "[[phase]]\nlearn = \"map\"\ndraws = 101\n",
                    recording),
              recording, 4, 77);
  TMpsomParameters parameters;
  parameters.shape = {4, 3};
  parameters.input_sizes = {3, 4};
  parameters.combination = TMpsomCombination::kAdded;
  parameters.iterations = 101;
  parameters.seed = 77;
  TMpsom expected(parameters);
  std::vector<testing::TMpsomExploration> explorations(4);
  for (std::size_t i = 0; i < 4; ++i) {
    const Matrix<float>& joints = frames_of(recording, "joints", i);
    const Matrix<float>& touch = frames_of(recording, "touch", i);
    for (std::size_t f = 0; f < joints.rows(); ++f) {
      explorations[i].push_back({Signal::dense({joints.row(f).begin(), joints.row(f).end()}),
                                 Signal::dense({touch.row(f).begin(), touch.row(f).end()})});
    }
  }
  testing::train_t_mpsom(expected, explorations);
  TMpsom::Workspace workspace(expected);
  std::vector<float> activity(12);
  for (std::size_t i = 0; i < 6; ++i) {
    const Matrix<float> given = dense(output_of(system, recording, "map", i));
    for (std::size_t f = 0; f < given.rows(); ++f) {
      const std::vector<SignalView> inputs{
          SignalView::dense(frames_of(recording, "joints", i).row(f)),
          SignalView::dense(frames_of(recording, "touch", i).row(f))};
      expected.activation(inputs, workspace, activity);
      EXPECT_EQ(std::vector<float>(given.row(f).begin(), given.row(f).end()), activity);
    }
  }
}

std::vector<float> activity_of(const Som& som, const SignalView& input) {
  SomWorkspace workspace;
  std::vector<float> activity(som.neurons());
  som.activity(input, workspace, activity);
  return activity;
}

void learn(SomLearner& learner, const SomParameters& p, std::size_t t, const SignalView& input) {
  learner.learn(input, p.learning_rate().at(t), p.radius().at(t));
}

SomParameters small_map(std::size_t draws, std::uint64_t seed) {
  SomParameters p;
  p.rows = 3;
  p.columns = 2;
  p.iterations = draws;
  p.seed = seed;
  p.arithmetic = Arithmetic::kPlain;
  return p;
}

Samples activities(const Som& som, const Samples& inputs) {
  std::vector<Signal> all;
  for (std::size_t i = 0; i < inputs.count(); ++i) {
    all.push_back(Signal::dense(activity_of(som, inputs[i])));
  }
  return Samples::from_signals(all);
}

const std::string kSmall = kThreeByTwo;

// The response is computed with the weights as they are; then both learn.
TEST(SystemTraining, TwoMapsLearnFramesTogetherAsInAnObviousLoop) {
  const Recording recording = hand_recording(6, 5);
  const std::size_t draws = 60;
  const System system = trained(
      build(channels() + module("b", "som", "input = \"scaled\"" + kSmall) +
                module("scaled", "scale", "input = \"a\"") +
                module("a", "som", "input = \"joints\"" + kSmall) +
                "[[phase]]\nlearn = [\"b\", \"a\"]\ndraws = 60\norder = \"without_replacement\"\n",
            recording),
      recording, 4, 9);
  const Samples joints = all_joints(recording, 4);
  // b comes first in the description and has the seed itself; a runs first, and draws.
  const std::uint64_t seed_of_a = map_of(system, "a").parameters().seed;
  EXPECT_EQ(map_of(system, "b").parameters().seed, 9U);
  EXPECT_NE(seed_of_a, 9U);
  Som a = untrained_som(small_map(draws, seed_of_a), joints).value();
  Som b = untrained_som(small_map(draws, 9), activities(a, joints)).value();
  SomLearner learner_of_a(a);
  SomLearner learner_of_b(b);
  DrawSequence order(Draws::kWithoutReplacement, 4, seed_of_a);
  std::size_t t = 0;
  while (t < draws) {
    const Matrix<float>& frames = frames_of(recording, "joints", order.next());
    for (std::size_t f = 0; f < frames.rows() && t < draws; ++f, ++t) {
      const SignalView input = SignalView::dense(frames.row(f));
      learner_of_a.settle();
      const std::vector<float> response = activity_of(a, input);
      learn(learner_of_a, a.parameters(), t, input);
      learn(learner_of_b, b.parameters(), t, SignalView::dense(response));
    }
  }
  learner_of_a.settle();
  learner_of_b.settle();
  EXPECT_EQ(map_of(system, "a").weights(), a.weights());
  EXPECT_EQ(map_of(system, "b").weights(), b.weights());
}

TEST(SystemTraining, TwoMapsLearnExplorationsTogetherAsInAnObviousLoop) {
  const Recording recording = hand_recording(6, 5);
  const std::size_t draws = 60;
  const System system = trained(build(channels() + module("closed", "last", "input = \"joints\"") +
                                          module("a", "som", "input = \"closed\"" + kSmall) +
                                          module("b", "som", "input = \"a\"" + kSmall) +
                                          "[[phase]]\nlearn = [\"b\", \"a\"]\ndraws = 60\n",
                                      recording),
                                recording, 4, 9);
  const Samples joints = last_joints(recording, 4);
  Som a = untrained_som(small_map(draws, 9), joints).value();
  const std::uint64_t seed_of_b = map_of(system, "b").parameters().seed;
  Som b = untrained_som(small_map(draws, seed_of_b), activities(a, joints)).value();
  SomLearner learner_of_a(a);
  SomLearner learner_of_b(b);
  DrawSequence order(Draws::kWithReplacement, 4, 9);
  for (std::size_t t = 0; t < draws; ++t) {
    const SignalView input = joints[order.next()];
    learner_of_a.settle();
    const std::vector<float> response = activity_of(a, input);
    learn(learner_of_a, a.parameters(), t, input);
    learn(learner_of_b, b.parameters(), t, SignalView::dense(response));
  }
  learner_of_a.settle();
  learner_of_b.settle();
  EXPECT_EQ(map_of(system, "a").weights(), a.weights());
  EXPECT_EQ(map_of(system, "b").weights(), b.weights());
}

// Two maps in one phase, of which the first has constant inputs for each exploration.
std::string channel_map(const std::string& more) {
  return channels() +
         module("code", "one_hot", "input = \"touch\"\nlow = 0\nhigh = 1\nelements = 7") +
         module("stm", "accumulate", "input = \"code\"") +
         module("a", "som", "input = \"stm\"\nrows = 5\ncolumns = 4\n" + more) +
         module("b", "som", "input = \"a\"" + kSmall) +
         "[[phase]]\nlearn = [\"b\", \"a\"]\ndraws = 300\n";
}

std::size_t place_of_greatest(std::span<const float> values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

void expect_alike(const System& one, const System& other, const Recording& recording,
                  const std::string& map) {
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    const Matrix<float> a = dense(output_of(one, recording, map, i));
    const Matrix<float> b = dense(output_of(other, recording, map, i));
    EXPECT_EQ(place_of_greatest(a.row(0)), place_of_greatest(b.row(0))) << map << " " << i;
    for (std::size_t n = 0; n < a.columns(); ++n) EXPECT_NEAR(a(0, n), b(0, n), 1e-4) << map;
  }
}

TEST(SystemTraining, MapsLearnTogetherByInnerProductsAsByPlainArithmetic) {
  const Recording recording = hand_recording(8, 5);
  for (const std::string& more :
       {std::string(), std::string("similarity = \"dot_product\"\n"),
        std::string("normalize_input = true\ninitial_weights = \"samples\"\n"),
        std::string("similarity = \"dot_product\"\ninitial_weights = \"uniform\"\n")}) {
    const System plain =
        trained(build(channel_map(more + "arithmetic = \"plain\"\n"), recording), recording, 6, 9);
    EXPECT_EQ(map_of(plain, "a").parameters().arithmetic, Arithmetic::kPlain);
    for (const std::string& arithmetic :
         {std::string(), std::string("arithmetic = \"inner_products\"")}) {
      const System fast =
          trained(build(channel_map(more + arithmetic), recording), recording, 6, 9);
      EXPECT_EQ(map_of(fast, "a").parameters().arithmetic, Arithmetic::kInnerProducts);
      EXPECT_EQ(map_of(fast, "b").parameters().arithmetic, Arithmetic::kPlain);
      EXPECT_EQ(map_of(fast, "a").elements(), map_of(plain, "a").elements());
      expect_alike(fast, plain, recording, "a");
      expect_alike(fast, plain, recording, "b");
    }
  }
}

TEST(SystemTraining, InnerProductsNeedTheSameInputsThroughout) {
  const Recording recording = hand_recording(6, 5);
  const auto refused = [&](const std::string& modules, const std::string& where) {
    System system = build(channels() + modules, recording);
    const auto trained = try_train(system, recording, 4);
    ASSERT_FALSE(trained);
    EXPECT_EQ(trained.error().kind, ErrorKind::kUsage);
    EXPECT_NE(trained.error().where.find(where), std::string::npos) << to_string(trained.error());
    EXPECT_NE(trained.error().what.find("inner products require constant inputs"),
              std::string::npos);
  };
  const std::string by_products = "\narithmetic = \"inner_products\"";
  refused(module("a", "som", "input = \"joints\"" + kSmall + by_products) +
              "[[phase]]\nlearn = \"a\"\ndraws = 9\n",
          "module 'a'");
  refused(module("closed", "last", "input = \"joints\"") +
              module("a", "som", "input = \"closed\"" + kSmall) +
              module("b", "som", "input = \"a\"" + kSmall + by_products) +
              "[[phase]]\nlearn = [\"a\", \"b\"]\ndraws = 9\n",
          "module 'b'");
}

TEST(SystemTraining, StepByStepHasAFixedLengthAndBoundedWeights) {
  const Recording recording = hand_recording(6, 5);
  for (const auto& [setting, reason] :
       {std::pair{"\ntolerance = 0.1", "cannot depend on the map's error"},
        {"\nneighbourhood = \"mexican_hat\"", "grow without limit"}}) {
    System system = build(channels() + module("a", "som", "input = \"joints\"" + kSmall + setting) +
                              "[[phase]]\nlearn = \"a\"\ndraws = 9\n",
                          recording);
    const auto trained = try_train(system, recording, 4);
    ASSERT_FALSE(trained);
    EXPECT_EQ(trained.error().kind, ErrorKind::kUsage);
    EXPECT_NE(trained.error().what.find(reason), std::string::npos) << to_string(trained.error());
  }
}

// A map that receives its own activity of the preceding frame.
TEST(SystemTraining, AMapInALoopLearnsAsInAnObviousLoop) {
  const Recording recording = hand_recording(6, 5);
  const std::size_t draws = 60;
  const System system = trained(
      build(channels() + module("both", "concatenation", "inputs = [\"joints\", \"before\"]") +
                module("map", "som", "input = \"both\"\ninitial_weights = \"uniform\"" + kSmall) +
                module("before", "delay", "input = \"map\"\nshape = [3, 2]") +
                "[[phase]]\nlearn = \"map\"\ndraws = 60\n",
            recording),
      recording, 4, 9);
  SomParameters parameters = small_map(draws, 9);
  parameters.initial_weights = InitialWeights::kUniform;
  Som map = untrained_som(parameters, Samples(Matrix<float>(1, 9))).value();
  SomLearner learner(map);
  DrawSequence order(Draws::kWithReplacement, 4, 9);
  const auto input_of = [&](std::size_t exploration, std::size_t f, std::vector<float>& before) {
    const Matrix<float>& joints = frames_of(recording, "joints", exploration);
    std::vector<float> input(joints.row(f).begin(), joints.row(f).end());
    input.insert(input.end(), before.begin(), before.end());
    before = activity_of(map, SignalView::dense(input));
    return input;
  };
  for (std::size_t t = 0; t < draws;) {
    const std::size_t exploration = order.next();
    std::vector<float> before(6);
    const std::size_t frames = frames_of(recording, "joints", exploration).rows();
    for (std::size_t f = 0; f < frames && t < draws; ++f, ++t) {
      learn(learner, map.parameters(), t, SignalView::dense(input_of(exploration, f, before)));
      learner.settle();
    }
  }
  EXPECT_EQ(map_of(system, "map").weights(), map.weights());
  const Matrix<float> given = dense(output_of(system, recording, "map", 5));
  std::vector<float> before(6);
  for (std::size_t f = 0; f < given.rows(); ++f) {
    input_of(5, f, before);
    EXPECT_EQ(std::vector<float>(given.row(f).begin(), given.row(f).end()), before);
  }
}

TEST(SystemTraining, AMapThatReceivesItsOutputCannotStartFromItsInput) {
  const Recording recording = hand_recording(4, 5);
  System system =
      build(channels() + module("both", "concatenation", "inputs = [\"joints\", \"before\"]") +
                module("map", "som", "input = \"both\"" + kSmall) +
                module("before", "delay", "input = \"map\"\nshape = [3, 2]"),
            recording);
  const auto refused = try_train(system, recording, 4);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(refused.error().where, "system.toml:16, module 'map'");
}

// Everything that learns, in all ways.
const std::string kEverything =
    channels() + module("standard", "standardization", "input = \"joints\"") +
    module("code", "one_hot", "input = \"height\"\nelements = 4\noutside = \"clamp\"") +
    module("tensor_map", "t_mpsom", "inputs = [\"code\", \"standard\"]\nshape = [3, 2]") +
    module("upper", "som", "input = \"tensor_map\"" + kSmall) +
    module("stm", "accumulate", "input = \"upper\"") +
    module("map", "som", "input = \"stm\"" + kSmall) +
    "[[phase]]\nlearn = [\"tensor_map\", \"upper\"]\ndraws = 150\n";

TEST(SystemTraining, NothingOutsideTheTrainingPartHasAnyInfluence) {
  const Recording recording = hand_recording(8, 5);
  const std::string expected = saved_bytes(trained(build(kEverything, recording), recording, 5));
  Recording other = recording;
  for (std::size_t i = 5; i < 8; ++i) {
    for (Channel& channel : other.explorations[i].channels) {
      for (float& value : channel.frames.values()) value = 1.0F - value;
    }
  }
  EXPECT_EQ(saved_bytes(trained(build(kEverything, other), other, 5)), expected);
  other = recording;
  other.explorations[4].channels[2].frames(0, 0) += 0.01F;
  EXPECT_NE(saved_bytes(trained(build(kEverything, other), other, 5)), expected);
}

TEST(SystemTraining, TheSeedDecidesAndModulesHaveSeedsOfTheirOwn) {
  const Recording recording = hand_recording(6, 5);
  const std::string text = channels() + module("closed", "last", "input = \"joints\"") +
                           module("a", "som", "input = \"closed\"" + kSmall) +
                           module("b", "som", "input = \"closed\"" + kSmall) +
                           module("c", "som", "input = \"closed\"" + kSmall);
  const auto with_seed = [&](std::uint64_t seed) {
    return trained(build(text, recording), recording, 6, seed);
  };
  const System one = with_seed(1);
  EXPECT_EQ(map_of(one, "a").parameters().seed, 1U);
  EXPECT_NE(map_of(one, "a").weights(), map_of(one, "b").weights());
  EXPECT_NE(map_of(one, "c").weights(), map_of(one, "b").weights());
  EXPECT_NE(map_of(one, "c").weights(), map_of(one, "a").weights());
  const System two = with_seed(2);
  for (const char* name : {"a", "b", "c"}) {
    EXPECT_NE(map_of(one, name).weights(), map_of(two, name).weights());
    EXPECT_LE(map_of(two, name).parameters().seed, 1'000'000'000'000'000U);
  }
  EXPECT_EQ(saved_bytes(one), saved_bytes(with_seed(1)));
}

TEST(SystemTraining, ThreadsMakeNoDifference) {
  const Recording recording = hand_recording(12, 5);
  const std::string expected = saved_bytes(trained(build(kEverything, recording), recording, 8));
  for (const std::size_t threads : {2U, 4U}) {
    System system = build(kEverything, recording);
    ASSERT_TRUE(try_train(system, recording, 8, {1, threads, {}}));
    EXPECT_EQ(saved_bytes(system), expected);
  }
}

TEST(SystemTraining, AProgressMayStopEveryPhase) {
  const Recording recording = hand_recording(6, 5);
  int calls = 0;
  System all = build(kEverything, recording);
  ASSERT_TRUE(try_train(all, recording, 6, {1, 1, [&](std::uint64_t done, std::uint64_t total) {
                                              EXPECT_LE(done, total);
                                              ++calls;
                                              return true;
                                            }}));
  ASSERT_GE(calls, 4);  // at 64, 128 and 150 of the joint phase, and of the single map
  for (int allowed = 0; allowed < calls; ++allowed) {
    System system = build(kEverything, recording);
    int left = allowed;
    const auto stopped = try_train(
        system, recording, 6, {1, 1, [&](std::uint64_t, std::uint64_t) { return left-- > 0; }});
    ASSERT_FALSE(stopped) << allowed;
    EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
    EXPECT_EQ(left, -1);
  }
}

// After each 64 draws and after the last, of frames as of explorations.
TEST(SystemTraining, AProgressReportsTheNumberOfDraws) {
  using DrawCounts = std::vector<std::uint64_t>;
  const Recording recording = hand_recording(6, 5);
  for (const std::string channel : {"joints", "closed"}) {
    for (const DrawCounts& expected : {DrawCounts{63}, DrawCounts{64}, DrawCounts{64, 128, 130}}) {
      const std::uint64_t draws = expected.back();
      System system =
          build(channels() + module("closed", "last", "input = \"joints\"") +
                    module("a", "som", "input = \"" + channel + "\"" + kSmall) +
                    module("b", "som", "input = \"a\"" + kSmall) +
                    "[[phase]]\nlearn = [\"b\", \"a\"]\ndraws = " + std::to_string(draws) + "\n",
                recording);
      DrawCounts reported;
      const auto report = [&](std::uint64_t done, std::uint64_t all) {
        EXPECT_EQ(all, draws);
        reported.push_back(done);
        return true;
      };
      ASSERT_TRUE(try_train(system, recording, 6, {1, 1, report}));
      EXPECT_EQ(reported, expected) << channel;
    }
  }
}

TEST(SystemTraining, WhatFrozenModulesGaveIsKept) {
  const Recording recording = hand_recording(6, 5);
  System system = build(kEverything, recording);
  auto activations = evaluate_fixed(system, recording, {}, 1);
  ASSERT_TRUE(activations);
  const std::vector<std::size_t> explorations{4, 1, 2};
  ASSERT_TRUE(train_system(system, recording, explorations, {}, *activations));
  for (std::size_t i = 0; i < 6; ++i) {
    const bool learned_from = i == 1 || i == 2 || i == 4;
    const Sequence* stm = activations->find(*system.find("stm"), i);
    ASSERT_EQ(stm != nullptr, learned_from) << i;
    if (stm != nullptr) {
      EXPECT_EQ(dense(*stm), dense(output_of(system, recording, "stm", i)));
    }
  }
}

TEST(SystemTraining, ErrorsOfTheDataNameModuleAndFrame) {
  Recording recording = hand_recording(4, 5);
  System none = build(kEverything, recording);
  const auto nothing = try_train(none, recording, 0);
  ASSERT_FALSE(nothing);
  EXPECT_NE(nothing.error().what.find("no explorations"), std::string::npos)
      << to_string(nothing.error());
  for (Exploration& e : recording.explorations) {
    for (std::size_t f = 0; f < e.channels[2].frames.rows(); ++f) e.channels[2].frames(f, 1) = 2.0F;
  }
  System system = build(kEverything, recording);
  const auto refused = try_train(system, recording, 4);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_NE(refused.error().where.find("system.toml:13, module 'standard'"), std::string::npos)
      << to_string(refused.error());
  EXPECT_NE(to_string(refused.error()).find("2"), std::string::npos);
}

}  // namespace
}  // namespace somato
