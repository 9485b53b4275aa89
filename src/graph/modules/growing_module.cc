#include "graph/modules/growing_module.h"

#include <algorithm>
#include <vector>

#include "maps/growing_cells.h"
#include "maps/growing_grid.h"
#include "maps/growing_when_required.h"
#include "maps/map_parts.h"
#include "maps/som_archive.h"
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

template <typename Parameters, typename Map>
class KindOf : public GrowingKind {
 public:
  explicit KindOf(const Parameters& parameters) : parameters_(parameters) {}

  const GrowthParameters& growth() const override { return parameters_.growth; }

  std::unique_ptr<GrowingMap> start(const GrowthParameters& growth,
                                    const Samples& samples) const override {
    Parameters started = parameters_;
    started.growth = growth;
    return std::make_unique<Map>(started, samples);
  }

  std::uint64_t automatic_iterations(std::size_t samples) const override {
    return iterations_of(parameters_, samples);
  }

 private:
  Parameters parameters_;
};

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

Result<void> GrowingModule::learn(const LearningPlan& plan, const TrainingInputs& explorations) {
  const Samples samples = all_values(explorations);
  SOMATO_TRY_VOID(check_growing(samples));
  GrowthParameters growth = kind_->growth();
  growth.seed = plan.seed;
  if (plan.order) growth.draws = *plan.order;
  if (plan.draws) growth.iterations = plan.draws;
  growth.iterations = growth.iterations.value_or(kind_->automatic_iterations(samples.count()));
  const std::unique_ptr<GrowingMap> map = kind_->start(growth, samples);
  SOMATO_TRY_VOID(grow(*map, growth, samples, plan.progress, plan.observer));
  som_ = map->map();
  return {};
}

void GrowingModule::save(Archive& archive, const std::string& prefix) const {
  require(som_.neurons() > 0, "a map must be trained before it is saved");
  add_som(archive, prefix, som_);
}

Result<void> GrowingModule::load(const Archive& archive, const std::string& prefix,
                                 const std::string& where) {
  SOMATO_TRY(auto som, som_from(archive, prefix, where));
  if (som.input_size() != input_size_ || som.neurons() > kind_->growth().most_neurons) {
    return damaged_model("the map does not fit its module", where);
  }
  som_ = std::move(som);
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
