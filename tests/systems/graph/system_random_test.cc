// Random systems, right and wrong: each runs from text to saved model, or is refused with a place.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/support/sanitized.h"
#include "base/support/temporary_folder.h"
#include "somato/graph/system_model.h"
#include "systems/support/random_system.h"
#include "systems/support/systems.h"
#include "systems/walk/walk.h"

namespace somato {
namespace {

using testing::dense;
using testing::first_explorations;
using testing::RandomSystem;
using testing::try_build;
using testing::try_train;

constexpr std::size_t kLearnedModules =
    4;  // The first four of six explorations; the others are held out.
constexpr int kGraphs = testing::fewer_if_sanitized(2400);
constexpr std::size_t kMostFrames = 20;  // of hand_recording()

void expect_place(const Error& error, const std::string& text) {
  EXPECT_FALSE(error.what.empty()) << text;
  EXPECT_NE(error.where.find("system.toml"), std::string::npos) << to_string(error) << "\n" << text;
}

// The outputs of all modules for the explorations held out, or an error of the data.
Result<Activations> held_out(const System& system, const Recording& recording) {
  std::vector<std::size_t> all = first_explorations(system.modules().size());
  Activations activations(system.modules().size(), recording.explorations.size());
  const std::vector<std::size_t> explorations{kLearnedModules, kLearnedModules + 1};
  auto evaluated = evaluate(system, recording, explorations, all, 1, activations);
  if (!evaluated) return fail(std::move(evaluated.error()));
  return activations;
}

void expect_as_promised(const System& system, const Activations& activations,
                        const std::string& text) {
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    const PortType& promised = system.modules()[module].output;
    for (const std::size_t exploration : {kLearnedModules, kLearnedModules + 1}) {
      const Samples& values = activations.find(module, exploration)->values;
      const std::string which = system.modules()[module].name + "\n" + text;
      ASSERT_EQ(values.size(), promised.size()) << which;
      ASSERT_EQ(values.is_sparse(), promised.sparse) << which;
      ASSERT_GE(values.count(), 1U) << which;
      if (promised.rate == Rate::kExploration) {
        ASSERT_EQ(values.count(), 1U) << which;
      }
      for (std::size_t i = 0; i < values.count(); ++i) {
        for (const float value : values[i].values) ASSERT_TRUE(std::isfinite(value)) << which;
      }
    }
  }
}

void expect_same_bits(const System& system, const Activations& a, const Activations& b,
                      const std::string& text) {
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    for (const std::size_t exploration : {kLearnedModules, kLearnedModules + 1}) {
      ASSERT_EQ(dense(*a.find(module, exploration)), dense(*b.find(module, exploration))) << text;
    }
  }
}

struct Counts {
  int ran = 0;
  int refused = 0;
  int stopped = 0;  ///< By what the data held.
  int joint = 0;    ///< Phases in which several modules learned, of those that ran.
  int loops = 0;
  int compared = 0;  ///< Frames after which a live walk gave what evaluating gives.
  std::set<std::string> types;
};

Exploration cut_at(Exploration exploration, std::size_t frames) {
  for (Channel& channel : exploration.channels) {
    const Matrix<float> whole = channel.frames;
    channel.frames = Matrix<float>(std::min(frames, whole.rows()), whole.columns());
    const auto kept = whole.values().first(channel.frames.values().size());
    std::copy(kept.begin(), kept.end(), channel.frames.values().begin());
  }
  return exploration;
}

// Follows an exploration frame by frame and compares every module after each frame with what
// evaluating the frames so far gives, and the frames of all modules with those of the whole.
void expect_live_as_batch(const System& system, const Exploration& exploration,
                          const Activations& whole, const std::string& text, Counts& counts) {
  const std::vector<std::size_t> all = first_explorations(system.modules().size());
  Walk live(system, all, Outputs::kLatest);
  Walk stepped(system, all, Outputs::kAll);
  ASSERT_TRUE(live.start(&exploration)) << text;
  ASSERT_TRUE(stepped.start(&exploration)) << text;
  std::vector<std::size_t> frames(exploration.channels.size());
  for (std::size_t count = 1; count <= kMostFrames; ++count) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
      frames[i] = std::min(count, exploration.channels[i].frames.rows());
    }
    ASSERT_TRUE(live.follow(frames)) << text;
    ASSERT_TRUE(stepped.follow(frames)) << text;
    Recording so_far;
    so_far.explorations.push_back(cut_at(exploration, count));
    Activations batch(system.modules().size(), 1);
    const std::vector<std::size_t> only{0};
    const auto evaluated = evaluate(system, so_far, only, all, 1, batch);
    const auto settled = live.settle();
    ASSERT_EQ(settled.has_value(), evaluated.has_value()) << text;
    if (!settled) {
      EXPECT_EQ(settled.error().what, evaluated.error().what);
      continue;
    }
    ++counts.compared;
    for (const std::size_t module : all) {
      const Samples& values = batch.find(module, 0)->values;
      ASSERT_EQ(Signal::copy_of(*live.output(module)), Signal::copy_of(values[values.count() - 1]))
          << system.modules()[module].name << ", frame " << count << "\n"
          << text;
    }
  }
  ASSERT_TRUE(stepped.settle()) << text;
  for (const std::size_t module : all) {
    ASSERT_EQ(dense(stepped.take(module)), dense(*whole.find(module, kLearnedModules))) << text;
  }
}

void try_one(const std::string& text, const Recording& recording, const std::string& path,
             Counts& counts) {
  auto system = try_build(text, recording);
  if (!system) {
    EXPECT_EQ(system.error().kind, ErrorKind::kUsage) << to_string(system.error()) << text;
    expect_place(system.error(), text);
    ++counts.refused;
    return;
  }
  const auto trained = try_train(*system, recording, kLearnedModules);
  if (!trained) {
    expect_place(trained.error(), text);
    ++counts.stopped;
    return;
  }
  const auto activations = held_out(*system, recording);
  if (!activations) {
    expect_place(activations.error(), text);
    ++counts.stopped;
    return;
  }
  expect_as_promised(*system, *activations, text);
  const auto saved = save_system(path, *system);
  ASSERT_TRUE(saved) << to_string(saved.error());
  const auto loaded = load_system(path);
  ASSERT_TRUE(loaded) << to_string(loaded.error()) << "\n" << text;
  expect_same_bits(*system, *activations, *held_out(loaded->system, recording), text);
  expect_live_as_batch(*system, recording.explorations[kLearnedModules], *activations, text,
                       counts);
  ++counts.ran;
  for (const SystemModule& module : system->modules()) counts.types.insert(module.type->name);
  for (const Phase& phase : system->phases()) counts.joint += phase.learners.size() > 1 ? 1 : 0;
  counts.loops += system->find("back") ? 1 : 0;
}

TEST(SystemRandom, EachRunsTheSameAsAWholeAndLiveOrIsRefusedWithAPlace) {
  const TemporaryFolder folder;
  const Recording recording = testing::hand_recording(6, 2);
  Counts counts;
  for (std::uint64_t seed = 0; seed < std::uint64_t{kGraphs}; ++seed) {
    const std::string text = "# " + std::to_string(seed) + "\n" + RandomSystem(seed).write();
    SCOPED_TRACE(text);
    ASSERT_NO_THROW(try_one(text, recording, folder.file("model"), counts));
  }
  RecordProperty("ran", counts.ran);
  RecordProperty("refused", counts.refused);
  RecordProperty("stopped", counts.stopped);
  RecordProperty("joint", counts.joint);
  RecordProperty("loops", counts.loops);
  EXPECT_GE(counts.ran, testing::fewer_if_sanitized(1000));
  EXPECT_GE(counts.compared, testing::fewer_if_sanitized(20000));
  EXPECT_GE(counts.refused, testing::fewer_if_sanitized(300));
  EXPECT_GE(counts.joint, testing::fewer_if_sanitized(20));
  EXPECT_GE(counts.loops, testing::fewer_if_sanitized(50));
  EXPECT_EQ(counts.types.size(), module_types().size());
  EXPECT_EQ(counts.ran + counts.refused + counts.stopped, kGraphs);
}

}  // namespace
}  // namespace somato
