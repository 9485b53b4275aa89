#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/random.h"
#include "somato/graph/module.h"

namespace somato::testing {

/// Writes a random system: mostly what fits, sometimes what does not. Each statement draws in a
/// defined order, so that a seed gives the same system with every compiler.
class RandomSystem {
 public:
  explicit RandomSystem(std::uint64_t seed) : random_(seed), wildness_(kWildness[seed % 4]) {}

  std::string write() {
    for (const char* channel : {"height", "joints", "touch", "sound"}) {
      if (channel == std::string("sound") && random_.below(2) == 0) continue;
      text_ += fmt::format("[module.{0}]\ntype = \"channel\"\nchannel = \"{0}\"\n", channel);
      names_.push_back({channel, channel == std::string("sound") ? "sound" : "hand"});
    }
    const std::size_t count = 1 + random_.below(6);
    for (std::size_t i = 0; i < count; ++i) write_module(fmt::format("m{}", i));
    if (random_.below(4) == 0) write_loop();
    if (random_.below(8) == 0) write_pair();
    const std::size_t phases = random_.below(3);
    for (std::size_t i = 0; i < phases && !learners_.empty(); ++i) write_phase();
    if (wild(4)) text_ += "[system]\nnme = 3\n";
    return text_;
  }

 private:
  static constexpr std::size_t kWildness[] = {0, 1, 2, 6};

  // True in `wildness_` of `rarity` x 50 cases.
  bool wild(std::size_t rarity = 1) { return random_.below(50 * rarity) < wildness_; }

  template <typename T>
  const T& any(const std::vector<T>& all) {
    return all[random_.below(all.size())];
  }

  std::string misspelt(std::string name) {
    if (wild(2)) name.insert(random_.below(name.size() + 1), 1, 'x');
    return name;
  }

  // The name of a module, and which others it can stand beside: "once" an exploration, or those
  // whose frames go together.
  struct Name {
    std::string name;
    std::string group;
  };

  // The latest as often as all others, so that chains become long.
  const Name& any_before() { return random_.below(2) == 0 ? names_.back() : any(names_); }

  // Something before that fits beside the first input, or rarely anything.
  std::string input() {
    if (wild(2)) return fmt::format("m{}", random_.below(7));
    for (int attempt = 0; attempt < 20; ++attempt) {
      const Name& name = any_before();
      if (group_.empty() && takes_frames_ && name.group == "once") continue;
      if (!group_.empty() && name.group != group_) continue;
      group_ = name.group;
      return name.name;
    }
    return any_before().name;
  }

  std::string ports(const ModuleType& type) {
    std::string text;
    for (const InputPort& port : type.ports) {
      if (wild(2) || (!port.required && random_.below(3) != 0)) continue;
      text += misspelt(port.name) + " = ";
      if (!port.many) {
        text += wild(4) ? "[\"joints\"]\n" : fmt::format("\"{}\"\n", input());
        continue;
      }
      inputs_ = 1 + random_.below(2);
      text += fmt::format("[\"{}\"", input());
      for (std::size_t i = 1; i < inputs_; ++i) text += fmt::format(", \"{}\"", input());
      text += "]\n";
    }
    return text;
  }

  // A value of the parameter's kind, in its range or out of it, small enough to be quick.
  std::string value(const ParameterInfo& info) {
    if (wild(2))
      return any(std::vector<std::string>{"-1", "1e308", "\"nonsense\"", "[[]]", "nan",
                                          "9223372036854775807", "0", "true", "[]"});
    if (!info.choices.empty()) return "\"" + any(info.choices) + "\"";
    if (info.type.find("switch") != std::string::npos) return random_.below(2) ? "true" : "false";
    if (info.type.find("integer") != std::string::npos) {
      return fmt::format("{}", 1 + random_.below(4));
    }
    if (info.type.find("number") != std::string::npos) {
      const double least = wild() ? -1.0 : 0.0;
      return fmt::format("{}", least + static_cast<double>(random_.below(9)) / 4.0);
    }
    return "[\"1\"]";
  }

  void write_module(const std::string& name) {
    const std::vector<ModuleType>& types = module_types();
    const ModuleType& type = types[1 + random_.below(types.size() - 1)];
    const std::vector<std::string> closing{
        "first", "last", "change", "resampling", "accumulate", "spectrum", "leaky_accumulate"};
    const std::vector<std::string> others{"onset_window", "mean_removal", "delay", "tare",
                                          "high_pass"};
    const auto is_one_of = [&](const std::vector<std::string>& names) {
      return std::find(names.begin(), names.end(), type.name) != names.end();
    };
    takes_frames_ = is_one_of(closing) || is_one_of(others);
    group_.clear();
    text_ += fmt::format("[module.{}]\ntype = \"{}\"\n", name, misspelt(type.name));
    inputs_ = 1;
    text_ += ports(type);
    text_ += fitting_parameters(type.name);
    for (const ParameterInfo& info : type.parameters) {
      if (is_given(type.name, info.name) || random_.below(8) != 0) continue;
      const std::string key = misspelt(info.name);
      text_ += fmt::format("{} = {}\n", key, value(info));
    }
    if (is_one_of(closing)) group_ = "once";
    if (type.name == "onset_window") group_ = name;
    names_.push_back({name, group_});
    if (type.name == "som" || type.name == "t_mpsom" || (type.learns && wild())) {
      learners_.push_back(name);
    }
  }

  // The parameters that make a type quick and, mostly, valid.
  std::string fitting_parameters(const std::string& type) {
    if (type == "som") return fmt::format("rows = {}\ncolumns = 2\n", 1 + random_.below(3));
    if (type == "t_mpsom") return inputs_ == 1 ? "shape = [3]\n" : "shape = [2, 3]\n";
    if (type.starts_with("growing_")) {
      return type == "growing_cells" ? "most_neurons = 6\ninsertion_interval = 5\n"
                                     : "most_neurons = 6\n";
    }
    if (type == "one_hot") {
      return random_.below(3) == 0 ? "outside = \"clamp\"\n"
                                   : "low = -1\nhigh = 2\noutside = \"clamp\"\n";
    }
    if (type == "number_code") return "bits = 3\noutside = \"clamp\"\n";
    if (type == "onset_window") return "threshold = 0\nlength = 3\nbeyond = \"hold\"\n";
    if (type == "spectrum") return "segment_length = 4\nbands = 3\nhigh = 30\n";
    if (type == "standardization") return "constant_columns = \"zero\"\n";
    if (type == "high_pass") return "rate = 20\n";
    if (type == "resampling") return "points = 3\n";
    return {};
  }

  static bool is_given(const std::string& type, const std::string& name) {
    const std::vector<std::string> given{"rows",
                                         "columns",
                                         "shape",
                                         "low",
                                         "high",
                                         "outside",
                                         "bits",
                                         "threshold",
                                         "length",
                                         "beyond",
                                         "segment_length",
                                         "bands",
                                         "constant_columns",
                                         "points",
                                         "iterations",
                                         "most_neurons",
                                         "insertion_interval",
                                         "transform_length"};
    return (type != "som" || name != "outside") &&
           std::find(given.begin(), given.end(), name) != given.end();
  }

  // A leaky memory around something that learns or does not.
  void write_loop() {
    const std::string shape = wild() ? "[4]" : "[3]";
    text_ += fmt::format("[module.in]\ntype = \"concatenation\"\ninputs = [\"{}\", \"back\"]\n",
                         wild() ? any_before().name : "joints");
    switch (random_.below(4)) {
      case 0:
        text_ +=
            "[module.out]\ntype = \"som\"\ninput = \"in\"\nrows = 3\ncolumns = 1\n"
            "initial_weights = \"uniform\"\n";
        learners_.emplace_back("out");
        text_ += fmt::format("[module.flat]\ntype = \"concatenation\"\ninputs = [\"out\"]\n");
        break;
      case 1:
        text_ += "[module.flat]\ntype = \"t_mpsom\"\ninputs = [\"in\"]\nshape = [3]\n";
        learners_.emplace_back("flat");
        break;
      case 2:
        text_ += "[module.flat]\ntype = \"sum\"\ninputs = [\"joints\", \"back\"]\n";
        break;
      default:
        text_ +=
            "[module.grown]\ntype = \"scale\"\nfactor = 1e20\ninput = \"back\"\n"
            "[module.flat]\ntype = \"sum\"\ninputs = [\"joints\", \"grown\"]\n";
        break;
    }
    const bool delays = !wild();
    text_ +=
        fmt::format("[module.back]\ntype = \"{}\"\ninput = \"flat\"\n", delays ? "delay" : "scale");
    if (delays && !wild()) text_ += fmt::format("shape = {}\n", shape);
    names_.push_back({"in", "hand"});
  }

  // Two maps that learn together, one from the other.
  void write_pair() {
    const bool frames = random_.below(2) == 0;
    text_ += fmt::format(
        "[module.closed]\ntype = \"last\"\ninput = \"joints\"\n"
        "[module.lower]\ntype = \"som\"\ninput = \"{}\"\nrows = 2\n"
        "columns = 2\n[module.upper]\ntype = \"t_mpsom\"\nshape = [3]\n"
        "inputs = [\"lower\"]\n[[phase]]\nlearn = [\"upper\", \"lower\"]\n",
        frames ? "joints" : "closed");
    if (!wild()) text_ += "draws = 9\n";
    names_.push_back({"upper", frames ? "hand" : "once"});
  }

  void write_phase() {
    text_ += "[[phase]]\nlearn = [";
    const std::size_t count = 1 + random_.below(2);
    for (std::size_t i = 0; i < count && !learners_.empty(); ++i) {
      const std::size_t which = random_.below(learners_.size());
      text_ += fmt::format("{}\"{}\"", i == 0 ? "" : ", ", misspelt(learners_[which]));
      if (!wild()) learners_.erase(learners_.begin() + static_cast<std::ptrdiff_t>(which));
    }
    text_ += fmt::format("]\ndraws = {}\n", 1 + random_.below(20));
    if (random_.below(4) == 0) text_ += "order = \"without_replacement\"\n";
    if (wild()) text_ += "of = \"explorations\"\n";
  }

  Random random_;
  std::size_t wildness_;
  std::string text_;
  std::vector<Name> names_;
  std::vector<std::string> learners_;
  std::size_t inputs_ = 1;
  std::string group_;
  bool takes_frames_ = false;
};

}  // namespace somato::testing
