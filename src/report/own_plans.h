#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "somato/recording/layout.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/reproduction_plan.h"

namespace somato::detail {

/// What the files that travel with the library say of what was run.
class OwnPlans {
 public:
  /// What a file says beside the study itself.
  struct Own {
    std::vector<Claim> claims;      ///< Of the whole file.
    std::vector<Settings> explore;  ///< Of its table [explore].
  };

  OwnPlans() : own_(own_systems().value_or(OwnSystems{})) {}

  /// Of the part with these names and the same settings of modules, phases and labels; nothing when
  /// the library has none, or another one. `layout` is that of the recording, or empty.
  std::optional<Own> find(const PartResults& part, const RecordingLayout& layout);

 private:
  const ReproductionPlan& plan_of(const NamedFile& file, const std::string& kind);
  std::optional<Own> find_in(const NamedFile& file, const std::string& kind,
                             const PartResults& part, const RecordingLayout& layout);

  OwnSystems own_;
  std::map<std::string, ReproductionPlan> plans_;
};

}  // namespace somato::detail
