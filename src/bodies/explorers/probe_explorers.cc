#include "bodies/explorers/probe_explorers.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "bodies/explorers/hand_explorers.h"
#include "bodies/probes/hardness_probe.h"
#include "bodies/probes/probe_scene.h"
#include "bodies/probes/texture_probe.h"
#include "bodies/sensors/potentiometer.h"
#include "bodies/sensors/probe_truth.h"

namespace somato::detail {
namespace {

// A trial of an object or material.
struct Trial {
  const ExplorerSetup& setup;
  const Material& material;
  std::size_t thing = 0;
  std::size_t number = 0;
  const ExploreOptions& options;

  std::uint64_t seed_of(Draws draws) const { return setup.seed_of(thing, number, draws); }
};

// The true values of both probes.
struct ProbeTruth {
  SoundTruth sound;
  StickTruth stick;
};

// The same options with an observer that keeps the true sound of recorded steps.
ExploreOptions keeping_true_sound(ExploreOptions options, SoundTruth& truth) {
  options.observer.on_step = [&truth, seen = std::move(options.observer.on_step)](
                                 const ExplorationStep& step) -> Result<void> {
    truth.end_step(step.readings == Readings::kRecorded);
    return seen ? seen(step) : Result<void>();
  };
  return options;
}

// The true values are kept in `truth` unless it is nullptr.
Result<Exploration> stroke(const Trial& trial, SoundTruth* truth) {
  const ExploringParameters& parameters = trial.setup.parameters;
  SOMATO_TRY(auto probe,
             make_texture_probe(trial.material, parameters.texture_probe,
                                {trial.setup.seed, trial.seed_of(Draws::kTexture)}, truth));
  const ExploreOptions options =
      truth != nullptr ? keeping_true_sound(trial.options, *truth) : trial.options;
  return prepare_body(
             *probe, options, [&] { return probe_scene(Probe::kTexture, trial.material.name); },
             [&] {
               return probe_poses(Probe::kTexture, {.lever = probe->state().positions.front()});
             })
      .and_then([&] { return explore_by_stroking(*probe, parameters.stroke); });
}

// The servo's potentiometer measures the position of the stick: its driver does not detect what
// stops it.
Result<Exploration> press(const Trial& trial, StickTruth* truth) {
  const ExploringParameters& parameters = trial.setup.parameters;
  SOMATO_TRY(auto probe, make_hardness_probe(trial.material, parameters.hardness_probe,
                                             trial.seed_of(Draws::kHardness), truth));
  const auto poses = [&] {
    const Matrix<float>& read = probe->state().readings.front();
    const double counts = read.empty() ? 0.0 : double{read(0, 0)};
    const auto stick = stick_position(counts, parameters.hardness_probe);
    return probe_poses(Probe::kHardness, {.stick = stick.value_or(0.0)});
  };
  return prepare_body(
             *probe, trial.options,
             [&] { return probe_scene(Probe::kHardness, trial.material.name); }, poses)
      .and_then([&] { return explore_by_pressing(*probe, parameters.press); });
}

// Adds the true values of the probes that explored, after all readings.
void add_true_values(Probe probe, const Trial& trial, const ProbeTruth& truth,
                     Exploration& exploration) {
  ExplorationDraws draws = trial.setup.draws_of(trial.thing, trial.number);
  if (probe != Probe::kHardness) {
    const Channel& sound = **find_channel(exploration, "sound");
    truth.sound.add_to(exploration, sound.frames.rows());
    draws.sound_before = truth.sound.before();
  }
  if (probe != Probe::kTexture) {
    truth.stick.add_to(exploration);
    draws.stick_before = truth.stick.ticks;
  }
  put_draws(draws, exploration);
}

// Adds the channels of the probes to the exploration.
Result<Exploration> try_material(Probe probe, const Trial& trial, Exploration exploration = {}) {
  const bool keeps = trial.setup.keeps_true_values();
  ProbeTruth truth;
  const auto append = [&](Exploration&& more) {
    std::move(more.channels.begin(), more.channels.end(), std::back_inserter(exploration.channels));
  };
  if (probe != Probe::kHardness) {
    SOMATO_TRY_VOID(stroke(trial, keeps ? &truth.sound : nullptr).map(append));
  }
  if (probe != Probe::kTexture) {
    SOMATO_TRY_VOID(press(trial, keeps ? &truth.stick : nullptr).map(append));
  }
  if (keeps) add_true_values(probe, trial, truth, exploration);
  return exploration;
}

// The table's own, or where it has none those of its objects, each once.
std::vector<ExploredThing> materials_of(const ObjectTable& table) {
  std::vector<Material> materials = table.materials;
  if (materials.empty()) {
    for (const Object& object : table.objects) materials.push_back(object.material);
  }
  std::vector<ExploredThing> things;
  for (const Material& material : materials) {
    const bool is_known =
        std::any_of(things.begin(), things.end(),
                    [&](const ExploredThing& other) { return other.name == material.name; });
    if (!is_known) things.push_back({material.name, {}, material});
  }
  return things;
}

class ProbeExplorer : public SimulatedExplorer {
 public:
  ProbeExplorer(Probe probe, std::vector<ExploredThing> things, ExplorerSetup setup)
      : SimulatedExplorer(std::move(things), setup.source),
        probe_(probe),
        setup_(std::move(setup)) {}

 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    const Material& material = things()[thing].material;
    auto exploration = try_material(probe_, {setup_, material, thing, trial, options});
    if (exploration) exploration->labels = labels_of(material, trial);
    return exploration;
  }

 private:
  Probe probe_;
  ExplorerSetup setup_;
};

Result<void> check_probes(const std::vector<ExploredThing>& things,
                          const ExploringParameters& parameters) {
  for (const ExploredThing& thing : things) {
    SOMATO_TRY_VOID(make_texture_probe(thing.material, parameters.texture_probe, {}));
    SOMATO_TRY_VOID(make_hardness_probe(thing.material, parameters.hardness_probe, 0));
  }
  return {};
}

class AllSensesExplorer : public SimulatedExplorer {
 public:
  AllSensesExplorer(std::unique_ptr<SimulatedExplorer> hand, ExplorerSetup setup)
      : SimulatedExplorer(hand->things(), setup.source),
        hand_(std::move(hand)),
        setup_(std::move(setup)) {}

 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    const Material& material = things()[thing].material;
    return hand_->explore(thing, trial, options).and_then([&](Exploration grasped) {
      return try_material(Probe::kBoth, {setup_, material, thing, trial, options},
                          std::move(grasped));
    });
  }

 private:
  std::unique_ptr<SimulatedExplorer> hand_;
  ExplorerSetup setup_;
};

}  // namespace

Result<std::unique_ptr<SimulatedExplorer>> probe_explorer(Probe probe, const ObjectTable& things,
                                                          ExplorerSetup setup) {
  std::vector<ExploredThing> materials = materials_of(things);
  if (materials.empty()) {
    return fail(ErrorKind::kUsage, "no materials for a probe", {},
                "add a table [material.NAME], or objects");
  }
  SOMATO_TRY_VOID(check_probes(materials, setup.parameters));
  return std::make_unique<ProbeExplorer>(probe, std::move(materials), std::move(setup));
}

Result<std::unique_ptr<SimulatedExplorer>> all_senses_explorer(const ObjectTable& things,
                                                               ExplorerSetup setup) {
  setup.parameters.simulation.taxels = true;
  SOMATO_TRY(auto hand, hand_explorer(Hand::kLucs3, things, setup));
  SOMATO_TRY_VOID(check_probes(materials_of({things.objects, {}}), setup.parameters));
  return std::make_unique<AllSensesExplorer>(std::move(hand), std::move(setup));
}

}  // namespace somato::detail
