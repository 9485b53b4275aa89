#include "somato/studies/reproduction.h"

#include <algorithm>
#include <utility>

#include "somato/graph/system.h"
#include "studies/description/variation.h"

namespace somato {
namespace {

constexpr const char* kQuestion = "question";

const Table* table_named(const Table& file, const std::string& name) {
  const Table::Entry* entry = file.find(name);
  return entry ? std::get_if<Table>(&entry->content) : nullptr;
}

// The keys that a question may contain in addition to its changes.
bool belongs_to_question(const std::string& name) {
  return name == kQuestion || name == "variation" || name == "claim";
}

Result<QuestionParameters> read_question(const Table& file) {
  const Table* table = table_named(file, kQuestion);
  if (!table) {
    return fail(ErrorKind::kUsage, "'question' must be a table", file.find(kQuestion)->where,
                "write [question] on a separate line, its keys below");
  }
  auto question = read_parameters<QuestionParameters>(*table);
  if (!question) return question;
  if (question->name.empty() || question->systems.empty()) {
    return fail(ErrorKind::kUsage, "a question needs a name and systems", table->where,
                R"(add name = "..." and systems = ["..."] to [question])");
  }
  return question;
}

bool is_channel(const ModuleDescription& module) {
  const Table::Entry* type = module.settings.find("type");
  const Value* value = type ? std::get_if<Value>(&type->content) : nullptr;
  return value && *value == Value{"channel"};
}

bool states_shapes(const SystemDescription& system) {
  return std::all_of(system.modules.begin(), system.modules.end(), [](const auto& module) {
    return !is_channel(module) || module.settings.find("shape");
  });
}

// Errors in modules are reported before exploring, if they are already detectable.
Result<void> check_modules(const SystemDescription& system) {
  if (!states_shapes(system)) return {};
  RecordingLayout any_number;  // which decides automatic sizes
  any_number.explorations = 1;
  any_number.frames = 1;
  const auto built = System::build(system, any_number);
  return built ? Result<void>() : fail(built.error());
}

Result<ReproductionPart> part_of(const Table& file, const std::string& question,
                                 const std::string& variation, std::optional<std::size_t> pairs) {
  SOMATO_TRY(auto description, read_study(file));
  SOMATO_TRY_VOID(check_modules(description.system));
  ReproductionPart part{question, description.study.name, variation, {}, {}, pairs};
  part.description = std::move(description);
  if (const Table* explore = table_named(file, "explore")) part.explore = *explore;
  return part;
}

Result<void> add_part(const Table& file, const std::string& question, const std::string& variation,
                      std::optional<std::size_t> pairs, ReproductionPlan& plan) {
  SOMATO_TRY(auto part, part_of(file, question, variation, pairs));
  plan.parts.push_back(std::move(part));
  return {};
}

bool is_for(const Variation& variation, const std::string& system) {
  const auto& systems = variation.systems;
  return systems.empty() || std::find(systems.begin(), systems.end(), system) != systems.end();
}

// The file itself, if requested, and with each of the variations.
Result<void> add_variations(const Table& file, const std::string& system,
                            const std::string& question, const std::vector<Variation>& variations,
                            std::optional<std::size_t> pairs, ReproductionPlan& plan) {
  for (const Variation& variation : variations) {
    if (!is_for(variation, system)) continue;
    SOMATO_TRY(auto varied, with_changes(file, variation.changes));
    auto added = add_part(varied, question, variation.name, pairs, plan);
    if (!added) return added;
  }
  return {};
}

Result<const NamedFile*> find_system(const std::vector<NamedFile>& systems, const std::string& name,
                                     const std::string& where) {
  std::vector<std::string> known;
  for (const NamedFile& system : systems) {
    if (system.name == name) return &system;
    known.push_back(system.name);
  }
  return fail(unknown_name("system", name, where, known));
}

// The changes of a question for all of its variations: [study], [explore], [module.NAME].
Table common_changes(const Table& file) {
  Table changes{file.where, {}};
  for (const Table::Entry& entry : file.entries) {
    if (!belongs_to_question(entry.name)) changes.entries.push_back(entry);
  }
  return changes;
}

Result<void> check_names(const std::vector<Variation>& variations,
                         const std::vector<std::string>& systems) {
  for (const Variation& variation : variations) {
    for (const std::string& system : variation.systems) {
      if (std::find(systems.begin(), systems.end(), system) != systems.end()) continue;
      return fail(unknown_name("system of the question", system, variation.where, systems));
    }
  }
  return {};
}

Result<void> add_question(const NamedFile& file, const std::vector<NamedFile>& systems,
                          const std::vector<Variation>& variations, ReproductionPlan& plan) {
  SOMATO_TRY(const auto question, read_question(file.content));
  SOMATO_TRY_VOID(check_names(variations, question.systems));
  for (const std::string& name : question.systems) {
    SOMATO_TRY(const auto system,
               find_system(systems, name, table_named(file.content, kQuestion)->where));
    SOMATO_TRY(const auto changed, with_changes(system->content, common_changes(file.content)));
    Result<void> added = add_part(changed, question.name, {}, question.pairs, plan);
    if (added) {
      added = add_variations(changed, name, question.name, variations, question.pairs, plan);
    }
    if (!added) return added;
  }
  return {};
}

bool is_run(const ReproductionPlan& plan, std::size_t first, const std::string& system,
            const std::string& variation) {
  const auto begin = plan.parts.begin() + static_cast<std::ptrdiff_t>(first);
  return std::any_of(begin, plan.parts.end(), [&](const ReproductionPart& part) {
    return part.system == system && part.variation == variation;
  });
}

// Names both sides of a claim in the file of `system`.
void complete(Claim& claim, const std::string& system) {
  if (claim.system.empty()) claim.system = system;
  if (!claim.compares()) return;
  const bool same_map = claim.than_system.empty() && claim.than_variation.empty();
  if (same_map) claim.than_variation = claim.variation;
  if (claim.than_system.empty()) claim.than_system = claim.system;
}

bool compares_with_itself(const Claim& claim) {
  return claim.compares() && claim.system == claim.than_system &&
         claim.variation == claim.than_variation && claim.metric == claim.other_metric();
}

// Claims of a file are about the parts that it added.
Result<void> add_claims(const Table& file, std::size_t first_part, const std::string& question,
                        ReproductionPlan& plan) {
  SOMATO_TRY(auto claims, read_claims(file));
  for (Claim& claim : claims) {
    complete(claim, plan.parts[first_part].system);
    if (compares_with_itself(claim)) {
      return fail(ErrorKind::kUsage, "the claim compares a metric with itself", claim.where,
                  "use another than_system, than_variation or than_metric");
    }
    const bool compares = claim.compares();
    const bool other_file = question.empty() && compares && claim.than_system != claim.system;
    const bool known = is_run(plan, first_part, claim.system, claim.variation) &&
                       (!compares || other_file ||
                        is_run(plan, first_part, claim.than_system, claim.than_variation));
    if (!known) {
      return fail(ErrorKind::kUsage, "the claim refers to a system or variation that is not run",
                  claim.where, "use systems and variations of this file");
    }
    claim.question = question;
    plan.claims.push_back(std::move(claim));
  }
  return {};
}

// Without the tables within it.
std::vector<Setting> values_of(const Table& table) {
  std::vector<Setting> settings;
  for (const Table::Entry& entry : table.entries) {
    const auto* value = std::get_if<Value>(&entry.content);
    if (value) settings.push_back({entry.name, to_toml(*value)});
  }
  return settings;
}

// Adds those of the tables within it, and within these.
void add_inner_settings(const Table& table, const std::string& name, std::vector<Settings>& all) {
  for (const Table::Entry& entry : table.entries) {
    const auto* inner = std::get_if<Table>(&entry.content);
    if (!inner) continue;
    const std::string inner_name = name + "." + entry.name;
    auto settings = values_of(*inner);
    if (!settings.empty()) all.push_back({inner_name, std::move(settings)});
    add_inner_settings(*inner, inner_name, all);
  }
}

}  // namespace

const Declarations<QuestionParameters>& QuestionParameters::declarations() {
  using P = QuestionParameters;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(),
               "Name of the question, which is used in the results. Required.")
          .add("text", &P::text, "", Range::any(), "The question, in one sentence.")
          .add("systems", &P::systems, "", Range::any(),
               "Names of the built-in systems that the question is about.")
          .add("pairs", &P::pairs, "", Range::between(1, 1e6),
               "Maximum number of pairs of recording and seed for each variation.");
  return declared;
}

Result<void> add_to_plan(const NamedFile& file, const std::vector<NamedFile>& systems,
                         ReproductionPlan& plan) {
  SOMATO_TRY(const auto variations, read_variations(file.content));
  const std::size_t first = plan.parts.size();
  if (file.content.find(kQuestion)) {
    auto added = add_question(file, systems, variations, plan);
    if (!added) return added;
    return add_claims(file.content, first, plan.parts[first].question, plan);
  }
  Result<void> added = add_part(file.content, {}, {}, {}, plan);
  if (added) {
    plan.parts[first].description.text = file.text;
    added = add_variations(file.content, plan.parts[first].system, {}, variations, {}, plan);
  }
  return added ? add_claims(file.content, first, {}, plan) : added;
}

std::vector<Settings> explore_settings(const Table& explore) {
  std::vector<Settings> all;
  auto own = values_of(explore);
  if (!own.empty()) all.push_back({"explore", std::move(own)});
  add_inner_settings(explore, "explore", all);
  return all;
}

}  // namespace somato
