#include "somato/graph/system.h"

#include <gtest/gtest.h>

#include "systems/graph/wiring.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::hand_recording;
using testing::module;
using testing::try_build;

// Lines 1 to 12.
const std::string kChannels =
    "[module.height]\ntype = \"channel\"\nchannel = \"height\"\n"
    "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
    "[module.touch]\ntype = \"channel\"\nchannel = \"touch\"\n"
    "[module.sound]\ntype = \"channel\"\nchannel = \"sound\"\n";

Error refusal(const std::string& text) {
  const auto system = try_build(text, hand_recording(3, 1));
  if (!system) return system.error();
  ADD_FAILURE() << "was built:\n" << text;
  return {};
}

// `text` comes after the channels and begins in line 13.
void expect_refused(const std::string& text, const std::string& where, const std::string& what) {
  const Error error = refusal(kChannels + text);
  EXPECT_EQ(error.kind, ErrorKind::kUsage) << text;
  EXPECT_EQ(error.where, where) << text;
  const std::string said = error.what + "; " + error.advice;
  EXPECT_NE(said.find(what), std::string::npos) << said << "\n" << text;
}

void expect_built(const std::string& text) {
  const auto system = try_build(kChannels + text, hand_recording(3, 1));
  EXPECT_TRUE(system) << to_string(system.error()) << "\n" << text;
}

TEST(System, RefusesUnknownNamesWithTheNearest) {
  expect_refused(module("m", "sum_up", ""), "system.toml:14, module 'm'",
                 "unknown type of module 'sum_up'");
  expect_refused(module("m", "changee", ""), "system.toml:14, module 'm'",
                 "did you mean 'change'?");
  expect_refused("[module.m]\ninput = \"joints\"\n", "system.toml:13, module 'm'",
                 "'type' is missing");
  expect_refused("[module.m]\ntype = [\"sum\"]\n", "system.toml:14, module 'm'",
                 "'type' is missing");
  expect_refused(module("m", "change", "inputt = \"joints\""), "system.toml:15, module 'm'",
                 "unknown key 'inputt'; did you mean 'input'?");
  expect_refused(module("m", "som", "input = \"joints\"\nrow = 3"), "system.toml:16, module 'm'",
                 "did you mean 'rows'?");
  expect_refused(module("m", "som", "input = \"joints\"\nseed = 3"), "system.toml:16, module 'm'",
                 "unknown key 'seed'");
  expect_refused(module("m", "change", "input = \"joint\""),
                 "system.toml:15, module 'm', port 'input'",
                 "unknown module 'joint'; did you mean 'joints'?");
  expect_refused(module("m", "sum", "inputs = [\"joints\", \"toch\"]"),
                 "system.toml:15, module 'm', port 'inputs'", "did you mean 'touch'?");
  expect_refused(module("m", "channel", "channel = \"joint\""), "system.toml:13, module 'm'",
                 "did you mean 'joints'?");
  expect_refused("[[phase]]\nlearn = \"joins\"\n", "system.toml:13", "did you mean 'joints'?");
}

TEST(System, RefusesPortsThatAreNotConnectedRightly) {
  expect_refused(module("m", "change", ""), "system.toml:13, module 'm', port 'input'",
                 "no module is connected");
  expect_refused(module("m", "change", "input = [\"joints\"]"),
                 "system.toml:15, module 'm', port 'input'", "the name of one module");
  expect_refused(module("m", "change", "input = 3"), "system.toml:15, module 'm', port 'input'",
                 "the name of one module");
  expect_refused(module("m", "sum", "inputs = []"), "system.toml:15, module 'm', port 'inputs'",
                 "the names of modules");
  expect_refused(module("m", "sum", "inputs = [1]"), "system.toml:15, module 'm', port 'inputs'",
                 "the names of modules");
  expect_refused(module("m", "sum", "[module.m.inputs]\nx = 1"),
                 "system.toml:15, module 'm', port 'inputs'", "the names of modules");
  expect_refused(module("m", "scale", "input = \"joints\"\n[module.m.factor]\nx = 1"),
                 "system.toml:16, module 'm'", "factor");
  expect_built(module("m", "sum", "inputs = \"joints\""));
}

TEST(System, RefusesParametersOutOfRange) {
  expect_refused(module("m", "som", "input = \"joints\"\nrows = 0"), "system.toml:16, module 'm'",
                 "'rows' must be");
  expect_refused(module("m", "scale", "input = \"joints\"\nfactor = \"much\""),
                 "system.toml:16, module 'm'", "'factor' must be");
  expect_refused(module("m", "som", "input = \"joints\"\nepochs = 3"), "system.toml:16, module 'm'",
                 "has no effect");
  expect_refused(module("m", "som",
                        "input = \"joints\"\nlattice = \"hexagonal\"\n"
                        "topology = \"torus\"\nrows = 3"),
                 "system.toml:13, module 'm'", "even");
  expect_refused(module("m", "som",
                        "input = \"joints\"\nradius_schedule = \"exponential\"\n"
                        "radius_end = 0"),
                 "system.toml:13, module 'm'", "radius");
  expect_refused(module("m", "channel", ""), "system.toml:13, module 'm'", "'channel' is missing");
  expect_refused(module("m", "channel", "channel = \"touch\"\nshape = [4]"),
                 "system.toml:13, module 'm'", "has the shape 2 x 2 in the recording, not 4");
  expect_refused(module("m", "channel", "channel = \"joints\"\nelements = [\"4\"]"),
                 "system.toml:13, module 'm'", "elements are numbered from 1 to 3");
  for (const char* name : {"0", "-1", "+1", "1.0", "", "99999999999999999999", " 1"}) {
    expect_refused(
        module("m", "channel", "channel = \"joints\"\nelements = [\"" + std::string(name) + "\"]"),
        "system.toml:13, module 'm'", "unknown element");
  }
  expect_refused(module("m", "onset_window", "input = \"joints\"\nelement = 4"),
                 "system.toml:13, module 'm'", "'element' is 4, but the input has 3 elements");
  for (const std::string key : {"low", "high"}) {
    expect_refused(module("m", "one_hot", "input = \"joints\"\n" + key + " = [0, 1]"),
                   "system.toml:13, module 'm'",
                   "'" + key + "' has 2 numbers, but the input has 3 elements");
  }
  expect_refused(module("m", "one_hot", "input = \"joints\"\nlow = 1\nhigh = 1"),
                 "system.toml:13, module 'm'", "'low' is 1 and 'high' is 1 for element 1");
  expect_refused(module("m", "one_hot", "input = \"joints\"\nlow = -1e300\nhigh = 1e300"),
                 "system.toml:13, module 'm'", "single precision");
  expect_refused(module("m", "number_code", "input = \"joints\"\nbits = 25"),
                 "system.toml:13, module 'm'", "1 to 24 bits");
  expect_refused(module("m", "t_mpsom", "inputs = [\"joints\", \"touch\"]\nshape = [3]"),
                 "system.toml:13, module 'm'", "2 inputs do not fit a grid of 1 axes");
}

TEST(System, RefusesRatesClocksAndShapesThatDoNotFit) {
  const std::string last = module("last", "last", "input = \"joints\"");  // lines 13 to 15
  for (const char* type :
       {"first", "last", "delay", "change", "resampling", "onset_window", "mean_removal",
        "spectrum", "accumulate", "leaky_accumulate", "tare", "high_pass"}) {
    expect_refused(last + module("m", type, "input = \"last\""),
                   "system.toml:18, module 'm', port 'input'", "it requires frames");
  }
  for (const char* type : {"sum", "tensor_product", "concatenation"}) {
    expect_refused(last + module("m", type, "inputs = [\"joints\", \"last\"]"),
                   "system.toml:18, module 'm', port 'inputs'", "another one per exploration");
    expect_refused(module("m", type, "inputs = [\"joints\", \"sound\"]"),
                   "system.toml:15, module 'm', port 'inputs'",
                   "the frames of 'height' and of 'sound' are not recorded together");
  }
  expect_refused(module("m", "t_mpsom", "inputs = [\"joints\", \"sound\"]\nshape = [2, 2]"),
                 "system.toml:15, module 'm', port 'inputs'", "are not recorded together");
  expect_refused(module("m", "sum", "inputs = [\"joints\", \"touch\"]"),
                 "system.toml:15, module 'm', port 'inputs'",
                 "2 x 2 elements cannot be added to 3");
  expect_refused(module("m", "spectrum", "input = \"joints\"\nspeed = \"touch\"\nhigh = 1"),
                 "system.toml:16, module 'm', port 'speed'", "a speed must be a single number");
  expect_refused(module("m", "spectrum", "input = \"joints\"\nspeed = \"height\""),
                 "system.toml:16, module 'm', port 'speed'", "'bands' and 'high'");
  expect_built(module("m", "spectrum", "input = \"sound\"\nspeed = \"height\"\nhigh = 1"));
  // Each finds its own onset: their frames were not taken together, however many there are.
  const std::string window = "input = \"joints\"\nthreshold = 0.1\nlength = 2";
  expect_refused(module("one", "onset_window", window) + module("two", "onset_window", window) +
                     module("m", "sum", "inputs = [\"one\", \"two\"]"),
                 "system.toml:25, module 'm', port 'inputs'", "are not recorded together");
}

// Half of the lowest rate ends the bands of all, which a trained system keeps.
TEST(System, SpectraOfSeveralRatesHaveCommonFrequencies) {
  Recording recording = hand_recording(2, 1);
  recording.explorations[1].channels.back().rate = 80.0;
  const auto rate_of = [&](const std::string& settings) -> std::string {
    const auto system =
        try_build(kChannels + module("frames", "window", "input = 'sound'\nlength = 8") +
                      module("m", "spectrum", "input = 'frames'\n" + settings),
                  recording);
    if (!system) return to_string(system.error());
    const Table::Entry* entry = system->description().modules.back().settings.find("rate");
    if (entry == nullptr) return "none";
    return to_toml(std::get<Value>(entry->content));
  };
  EXPECT_EQ(rate_of(""), "80.0");
  EXPECT_EQ(rate_of("bands = 0\nsegment_length = 8"), "80.0");
  EXPECT_EQ(rate_of("high = 30"), "none");
  EXPECT_EQ(rate_of("rate = 60"), "60");
  EXPECT_NE(rate_of("high = 30\nrate = 60").find("'rate' has no effect"), std::string::npos);
}

TEST(System, RefusesOutputsAndMapsThatAreTooLarge) {
  const std::string wide =
      module("wide", "one_hot", "input = \"touch\"\nlow = 0\nhigh = 1\nelements = 1048576");
  expect_built(wide);
  expect_refused(wide + module("m", "tensor_product", "inputs = [\"wide\", \"wide\"]"),
                 "system.toml:21, module 'm', port 'inputs'", "exceeds the maximum of 4294967295");
  expect_refused(wide + module("m", "number_code", "input = \"wide\"\nbits = 24"),
                 "system.toml:21, module 'm', port 'input'", "exceeds the maximum of 67108864");
  expect_refused(wide + module("m", "one_hot",
                               "input = \"wide\"\nlow = 0\nhigh = 1\n"
                               "elements = 1000"),
                 "system.toml:21, module 'm', port 'input'", "exceeds the maximum of");
  expect_refused(wide + module("m", "som",
                               "input = \"wide\"\nrows = 4096\ncolumns = 4096\n"
                               "initial_weights = \"uniform\""),
                 "system.toml:21, module 'm', port 'input'", "of memory, and this machine has");
  expect_refused(module("m", "som", "input = \"joints\"\nrows = 16777216\ncolumns = 16777216"),
                 "system.toml:13, module 'm'", "has more than 16777216 neurons");
  expect_refused(module("m", "t_mpsom",
                        "inputs = \"touch\"\nshape = [4096, 4096, 4096]\n"
                        "input_axes = [0]"),
                 "system.toml:13, module 'm'", "no input is spread along axis 1");
  expect_refused(wide + module("m", "t_mpsom", "inputs = \"wide\"\nshape = [4096]"),
                 "system.toml:19, module 'm'", "more than 4294967296 weights");
}

TEST(System, RefusesShapesWithoutARecordingThatNoMachineHolds) {
  const auto without = [](const std::string& settings) {
    return parse_toml("[module.c]\ntype = \"channel\"\n" + settings, "system.toml")
        .and_then([](const Table& table) { return read_system(table); })
        .and_then([](SystemDescription description) {
          return System::build(std::move(description), {});
        });
  };
  const auto system = without("channel = \"x\"\nshape = [2, 3]\nelements = [\"6\"]\n");
  ASSERT_TRUE(system) << to_string(system.error());
  EXPECT_EQ(system->modules()[0].output.size(), 1U);
  EXPECT_NE(to_string(without("channel = \"x\"\n").error()).find("its shape is unknown"),
            std::string::npos);
  EXPECT_NE(to_string(without("shape = [3]\n").error()).find("'channel' is missing"),
            std::string::npos);
  const auto large = without("channel = \"x\"\nshape = [16777216, 16777216, 16777216]\n");
  ASSERT_FALSE(large);
  EXPECT_NE(to_string(large.error()).find("exceeds the maximum of"), std::string::npos);
}

TEST(System, RefusesLoopsThatCannotRun) {
  expect_refused(module("a", "sum", "inputs = [\"joints\", \"c\"]") +
                     module("b", "scale", "input = \"a\"") + module("c", "scale", "input = \"b\""),
                 "system.toml:16, module 'b'", "a loop requires a delay: b -> c -> a -> b");
  expect_refused(module("a", "sum", "inputs = [\"joints\", \"a\"]"), "system.toml:13, module 'a'",
                 "a loop requires a delay: a -> a");
  const std::string sum = module("a", "sum", "inputs = [\"joints\", \"d\"]");  // lines 13 to 15
  expect_refused(sum + module("d", "delay", "input = \"a\""), "system.toml:16, module 'd'",
                 "a delay in a loop requires 'shape'");
  expect_refused(sum + module("d", "delay", "input = \"a\"\nshape = [4]"),
                 "system.toml:15, module 'a', port 'inputs'", "4 elements cannot be added to 3");
  expect_refused(module("a", "concatenation", "inputs = [\"joints\", \"d\"]") +
                     module("d", "delay", "input = \"a\"\nshape = [3]"),
                 "system.toml:18, module 'd', port 'input'",
                 "its 'shape' is 3, but the input has 6");
  expect_refused(module("d", "delay", "input = \"d\"\nshape = [3]"), "system.toml:13, module 'd'",
                 "its loop receives no frames from outside");
  expect_refused(
      module("e", "scale", "input = \"d\"") + module("d", "delay", "input = \"e\"\nshape = [3]"),
      "system.toml:16, module 'd'", "its loop receives no frames from outside");
  expect_refused(module("a", "sum", "inputs = [\"joints\", \"d\"]") +
                     module("r", "mean_removal", "input = \"a\"") +
                     module("d", "delay", "input = \"r\"\nshape = [3]"),
                 "system.toml:16, module 'r'", "it requires whole explorations");
  expect_refused(module("l", "last", "input = \"joints\"") +
                     module("a", "sum", "inputs = [\"l\", \"d\"]") +
                     module("d", "delay", "input = \"a\"\nshape = [3]"),
                 "system.toml:19, module 'd'", "its loop receives no frames from outside");
  expect_refused(module("a", "sum", "inputs = [\"height\", \"sound\", \"d\"]") +
                     module("d", "delay", "input = \"a\"\nshape = [1]"),
                 "system.toml:15, module 'a', port 'inputs'", "are not recorded together");
  expect_refused(
      module("a", "concatenation", "inputs = [\"joints\", \"d\"]") +
          module("d", "delay", "input = \"a\"\nshape = [1048576, 1048576, 1048576, 1048576]"),
      "system.toml:16, module 'd'", "exceeds the maximum of");
  expect_built(sum + module("d", "delay", "input = \"a\"\nshape = [3]"));
}

std::string two_maps(const std::string& between, const std::string& second) {
  return module("a", "som", "input = \"joints\"\nrows = 2\ncolumns = 2") + between +
         module("b", "som", "input = \"" + second + "\"\nrows = 2\ncolumns = 2");
}

TEST(System, RefusesPhasesThatCannotBe) {
  const std::string map = module("m", "som", "input = \"joints\"");  // lines 13 to 15
  expect_refused(map + "[[phase]]\ndraws = 3\n", "system.toml:16", "'learn' is missing or empty");
  expect_refused(map + "[[phase]]\nlearn = \"joints\"\n", "system.toml:16",
                 "'joints' has nothing to learn");
  expect_refused(map + "[[phase]]\nlearn = [\"m\", \"m\"]\n", "system.toml:16",
                 "'m' is listed twice");
  expect_refused(map + "[[phase]]\nlearn = \"m\"\n[[phase]]\nlearn = \"m\"\n", "system.toml:18",
                 "'m' is listed twice");
  expect_refused(map + "[[phase]]\nlearn = \"m\"\nof = \"explorations\"\n", "system.toml:16",
                 "'m' learns frames, not explorations");
  const std::string iterations = module("m", "som", "input = \"joints\"\niterations = 9");
  expect_built(iterations + "[[phase]]\nlearn = \"m\"\n");
  expect_refused(iterations + "[[phase]]\nlearn = \"m\"\ndraws = 9\n", "system.toml:16, module 'm'",
                 "'iterations' has no effect");
  expect_refused(module("m", "som", "input = \"joints\"\ndraws = \"without_replacement\""),
                 "system.toml:16, module 'm'", "'draws' has no effect");
  expect_refused(module("m", "som", "input = \"joints\"\ntraining = \"batch\""), "system.toml:13",
                 "'m' learns from all samples at once, which it cannot do here");
  expect_refused(module("l", "last", "input = \"joints\"") +
                     module("m", "som", "input = \"l\"\ntraining = \"batch\"") +
                     "[[phase]]\nlearn = \"m\"\ndraws = 9\n",
                 "system.toml:20", "without draws");
}

TEST(System, RefusesModulesThatCannotLearnTogether) {
  const std::string both = "[[phase]]\nlearn = [\"a\", \"b\"]\ndraws = 9\n";
  expect_built(two_maps("", "a") + both);
  expect_refused(two_maps("", "a") + "[[phase]]\nlearn = [\"a\", \"b\"]\n", "system.toml:23",
                 "does not specify how long");
  expect_refused(two_maps("", "sound") + both, "system.toml:23",
                 "their frames are not recorded together");
  expect_refused(two_maps(module("l", "last", "input = \"a\""), "l") + both, "system.toml:26",
                 "one learns from frames and the other from explorations");
  expect_refused(two_maps(module("r", "mean_removal", "input = \"a\""), "r") + both,
                 "system.toml:26", "'r' requires whole explorations");
  expect_refused(two_maps("", "a") + "[[phase]]\nlearn = \"b\"\n[[phase]]\nlearn = \"a\"\n",
                 "system.toml:23", "'b' learns before 'a', which it depends on");
  for (const char* type : {"standardization", "one_hot"}) {
    const std::string code = module("s", type, "input = \"joints\"") +
                             module("m", "som", "input = \"s\"\nrows = 2\ncolumns = 2");
    expect_refused(code + "[[phase]]\nlearn = [\"s\", \"m\"]\ndraws = 9\n", "system.toml:21",
                   "'s' learns from all samples at once");
    expect_refused(code + "[[phase]]\nlearn = \"s\"\ndraws = 9\n", "system.toml:21",
                   "without draws");
    expect_refused(code + "[[phase]]\nlearn = \"s\"\norder = \"with_replacement\"\n",
                   "system.toml:21", "without draws");
  }
  expect_refused(module("a", "sum", "inputs = [\"joints\", \"d\"]") +
                     module("s", "standardization", "input = \"a\"") +
                     module("d", "delay", "input = \"s\"\nshape = [3]"),
                 "system.toml:16", "learns from all samples at once, which it cannot do here");
}

// Neither can wait for the other.
TEST(System, RefusesToLetModulesOfALoopLearnOneAfterTheOther) {
  const std::string loop =
      module("a", "concatenation", "inputs = [\"joints\", \"d\"]") +
      module("m", "som", "input = \"a\"\nrows = 2\ncolumns = 2\ninitial_weights = \"uniform\"") +
      module("n", "t_mpsom", "inputs = \"m\"\nshape = [2]") +
      module("d", "delay", "input = \"n\"\nshape = [2]");
  expect_refused(loop, "system.toml:16", "'m' and 'n' depend on each other");
  expect_refused(loop + "[[phase]]\nlearn = \"m\"\n", "system.toml:22", "depend on each other");
  expect_refused(loop + "[[phase]]\nlearn = \"n\"\n[[phase]]\nlearn = \"m\"\n", "system.toml:30",
                 "'n' learns before 'm', which it depends on");
  expect_built(loop + "[[phase]]\nlearn = [\"n\", \"m\"]\ndraws = 9\n");
}

TEST(System, LearnersThatNoPhaseNamesLearnAsSoonAsTheyAreNeeded) {
  const auto system =
      try_build(kChannels + module("free", "som", "input = \"height\"") +
                    module("s", "standardization", "input = \"joints\"") +
                    module("m", "som", "input = \"s\"") + "[[phase]]\nlearn = \"m\"\ndraws = 9\n",
                hand_recording(3, 1));
  ASSERT_TRUE(system) << to_string(system.error());
  std::vector<std::string> names;
  for (const Phase& phase : system->phases()) {
    ASSERT_EQ(phase.learners.size(), 1U);
    names.push_back(system->modules()[phase.learners[0]].name);
    EXPECT_EQ(phase.draws.has_value(), names.back() == "m");
  }
  EXPECT_EQ(names, (std::vector<std::string>{"s", "m", "free"}));
}

TEST(System, DescribesShapesRatesAndFixedModules) {
  const auto system = try_build(
      kChannels + module("code", "one_hot", "input = \"touch\"\nlow = 0\nhigh = 1\nelements = 7") +
          module("one", "one_hot", "input = \"height\"\nlow = 0\nhigh = 1\nelements = 5") +
          module("product", "tensor_product", "inputs = [\"one\", \"joints\", \"code\"]") +
          module("stm", "accumulate", "input = \"product\"") +
          module("map", "som", "input = \"stm\"\nrows = 2\ncolumns = 3") +
          module("winner", "winner", "input = \"map\""),
      hand_recording(3, 1));
  ASSERT_TRUE(system) << to_string(system.error());
  const auto type = [&](const char* name) { return system->modules()[*system->find(name)].output; };
  EXPECT_EQ(type("joints"), (PortType{Rate::kFrame, {3}, false, "height"}));
  EXPECT_EQ(type("sound"), (PortType{Rate::kFrame, {1}, false, "sound"}));
  EXPECT_EQ(type("code"), (PortType{Rate::kFrame, {2, 2, 7}, true, "height"}));
  EXPECT_EQ(type("one"), (PortType{Rate::kFrame, {5}, true, "height"}));
  EXPECT_EQ(type("product"), (PortType{Rate::kFrame, {5, 3, 2, 2, 7}, true, "height"}));
  EXPECT_EQ(type("stm"), (PortType{Rate::kExploration, {5, 3, 2, 2, 7}, true, ""}));
  EXPECT_EQ(type("map"), (PortType{Rate::kExploration, {2, 3}, false, ""}));
  EXPECT_EQ(type("winner"), (PortType{Rate::kExploration, {2, 3}, true, ""}));
  EXPECT_TRUE(system->is_fixed(*system->find("stm")));
  EXPECT_FALSE(system->is_fixed(*system->find("map")));
  EXPECT_FALSE(system->is_fixed(*system->find("winner")));
  EXPECT_EQ(system->modules()[*system->find("map")].module->memory(), 6U * 420U * 4U);
}

// A model file has room for 1000 parts.
TEST(System, RefusesMoreThanAModelFileHolds) {
  std::string names = "\"height\"";
  for (int i = 0; i < 995; ++i) names += ", \"height\"";
  std::string axes = "0";
  for (int i = 0; i < 995; ++i) axes += ", 0";
  expect_refused(
      module("m", "t_mpsom", "inputs = [" + names + "]\nshape = [2]\ninput_axes = [" + axes + "]"),
      "system.toml:13", "too many inputs for a model file");
}

TEST(Wiring, PutsAModuleAfterWhatItListensTo) {
  // 0 -> 1 -> 2 -> 3(delay) -> 1 and 2 -> 4
  const Wiring wiring({{}, {0, 3}, {1}, {2}, {2}}, {false, false, false, true, false});
  EXPECT_TRUE(wiring.endless_loop().empty());
  ASSERT_EQ(wiring.groups().size(), 3U);
  EXPECT_EQ(wiring.groups()[0], std::vector<std::size_t>{0});
  EXPECT_EQ(wiring.groups()[1], (std::vector<std::size_t>{3, 1, 2}));
  EXPECT_EQ(wiring.groups()[2], std::vector<std::size_t>{4});
  EXPECT_TRUE(wiring.is_loop(wiring.groups()[1]));
  EXPECT_FALSE(wiring.is_loop(wiring.groups()[2]));
  EXPECT_TRUE(wiring.reaches(3, 4));
  EXPECT_FALSE(wiring.reaches(4, 3));
}

}  // namespace
}  // namespace somato
