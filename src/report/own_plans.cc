#include "report/own_plans.h"

#include <algorithm>
#include <utility>

#include "report/rebuilt_study.h"
#include "studies/settings.h"

namespace somato::detail {
namespace {

// Those that decide what a metric of a study means.
bool asks_the_same(const std::vector<Settings>& own, const std::vector<Settings>& other) {
  const auto same = [&](const std::string& name) {
    const std::string* mine = find_setting(own, "study", name);
    const std::string* theirs = find_setting(other, "study", name);
    return mine && theirs && *mine == *theirs;
  };
  return same("label") && same("only") && same("labels") && same("individual") && same("order") &&
         same("within") && same("map");
}

bool is_same(const ReproductionPart& own, const PartResults& part, const RecordingLayout& layout) {
  if (own.question != part.question || own.system != part.system ||
      own.variation != part.variation) {
    return false;
  }
  const auto system = System::build(own.description.system, layout);
  if (!system) return false;
  const auto settings = study_settings(own.description, *system);
  return same_system(settings, part.settings) && asks_the_same(settings, part.settings);
}

}  // namespace

std::optional<OwnPlans::Own> OwnPlans::find(const PartResults& part,
                                            const RecordingLayout& layout) {
  const auto look_in = [&](const std::vector<NamedFile>& files, const std::string& kind,
                           const std::string& name) -> std::optional<Own> {
    for (const NamedFile& file : files) {
      if (file.name != name) continue;
      if (auto own = find_in(file, kind, part, layout)) return own;
    }
    return {};
  };
  if (!part.question.empty()) return look_in(own_.questions, "questions", part.question);
  if (auto own = look_in(own_.systems, "systems", part.system)) return own;
  return look_in(own_.recorded, "recorded", part.system);
}

std::optional<OwnPlans::Own> OwnPlans::find_in(const NamedFile& file, const std::string& kind,
                                               const PartResults& part,
                                               const RecordingLayout& layout) {
  const ReproductionPlan& plan = plan_of(file, kind);
  const auto found =
      std::find_if(plan.parts.begin(), plan.parts.end(),
                   [&](const ReproductionPart& own) { return is_same(own, part, layout); });
  if (found == plan.parts.end()) return {};
  return Own{plan.claims, explore_settings(found->explore)};
}

const ReproductionPlan& OwnPlans::plan_of(const NamedFile& file, const std::string& kind) {
  const auto [entry, is_new] = plans_.try_emplace(kind + "/" + file.name);
  if (is_new) {
    if (!add_to_plan(file, own_.systems, entry->second)) entry->second = {};
  }
  return entry->second;
}

}  // namespace somato::detail
