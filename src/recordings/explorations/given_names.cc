#include "recordings/explorations/given_names.h"

#include <algorithm>
#include <utility>

namespace somato {
namespace {

Label& find_or_add(std::vector<Label>& labels, const std::string& name) {
  const auto found = std::find_if(labels.begin(), labels.end(),
                                  [&](const Label& label) { return label.name == name; });
  return found != labels.end() ? *found : labels.emplace_back(Label{name, "unknown"});
}

}  // namespace

void GivenNames::give(std::size_t exploration, const Label& label) {
  std::optional<std::string> before = given(exploration, label.name);
  if (before == label.value) return;
  given_[exploration][label.name] = label.value;
  order_.push_back({exploration, label, std::move(before)});
}

void GivenNames::take_back() {
  const GivenName last = std::move(order_.back());
  order_.pop_back();
  auto& labels = given_[last.exploration];
  if (last.before) {
    labels[last.label.name] = *last.before;
    return;
  }
  labels.erase(last.label.name);
  if (labels.empty()) given_.erase(last.exploration);
  forgotten_.insert(last.label.name);
}

void GivenNames::forget(std::size_t exploration) {
  given_.erase(exploration);
  std::erase_if(order_, [&](const GivenName& one) { return one.exploration == exploration; });
}

void GivenNames::forget_before(std::size_t first) {
  const auto end = given_.lower_bound(first);
  for (auto gone = given_.begin(); gone != end; ++gone) {
    for (const auto& [name, value] : gone->second) forgotten_.insert(name);
  }
  given_.erase(given_.begin(), end);
  std::erase_if(order_, [&](const GivenName& one) { return one.exploration < first; });
}

std::optional<std::string> GivenNames::given(std::size_t exploration,
                                             const std::string& label) const {
  const auto labels = given_.find(exploration);
  if (labels == given_.end()) return {};
  const auto found = labels->second.find(label);
  return found == labels->second.end() ? std::nullopt : std::optional(found->second);
}

std::vector<Label> GivenNames::labels(std::size_t exploration, std::vector<Label> own) const {
  for (const std::string& name : forgotten_) find_or_add(own, name);
  for (const auto& [index, labels] : given_) {
    for (const auto& [name, value] : labels) {
      Label& label = find_or_add(own, name);
      if (index == exploration) label.value = value;
    }
  }
  return own;
}

Recording GivenNames::apply(const Recording& recording, std::size_t first) const {
  Recording named = recording;
  for (std::size_t i = 0; i < named.explorations.size(); ++i) {
    named.explorations[i].labels = labels(first + i, std::move(named.explorations[i].labels));
  }
  return named;
}

}  // namespace somato
