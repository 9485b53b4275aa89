#include "somato/graph/module.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <set>

#include "base/support/places.h"
#include "somato/codes/memory.h"
#include "somato/codes/number_codes.h"
#include "somato/codes/spectrum.h"
#include "systems/signals/change.h"
#include "systems/signals/logarithm.h"
#include "systems/signals/onset.h"
#include "systems/signals/resampling.h"
#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::dense;
using testing::frames_of;
using testing::hand_recording;
using testing::module;
using testing::output_of;
using testing::trained;
using testing::try_output;

using Floats = std::vector<float>;

std::string all_channels() {
  return testing::channels({"height", "wrist", "joints", "touch", "sound"});
}

// Compares the output of a module `m` of that text for every exploration of a recording.
void expect_gives(const std::string& text,
                  const std::function<Matrix<float>(const Recording&, std::size_t)>& oracle) {
  const Recording recording = hand_recording(5, 7);
  const System system = trained(build(all_channels() + text, recording), recording, 3);
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    EXPECT_EQ(dense(output_of(system, recording, "m", i)), oracle(recording, i)) << text;
  }
}

Matrix<float> single_row(std::span<const float> values) {
  return {1, values.size(), Floats(values.begin(), values.end())};
}

// The types with a section in the reference of modules.
std::set<std::string> documented_types() {
  std::ifstream page(source_path("docs/reference/modules.md"));
  const std::string begin = "## `";
  std::set<std::string> names;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with(begin))
      names.insert(line.substr(begin.size(), line.rfind('`') - begin.size()));
  }
  return names;
}

TEST(Module, EveryTypeIsThereOnceAndSaysWhatItDoes) {
  std::set<std::string> names;
  for (const ModuleType& type : module_types()) {
    EXPECT_TRUE(names.insert(type.name).second) << type.name;
    EXPECT_FALSE(type.text.empty() || type.output.empty()) << type.name;
    std::set<std::string> keys{"type"};
    for (const InputPort& port : type.ports) EXPECT_TRUE(keys.insert(port.name).second);
    for (const ParameterInfo& info : type.parameters) {
      EXPECT_TRUE(keys.insert(info.name).second) << type.name << " " << info.name;
    }
    EXPECT_EQ(find_module_type(type.name, "").value(), &type);
  }
  EXPECT_EQ(names, documented_types());
}

TEST(Module, ChannelTakesFramesOrSomeOfTheirElements) {
  expect_gives(module("m", "channel", "channel = \"touch\"\nshape = [2, 2]"),
               [](const Recording& r, std::size_t i) { return frames_of(r, "touch", i); });
  expect_gives(module("m", "channel", "channel = \"joints\"\nelements = [\"3\", \"1\"]"),
               [](const Recording& r, std::size_t i) {
                 const Matrix<float>& joints = frames_of(r, "joints", i);
                 Matrix<float> taken(joints.rows(), 2);
                 for (std::size_t f = 0; f < joints.rows(); ++f) {
                   taken(f, 0) = joints(f, 2);
                   taken(f, 1) = joints(f, 0);
                 }
                 return taken;
               });
}

TEST(Module, ChannelTakesElementsByNameBeforeNumber) {
  Recording recording = hand_recording(2, 7);
  for (Exploration& e : recording.explorations) e.channels[2].element_names = {"thumb", "1", "3"};
  const System system =
      build(module("m", "channel", "channel = \"joints\"\nelements = [\"1\", \"thumb\", \"2\"]"),
            recording);
  const Matrix<float> given = dense(output_of(system, recording, "m", 1));
  const Matrix<float>& joints = frames_of(recording, "joints", 1);
  EXPECT_EQ(given(0, 0), joints(0, 1));
  EXPECT_EQ(given(0, 1), joints(0, 0));
  EXPECT_EQ(given(0, 2), joints(0, 1));
  const auto wrong = testing::try_build(
      module("m", "channel", "channel = \"joints\"\nelements = [\"thumbs\"]"), recording);
  EXPECT_NE(to_string(wrong.error()).find("did you mean 'thumb'?"), std::string::npos);
}

TEST(Module, ChannelTreatsInvalidValuesAsSet) {
  Recording recording = hand_recording(1, 7);
  recording.explorations[0].channels[0].frames = Matrix<float>(4, 1, {0, 5, 0, 0});
  recording.explorations[0].channels[0].valid = Matrix<std::uint8_t>(4, 1, {0, 1, 0, 0});
  const auto given = [&](const std::string& invalid) {
    const System system = build(
        module("m", "channel", "channel = \"height\"\ninvalid = \"" + invalid + "\""), recording);
    return try_output(system, recording, "m", 0);
  };
  EXPECT_EQ(dense(*given("zero")), Matrix<float>(4, 1, {0, 5, 0, 0}));
  EXPECT_EQ(dense(*given("hold")), Matrix<float>(4, 1, {0, 5, 5, 5}));
  const auto refused = given("refuse");
  ASSERT_FALSE(refused);
  EXPECT_EQ(to_string(refused.error())
                .find("trial 1, system.toml:1, module 'm': channel 'height', "
                      "frame 1, element 1 is not valid"),
            0U)
      << to_string(refused.error());
}

TEST(Module, ChannelFillsInvalidValuesWithNumbers) {
  Recording recording = hand_recording(1, 7);
  Channel& channel = recording.explorations[0].channels[0];
  channel.frames = Matrix<float>(4, 1, {0, 5, 0, 0});
  channel.valid = Matrix<std::uint8_t>(4, 1, {0, 1, 0, 0});
  const auto given = [&](const std::string& settings) {
    const System system =
        build(module("m", "channel", "channel = \"height\"\n" + settings), recording);
    return dense(output_of(system, recording, "m", 0));
  };
  EXPECT_EQ(given("fill = 2.5"), Matrix<float>(4, 1, {2.5F, 5, 2.5F, 2.5F}));
  EXPECT_EQ(given("fill = [2.5]\ninvalid = \"hold\""), Matrix<float>(4, 1, {2.5F, 5, 5, 5}));
}

TEST(Module, ChannelFillsEachSelectedElementWithItsOwnNumber) {
  Recording recording = hand_recording(1, 7);
  Channel& joints = recording.explorations[0].channels[2];
  ASSERT_EQ(joints.name, "joints");
  joints.valid = Matrix<std::uint8_t>(joints.frames.rows(), joints.frames.columns(), 1);
  joints.valid(0, 1) = 0;
  joints.valid(0, 2) = 0;
  const System system = build(module("m", "channel",
                                     "channel = \"joints\"\nelements = [\"3\", \"1\", \"2\"]\n"
                                     "fill = [30, 10, 20]"),
                              recording);
  const Matrix<float> given = dense(output_of(system, recording, "m", 0));
  EXPECT_EQ(given(0, 0), 30.0F);
  EXPECT_EQ(given(0, 1), joints.frames(0, 0));
  EXPECT_EQ(given(0, 2), 20.0F);
}

TEST(Module, ChannelRefusesFillsThatDoNotFit) {
  const Recording recording = hand_recording(1, 7);
  const auto refused = [&](const std::string& settings) {
    const auto wrong =
        testing::try_build(module("m", "channel", "channel = \"joints\"\n" + settings), recording);
    return wrong ? std::string() : to_string(wrong.error());
  };
  EXPECT_NE(refused("fill = [1, 2]").find("'fill' has 2 numbers for 3 elements"),
            std::string::npos);
  EXPECT_NE(refused("fill = 1\ninvalid = \"zero\"").find("exclude each other"), std::string::npos);
}

TEST(Module, OneHotPutsAOneInTheBinOfEachElement) {
  const auto oracle = [](const Recording& r, std::size_t i) {
    const Matrix<float>& joints = frames_of(r, "joints", i);
    const double low[] = {0.0, -1.0, 0.25};
    const double high[] = {1.0, 1.0, 0.75};
    Matrix<float> code(joints.rows(), 12);
    for (std::size_t f = 0; f < joints.rows(); ++f) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double place = (double{joints(f, j)} - low[j]) / (high[j] - low[j]) * 4.0;
        code(f, 4 * j + static_cast<std::size_t>(std::clamp(place, 0.0, 3.5))) = 1.0F;
      }
    }
    return code;
  };
  expect_gives(module("m", "one_hot",
                      "input = \"joints\"\nlow = [0, -1.0, 0.25]\nhigh = [1, 1.0, 0.75]\n"
                      "elements = 4\noutside = \"clamp\""),
               oracle);
}

TEST(Module, OneHotLearnsItsRangesWhereTheyAreTrained) {
  Recording recording = hand_recording(4, 7);
  const auto code = [&](const std::string& ends) {
    const System system = trained(build(all_channels() + module("m", "one_hot",
                                                                "input = \"height\"\nelements = 2\n"
                                                                "outside = \"clamp\"\n" +
                                                                    ends),
                                        recording),
                                  recording, 3);
    std::vector<std::size_t> bins;
    for (const float value : {0.0F, 3.9F, 4.1F, 6.0F, 100.0F}) {
      recording.explorations[3].channels[0].frames = Matrix<float>(1, 1, value);
      const Matrix<float> given = dense(output_of(system, recording, "m", 3));
      EXPECT_EQ(given(0, 0) + given(0, 1), 1.0F);
      bins.push_back(given(0, 0) == 1.0F ? 0 : 1);
    }
    return bins;
  };
  for (std::size_t i = 0; i < 3; ++i) {
    recording.explorations[i].channels[0].frames =
        Matrix<float>(2, 1, {2.0F + static_cast<float>(i), 6.0F});
  }
  recording.explorations[3].channels[0].frames = Matrix<float>(1, 1, 1000.0F);
  using Bins = std::vector<std::size_t>;
  EXPECT_EQ(code(""), (Bins{0, 0, 1, 1, 1}));           // 2 to 6, halves at 4
  EXPECT_EQ(code("high = 8"), (Bins{0, 0, 0, 1, 1}));   // 2 to 8, halves at 5
  EXPECT_EQ(code("low = -18"), (Bins{1, 1, 1, 1, 1}));  // -18 to 6, halves at -6
  for (std::size_t i = 0; i < 3; ++i) {
    recording.explorations[i].channels[0].frames = Matrix<float>(1, 1, 6.0F);
  }
  EXPECT_EQ(code("low = 2"), (Bins{0, 0, 1, 1, 1}));  // 2 to 6 again
  System constant = build(all_channels() + module("m", "one_hot", "input = \"height\""), recording);
  const auto refused = testing::try_train(constant, recording, 3);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("module 'm': element 1 is 6 in all training data"),
            std::string::npos)
      << to_string(refused.error());
}

Matrix<float> beside(
    const Recording& r, std::size_t i,
    const std::function<Floats(std::span<const float>, std::span<const float>)>& combine) {
  const Matrix<float>& a = frames_of(r, "joints", i);
  const Matrix<float>& b = frames_of(r, "touch", i);
  Floats all;
  for (std::size_t f = 0; f < a.rows(); ++f) {
    for (const float value : combine(a.row(f), b.row(f))) all.push_back(value);
  }
  return {a.rows(), all.size() / a.rows(), all};
}

TEST(Module, SignalsAreCombined) {
  expect_gives(module("m", "tensor_product", "inputs = [\"joints\", \"touch\"]"),
               [](const Recording& r, std::size_t i) {
                 return beside(r, i, [](auto a, auto b) {
                   Floats product;
                   for (const float x : a) {
                     for (const float y : b) product.push_back(x * y);
                   }
                   return product;
                 });
               });
  expect_gives(module("m", "concatenation", "inputs = [\"joints\", \"touch\"]"),
               [](const Recording& r, std::size_t i) {
                 return beside(r, i, [](auto a, auto b) {
                   Floats both(a.begin(), a.end());
                   both.insert(both.end(), b.begin(), b.end());
                   return both;
                 });
               });
  expect_gives(module("m", "sum", "inputs = [\"joints\", \"joints\", \"joints\"]"),
               [](const Recording& r, std::size_t i) {
                 return beside(r, i, [](auto a, auto) {
                   Floats sum;
                   for (const float x : a) sum.push_back(x + x + x);
                   return sum;
                 });
               });
}

TEST(Module, SignalsAreScaledOneByOne) {
  expect_gives(module("m", "scale", "input = \"joints\"\nfactor = -3\noffset = 1.5"),
               [](const Recording& r, std::size_t i) {
                 Matrix<float> scaled = frames_of(r, "joints", i);
                 for (float& x : scaled.values()) x = static_cast<float>(-3.0 * double{x} + 1.5);
                 return scaled;
               });
  expect_gives(module("m", "scale",
                      "input = \"joints\"\nfactor = -3\noffset = 1.5\n"
                      "rectify = true"),
               [](const Recording& r, std::size_t i) {
                 Matrix<float> scaled = frames_of(r, "joints", i);
                 for (float& x : scaled.values()) {
                   x = std::max(0.0F, static_cast<float>(-3.0 * double{x} + 1.5));
                 }
                 return scaled;
               });
  expect_gives(module("m", "logarithm", "input = \"joints\"\nunit = 0.1"),
               [](const Recording& r, std::size_t i) {
                 Matrix<float> logarithms = frames_of(r, "joints", i);
                 for (float& x : logarithms.values()) {
                   x = static_cast<float>(signed_logarithm(x, 0.1));
                 }
                 return logarithms;
               });
  expect_gives(module("m", "normalization", "input = \"joints\"\nnorm = \"maximum\""),
               [](const Recording& r, std::size_t i) {
                 return beside(r, i, [](auto a, auto) {
                   const double most = *std::max_element(a.begin(), a.end());
                   Floats normal;
                   for (const float x : a) normal.push_back(static_cast<float>(double{x} / most));
                   return normal;
                 });
               });
}

TEST(Module, SparseSignalsStaySparseAsLongAsZerosStayZero) {
  const Recording recording = hand_recording(2, 7);
  const System system = build(
      all_channels() +
          module("hot", "one_hot", "input = \"joints\"\nlow = 0\nhigh = 1\nelements = 5") +
          module("product", "tensor_product", "inputs = [\"hot\", \"touch\"]") +
          module("scaled", "scale", "input = \"product\"\nfactor = 2") +
          module("shifted", "scale", "input = \"product\"\noffset = 2") +
          module("normal", "normalization", "input = \"scaled\"") +
          module("logarithms", "logarithm", "input = \"scaled\"") +
          module("both", "concatenation", "inputs = [\"hot\", \"scaled\"]") +
          module("mixed", "concatenation", "inputs = [\"hot\", \"touch\"]") +
          module("stm", "accumulate", "input = \"both\"") +
          module("steps", "leaky_accumulate", "input = \"both\"\nevery_frame = true") +
          module("late", "delay", "input = \"both\"") + module("end", "last", "input = \"both\"") +
          module("added", "sum", "inputs = [\"hot\", \"hot\"]"),
      recording);
  const std::map<std::string, bool> sparse{
      {"hot", true},  {"product", true}, {"scaled", true},    {"shifted", false}, {"normal", true},
      {"both", true}, {"mixed", false},  {"stm", true},       {"steps", true},    {"late", false},
      {"end", true},  {"added", false},  {"logarithms", true}};
  for (const auto& [name, is_sparse] : sparse) {
    EXPECT_EQ(system.modules()[*system.find(name)].output.sparse, is_sparse) << name;
    EXPECT_EQ(output_of(system, recording, name, 0).values.is_sparse(), is_sparse) << name;
  }
  EXPECT_EQ(dense(output_of(system, recording, "shifted", 0))(0, 0),
            dense(output_of(system, recording, "product", 0))(0, 0) + 2.0F);
}

TEST(Module, FramesBecomeOneValue) {
  const auto row = [](const Matrix<float>& frames, std::size_t f) {
    return single_row(frames.row(f));
  };
  expect_gives(module("m", "first", "input = \"joints\""), [&](const Recording& r, std::size_t i) {
    return row(frames_of(r, "joints", i), 0);
  });
  expect_gives(module("m", "last", "input = \"joints\""), [&](const Recording& r, std::size_t i) {
    return row(frames_of(r, "joints", i), frames_of(r, "joints", i).rows() - 1);
  });
  expect_gives(module("m", "change", "input = \"joints\""), [](const Recording& r, std::size_t i) {
    const Matrix<float>& frames = frames_of(r, "joints", i);
    Floats change;
    for (std::size_t j = 0; j < 3; ++j)
      change.push_back(frames(frames.rows() - 1, j) - frames(0, j));
    return single_row(change);
  });
  expect_gives(module("m", "accumulate", "input = \"joints\""),
               [](const Recording& r, std::size_t i) {
                 const Matrix<float>& frames = frames_of(r, "joints", i);
                 Floats sums;
                 for (std::size_t j = 0; j < 3; ++j) {
                   double sum = 0.0;
                   for (std::size_t f = 0; f < frames.rows(); ++f) sum += double{frames(f, j)};
                   sums.push_back(static_cast<float>(sum));
                 }
                 return single_row(sums);
               });
  expect_gives(module("m", "mean", "input = \"joints\""), [](const Recording& r, std::size_t i) {
    const Matrix<float>& frames = frames_of(r, "joints", i);
    Floats means;
    for (std::size_t j = 0; j < 3; ++j) {
      double sum = 0.0;
      for (std::size_t f = 0; f < frames.rows(); ++f) sum += double{frames(f, j)};
      means.push_back(
          static_cast<float>(double{static_cast<float>(sum)} / static_cast<double>(frames.rows())));
    }
    return single_row(means);
  });
  expect_gives(module("m", "resampling", "input = \"joints\"\npoints = 2"),
               [](const Recording& r, std::size_t i) {
                 const Matrix<float>& frames = frames_of(r, "joints", i);
                 Floats ends(frames.row(0).begin(), frames.row(0).end());
                 const auto last = frames.row(frames.rows() - 1);
                 ends.insert(ends.end(), last.begin(), last.end());
                 return single_row(ends);
               });
}

TEST(Module, FramesBecomeOtherFrames) {
  expect_gives(module("m", "delay", "input = \"joints\""), [](const Recording& r, std::size_t i) {
    const Matrix<float>& frames = frames_of(r, "joints", i);
    Matrix<float> late(frames.rows(), 3);
    for (std::size_t f = 1; f < frames.rows(); ++f) {
      for (std::size_t j = 0; j < 3; ++j) late(f, j) = frames(f - 1, j);
    }
    return late;
  });
  expect_gives(module("m", "mean_removal", "input = \"joints\""),
               [](const Recording& r, std::size_t i) {
                 Matrix<float> frames = frames_of(r, "joints", i);
                 for (std::size_t j = 0; j < 3; ++j) {
                   double sum = 0.0;
                   for (std::size_t f = 0; f < frames.rows(); ++f) sum += double{frames(f, j)};
                   const double mean = sum / static_cast<double>(frames.rows());
                   for (std::size_t f = 0; f < frames.rows(); ++f) {
                     frames(f, j) = static_cast<float>(double{frames(f, j)} - mean);
                   }
                 }
                 return frames;
               });
  expect_gives(
      module("m", "window", "input = \"joints\"\nstart = 2\nlength = 9\nbeyond = \"hold\""),
      [](const Recording& r, std::size_t i) {
        const Matrix<float>& joints = frames_of(r, "joints", i);
        Matrix<float> window(9, 3);
        for (std::size_t f = 0; f < 9; ++f) {
          for (std::size_t j = 0; j < 3; ++j) {
            window(f, j) = joints(std::min(f + 2, joints.rows() - 1), j);
          }
        }
        return window;
      });
  expect_gives(module("m", "onset_window",
                      "input = \"sound\"\nquantity = \"value\"\n"
                      "threshold = 0.8\nbefore = 1\nlength = 4\n"
                      "beyond = \"hold\""),
               [](const Recording& r, std::size_t i) {
                 const Matrix<float>& sound = frames_of(r, "sound", i);
                 std::ptrdiff_t onset = 0;
                 while (sound(static_cast<std::size_t>(onset), 0) < 0.8F) ++onset;
                 Matrix<float> window(4, 1);
                 const auto last = static_cast<std::ptrdiff_t>(sound.rows()) - 1;
                 for (std::ptrdiff_t k = 0; k < 4; ++k) {
                   const auto f = std::clamp<std::ptrdiff_t>(onset - 1 + k, 0, last);
                   window(static_cast<std::size_t>(k), 0) = sound(static_cast<std::size_t>(f), 0);
                 }
                 return window;
               });
  expect_gives(
      module("m", "leaky_accumulate", "input = \"joints\"\nleak = 0.25\nevery_frame = true"),
      [](const Recording& r, std::size_t i) {
        const Matrix<float>& frames = frames_of(r, "joints", i);
        Matrix<float> memory(frames.rows(), 3);
        for (std::size_t j = 0; j < 3; ++j) {
          double held = 0.0;
          for (std::size_t f = 0; f < frames.rows(); ++f) {
            held = 0.75 * held + double{frames(f, j)};
            memory(f, j) = static_cast<float>(held);
          }
        }
        return memory;
      });
}

// These have oracles of their own among the tests of codes.
TEST(Module, NumberCodesAndSpectraAreThoseOfTheCodes) {
  expect_gives(module("m", "number_code", "input = \"joints\"\nbits = 4\ncode = \"gray\""),
               [](const Recording& r, std::size_t i) {
                 const NumberCode code({NumberCodeKind::kGray, 0.0, 1.0, 4, OutsideRange::kRefuse});
                 const Matrix<float>& joints = frames_of(r, "joints", i);
                 Floats bits;
                 for (const float x : joints.values()) {
                   const Signal coded = code.encode(x).value();
                   bits.insert(bits.end(), coded.values().begin(), coded.values().end());
                 }
                 return Matrix<float>(joints.rows(), 12, bits);
               });
  SpectrumParameters parameters;
  parameters.segment_length = 8;
  parameters.bands = 5;
  expect_gives(module("m", "spectrum", "input = \"sound\"\nsegment_length = 8\nbands = 5"),
               [&](const Recording& r, std::size_t i) {
                 const Signal spectrum =
                     Spectrum(parameters).apply(frames_of(r, "sound", i), 100.0).value();
                 return single_row(spectrum.values());
               });
  parameters.high = 20.0;
  expect_gives(module("m", "spectrum",
                      "input = \"sound\"\nspeed = \"height\"\nsegment_length = 8\n"
                      "bands = 5\nhigh = 20"),
               [&](const Recording& r, std::size_t i) {
                 const Matrix<float>& speeds = frames_of(r, "height", i);
                 double sum = 0.0;
                 for (const float speed : speeds.values()) sum += double{speed};
                 const Signal spectrum = Spectrum(parameters)
                                             .apply(frames_of(r, "sound", i), 100.0,
                                                    sum / static_cast<double>(speeds.rows()))
                                             .value();
                 return single_row(spectrum.values());
               });
}

TEST(Module, StandardizationLearnsOnlyFromTheTrainingPart) {
  expect_gives(module("m", "standardization", "input = \"joints\""),
               [](const Recording& r, std::size_t i) {
                 Matrix<float> given = frames_of(r, "joints", i);
                 for (std::size_t j = 0; j < 3; ++j) {
                   Floats values;
                   for (std::size_t e = 0; e < 3; ++e) {
                     const Matrix<float>& frames = frames_of(r, "joints", e);
                     for (std::size_t f = 0; f < frames.rows(); ++f) values.push_back(frames(f, j));
                   }
                   double mean = 0.0;
                   for (const float x : values) mean += double{x};
                   mean /= static_cast<double>(values.size());
                   double squares = 0.0;
                   for (const float x : values) squares += (double{x} - mean) * (double{x} - mean);
                   const double deviation = std::sqrt(squares / static_cast<double>(values.size()));
                   for (std::size_t f = 0; f < given.rows(); ++f) {
                     given(f, j) = static_cast<float>((double{given(f, j)} - mean) / deviation);
                   }
                 }
                 return given;
               });
}

TEST(Module, WinnerIsTheFirstOfTheGreatest) {
  expect_gives(module("m", "winner", "input = \"touch\""), [](const Recording& r, std::size_t i) {
    const Matrix<float>& frames = frames_of(r, "touch", i);
    Matrix<float> winners(frames.rows(), 4);
    for (std::size_t f = 0; f < frames.rows(); ++f) {
      std::size_t best = 0;
      for (std::size_t k = 1; k < 4; ++k) best = frames(f, k) > frames(f, best) ? k : best;
      winners(f, best) = 1.0F;
    }
    return winners;
  });
}

// A sparse signal has the same winner as a dense one, whatever is stored.
TEST(Module, WinnerOfASparseSignalCountsItsZeros) {
  auto made = find_module_type("winner", "").value()->make(Table{});
  ASSERT_TRUE(made);
  ASSERT_TRUE((*made)->connect({{"input", {Rate::kFrame, {4}, true, "c"}}}));
  Random random(4);
  for (int trial = 0; trial < 500; ++trial) {
    std::vector<std::uint32_t> indices;
    Floats values;
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (random.below(4) == 0) continue;
      indices.push_back(k);
      values.push_back(static_cast<float>(random.below(5)) - 3.0F);
    }
    const Signal sparse = Signal::sparse({4}, indices, values);
    const Floats all = sparse.to_dense();
    const auto best = std::max_element(all.begin(), all.end()) - all.begin();
    const SignalView view = sparse.view();
    SignalBuffer winner;
    ASSERT_TRUE((*made)->start()->step({&view, 1}, winner));
    EXPECT_EQ(Signal::copy_of(winner.view()),
              Signal::sparse({4}, {static_cast<std::uint32_t>(best)}, {1.0F}));
  }
}

TEST(Module, AWinnerAmongThousandsOfMillionsIsFoundAtOnce) {
  const Recording recording = hand_recording(1, 7);
  std::string text = all_channels();
  text += module("hot", "one_hot", "input = \"height\"\nlow = 0\nhigh = 1\nelements = 60000");
  text += module("square", "tensor_product", "inputs = [\"hot\", \"hot\"]");
  text += module("m", "winner", "input = \"square\"");
  const System system = build(text, recording);
  const Sequence given = output_of(system, recording, "m", 0);
  const auto bin = static_cast<std::uint32_t>(frames_of(recording, "height", 0)(0, 0) * 60000.0F);
  EXPECT_NEAR(given.values[0].indices[0], bin * 60001.0, 60001.0);
}

// Every type that is stepped gives the same frame by frame as during a whole exploration.
TEST(Module, SteppedFrameByFrameIsAsAWhole) {
  const Recording recording = hand_recording(6, 9);
  const std::string text =
      all_channels() +
      module("hot", "one_hot", "input = \"touch\"\nelements = 3\noutside = \"clamp\"") +
      module("product", "tensor_product", "inputs = [\"hot\", \"joints\"]") +
      module("both", "concatenation", "inputs = [\"hot\", \"product\"]") +
      module("sum", "sum", "inputs = [\"both\", \"both\"]") +
      module("normal", "normalization", "input = \"sum\"") +
      module("scaled", "scale", "input = \"normal\"\nfactor = 3\noffset = -0.1") +
      module("standard", "standardization", "input = \"joints\"") +
      module("late", "delay", "input = \"standard\"") +
      module("logarithms", "logarithm", "input = \"late\"\nunit = 0.3") +
      module("zero", "tare", "input = \"hot\"\nframes = 2") +
      module("quick", "high_pass", "input = \"zero\"\ntime_constant = 0.1\nrate = 20") +
      module("stm", "accumulate", "input = \"late\"\nevery_frame = true") +
      module("leaky", "leaky_accumulate", "input = \"hot\"\nleak = 0.3\nevery_frame = true") +
      module("bits", "number_code", "input = \"joints\"\nbits = 5") +
      module("map", "som", "input = \"product\"\nrows = 3\ncolumns = 2\niterations = 30") +
      module("tensor_map", "t_mpsom",
             "inputs = [\"hot\", \"joints\"]\nshape = [4, 3]\n"
             "iterations = 30") +
      module("winner", "winner", "input = \"map\"");
  const System system = trained(build(text, recording), recording, 4);
  std::set<std::string> stepped;
  for (const SystemModule& m : system.modules()) {
    if (!m.module->is_stepped()) continue;
    std::vector<Sequence> inputs;
    for (const std::size_t input : m.inputs) {
      inputs.push_back(output_of(system, recording, system.modules()[input].name, 5));
    }
    if (inputs.empty()) continue;
    stepped.insert(m.type->name);
    const Matrix<float> whole = dense(output_of(system, recording, m.name, 5));
    const auto runner = m.module->start();
    SignalBuffer output;
    for (std::size_t frame = 0; frame < whole.rows(); ++frame) {
      std::vector<SignalView> views;
      for (const Sequence& input : inputs) views.push_back(input.values[frame]);
      ASSERT_TRUE(runner->step(views, output));
      EXPECT_EQ(output.view().sparse, m.output.sparse) << m.name;
      const auto row = whole.row(frame);
      EXPECT_EQ(Signal::copy_of(output.view()).to_dense(), Floats(row.begin(), row.end()))
          << m.name;
    }
  }
  EXPECT_EQ(stepped.size(), 17U);  // all but channel and those that need explorations as a whole
}

// y(t) = x(t) + 0.75 y(t - 1), by three modules in a loop and by the memory that is made for it.
TEST(Module, ALoopThroughADelayIsALeakyMemory) {
  const Recording recording = hand_recording(3, 11);
  const System system =
      build(all_channels() + module("y", "sum", "inputs = [\"touch\", \"decayed\"]") +
                module("decayed", "scale", "input = \"before\"\nfactor = 0.75") +
                module("before", "delay", "input = \"y\"\nshape = [2, 2]") +
                module("after", "scale", "input = \"before\"\nfactor = 2") +
                module("memory", "leaky_accumulate",
                       "input = \"touch\"\nleak = 0.25\n"
                       "every_frame = true"),
            recording);
  for (std::size_t i = 0; i < 3; ++i) {
    const Matrix<float>& x = frames_of(recording, "touch", i);
    const Matrix<float> y = dense(output_of(system, recording, "y", i));
    const Matrix<float> before = dense(output_of(system, recording, "before", i));
    const Matrix<float> after = dense(output_of(system, recording, "after", i));
    const Matrix<float> memory = dense(output_of(system, recording, "memory", i));
    for (std::size_t k = 0; k < 4; ++k) {
      float held = 0.0F;
      for (std::size_t f = 0; f < x.rows(); ++f) {
        EXPECT_EQ(before(f, k), held);
        EXPECT_EQ(after(f, k), 2.0F * held);
        held = x(f, k) + static_cast<float>(0.75 * double{held});
        EXPECT_EQ(y(f, k), held);
        EXPECT_NEAR(y(f, k), memory(f, k), 1e-6);
      }
    }
  }
}

TEST(Module, ASparseSignalComesOutOfALoopsDelayDense) {
  const Recording recording = hand_recording(2, 11);
  const System system =
      build(all_channels() +
                module("hot", "one_hot",
                       "input = \"mean\"\nlow = 0\nhigh = 2\nelements = 4\n"
                       "outside = \"clamp\"") +
                module("mean", "sum", "inputs = [\"height\", \"was\"]") +
                module("before", "delay", "input = \"hot\"\nshape = [4]") +
                module("product", "tensor_product", "inputs = [\"height\", \"before\"]") +
                module("win", "number_code", "input = \"product\"\nbits = 1") +
                module("flat", "tensor_product", "inputs = [\"height\"]") +
                module("was", "delay", "input = \"flat\""),
            recording);
  const Matrix<float> hot = dense(output_of(system, recording, "hot", 0));
  const Sequence before = output_of(system, recording, "before", 0);
  EXPECT_FALSE(before.values.is_sparse());
  for (std::size_t f = 1; f < hot.rows(); ++f) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(dense(before)(f, k), hot(f - 1, k));
  }
}

// A value that leaves the range of single precision is an error with module and frame, never an
// infinity.
TEST(Module, NothingThatIsNotFiniteComesOut) {
  Recording recording = hand_recording(2, 11);
  recording.explorations[1].channels[2].frames = Matrix<float>(2, 3, {1, 1, 1, 3e38F, 1, 1});
  for (std::size_t c : {0U, 1U, 3U}) {
    recording.explorations[1].channels[c].frames =
        Matrix<float>(2, recording.explorations[1].channels[c].frames.columns());
  }
  for (const std::string& text :
       {module("m", "sum", "inputs = [\"joints\", \"joints\"]"),
        module("m", "tensor_product", "inputs = [\"joints\", \"joints\"]"),
        module("m", "scale", "input = \"joints\"\nfactor = 2"),
        module("m", "sum", "inputs = [\"joints\", \"s\", \"d\"]") +
            module("s", "scale", "input = \"joints\"\nfactor = 1") +
            module("d", "delay", "input = \"m\"\nshape = [3]")}) {
    const System system = build(all_channels() + text, recording);
    EXPECT_TRUE(try_output(system, recording, "m", 0)) << text;
    const auto given = try_output(system, recording, "m", 1);
    ASSERT_FALSE(given) << text;
    EXPECT_EQ(given.error().kind, ErrorKind::kData);
    EXPECT_EQ(given.error().where, "trial 2, system.toml:16, module 'm'");
    EXPECT_NE(given.error().what.find("(frame 2)"), std::string::npos) << given.error().what;
  }
}

TEST(Module, ATMpsomWithoutNormsSaysWhenNumbersLeaveTheirRange) {
  Recording recording = hand_recording(2, 11);
  for (Exploration& e : recording.explorations) {
    for (float& value : e.channels[2].frames.values()) value = 3e38F;
  }
  const std::string text =
      all_channels() + module("m", "t_mpsom",
                              "inputs = [\"joints\", \"joints\"]\nshape = [2, 2]\n"
                              "input_norm = \"none\"\nweight_norm = \"none\"\n"
                              "iterations = 100\nlearning_rate_start = 1");
  System system = build(text, recording);
  const auto learned = testing::try_train(system, recording, 2);
  ASSERT_FALSE(learned);
  EXPECT_EQ(learned.error().kind, ErrorKind::kData) << to_string(learned.error());
  EXPECT_NE(learned.error().where.find("module 'm'"), std::string::npos);
}

}  // namespace
}  // namespace somato
