#include "systems/model/element_names.h"

#include <algorithm>
#include <iterator>

#include "base/core/contains.h"
#include "somato/graph/module.h"

namespace somato {
namespace {

// Each element of their output comes from the element of their input at the same place.
const std::vector<std::string> kElementwise{"first",         "last",           "mean",
                                            "change",        "accumulate",     "leaky_accumulate",
                                            "scale",         "delay",          "mean_removal",
                                            "high_pass",     "tare",           "logarithm",
                                            "normalization", "standardization"};

class ElementNames {
 public:
  explicit ElementNames(const System& system) : system_(system) {}

  std::vector<std::string> of(std::size_t module) const {
    const SystemModule& own = system_.modules()[module];
    std::vector<std::string> names;
    if (const auto* source = dynamic_cast<const Source*>(own.module.get())) {
      names = of_channel(module, *source);
    } else if (contains(kElementwise, own.type->name)) {
      names = of(own.inputs.front());
    } else if (own.type->name == "concatenation") {
      for (const std::size_t input : own.inputs) std::ranges::copy(of(input), back(names));
    }
    return names.size() == own.output.size() ? names : of_module(module);
  }

 private:
  static std::back_insert_iterator<std::vector<std::string>> back(std::vector<std::string>& names) {
    return std::back_inserter(names);
  }

  static void prefix(std::vector<std::string>& names, const std::string& with) {
    for (std::string& name : names) name.insert(0, with + " ");
  }

  std::vector<std::string> of_module(std::size_t module) const {
    std::vector<std::string> names = numbers_as_names(system_.modules()[module].output.size());
    prefix(names, system_.modules()[module].name);
    return names;
  }

  std::vector<std::string> of_channel(std::size_t module, const Source& source) const {
    std::vector<std::string> names;
    for (const ChannelLayout& channel : system_.layout().channels) {
      if (channel.name != source.channel()) continue;
      names = taken_elements(system_.description().modules[module].settings, channel.element_names);
    }
    const std::size_t elements = system_.modules()[module].output.size();
    const bool are_named = names.size() == elements;
    if (!are_named) names = numbers_as_names(elements);
    if (are_named && system_.layout().channels.size() == 1) return names;
    prefix(names, source.channel());
    return names;
  }

  const System& system_;
};

}  // namespace

std::vector<std::string> taken_elements(const Table& settings,
                                        const std::vector<std::string>& all) {
  const Table::Entry* entry = settings.find("elements");
  const auto* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  const auto* list = value ? std::get_if<Value::List>(&value->content) : nullptr;
  std::vector<std::string> names;
  for (const Value& one : list ? *list : Value::List{}) {
    const auto* name = std::get_if<std::string>(&one.content);
    if (!name) return {};
    const auto number = std::find_if(all.begin(), all.end(), [&, i = 0U](const auto&) mutable {
      return std::to_string(++i) == *name;
    });
    const bool is_name = contains(all, *name) || number == all.end();
    names.push_back(is_name ? *name : *number);
  }
  return names.empty() ? all : names;
}

std::vector<std::string> numbers_as_names(std::size_t count) {
  std::vector<std::string> names;
  names.reserve(count);
  for (std::size_t i = 1; i <= count; ++i) names.push_back(std::to_string(i));
  return names;
}

std::vector<std::string> element_names(const System& system, std::size_t module) {
  return ElementNames(system).of(module);
}

}  // namespace somato
