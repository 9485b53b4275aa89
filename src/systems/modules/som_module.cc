#include "systems/modules/som_module.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "maps/som/initial_weights.h"
#include "maps/som/map_parts.h"
#include "maps/som/som_archive.h"
#include "maps/som/som_preparation.h"
#include "maps/training/som_start.h"
#include "somato/core/check.h"
#include "systems/modules/support.h"

namespace somato::modules {
namespace {

class SomRunner : public Runner {
 public:
  explicit SomRunner(const Som& som) : som_(som) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    som_.activity(inputs.front(), workspace_, out.begin_dense(som_.neurons()));
    return {};
  }

 private:
  const Som& som_;
  SomWorkspace workspace_;
};

// Settings for a map that learns in the meantime; `fixed` are its samples, if they are constant.
class LearningRunner : public Runner {
 public:
  LearningRunner(const Som& som, SomLearner& learner, const Samples* fixed, std::size_t sample)
      : som_(som), learner_(learner), fixed_(fixed), sample_(sample) {}

  Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) override {
    std::vector<float>& activity = out.begin_dense(som_.neurons());
    if (fixed_) {
      learner_.activity(*fixed_, sample_, activity);
    } else {
      learner_.settle();
      som_.activity(inputs.front(), workspace_, activity);
    }
    return {};
  }

 private:
  const Som& som_;
  SomLearner& learner_;
  const Samples* fixed_;
  std::size_t sample_;
  SomWorkspace workspace_;
};

// Maps that learn together, step by step, share a number of steps, and none is checked on the way.
Result<void> check_stepwise(const SomParameters& parameters) {
  if (parameters.is_length_automatic()) {
    return fail(
        ErrorKind::kUsage,
        "the length of training cannot depend on the map's error, because the map learns in "
        "step with other modules, or from frames",
        {}, "remove 'tolerance', and set 'iterations'");
  }
  if (!may_diverge(parameters)) return {};
  return fail(ErrorKind::kUsage,
              "a map that learns in step with other modules, or from frames, cannot use the "
              "neighbourhood mexican_hat, because its weights could grow without limit unnoticed",
              {}, "choose another 'neighbourhood', or similarity = \"dot_product\"");
}

// The labels of frames are unknown, and maps that learn together end together.
Result<void> check_not_refined(const RefinementParameters& refinement) {
  if (refinement.refine == Refinement::kNone) return {};
  return fail(ErrorKind::kUsage,
              "a map that learns in step with other modules, or from frames, cannot be refined by "
              "labels",
              "",
              "leave 'refine' out, or give the map one input per exploration and a phase "
              "of its training only");
}

}  // namespace

Table SomModule::decide(const std::vector<Connection>& inputs, const RecordingLayout& layout) {
  const bool of_frames = inputs.front().type.rate == Rate::kFrame;
  const std::size_t samples = of_frames ? layout.frames : layout.explorations;
  if (!parameters_.is_size_automatic() || samples == 0) return {};
  decide_size(parameters_, samples);
  Table decided;
  for (const char* name : {"rows", "columns", "iterations", "radius_end"}) {
    if (!reason_without_effect(parameters_, name).empty()) continue;
    decided.entries.push_back(
        {name, {}, SomParameters::declarations().find(name)->read(parameters_)});
  }
  return decided;
}

Result<PortType> SomModule::connect(const std::vector<Connection>& inputs) {
  const PortType& input = inputs.front().type;
  input_size_ = input.size();
  rate_ = input.rate;
  if (parameters_.is_size_automatic()) {
    return fail(ErrorKind::kUsage, "the map's size is automatic, which requires a recording", {},
                "provide the recording, or set 'rows' and 'columns' to numbers");
  }
  if (auto grid = Grid::validate(*parameters_.rows, *parameters_.columns, parameters_.lattice,
                                 parameters_.topology);
      !grid) {
    return fail(std::move(grid.error()));
  }
  const std::size_t neurons = parameters_.grid().size();
  // The number of stored elements of a sparse input is only known in training.
  const bool all_stored =
      !input.sparse || !InitialWeightsSource::are_zero_without_samples(parameters_);
  SOMATO_TRY_VOID(check_memory(neurons, all_stored ? input_size_ : 1, inputs.front().port));
  SOMATO_TRY_VOID(resolve(parameters_, 2, input_size_));
  SOMATO_TRY_VOID(check_refinement(refinement_, parameters_));
  return checked_size({rate_, {*parameters_.rows, *parameters_.columns}, false, input.clock},
                      inputs.front().port);
}

std::unique_ptr<Runner> SomModule::start() const {
  require(som_.neurons() > 0, "a map must be trained before it is used");
  if (!learner_) return std::make_unique<SomRunner>(som_);
  return std::make_unique<LearningRunner>(som_, *learner_, fixed_ ? &*fixed_ : nullptr,
                                          exploration_);
}

std::size_t SomModule::memory() const {
  const std::size_t elements = som_.neurons() > 0 ? som_.elements().count() : input_size_;
  return parameters_.grid().size() * elements * sizeof(float);
}

SomParameters SomModule::parameters_for(const LearningPlan& plan) const {
  SomParameters parameters = parameters_;
  parameters.seed = plan.seed;
  if (plan.draws) parameters.iterations = plan.draws;
  if (plan.order) parameters.draws = *plan.order;
  return parameters;
}

Result<void> SomModule::learn(const LearningPlan& plan, const TrainingInputs& explorations) {
  const bool known = plan.known.count() > 0;
  TrainingOptions options{1, plan.progress, plan.observer, {}};
  if (known) options.training = plan.training;
  SOMATO_TRY(auto trained, train_som(parameters_for(plan),
                                     known ? plan.known : all_values(explorations), options));
  order_.reset();
  if (is_refined()) {
    SOMATO_TRY(
        auto refined,
        refine(trained, plan, known ? plan.known.subset(plan.training) : all_values(explorations)));
    trained = std::move(refined.som);
    order_ = refined.order;
  }
  learner_.reset();
  som_ = std::move(trained);
  return {};
}

Result<RefinedSom> SomModule::refine(const Som& trained, const LearningPlan& plan,
                                     const Samples& samples) const {
  if (plan.classes.empty()) {
    return fail(
        ErrorKind::kUsage,
        "the map is refined by labels (refine), and the explorations are learned without any here",
        {}, "leave 'refine' out, or train the system in a study, which has labels");
  }
  require(plan.classes.size() == samples.count(), "each exploration has one value and one class");
  return refine_som(trained, samples, {plan.classes.begin(), plan.classes.end()}, refinement_,
                    {plan.seed, 1, plan.progress});
}

Result<NeuronOrigins> SomModule::learn_further(const LearningPlan& plan, const Samples& inputs) {
  require(som_.neurons() > 0, "a map must be trained before it learns further");
  if (is_refined()) {
    return fail(ErrorKind::kUsage,
                "a map that labels have refined cannot learn further, because learning without "
                "labels would undo the refinement",
                {}, "train it anew with all explorations, or leave 'refine' out");
  }
  TrainingOptions options{1, plan.progress, plan.observer, {}};
  options.start = &som_;
  SOMATO_TRY(auto trained, train_som(parameters_for(plan), inputs, options));
  som_ = std::move(trained);
  NeuronOrigins origins(som_.neurons());
  for (std::size_t neuron = 0; neuron < origins.size(); ++neuron) origins[neuron] = neuron;
  return origins;
}

Result<std::uint64_t> SomModule::begin(const LearningPlan& plan,
                                       const TrainingInputs& explorations) {
  SOMATO_TRY_VOID(check_not_refined(refinement_));
  SomParameters parameters = parameters_for(plan);
  learner_.reset();
  fixed_.reset();
  if (!plan.inputs_fixed && parameters.arithmetic == Arithmetic::kInnerProducts) {
    return fail(ErrorKind::kUsage,
                "inner products require constant inputs, one per exploration; here they are frames "
                "or change during training",
                {}, "remove 'arithmetic'");
  }
  SOMATO_TRY_VOID(check_stepwise(parameters));
  if (!plan.inputs_fixed) parameters.arithmetic = Arithmetic::kPlain;
  if (plan.inputs_unknown && parameters.initial_weights != InitialWeights::kUniform) {
    return fail(
        ErrorKind::kUsage,
        "the map receives its own output, so its weights cannot be initialized from its input", {},
        "write initial_weights = \"uniform\"");
  }
  // The output of learning modules may contain any element later.
  if (auto fits = check_memory(parameters.grid().size(), plan.inputs_fixed ? 1 : input_size_, {});
      !fits) {
    return fail(std::move(fits.error()));
  }
  Samples samples =
      plan.inputs_unknown ? Samples(Matrix<float>(1, input_size_)) : all_values(explorations);
  SOMATO_TRY(auto start, start_som(parameters, samples, {}));
  som_ = start.whole(std::move(start.som));
  learner_ = std::make_unique<SomLearner>(som_);
  if (plan.inputs_fixed) fixed_ = std::move(samples);
  return *som_.parameters().iterations;
}

Result<void> SomModule::step(std::span<const SignalView> inputs, std::uint64_t draw) {
  const SomParameters& p = som_.parameters();
  const LearningStep step{p.learning_rate().at(draw), p.radius().at(draw)};
  if (fixed_) {
    learner_->learn(*fixed_, {&exploration_, 1}, {&step, 1});
  } else {
    learner_->learn(inputs.front(), step.learning_rate, step.radius);
  }
  return {};
}

void SomModule::finish() {
  learner_.reset();
  fixed_.reset();
}

void SomModule::save(Archive& archive, const std::string& prefix) const {
  require(som_.neurons() > 0, "a map must be trained before it is saved");
  add_som(archive, prefix, som_);
}

Result<void> SomModule::load(const Archive& archive, const std::string& prefix,
                             const std::string& where) {
  SOMATO_TRY(auto som, som_from(archive, prefix, where));
  if (!fits(som)) return damaged_model("the map does not fit its module", where);
  learner_.reset();
  som_ = std::move(som);
  return {};
}

bool SomModule::fits(const Som& som) const {
  return som.input_size() == input_size_ && som.grid().rows() == parameters_.rows &&
         som.grid().columns() == parameters_.columns;
}

namespace {

// The keys of the map's training, and those of its refinement.
std::pair<Table, Table> split(const Table& table) {
  std::pair<Table, Table> parts{{table.where, {}}, {table.where, {}}};
  for (const Table::Entry& key : table.entries) {
    const bool of_refinement = RefinementParameters::declarations().find(key.name).has_value();
    (of_refinement ? parts.second : parts.first).entries.push_back(key);
  }
  return parts;
}

ModuleType som_type() {
  ModuleType type = describe<SomModule>("som", "A self-organizing map.",
                                        {input_port("The input of the map, flattened.")},
                                        "The activity of the neurons, rows x columns.", true);
  for (ParameterInfo& info : RefinementParameters::declarations().infos()) {
    type.parameters.push_back(std::move(info));
  }
  // A study sets the seed of each run.
  std::erase_if(type.parameters, [](const ParameterInfo& info) { return info.name == "seed"; });
  type.make = [](const Table& table) -> Result<std::unique_ptr<Module>> {
    const auto [of_som, of_refinement] = split(table);
    SOMATO_TRY(SomParameters parameters, read_parameters<SomParameters>(of_som));
    SOMATO_TRY(const auto refinement, read_parameters<RefinementParameters>(of_refinement));
    for (const Table::Entry& key : table.entries) {
      std::string reason = reason_without_effect(parameters, key.name);
      if (reason.empty()) reason = reason_without_effect(refinement, key.name);
      if (!reason.empty()) return fail(without_effect(key.name, reason, key.where));
    }
    return std::make_unique<SomModule>(std::move(parameters), refinement);
  };
  return type;
}

}  // namespace

std::vector<ModuleType> som_types() {
  return {som_type()};
}

}  // namespace somato::modules
