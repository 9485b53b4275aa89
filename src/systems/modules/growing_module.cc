#include "systems/modules/growing_module.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "maps/online/growing_cells.h"
#include "maps/online/growing_grid.h"
#include "maps/online/growing_when_required.h"
#include "maps/som/map_parts.h"
#include "maps/som/som_archive.h"
#include "maps/training/glvq.h"
#include "somato/core/check.h"

namespace somato::modules {
namespace {

class GrownRunner : public Runner {
 public:
  GrownRunner(const Som& som, std::size_t size) : som_(som), size_(size) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    std::vector<float>& activity = out.begin_dense(size_);
    std::fill(activity.begin(), activity.end(), 0.0F);
    som_.activity(inputs.front(), workspace_, std::span(activity).first(som_.neurons()));
    return {};
  }

 private:
  const Som& som_;
  std::size_t size_;
  SomWorkspace workspace_;
};

std::vector<float> dense_values(const SignalView& input) {
  std::vector<float> values(input.size);
  write_dense(input, values);
  return values;
}

constexpr std::uint64_t kDrawsOfASample = 10;

std::uint64_t iterations_of(const GrowingWhenRequiredParameters& /*parameters*/,
                            std::size_t samples) {
  return kDrawsOfASample * samples;
}

std::uint64_t iterations_of(const GrowingCellsParameters& parameters, std::size_t /*samples*/) {
  return parameters.insertion_interval * parameters.growth.most_neurons;
}

// More than it takes: every insertion adds two neurons at least.
std::uint64_t iterations_of(const GrowingGridParameters& parameters, std::size_t /*samples*/) {
  const std::uint64_t most = parameters.growth.most_neurons;
  return parameters.growth_inputs * most * most + parameters.tuning_inputs * most;
}

template <typename Map>
bool can_be(const Grid& grid) {
  if constexpr (!std::is_same_v<Map, GrowingGrid>) return grid.graph() != nullptr;
  return grid.graph() == nullptr && grid.rows() >= 2 && grid.columns() >= 2;
}

template <typename Parameters, typename Map>
class KindOf : public GrowingKind {
 public:
  explicit KindOf(const Parameters& parameters) : parameters_(parameters) {}

  const GrowthParameters& growth() const override { return parameters_.growth; }

  std::unique_ptr<GrowingMap> start(const GrowthParameters& growth,
                                    const NamedSamples& samples) const override {
    Parameters started = parameters_;
    started.growth = growth;
    if constexpr (std::is_constructible_v<Map, Parameters, NamedSamples>) {
      return std::make_unique<Map>(started, samples);
    } else {
      return std::make_unique<Map>(started, samples.samples);
    }
  }

  bool learns_names() const override {
    if constexpr (std::is_same_v<Map, GrowingWhenRequired>) return parameters_.by_names;
    return false;
  }

  RefinementParameters refinement() const override {
    if constexpr (std::is_same_v<Map, GrowingWhenRequired>) {
      RefinementParameters refinement = parameters_.refinement;
      refinement.refine_neighbours = 0.0;  // edges connect what is near each other, in any class
      return refinement;
    }
    return {};
  }

  Result<void> check_settings() const override {
    if constexpr (std::is_same_v<Map, GrowingWhenRequired>) return check(parameters_);
    return {};
  }

  std::unique_ptr<GrowingMap> start(const Som& som) const override {
    if (!can_be<Map>(som.grid())) return nullptr;
    Parameters learned = parameters_;
    learned.growth.seed = som.parameters().seed;
    learned.growth.iterations = som.parameters().iterations;
    return std::make_unique<Map>(learned, som);
  }

  std::uint64_t automatic_iterations(std::size_t samples) const override {
    return iterations_of(parameters_, samples);
  }

 private:
  Parameters parameters_;
};

// Refuses keys without effect.
template <typename Parameters>
Result<void> check_effects(const Parameters& parameters, const Table& table) {
  if constexpr (std::is_same_v<Parameters, GrowingWhenRequiredParameters>) {
    for (const Table::Entry& key : table.entries) {
      const std::string reason = reason_without_effect(parameters, key.name);
      if (!reason.empty()) return fail(without_effect(key.name, reason, key.where));
    }
  }
  return {};
}

template <typename Parameters, typename Map>
ModuleType growing_type(std::string name, std::string text) {
  ModuleType type{std::move(name),
                  std::move(text),
                  {input_port("The input of the map, flattened.")},
                  "The activity of the neurons, 1 x most_neurons.",
                  true,
                  Parameters::declarations().infos(),
                  [](const Table& table) -> Result<std::unique_ptr<Module>> {
                    SOMATO_TRY(auto parameters, read_parameters<Parameters>(table));
                    SOMATO_TRY_VOID(check_effects(parameters, table));
                    return std::make_unique<GrowingModule>(
                        std::make_unique<KindOf<Parameters, Map>>(parameters));
                  }};
  // A study sets the seed of each run.
  std::erase_if(type.parameters, [](const ParameterInfo& info) { return info.name == "seed"; });
  return type;
}

}  // namespace

Grid GrowingModule::grid() const {
  if (som_.neurons() > 0) return som_.grid();
  return {1, kind_->growth().most_neurons, Lattice::kRectangular, Topology::kPlane};
}

Result<PortType> GrowingModule::connect(const std::vector<Connection>& inputs) {
  SOMATO_TRY_VOID(kind_->check_settings());
  const PortType& input = inputs.front().type;
  input_size_ = input.size();
  const std::size_t most = kind_->growth().most_neurons;
  SOMATO_TRY_VOID(check_memory(most, input_size_, inputs.front().port));
  return checked_size({input.rate, {1, most}, false, input.clock}, inputs.front().port);
}

std::unique_ptr<Runner> GrowingModule::start() const {
  require(som_.neurons() > 0, "a map must be trained before it is used");
  return std::make_unique<GrownRunner>(som_, kind_->growth().most_neurons);
}

std::size_t GrowingModule::memory() const {
  const std::size_t neurons = som_.neurons() > 0 ? som_.neurons() : kind_->growth().most_neurons;
  return neurons * input_size_ * sizeof(float);
}

GrowthParameters GrowingModule::growth_for(const LearningPlan& plan, std::size_t samples) const {
  GrowthParameters growth = kind_->growth();
  growth.seed = plan.seed;
  if (plan.order) growth.draws = *plan.order;
  if (plan.draws) growth.iterations = plan.draws;
  growth.iterations = growth.iterations.value_or(kind_->automatic_iterations(samples));
  return growth;
}

Result<void> GrowingModule::grow_from(std::unique_ptr<GrowingMap> map, const LearningPlan& plan,
                                      const GrowthParameters& growth, const NamedSamples& samples) {
  SOMATO_TRY_VOID(grow(*map, growth, samples, plan.progress, plan.observer));
  som_ = map->map();
  map_ = std::move(map);
  return {};
}

Result<void> GrowingModule::learn(const LearningPlan& plan, const TrainingInputs& explorations) {
  const Samples samples = all_values(explorations);
  SOMATO_TRY_VOID(check_growing(samples));
  SOMATO_TRY(const auto learned, named(plan, samples));
  const GrowthParameters growth = growth_for(plan, samples.count());
  SOMATO_TRY_VOID(grow_from(kind_->start(growth, learned), plan, growth, learned));
  order_.reset();
  if (kind_->refinement().refine == Refinement::kNone) return {};
  return refine(plan, learned);
}

// Neurons then have the classes of what they win.
Result<void> GrowingModule::refine(const LearningPlan& plan, const NamedSamples& named) {
  SOMATO_TRY(auto refined,
             refine_som(som_, named.samples, {named.classes.begin(), named.classes.end()},
                        kind_->refinement(), {plan.seed, 1, plan.progress}));
  const NeuronClasses found = classes_of_neurons(refined.som, named.samples, named.classes);
  map_->refine(refined.som, found.of_neuron);
  som_ = map_->map();
  order_ = refined.order;
  return {};
}

Result<NamedSamples> GrowingModule::named(const LearningPlan& plan, const Samples& samples) const {
  if (!kind_->learns_names()) return NamedSamples{samples, {}};
  if (plan.classes.size() == samples.count()) return NamedSamples{samples, plan.classes};
  return fail(ErrorKind::kUsage, "the map learns the names of explorations, which are not given",
              {}, "set by_names = false, or train it in a study with a label");
}

Result<NeuronOrigins> GrowingModule::learn_further(const LearningPlan& plan,
                                                   const Samples& inputs) {
  require(map_ != nullptr, "a map must be trained before it learns further");
  SOMATO_TRY_VOID(check_growing(inputs));
  require(inputs.size() == input_size_, "inputs have the wrong size for this map");
  SOMATO_TRY(const auto learned, named(plan, inputs));
  std::unique_ptr<GrowingMap> map = map_->copy();
  map->resume();
  map->see(learned);
  SOMATO_TRY_VOID(grow_from(std::move(map), plan, growth_for(plan, inputs.count()), learned));
  return map_->origins();
}

bool GrowingModule::add_neuron(const SignalView& input, std::size_t the_class) {
  require(map_ != nullptr, "a map must be trained before it learns further");
  const bool added = map_->add_at(dense_values(input), the_class);
  if (added) som_ = map_->map();
  return added;
}

void GrowingModule::place_neuron(std::size_t neuron, const SignalView& input,
                                 std::size_t the_class) {
  require(map_ != nullptr, "a map must be trained before it learns further");
  map_->place(neuron, dense_values(input), the_class);
  som_ = map_->map();
}

void GrowingModule::save(Archive& archive, const std::string& prefix) const {
  require(map_ != nullptr, "a map must be trained before it is saved");
  add_som(archive, prefix, som_);
  map_->save(archive, prefix);
}

Result<void> GrowingModule::load(const Archive& archive, const std::string& prefix,
                                 const std::string& where) {
  SOMATO_TRY(auto som, som_from(archive, prefix, where));
  auto map = kind_->start(som);
  if (som.input_size() != input_size_ || som.neurons() > kind_->growth().most_neurons || !map) {
    return damaged_model("the map does not fit its module", where);
  }
  SOMATO_TRY_VOID(map->load(archive, prefix, where));
  if (map->map().grid() != som.grid()) {
    return damaged_model("the connections of the neurons do not fit the map", where);
  }
  som_ = std::move(som);
  map_ = std::move(map);
  return {};
}

std::vector<ModuleType> growing_types() {
  return {
      growing_type<GrowingWhenRequiredParameters, GrowingWhenRequired>(
          "growing_when_required",
          "A map that adds a neuron where none is near an input (Marsland, Shapiro and Nehmzow, "
          "2002)."),
      growing_type<GrowingCellsParameters, GrowingCells>(
          "growing_cells",
          "A map of triangles that adds neurons where inputs are frequent, and can delete those "
          "where they are rare (growing cell structures; Fritzke, 1994)."),
      growing_type<GrowingGridParameters, GrowingGrid>(
          "growing_grid",
          "A rectangular map that adds rows and columns where inputs are frequent (Fritzke, "
          "1995).")};
}

}  // namespace somato::modules
