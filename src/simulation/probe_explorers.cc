#include "simulation/probe_explorers.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "simulation/hand_explorers.h"
#include "somato/simulation/texture_probe.h"

namespace somato::detail {
namespace {

Result<Exploration> stroke(const Material& material, const ExploringParameters& parameters,
                           const ProbeSeeds& seeds, const ExploreOptions& options) {
  return make_texture_probe(material, parameters.texture_probe, seeds)
      .and_then([&](const std::unique_ptr<Body>& probe) {
        probe->keep_to(options.limits);
        return explore_by_stroking(*probe, parameters.stroke);
      });
}

Result<Exploration> press(const Material& material, const ExploringParameters& parameters,
                          std::uint64_t seed, const ExploreOptions& options) {
  return make_hardness_probe(material, parameters.hardness_probe, seed)
      .and_then([&](const std::unique_ptr<Body>& probe) {
        probe->keep_to(options.limits);
        return explore_by_pressing(*probe, parameters.press);
      });
}

void append_channels(Exploration& exploration, Exploration&& more) {
  exploration.channels.insert(exploration.channels.end(),
                              std::make_move_iterator(more.channels.begin()),
                              std::make_move_iterator(more.channels.end()));
}

class ProbeExplorer : public ThingExplorer {
 public:
  ProbeExplorer(Probe probe, std::vector<Material> materials, ExploringParameters parameters,
                std::uint64_t seed)
      : probe_(probe),
        materials_(std::move(materials)),
        parameters_(std::move(parameters)),
        seed_(seed) {}

  std::vector<std::string> things() const override {
    std::vector<std::string> names;
    names.reserve(materials_.size());
    for (const Material& material : materials_) names.push_back(material.name);
    return names;
  }

  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options) const override {
    const Material& material = materials_[thing];
    Result<Exploration> exploration;
    if (probe_ != Probe::kHardness) {
      exploration = stroke(material, parameters_,
                           {seed_, seed_of(seed_, thing, trial, Draws::kTexture)}, options);
      if (!exploration) return exploration;
    }
    if (probe_ != Probe::kTexture) {
      auto pressed =
          press(material, parameters_, seed_of(seed_, thing, trial, Draws::kHardness), options);
      if (!pressed) return pressed;
      append_channels(*exploration, std::move(*pressed));
    }
    exploration->labels = labels_of(material, trial);
    return exploration;
  }

 private:
  Probe probe_;
  std::vector<Material> materials_;
  ExploringParameters parameters_;
  std::uint64_t seed_;
};

Result<void> check_probes(const std::vector<Material>& materials,
                          const ExploringParameters& parameters) {
  for (const Material& material : materials) {
    if (auto probe = make_texture_probe(material, parameters.texture_probe, {}); !probe)
      return fail(std::move(probe.error()));
    if (auto probe = make_hardness_probe(material, parameters.hardness_probe, 0); !probe)
      return fail(std::move(probe.error()));
  }
  return {};
}

class AllSensesExplorer : public ThingExplorer {
 public:
  AllSensesExplorer(std::unique_ptr<ThingExplorer> hand, std::vector<Object> objects,
                    ExploringParameters parameters, std::uint64_t seed)
      : hand_(std::move(hand)),
        objects_(std::move(objects)),
        parameters_(std::move(parameters)),
        seed_(seed) {}

  std::vector<std::string> things() const override { return hand_->things(); }

  Result<Exploration> explore(std::size_t thing, std::size_t trial,
                              const ExploreOptions& options) const override {
    auto exploration = hand_->explore(thing, trial, options);
    if (!exploration) return exploration;
    const Material& material = objects_[thing].material;
    auto sound = stroke(material, parameters_,
                        {seed_, seed_of(seed_, thing, trial, Draws::kTexture)}, options);
    if (!sound) return sound;
    append_channels(*exploration, std::move(*sound));
    auto hardness =
        press(material, parameters_, seed_of(seed_, thing, trial, Draws::kHardness), options);
    if (!hardness) return hardness;
    append_channels(*exploration, std::move(*hardness));
    return exploration;
  }

 private:
  std::unique_ptr<ThingExplorer> hand_;
  std::vector<Object> objects_;
  ExploringParameters parameters_;
  std::uint64_t seed_;
};

}  // namespace

std::vector<Material> materials_to_explore(const ObjectTable& things) {
  if (!things.materials.empty()) return things.materials;
  std::vector<Material> materials;
  for (const Object& object : things.objects) {
    const bool known = std::any_of(materials.begin(), materials.end(), [&](const Material& other) {
      return other.name == object.material.name;
    });
    if (!known) materials.push_back(object.material);
  }
  return materials;
}

Result<std::unique_ptr<ThingExplorer>> probe_explorer(Probe probe, const ObjectTable& things,
                                                      const ExploringParameters& parameters,
                                                      std::uint64_t seed) {
  std::vector<Material> materials = materials_to_explore(things);
  if (materials.empty()) {
    return fail(ErrorKind::kUsage, "there are no materials for a probe", {},
                "add a table [material.NAME], or objects");
  }
  if (auto usable = check_probes(materials, parameters); !usable)
    return fail(std::move(usable.error()));
  return std::make_unique<ProbeExplorer>(probe, std::move(materials), parameters, seed);
}

Result<std::unique_ptr<ThingExplorer>> all_senses_explorer(const ObjectTable& things,
                                                           ExploringParameters parameters,
                                                           std::uint64_t seed) {
  parameters.simulation.taxels = true;
  auto hand = closing_explorer(things, parameters, seed);
  if (!hand) return fail(std::move(hand.error()));
  const std::vector<Material> materials = materials_to_explore({things.objects, {}});
  if (auto usable = check_probes(materials, parameters); !usable)
    return fail(std::move(usable.error()));
  return std::make_unique<AllSensesExplorer>(std::move(*hand), things.objects,
                                             std::move(parameters), seed);
}

}  // namespace somato::detail
