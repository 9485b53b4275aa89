#include "somato/simulation/watched_explorer.h"

#include <functional>
#include <string>
#include <utility>

#include "simulation/probe_explorers.h"
#include "simulation/probe_scene.h"
#include "simulation/thing_explorer.h"
#include "somato/bodies/explore_by_grasping.h"
#include "somato/core/check.h"
#include "somato/simulation/hand_poses.h"
#include "somato/simulation/simulated_hand.h"
#include "somato/simulation/texture_probe.h"

namespace somato {
namespace {

using detail::Draws;
using detail::Probe;
using Poses = std::function<std::vector<ScenePose>()>;

// A body whose every step is seen; whoever moves it knows no difference.
class SeenBody : public Body {
 public:
  SeenBody(Body& body, ExplorationWatcher& watcher, Poses poses)
      : body_(body), watcher_(watcher), poses_(std::move(poses)) {}

  const BodyDescription& description() const override { return body_.description(); }
  const BodyState& state() const override { return body_.state(); }

 protected:
  Result<void> drive_to(std::span<const double> targets) override { return body_.command(targets); }
  Result<void> pass(double seconds) override {
    return body_.step(seconds).and_then([&] { return watcher_.moved(body_.state(), poses_()); });
  }

 private:
  Body& body_;
  ExplorationWatcher& watcher_;
  Poses poses_;
};

AfterFrames told_to(ExplorationWatcher& watcher) {
  return [&watcher](const BodyState& state) { return watcher.felt(state); };
}

// What all of them have in common.
class WatchedSimulation : public WatchedBody {
 public:
  WatchedSimulation(ExploringBody body, std::vector<ShownThing> things,
                    ExploringParameters parameters, std::uint64_t seed)
      : name_(choice_name(body)),
        things_(std::move(things)),
        parameters_(std::move(parameters)),
        seed_(seed) {}

  const std::string& name() const override { return name_; }
  const std::vector<ShownThing>& things() const override { return things_; }

 protected:
  const ExploringParameters& parameters() const { return parameters_; }
  std::uint64_t world() const { return seed_; }
  std::uint64_t seed_for(const WatchedExploration& what, Draws draws) const {
    return detail::seed_of(seed_, what.thing, what.trial, draws);
  }

 private:
  std::string name_;
  std::vector<ShownThing> things_;
  ExploringParameters parameters_;
  std::uint64_t seed_;
};

// Scenes are built when they are asked for: all of a table would take seconds.
class WatchedHand : public WatchedSimulation {
 public:
  WatchedHand(Hand hand, ExploringBody body, std::vector<ShownThing> things,
              ExploringParameters parameters, std::uint64_t seed)
      : WatchedSimulation(body, std::move(things), std::move(parameters), seed), hand_(hand) {}

  bool takes_placement() const override { return true; }

  Result<Exploration> explore(const WatchedExploration& what,
                              ExplorationWatcher& watcher) const override {
    const Object& object = *things().at(what.thing).object;
    auto scene = HandScene::build(hand_, object, parameters().simulation);
    if (!scene) return fail(std::move(scene.error()));
    auto hand = SimulatedHand::create(*scene, what.placement, seed_for(what, Draws::kHand));
    if (!hand) return fail(std::move(hand.error()));
    watcher.begins((*hand)->description(), scene_of(*scene));
    SeenBody seen(**hand, watcher, [&] { return poses_of(**hand); });
    auto explored =
        hand_ == Hand::kLucs2
            ? explore_by_grasping(seen, parameters().plan, parameters().grasp, {}, told_to(watcher))
            : explore_by_closing(seen, parameters().closing, told_to(watcher));
    if (explored) explored->labels = labels_of(scene->object(), what.trial);
    return explored;
  }

 private:
  Hand hand_;
};

class WatchedProbe : public WatchedSimulation {
 public:
  using WatchedSimulation::WatchedSimulation;
  bool takes_placement() const override { return false; }
};

class WatchedTextureProbe : public WatchedProbe {
 public:
  using WatchedProbe::WatchedProbe;

  Result<Exploration> explore(const WatchedExploration& what,
                              ExplorationWatcher& watcher) const override {
    const Material& material = things().at(what.thing).material;
    auto probe = make_texture_probe(material, parameters().texture_probe,
                                    {world(), seed_for(what, Draws::kTexture)});
    if (!probe) return fail(std::move(probe.error()));
    watcher.begins((*probe)->description(), detail::probe_scene(Probe::kTexture, material.name));
    SeenBody seen(**probe, watcher, [&] {
      return detail::probe_poses(Probe::kTexture, {.lever = (*probe)->state().positions.front()});
    });
    auto explored = explore_by_stroking(seen, parameters().stroke, told_to(watcher));
    if (explored) explored->labels = labels_of(material, what.trial);
    return explored;
  }
};

class WatchedHardnessProbe : public WatchedProbe {
 public:
  using WatchedProbe::WatchedProbe;

  // The servo's potentiometer tells where the stick is: its driver does not know what stops it.
  Result<Exploration> explore(const WatchedExploration& what,
                              ExplorationWatcher& watcher) const override {
    const Material& material = things().at(what.thing).material;
    const HardnessProbeParameters& built = parameters().hardness_probe;
    auto probe = make_hardness_probe(material, built, seed_for(what, Draws::kHardness));
    if (!probe) return fail(std::move(probe.error()));
    watcher.begins((*probe)->description(), detail::probe_scene(Probe::kHardness, material.name));
    SeenBody seen(**probe, watcher, [&] {
      const Matrix<float>& read = (*probe)->state().readings.front();
      const double counts = read.empty() ? 0.0 : double{read(0, 0)};
      return detail::probe_poses(Probe::kHardness,
                                 {.stick = stick_position(counts, built).value_or(0.0)});
    });
    auto explored = explore_by_pressing(seen, parameters().press, told_to(watcher));
    if (explored) explored->labels = labels_of(material, what.trial);
    return explored;
  }
};

std::vector<ShownThing> objects_of(const ObjectTable& table) {
  std::vector<ShownThing> things;
  things.reserve(table.objects.size());
  for (const Object& object : table.objects) {
    things.push_back({object.name, object, object.material});
  }
  return things;
}

std::vector<ShownThing> materials_of(const ObjectTable& table) {
  std::vector<ShownThing> things;
  for (const Material& material : detail::materials_to_explore(table)) {
    things.push_back({material.name, {}, material});
  }
  return things;
}

Result<std::unique_ptr<WatchedBody>> watch_probe(ExploringBody body, const ObjectTable& table,
                                                 const ExploringParameters& parameters,
                                                 std::uint64_t seed) {
  const bool strokes = body == ExploringBody::kTexture;
  const auto usable =
      detail::probe_explorer(strokes ? Probe::kTexture : Probe::kHardness, table, parameters, seed);
  if (!usable) return fail(usable.error());
  std::vector<ShownThing> things = materials_of(table);
  std::unique_ptr<WatchedBody> watched;
  if (strokes) {
    watched = std::make_unique<WatchedTextureProbe>(body, std::move(things), parameters, seed);
  } else {
    watched = std::make_unique<WatchedHardnessProbe>(body, std::move(things), parameters, seed);
  }
  return watched;
}

}  // namespace

Result<std::unique_ptr<WatchedBody>> watch_body(ExploringBody body, const ObjectTable& things,
                                                const ExploringParameters& parameters,
                                                std::uint64_t seed) {
  if (body == ExploringBody::kTexture || body == ExploringBody::kHardness) {
    return watch_probe(body, things, parameters, seed);
  }
  if (body != ExploringBody::kLucs2 && body != ExploringBody::kLucs3) {
    return fail(ErrorKind::kUsage, "only one body can be watched at a time", choice_name(body),
                "take lucs2, lucs3, texture or hardness");
  }
  if (things.objects.empty()) {
    return fail(ErrorKind::kUsage, "there are no objects for a hand", {},
                "add lines to the table [object]");
  }
  const Hand hand = body == ExploringBody::kLucs2 ? Hand::kLucs2 : Hand::kLucs3;
  return std::make_unique<WatchedHand>(hand, body, objects_of(things), parameters, seed);
}

}  // namespace somato
