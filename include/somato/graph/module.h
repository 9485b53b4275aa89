#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/core/signal_buffer.h"
#include "somato/files/archive.h"
#include "somato/graph/port.h"
#include "somato/maps/som_parameters.h"
#include "somato/recording/layout.h"
#include "somato/recording/recording.h"

namespace somato {

/// What is connected to an input port.
struct Connection {
  std::string port;  ///< The name of the port.
  PortType type;
};

/// A module at work on one exploration, frame by frame, with whatever it remembers from frame to
/// frame.
class Stepper {
 public:
  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper(Stepper&&) = delete;
  Stepper& operator=(const Stepper&) = delete;
  Stepper& operator=(Stepper&&) = delete;
  virtual ~Stepper() = default;

  /// The output for one frame of each input. Errors: kData.
  virtual Result<Signal> step(std::span<const SignalView> inputs) = 0;

  /// The same, flat, in memory of this object: valid until its next step. What runs live does so
  /// without allocation once its memory has grown. Errors: kData.
  virtual Result<SignalView> advance(std::span<const SignalView> inputs);

 private:
  Signal stepped_;
};

class Learner;

/// A module of a system: it has inputs, one output and parameters, and turns what came in during an
/// exploration into what goes out. Once it has learned it is constant while used: several threads
/// may run it at once.
class Module {
 public:
  Module() = default;
  Module(const Module&) = delete;
  Module(Module&&) = delete;
  Module& operator=(const Module&) = delete;
  Module& operator=(Module&&) = delete;
  virtual ~Module() = default;

  /// Decides the automatic parameters that the shape of the output depends on, from what a
  /// recording brings; called once, before connect(). Returns them with their values, for the
  /// description of the system: what has learned keeps its shape with other recordings.
  virtual Table decide(const std::vector<Connection>& /*inputs*/,
                       const RecordingLayout& /*layout*/) {
    return {};
  }

  /// What the output carries when the inputs are these, in the order of the ports; called once,
  /// before anything else. Errors (kUsage): inputs that do not fit, with the port as `where`.
  virtual Result<PortType> connect(const std::vector<Connection>& inputs) = 0;

  /// The output during a whole exploration. Errors: kData.
  virtual Result<Sequence> run(std::span<const Sequence* const> inputs) const = 0;

  /// Whether it chooses frames by what comes in, so that those of two such modules never go
  /// together.
  virtual bool chooses_frames() const { return false; }

  /// Whether it can run frame by frame, rather than on explorations as a whole.
  virtual bool is_stepped() const { return false; }

  /// The module at the start of an exploration, or nullptr when it is not stepped. The module must
  /// outlive it.
  virtual std::unique_ptr<Stepper> start() const { return nullptr; }

  /// The same, but where a value comes once an exploration: with each frame what it would be if
  /// that were the last one. nullptr when the module needs explorations as a whole.
  virtual std::unique_ptr<Stepper> start_live() const { return start(); }

  /// This module as one that has to learn, or nullptr.
  virtual Learner* learner() { return nullptr; }

  /// Bytes of what is kept after learning, once connected; before it has learned, at most.
  virtual std::size_t memory() const { return 0; }
};

/// A module where a recording comes in: it has no inputs.
class Source : public Module {
 public:
  /// What is coming; before connect(). Errors (kUsage): something is not there.
  virtual Result<void> open(const RecordingLayout& layout) = 0;

  /// What the exploration holds. Errors: kData.
  virtual Result<Sequence> read(const Exploration& exploration) const = 0;

  /// The channel that it takes, and how many elements that has.
  virtual const std::string& channel() const = 0;
  virtual std::size_t channel_elements() const = 0;

  /// What a single frame of the channel holds, all of it valid, into `out`.
  virtual void take(std::span<const float> frame, SignalBuffer& out) const = 0;

  Result<Sequence> run(std::span<const Sequence* const> inputs) const override;
};

/// How something is to be learned.
struct Lesson {
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> draws;  ///< Nothing: the module's own number.
  std::optional<Draws> order;          ///< Nothing: the module's own.
  Progress progress;
  bool inputs_unknown = false;  ///< The module hears itself: what comes in depends on it.
  /// Each exploration brings one value at each port, the same throughout: Learner::turn_to() tells
  /// which exploration comes next.
  bool inputs_fixed = false;
};

/// Of each exploration to learn from, what comes in at each port.
using TrainingInputs = std::vector<std::vector<const Sequence*>>;

/// What a learning module does besides running. Either learn() is called, or begin(), then step()
/// for every draw, and finish().
class Learner {
 public:
  Learner() = default;
  Learner(const Learner&) = delete;
  Learner(Learner&&) = delete;
  Learner& operator=(const Learner&) = delete;
  Learner& operator=(Learner&&) = delete;
  virtual ~Learner() = default;

  /// Whether it learns all at once when nothing else learns meanwhile.
  virtual bool learns_at_once() const = 0;

  /// Whether it can learn draw by draw.
  virtual bool learns_by_draws() const = 0;

  /// Whether what it begins with does not depend on its inputs, which begin() then is not given.
  virtual bool begins_without_inputs() const { return false; }

  /// Learns from all explorations. Errors: kData, kUsage, kInterrupted.
  virtual Result<void> learn(const Lesson& lesson, const TrainingInputs& explorations);

  /// Gets ready to learn draw by draw and returns how many draws there will be. `explorations` are
  /// the inputs before anything is learned in this phase; none when they are unknown or not needed.
  /// Errors: kData, kUsage.
  virtual Result<std::uint64_t> begin(const Lesson& lesson, const TrainingInputs& explorations);

  /// Learns one draw: a frame, or the value of an exploration. Errors: kData.
  virtual Result<void> step(std::span<const SignalView> inputs, std::uint64_t draw);

  /// Tells which of the explorations given to begin(), counted from 0, the module runs on and
  /// learns from next; only where its inputs are fixed, after begin().
  virtual void turn_to(std::size_t exploration);

  /// After the last draw.
  virtual void finish();

  /// Puts what was learned into an archive under names that begin with `prefix`, and takes it from
  /// there, bit by bit. Errors (kData): parts missing, damaged or of another size.
  virtual void save(Archive& archive, const std::string& prefix) const = 0;
  virtual Result<void> load(const Archive& archive, const std::string& prefix,
                            const std::string& where) = 0;
};

/// An input port of a type of modules.
struct InputPort {
  std::string name;
  std::string text;  ///< One line.
  bool required = true;
  bool many = false;  ///< Takes a list, one after the other.
};

/// A type of modules: what `type = "..."` in a description may name.
struct ModuleType {
  std::string name;
  std::string text;  ///< One line.
  std::vector<InputPort> ports;
  std::string output;  ///< One line.
  bool learns = false;
  std::vector<ParameterInfo> parameters;
  /// A module with the parameters of that table. Errors (kUsage) with their place.
  std::function<Result<std::unique_ptr<Module>>(const Table& parameters)> make;
};

/// All types of modules, in the order of the documentation.
const std::vector<ModuleType>& module_types();

/// The type of that name; an unknown one is an error (kUsage, at `where`) with the nearest name.
Result<const ModuleType*> find_module_type(const std::string& name, const std::string& where);

}  // namespace somato
