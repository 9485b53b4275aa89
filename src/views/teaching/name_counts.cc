#include "views/teaching/name_counts.h"

#include <algorithm>

namespace somato::live {
namespace {

std::vector<NameCount>::iterator find(std::vector<NameCount>& counts, const std::string& name) {
  return std::find_if(counts.begin(), counts.end(),
                      [&](const NameCount& one) { return one.name == name; });
}

}  // namespace

std::vector<NameCount> NameCounts::planned() const {
  std::vector<NameCount> counts;
  counts.reserve(planned_.size());
  for (const std::string& name : planned_) counts.push_back({name, 0});
  return counts;
}

std::vector<NameCount>& NameCounts::counts(const std::string& label) {
  const auto found = counts_.find(label);
  return found != counts_.end() ? found->second : counts_.emplace(label, planned()).first->second;
}

void NameCounts::add(const Label& label) {
  if (label.value == "unknown") return;
  auto& counts = this->counts(label.name);
  auto found = find(counts, label.value);
  if (found == counts.end()) found = counts.insert(found, {label.value, 0});
  ++found->explorations;
}

void NameCounts::remove(const Label& label) {
  if (label.value == "unknown") return;
  auto& counts = this->counts(label.name);
  const auto found = find(counts, label.value);
  if (found == counts.end() || found->explorations == 0) return;
  --found->explorations;
  const bool is_last = found + 1 == counts.end() && counts.size() > planned_.size();
  if (is_last && found->explorations == 0) counts.pop_back();
}

std::vector<NameCount> NameCounts::of(const std::string& label) const {
  const auto found = counts_.find(label);
  return found != counts_.end() ? found->second : planned();
}

std::optional<NameCount> NameCounts::next(const std::string& label) const {
  std::vector<NameCount> counts = of(label);
  if (!planned_.empty()) counts.resize(planned_.size());
  for (const NameCount& one : counts) {
    if (one.explorations < each_) return NameCount{one.name, one.explorations + 1};
  }
  return {};
}

}  // namespace somato::live
