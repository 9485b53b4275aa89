#include "somato/graph/system.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "base/core/contains.h"
#include "base/files/toml_file.h"
#include "systems/graph/phase_plan.h"
#include "systems/graph/wiring.h"
#include "systems/modules/delay.h"

namespace somato {
namespace {

const Table::Entry* find_entry(const ModuleDescription& module, const std::string& name) {
  return module.settings.find(name);
}

Result<std::string> type_of(const ModuleDescription& module) {
  const Table::Entry* entry = find_entry(module, "type");
  const Value* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  const auto* type = value ? std::get_if<std::string>(&value->content) : nullptr;
  if (type) return *type;
  return fail(ErrorKind::kUsage, "'type' is missing or not a text",
              entry ? entry->where : module.settings.where,
              "write type = \"...\"; 'somato modules' lists the types");
}

// In the place of an entry of that name, or at the end.
void set_entry(Table& settings, Table::Entry entry) {
  entry.where = settings.where;
  const auto known =
      std::find_if(settings.entries.begin(), settings.entries.end(),
                   [&](const Table::Entry& other) { return other.name == entry.name; });
  if (known == settings.entries.end()) {
    settings.entries.push_back(std::move(entry));
  } else {
    *known = std::move(entry);
  }
}

FrameRates rates_of(const Source& source, const RecordingLayout& layout) {
  for (std::size_t i = 0; i < layout.rates.size(); ++i) {
    if (layout.channels[i].name == source.channel()) return layout.rates[i];
  }
  return {};
}

bool is_port(const ModuleType& type, const std::string& name) {
  return std::any_of(type.ports.begin(), type.ports.end(),
                     [&](const InputPort& port) { return port.name == name; });
}

bool is_parameter(const ModuleType& type, const std::string& name) {
  return std::any_of(type.parameters.begin(), type.parameters.end(),
                     [&](const ParameterInfo& parameter) { return parameter.name == name; });
}

std::vector<std::string> keys_of(const ModuleType& type) {
  std::vector<std::string> keys{"type"};
  for (const InputPort& port : type.ports) keys.push_back(port.name);
  for (const ParameterInfo& parameter : type.parameters) keys.push_back(parameter.name);
  return keys;
}

// The settings that are parameters; others must be ports.
Result<Table> parameters_of(const ModuleDescription& module, const ModuleType& type) {
  Table parameters;
  parameters.where = module.settings.where;
  for (const Table::Entry& entry : module.settings.entries) {
    if (is_parameter(type, entry.name)) {
      parameters.entries.push_back(entry);
    } else if (entry.name != "type" && !is_port(type, entry.name)) {
      return fail(unknown_name("key", entry.name, entry.where, keys_of(type)));
    }
  }
  return parameters;
}

// The names at a port: a text, or a list of texts where the port takes many.
Result<std::vector<std::string>> names_at(const InputPort& port, const Table::Entry& entry) {
  const Value* value = std::get_if<Value>(&entry.content);
  const auto* text = value ? std::get_if<std::string>(&value->content) : nullptr;
  if (text) return std::vector<std::string>{*text};
  const auto* list = value ? std::get_if<Value::List>(&value->content) : nullptr;
  std::vector<std::string> names;
  for (const Value& item : list&& port.many ? *list : Value::List{}) {
    const auto* name = std::get_if<std::string>(&item.content);
    if (!name) break;
    names.push_back(*name);
  }
  if (!names.empty() && names.size() == list->size()) return names;
  return fail(
      ErrorKind::kUsage,
      port.many ? "the port takes the names of modules" : "the port takes the name of one module",
      entry.where,
      port.many ? "write " + port.name + " = [\"NAME\", ...]"
                : "write " + port.name + " = \"NAME\"");
}

// A description must be representable as text, which is stored in a model file.
Result<void> check_text(const SystemDescription& description) {
  const std::string text = to_toml(description);
  auto again =
      parse_toml(text, "as TOML").and_then([](const Table& table) { return read_system(table); });
  if (again && to_toml(*again) == text && again->modules.size() == description.modules.size()) {
    return {};
  }
  if (again) return fail(ErrorKind::kUsage, "the description cannot be represented as TOML");
  return fail(std::move(again.error()));
}

// A model file holds up to 1000 parts; a learning module has two, a T-MPSOM one more than inputs.
Result<void> check_parts(const std::vector<SystemModule>& modules, const SystemDescription& all) {
  constexpr std::size_t kMostParts = 990;
  std::size_t parts = 0;
  for (std::size_t i = 0; i < modules.size(); ++i) {
    if (modules[i].module->learner() != nullptr) {
      parts += 1 + std::max<std::size_t>(1, modules[i].inputs.size());
    }
    if (parts <= kMostParts) continue;
    return fail(ErrorKind::kUsage, "the learning modules have too many inputs for a model file",
                all.modules[i].settings.where, "combine inputs with 'concatenation'");
  }
  return {};
}

const modules::Delay* delay_of(const SystemModule& module) {
  return dynamic_cast<const modules::Delay*>(module.module.get());
}

// Whether a phase sets the length of the training of that module.
bool is_drawn_by_a_phase(const SystemDescription& description, const std::string& module) {
  return std::ranges::any_of(description.phases, [&](const PhaseDescription& phase) {
    return phase.draws && contains(phase.learn, module);
  });
}

}  // namespace

System::System() = default;
System::System(System&&) noexcept = default;
System& System::operator=(System&&) noexcept = default;
System::~System() = default;

Result<System> System::build(SystemDescription description, RecordingLayout layout) {
  System system;
  system.description_ = std::move(description);
  system.layout_ = std::move(layout);
  Result<void> built =
      system.make_modules()
          .and_then([&] { return check_text(system.description_); })
          .and_then([&] { return system.connect_ports(); })
          .and_then([&] { return check_parts(system.modules_, system.description_); })
          .and_then([&] { return system.wire(); })
          .and_then([&] { return system.infer_types(); })
          .and_then([&] { return system.plan_phases(); });
  if (!built) return fail(std::move(built.error()));
  return system;
}

Result<void> System::make_modules() {
  std::set<std::string> names;
  for (const ModuleDescription& module : description_.modules) {
    const std::size_t number = modules_.size();
    modules_.push_back({module.name, module.settings.where, nullptr, nullptr, {}, {}, {}, {}});
    if (!names.insert(module.name).second) {
      return fail(at_module(
          {ErrorKind::kUsage, "two modules have this name", {}, "rename one of them"}, number));
    }
    const auto type_name = type_of(module);
    if (!type_name) return fail(at_module(type_name.error(), number));
    const auto type = find_module_type(*type_name, find_entry(module, "type")->where);
    if (!type) return fail(at_module(type.error(), number));
    modules_.back().type = *type;
    auto parameters = parameters_of(module, **type);
    if (!parameters) return fail(at_module(std::move(parameters.error()), number));
    auto made = (*type)->make(*parameters);
    if (!made) return fail(at_module(std::move(made.error()), number));
    modules_.back().module = std::move(*made);
  }
  return {};
}

Result<void> System::connect_ports() {
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    SystemModule& module = modules_[i];
    for (const InputPort& port : module.type->ports) {
      const Table::Entry* entry = find_entry(description_.modules[i], port.name);
      if (!entry && !port.required) continue;
      if (!entry) {
        return fail(at_port(
            {ErrorKind::kUsage, "no module is connected", {}, "write " + port.name + " = \"NAME\""},
            i, port.name));
      }
      const auto names = names_at(port, *entry);
      if (!names) return fail(at_port(names.error(), i, port.name));
      for (const std::string& name : *names) {
        const auto input = find(name, entry->where);
        if (!input) return fail(at_port(input.error(), i, port.name));
        module.inputs.push_back(*input);
        module.ports.push_back(port.name);
      }
    }
  }
  return {};
}

Result<void> System::wire() {
  std::vector<std::vector<std::size_t>> inputs;
  std::vector<bool> delays;
  for (const SystemModule& module : modules_) {
    inputs.push_back(module.inputs);
    delays.push_back(delay_of(module) != nullptr);
  }
  wiring_ = std::make_unique<Wiring>(inputs, delays);
  if (wiring_->endless_loop().empty()) return {};
  std::string way;
  for (const std::size_t module : wiring_->endless_loop()) way += modules_[module].name + " -> ";
  way += modules_[wiring_->endless_loop().front()].name;
  return fail(at_module({ErrorKind::kUsage,
                         "a loop requires a delay: " + way,
                         {},
                         "insert a module of type \"delay\" between two of its modules"},
                        wiring_->endless_loop().front()));
}

Result<void> System::infer_types() {
  for (SystemModule& module : modules_) {
    auto* source = dynamic_cast<Source*>(module.module.get());
    if (source == nullptr) continue;
    module.rates = rates_of(*source, layout_);
    if (auto opened = source->open(layout_); !opened) {
      const auto number = static_cast<std::size_t>(&module - modules_.data());
      return fail(at_module(std::move(opened.error()), number));
    }
  }
  for (const std::vector<std::size_t>& group : wiring_->groups()) {
    Result<void> inferred =
        wiring_->is_loop(group) ? infer_loop(group) : infer_module(group.front());
    if (!inferred) return inferred;
  }
  return {};
}

// The delays of a loop declare their shapes; the frames are those of the inputs from outside.
Result<void> System::infer_loop(const std::vector<std::size_t>& group) {
  std::string clock;
  for (const std::size_t member : group) {
    for (const std::size_t input : modules_[member].inputs) {
      const bool outside = std::find(group.begin(), group.end(), input) == group.end();
      if (outside && clock.empty()) clock = modules_[input].output.clock;
    }
  }
  if (clock.empty()) {
    return fail(at_module({ErrorKind::kUsage,
                           "its loop receives no frames from outside",
                           {},
                           "connect a channel to one of its modules"},
                          group.front()));
  }
  for (const std::size_t member : group) {
    SOMATO_TRY_VOID(promise(member, clock));
  }
  for (const bool delays : {false, true}) {
    for (const std::size_t member : group) {
      if ((delay_of(modules_[member]) != nullptr) != delays) continue;
      SOMATO_TRY_VOID(infer_module(member));
    }
  }
  return {};
}

// The output of a member of a loop before its input is known.
Result<void> System::promise(std::size_t member, const std::string& clock) {
  if (!modules_[member].module->is_stepped()) {
    return fail(at_module({ErrorKind::kUsage,
                           "it requires whole explorations, so it cannot be part of a loop",
                           {},
                           "remove it from the loop"},
                          member));
  }
  const modules::Delay* delay = delay_of(modules_[member]);
  if (delay == nullptr) return {};
  if (delay->promised_shape().empty()) {
    return fail(at_module({ErrorKind::kUsage,
                           "a delay in a loop requires 'shape'",
                           {},
                           "write shape = [...], the shape of its input"},
                          member));
  }
  auto promised = modules::checked_size({Rate::kFrame, delay->promised_shape(), false, clock}, {});
  if (!promised) return fail(at_module(std::move(promised.error()), member));
  modules_[member].output = std::move(*promised);
  return {};
}

Result<void> System::infer_module(std::size_t number) {
  SystemModule& module = modules_[number];
  std::vector<Connection> inputs;
  inputs.reserve(module.inputs.size());
  for (std::size_t i = 0; i < module.inputs.size(); ++i) {
    inputs.push_back(
        {module.ports[i], modules_[module.inputs[i]].output, modules_[module.inputs[i]].rates});
  }
  if (!inputs.empty()) module.rates = inputs.front().rates;
  Table& settings = description_.modules[number].settings;
  for (Table::Entry& decided : module.module->decide(inputs, layout_).entries) {
    if (decided.name == "iterations" && is_drawn_by_a_phase(description_, module.name)) continue;
    set_entry(settings, std::move(decided));
  }
  auto output = module.module->connect(inputs);
  if (output) {
    module.output = std::move(*output);
    if (module.module->chooses_frames()) module.output.clock = module.name;
    return {};
  }
  Error error = std::move(output.error());
  const std::string port = std::move(error.where);
  error.where.clear();
  return fail(port.empty() ? at_module(std::move(error), number)
                           : at_port(std::move(error), number, port));
}

Result<void> System::plan_phases() {
  SOMATO_TRY(auto phases, somato::plan_phases(*this));
  phases_ = std::move(phases);
  return {};
}

Result<std::size_t> System::find(const std::string& name, const std::string& where) const {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < description_.modules.size(); ++i) {
    if (description_.modules[i].name == name) return i;
    known.push_back(description_.modules[i].name);
  }
  return fail(unknown_name("module", name, where, known));
}

bool System::is_fixed(std::size_t module) const {
  for (std::size_t i = 0; i < modules_.size(); ++i) {
    if (modules_[i].module->learner() == nullptr) continue;
    if (i == module || wiring_->reaches(i, module)) return false;
  }
  return true;
}

Error System::at_module(Error error, std::size_t module) const {
  // An error of a description has its line; one of the data, such as an element, is included.
  const bool inside = error.kind == ErrorKind::kData;
  const std::string& own = modules_[module].where;
  const std::string& line = error.where.empty() || inside ? own : error.where;
  const std::string detail = inside && !error.where.empty() ? ", " + error.where : "";
  error.where =
      line + (line.empty() ? "" : ", ") + "module '" + modules_[module].name + "'" + detail;
  return error;
}

Error System::at_port(Error error, std::size_t module, const std::string& port) const {
  const Table::Entry* entry = find_entry(description_.modules[module], port);
  if (error.where.empty() && entry) error.where = entry->where;
  error = at_module(std::move(error), module);
  error.where += ", port '" + port + "'";
  return error;
}

}  // namespace somato
