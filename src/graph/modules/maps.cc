#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "graph/modules/som_module.h"
#include "graph/modules/support.h"
#include "maps/map_parts.h"
#include "maps/t_mpsom_learner.h"
#include "somato/core/check.h"
#include "somato/core/memory.h"
#include "somato/maps/initial_weights.h"
#include "somato/maps/som_archive.h"
#include "somato/maps/t_mpsom.h"
#include "somato/maps/t_mpsom_archive.h"

namespace somato::modules {
namespace {

// Refused before it is asked for: a system that promises more memory than it has would end the
// program later, without a word.
Result<void> check_memory(std::size_t neurons, std::size_t elements, const std::string& port) {
  const double needed =
      static_cast<double>(neurons) * static_cast<double>(elements) * sizeof(float);
  const auto there = static_cast<double>(memory_of_machine());
  if (needed <= there) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("{} neurons with {} elements need {} of memory, and this machine has {}",
                          neurons, elements, memory_text(needed), memory_text(there)),
              port, "choose fewer neurons or elements");
}

class SomStepper : public Stepper {
 public:
  SomStepper(const Som& som, SomLearner* learner) : som_(som), learner_(learner) {}

  Result<Signal> step(std::span<const SignalView> inputs) override {
    if (learner_ != nullptr) learner_->settle();
    std::vector<float> activity(som_.neurons());
    som_.activity(inputs.front(), workspace_, activity);
    return Signal::dense({som_.grid().rows(), som_.grid().columns()}, std::move(activity));
  }

  Result<SignalView> advance(std::span<const SignalView> inputs) override {
    som_.activity(inputs.front(), workspace_, activity_.begin_dense(som_.neurons()));
    return activity_.view();
  }

 private:
  const Som& som_;
  SomLearner* learner_;  // of a map that learns meanwhile
  SomWorkspace workspace_;
  SignalBuffer activity_;
};

// Answers for the exploration that the phase has turned to.
class KnownStepper : public Stepper {
 public:
  KnownStepper(const InnerProductLearner& learner, std::size_t exploration)
      : learner_(learner), exploration_(exploration) {}

  Result<Signal> step(std::span<const SignalView> /*inputs*/) override {
    const SomParameters& p = learner_.parameters();
    std::vector<float> activity(p.grid().size());
    learner_.activity(exploration_, activity);
    return Signal::dense({*p.rows, *p.columns}, std::move(activity));
  }

 private:
  const InnerProductLearner& learner_;
  std::size_t exploration_;
};

}  // namespace

Table SomModule::decide(const std::vector<Connection>& inputs, const RecordingLayout& layout) {
  const bool of_frames = inputs.front().type.rate == Rate::kFrame;
  const std::size_t samples = of_frames ? layout.frames : layout.explorations;
  if (!parameters_.is_size_automatic() || samples == 0) return {};
  decide_size(parameters_, samples);
  Table decided;
  for (const char* name : {"rows", "columns", "iterations"}) {
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
    return fail(ErrorKind::kUsage, "the map's size is automatic, which takes a recording", {},
                "give the recording, or write rows and columns as numbers");
  }
  if (auto grid = Grid::validate(*parameters_.rows, *parameters_.columns, parameters_.lattice,
                                 parameters_.topology);
      !grid) {
    return fail(std::move(grid.error()));
  }
  const std::size_t neurons = parameters_.grid().size();
  // How many elements of a sparse input get weights is known when it learns.
  const bool all_stored =
      !input.sparse || !InitialWeightsSource::are_zero_without_samples(parameters_);
  if (auto fits = check_memory(neurons, all_stored ? input_size_ : 1, inputs.front().port); !fits) {
    return fail(std::move(fits.error()));
  }
  if (auto possible = resolve(parameters_, 2, input_size_); !possible) {
    return fail(std::move(possible.error()));
  }
  return checked_size({rate_, {*parameters_.rows, *parameters_.columns}, false, input.clock},
                      inputs.front().port);
}

std::unique_ptr<Stepper> SomModule::start() const {
  if (known_) return std::make_unique<KnownStepper>(*known_, exploration_);
  require(som_.neurons() > 0, "a map that has learned nothing cannot be used");
  return std::make_unique<SomStepper>(som_, learner_.get());
}

std::size_t SomModule::memory() const {
  const std::size_t elements = som_.neurons() > 0 ? som_.elements().count() : input_size_;
  return parameters_.grid().size() * elements * sizeof(float);
}

SomParameters SomModule::parameters_for(const Lesson& lesson) const {
  SomParameters parameters = parameters_;
  parameters.seed = lesson.seed;
  if (lesson.draws) parameters.iterations = lesson.draws;
  if (lesson.order) parameters.draws = *lesson.order;
  return parameters;
}

Result<void> SomModule::learn(const Lesson& lesson, const TrainingInputs& explorations) {
  auto trained = train_som(parameters_for(lesson), all_values(explorations), {1, lesson.progress});
  if (!trained) return fail(std::move(trained.error()));
  learner_.reset();
  som_ = std::move(*trained);
  return {};
}

Result<std::uint64_t> SomModule::begin(const Lesson& lesson, const TrainingInputs& explorations) {
  SomParameters parameters = parameters_for(lesson);
  known_.reset();
  learner_.reset();
  if (lesson.inputs_fixed) {
    auto known = InnerProductLearner::start(parameters, all_values(explorations));
    if (!known) return fail(std::move(known.error()));
    known_ = std::move(*known);
    if (known_) return *known_->parameters().iterations;
  }
  if (!lesson.inputs_fixed && parameters.arithmetic == Arithmetic::kInnerProducts) {
    return fail(ErrorKind::kUsage,
                "inner products need the same inputs throughout, one an exploration, and here they "
                "are frames or change while others learn",
                {}, "leave 'arithmetic' out");
  }
  if (lesson.inputs_unknown && parameters.initial_weights != InitialWeights::kUniform) {
    return fail(ErrorKind::kUsage,
                "it hears itself, so its weights cannot start from what it will hear", {},
                "write initial_weights = \"uniform\"");
  }
  // What others learn may bring any element later.
  if (auto fits = check_memory(parameters.grid().size(), lesson.inputs_fixed ? 1 : input_size_, {});
      !fits) {
    return fail(std::move(fits.error()));
  }
  const Samples samples =
      lesson.inputs_unknown ? Samples(Matrix<float>(1, input_size_)) : all_values(explorations);
  if (auto begun = begin_plain(std::move(parameters), samples); !begun) return fail(begun.error());
  return *som_.parameters().iterations;
}

Result<void> SomModule::begin_plain(SomParameters parameters, const Samples& samples) {
  parameters.arithmetic = Arithmetic::kPlain;
  auto som = untrained_som(parameters, samples);
  if (!som) return fail(std::move(som.error()));
  som_ = std::move(*som);
  learner_ = std::make_unique<SomLearner>(som_);
  return {};
}

Result<void> SomModule::step(std::span<const SignalView> inputs, std::uint64_t draw) {
  const SomParameters& p = known_ ? known_->parameters() : som_.parameters();
  const double rate = p.learning_rate().at(draw);
  const double radius = p.radius().at(draw);
  if (known_) {
    known_->learn(exploration_, rate, radius);
  } else {
    learner_->learn(inputs.front(), rate, radius);
  }
  return {};
}

void SomModule::finish() {
  learner_.reset();
  if (!known_) return;
  som_ = known_->form_som();
  known_.reset();
}

void SomModule::save(Archive& archive, const std::string& prefix) const {
  require(som_.neurons() > 0, "a map that has learned nothing cannot be saved");
  add_som(archive, prefix, som_);
}

Result<void> SomModule::load(const Archive& archive, const std::string& prefix,
                             const std::string& where) {
  auto som = som_from(archive, prefix, where);
  if (!som) return fail(std::move(som.error()));
  if (!fits(*som)) return damaged_model("a map does not fit its place in the system", where);
  learner_.reset();
  som_ = std::move(*som);
  return {};
}

bool SomModule::fits(const Som& som) const {
  return som.input_size() == input_size_ && som.grid().rows() == parameters_.rows &&
         som.grid().columns() == parameters_.columns;
}

void SomModule::set_som(Som som) {
  require(fits(som), "a map is given to a module of another size");
  som_ = std::move(som);
}

namespace {

// What the description may say of a T-MPSOM: all but what follows from its inputs.
struct TMpsomModuleParameters {
  TMpsomParameters map;

  static const Declarations<TMpsomModuleParameters>& declarations() {
    using P = TMpsomModuleParameters;
    static const auto declared = Declarations<P>().add_from(
        &P::map, TMpsomParameters::declarations(),
        {"shape", "input_axes", "combination", "arbor_sigma", "neighbourhood_sigma",
         "learning_rate_schedule", "learning_rate_start", "learning_rate_end",
         "learning_rate_reached_at", "input_norm", "weight_norm", "iterations"});
    return declared;
  }
};

// A T-MPSOM throws when numbers leave their range, which without norms hangs on what comes in.
template <typename Work>
Result<void> in_range(const Work& work) {
  try {
    work();
    return {};
  } catch (const InvalidArgument& error) {
    return fail(ErrorKind::kData, error.what(), {}, "scale what comes in, or leave the norms on");
  }
}

class TMpsomStepper : public Stepper {
 public:
  explicit TMpsomStepper(const TMpsom& map) : map_(map), workspace_(map) {}

  Result<Signal> step(std::span<const SignalView> inputs) override {
    std::vector<float> activity(map_.neurons());
    const auto active = in_range([&] { map_.activation(inputs, workspace_, activity); });
    if (!active) return fail(active.error());
    return Signal::dense(map_.parameters().shape, std::move(activity));
  }

  Result<SignalView> advance(std::span<const SignalView> inputs) override {
    std::vector<float>& activity = activity_.begin_dense(map_.neurons());
    const auto active = in_range([&] { map_.activation(inputs, workspace_, activity); });
    if (!active) return fail(active.error());
    return activity_.view();
  }

 private:
  const TMpsom& map_;
  TMpsom::Workspace workspace_;
  SignalBuffer activity_;
};

// While the map learns: the learner hears each input once, for its activity and to learn it.
class LearningTMpsomStepper : public Stepper {
 public:
  LearningTMpsomStepper(TMpsomLearner& learner, const TMpsomParameters& parameters)
      : learner_(learner), parameters_(parameters) {}

  Result<Signal> step(std::span<const SignalView> inputs) override {
    std::vector<float> activity(parameters_.neurons());
    const auto active = in_range([&] { learner_.activation(inputs, activity); });
    if (!active) return fail(active.error());
    return Signal::dense(parameters_.shape, std::move(activity));
  }

 private:
  TMpsomLearner& learner_;
  const TMpsomParameters& parameters_;
};

class TMpsomModule : public SteppedModule, public Learner {
 public:
  using Parameters = TMpsomModuleParameters;
  explicit TMpsomModule(Parameters parameters) : parameters_(std::move(parameters.map)) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    if (auto together = expect_together(inputs); !together) return fail(together.error());
    std::size_t elements = 0;
    for (const Connection& input : inputs) {
      parameters_.input_sizes.push_back(input.type.size());
      elements += input.type.size();
    }
    if (auto valid = parameters_.validate(); !valid) return fail(std::move(valid.error()));
    // Weights, arbors, and as much again while learning.
    if (auto fits = check_memory(parameters_.neurons(), 4 * elements, inputs.front().port); !fits) {
      return fail(std::move(fits.error()));
    }
    const PortType& first = inputs.front().type;
    return checked_size({first.rate, parameters_.shape, false, first.clock}, inputs.front().port);
  }

  Learner* learner() override { return this; }
  std::unique_ptr<Stepper> start() const override {
    require(map_.has_value(), "a T-MPSOM that has learned nothing cannot be used");
    if (learner_) return std::make_unique<LearningTMpsomStepper>(*learner_, map_->parameters());
    return std::make_unique<TMpsomStepper>(*map_);
  }

  std::size_t memory() const override {
    std::size_t elements = 0;
    for (const std::size_t size : parameters_.input_sizes) elements += size;
    return 2 * parameters_.neurons() * elements * sizeof(float);
  }

  bool learns_at_once() const override { return false; }
  bool learns_by_draws() const override { return true; }
  bool begins_without_inputs() const override { return true; }

  Result<std::uint64_t> begin(const Lesson& lesson,
                              const TrainingInputs& /*explorations*/) override {
    TMpsomParameters parameters = parameters_;
    parameters.seed = lesson.seed;
    parameters.iterations = lesson.draws.value_or(parameters.iterations);
    if (auto valid = parameters.validate(); !valid) return fail(std::move(valid.error()));
    learner_.reset();
    map_.emplace(parameters);
    learner_ = std::make_unique<TMpsomLearner>(*map_);
    return parameters.iterations;
  }

  Result<void> step(std::span<const SignalView> inputs, std::uint64_t draw) override {
    return in_range([&] { learner_->learn(inputs, map_->parameters().learning_rate().at(draw)); });
  }

  void finish() override { learner_.reset(); }

  void save(Archive& archive, const std::string& prefix) const override {
    require(map_.has_value(), "a T-MPSOM that has learned nothing cannot be saved");
    add_t_mpsom(archive, prefix, *map_);
  }

  Result<void> load(const Archive& archive, const std::string& prefix,
                    const std::string& where) override {
    auto map = t_mpsom_from(archive, prefix, where);
    if (!map) return fail(std::move(map.error()));
    if (map->parameters().input_sizes != parameters_.input_sizes ||
        map->parameters().shape != parameters_.shape) {
      return damaged_model("a T-MPSOM does not fit its place in the system", where);
    }
    learner_.reset();
    map_ = std::move(*map);
    return {};
  }

 private:
  TMpsomParameters parameters_;
  std::optional<TMpsom> map_;
  std::unique_ptr<TMpsomLearner> learner_;  // while it learns
};

class WinnerModule : public MappedModule {
 public:
  using Parameters = NoParameters;
  explicit WinnerModule(const Parameters& /*parameters*/) {}

  Result<PortType> connect(const std::vector<Connection>& inputs) override {
    type_ = inputs.front().type;
    type_.sparse = true;
    return checked_size(type_, inputs.front().port);
  }

  Result<Signal> map(std::span<const SignalView> inputs) const override {
    return Signal::sparse(type_.shape, {place_of_greatest(inputs.front())}, {1.0F});
  }

 private:
  // The first of equals. Zeros that are not stored are not looked at one by one: there may be
  // thousands of millions.
  static std::uint32_t place_of_greatest(const SignalView& input) {
    const auto most = std::max_element(input.values.begin(), input.values.end());
    const auto stored = static_cast<std::size_t>(most - input.values.begin());
    if (!input.sparse) return static_cast<std::uint32_t>(stored);
    if (most != input.values.end() && *most > 0.0F) return input.indices[stored];
    return first_zero(input).value_or(stored < input.indices.size() ? input.indices[stored] : 0);
  }

  // Of a sparse signal, stored or not.
  static std::optional<std::uint32_t> first_zero(const SignalView& input) {
    std::uint32_t place = 0;
    while (place < input.indices.size() && input.indices[place] == place &&
           input.values[place] != 0.0F) {
      ++place;
    }
    if (place == input.size) return {};
    return place;
  }

  PortType type_;
};

ModuleType som_type() {
  ModuleType type = describe<SomModule>("som", "A self-organizing map.",
                                        {input_port("What the map learns, flattened.")},
                                        "The activity of the neurons, rows x columns.", true);
  // A study gives every run a seed of its own.
  std::erase_if(type.parameters, [](const ParameterInfo& info) { return info.name == "seed"; });
  type.make = [](const Table& table) -> Result<std::unique_ptr<Module>> {
    Result<SomParameters> parameters = read_parameters<SomParameters>(table);
    if (!parameters) return fail(std::move(parameters.error()));
    for (const Table::Entry& key : table.entries) {
      const std::string reason = reason_without_effect(*parameters, key.name);
      if (!reason.empty()) return fail(without_effect(key.name, reason, key.where));
    }
    return std::make_unique<SomModule>(std::move(*parameters));
  };
  return type;
}

}  // namespace

std::vector<ModuleType> map_types() {
  return {som_type(),
          describe<TMpsomModule>(
              "t_mpsom", "A T-MPSOM (P06 section 4.1, P07, P11 section II).",
              {input_ports("One or more signals, each spread along an axis of the map.")},
              "The activity of the neurons, in the map's shape.", true),
          describe<WinnerModule>("winner", "The place of the greatest element.",
                                 {input_port("Such as a map's activity.")},
                                 "The input's shape, 1 at that place and 0 elsewhere; sparse.")};
}

}  // namespace somato::modules
