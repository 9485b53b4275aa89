#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/core/signal.h"
#include "somato/maps/som_parameters.h"
#include "somato/maps/som_training.h"
#include "somato/recording/layout.h"
#include "somato/recording/recording.h"

namespace somato {

class Archive;

/// The rate of new values of a port.
enum class Rate {
  kFrame,        ///< With every frame of an exploration.
  kExploration,  ///< Once, at the end of an exploration.
};

template <>
struct Choices<Rate> {
  static const std::vector<std::pair<Rate, std::string>>& all();
};

/// The type of the values at a port.
struct PortType {
  Rate rate = Rate::kFrame;
  std::vector<std::size_t> shape;  ///< Shape of one value, row-major.
  bool sparse = false;             ///< Only non-zero elements are stored.
  /// Identifies frames that are recorded together: they can be combined if the clocks are equal.
  /// Empty for one value per exploration.
  std::string clock;

  /// The number of elements; 2^64 - 1 if it is too large.
  std::size_t size() const;

  bool operator==(const PortType&) const = default;
};

/// "9 x 10, sparse, every frame".
std::string to_string(const PortType& type);

/// The values at a port during one exploration: flat values in order of time, a single one for a
/// port with Rate::kExploration.
struct Sequence {
  Samples values;
  double rate = 0.0;  ///< Frames per second; 0 if unknown.
};

/// The connection of an input port.
struct Connection {
  std::string port;  ///< The name of the port.
  PortType type;
  FrameRates rates = {};  ///< Those of the channel from which its frames come.
};

/// The state of a module during one exploration.
class Runner {
 public:
  Runner() = default;
  Runner(const Runner&) = delete;
  Runner(Runner&&) = delete;
  Runner& operator=(const Runner&) = delete;
  Runner& operator=(Runner&&) = delete;
  virtual ~Runner() = default;

  /// Processes one value of each input and writes the output to `out`, which still contains the
  /// output of the preceding step. Does not allocate once all memory is large enough. Errors:
  /// kData.
  virtual Result<void> step(std::span<const SignalView> inputs, SignalBuffer& out) = 0;

  /// Writes the output of a module that has one output per exploration, as if the preceding frame
  /// were the last one; for modules whose step() does not write it.
  virtual void value(SignalBuffer& /*out*/) const {}
};

class Learner;

/// A module of a system, with inputs, one output and parameters. A module is either stepped or
/// requires whole explorations. After training, const functions can be used by several threads.
class Module {
 public:
  Module() = default;
  Module(const Module&) = delete;
  Module(Module&&) = delete;
  Module& operator=(const Module&) = delete;
  Module& operator=(Module&&) = delete;
  virtual ~Module() = default;

  /// Sets the automatic parameters that determine the shape of the output, from the layout of a
  /// recording; called once, before connect(). Returns them with their values, for the description
  /// of the system, so that a trained module keeps its shape with other recordings.
  virtual Table decide(const std::vector<Connection>& /*inputs*/,
                       const RecordingLayout& /*layout*/) {
    return {};
  }

  /// The type of the output for these inputs, in the order of the ports; called once, before other
  /// functions. Errors (kUsage): inputs that do not fit, with the port as `where`.
  virtual Result<PortType> connect(const std::vector<Connection>& inputs) = 0;

  /// Whether the module runs frame by frame, with start(); otherwise it requires whole explorations
  /// and runs with run().
  virtual bool is_stepped() const { return true; }

  /// A runner at the start of an exploration, for a stepped module. The module must outlive it.
  virtual std::unique_ptr<Runner> start() const { return nullptr; }

  /// The output for a whole exploration, for a module that is not stepped. Errors: kData.
  virtual Result<Sequence> run(std::span<const Sequence* const> inputs) const;

  /// Whether it selects frames depending on its input, so that frames of two such modules cannot be
  /// combined.
  virtual bool chooses_frames() const { return false; }

  /// This module as a learner, or nullptr.
  virtual Learner* learner() { return nullptr; }

  /// Memory of learned values in bytes, after connect(); before training, an upper bound.
  virtual std::size_t memory() const { return 0; }
};

/// A module that reads a channel of a recording; it has no inputs.
class Source : public Module {
 public:
  /// Sets the layout of the recording, before connect(). Errors (kUsage): the channel is missing or
  /// does not fit.
  virtual Result<void> open(const RecordingLayout& layout) = 0;

  /// The name of the channel, and the number of its elements.
  virtual const std::string& channel() const = 0;
  virtual std::size_t channel_elements() const = 0;

  /// The number of each element of the output among those of the channel, from 0.
  virtual const std::vector<std::size_t>& elements() const = 0;

  /// Writes frame `row` of the channel to `out`, which still contains the preceding frame unless
  /// this is the first one of the exploration. Errors (kData): an invalid value.
  virtual Result<void> read(const Channel& channel, std::size_t row, bool is_first,
                            SignalBuffer& out) const = 0;
};

/// Settings of learning.
struct LearningPlan {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> draws;  ///< Empty: the module's own number.
  std::optional<Draws> order;          ///< Empty: the module's own order.
  Progress progress;
  /// The samples of a module that learns at once, if each exploration has one value at its only
  /// port: those of all known explorations, and the numbers of the training samples.
  Samples known;
  std::vector<std::size_t> training;
  /// The class of each training exploration, in their order, for a map that labels refine or that
  /// learns names; empty: the explorations have no classes.
  std::vector<std::size_t> classes;
  TrainingObserver observer;    ///< Receives snapshots of a map that learns at once.
  bool inputs_unknown = false;  ///< Whether the module depends on its own output.
  /// Whether each exploration has one constant value at each port: Learner::turn_to() then sets the
  /// next exploration.
  bool inputs_fixed = false;
};

/// The inputs at each port, for each training exploration.
using TrainingInputs = std::vector<std::vector<const Sequence*>>;

/// The learning interface of a module. Either learn() is called, or begin(), then step() for every
/// draw, and finish().
class Learner {
 public:
  Learner() = default;
  Learner(const Learner&) = delete;
  Learner(Learner&&) = delete;
  Learner& operator=(const Learner&) = delete;
  Learner& operator=(Learner&&) = delete;
  virtual ~Learner() = default;

  /// Whether it learns from all samples at once if no other module learns in the meantime.
  virtual bool learns_at_once() const = 0;

  /// Whether it can learn one draw at a time.
  virtual bool learns_by_draws() const = 0;

  /// Whether its initial state does not depend on its inputs, which are then not passed to begin().
  virtual bool begins_without_inputs() const { return false; }

  /// Learns from all explorations. Errors: kData, kUsage, kInterrupted.
  virtual Result<void> learn(const LearningPlan& plan, const TrainingInputs& explorations);

  /// Prepares learning by draws and returns the number of draws. `explorations` are the inputs
  /// before any learning in this phase; empty if they are unknown or not required. Errors: kData,
  /// kUsage.
  virtual Result<std::uint64_t> begin(const LearningPlan& plan, const TrainingInputs& explorations);

  /// Learns one draw: a frame, or the value of an exploration. Errors: kData.
  virtual Result<void> step(std::span<const SignalView> inputs, std::uint64_t draw);

  /// Sets the exploration, counted from 0 in those passed to begin(), that the module runs on and
  /// learns from next; only if its inputs are constant, after begin().
  virtual void turn_to(std::size_t exploration);

  /// Called after the last draw.
  virtual void finish();

  /// Adds the learned values to an archive under names that begin with `prefix`, and reads them
  /// back, bit by bit. Errors (kData): parts that are missing, damaged or of another size.
  virtual void save(Archive& archive, const std::string& prefix) const = 0;
  virtual Result<void> load(const Archive& archive, const std::string& prefix,
                            const std::string& where) = 0;
};

/// An input port of a type of modules.
struct InputPort {
  std::string name;
  std::string text;  ///< One line.
  bool required = true;
  bool many = false;  ///< Accepts a list of modules, in order.
};

/// A type of modules: a possible value of `type = "..."` in a description.
struct ModuleType {
  std::string name;
  std::string text;  ///< One line.
  std::vector<InputPort> ports;
  std::string output;  ///< One line.
  bool learns = false;
  std::vector<ParameterInfo> parameters;
  /// Creates a module with the parameters of the table. Errors (kUsage) with their location.
  std::function<Result<std::unique_ptr<Module>>(const Table& parameters)> make;
};

/// All types of modules, in the order of the documentation.
const std::vector<ModuleType>& module_types();

/// The type with that name; an unknown one is an error (kUsage, at `where`) with the nearest name.
Result<const ModuleType*> find_module_type(const std::string& name, const std::string& where);

}  // namespace somato
