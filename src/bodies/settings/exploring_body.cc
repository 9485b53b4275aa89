#include "somato/simulation/simulated_explorer.h"

#include <utility>

namespace somato {

const std::vector<std::pair<ExploringBody, std::string>>& Choices<ExploringBody>::all() {
  static const std::vector<std::pair<ExploringBody, std::string>> choices = {
      {ExploringBody::kLucs2, "lucs2"},     {ExploringBody::kLucs3, "lucs3"},
      {ExploringBody::kTexture, "texture"}, {ExploringBody::kHardness, "hardness"},
      {ExploringBody::kProbes, "probes"},   {ExploringBody::kAllSenses, "all_senses"}};
  return choices;
}

bool is_probe(ExploringBody body) {
  return body == ExploringBody::kTexture || body == ExploringBody::kHardness ||
         body == ExploringBody::kProbes;
}

Result<ObjectTable> default_things(ExploringBody body) {
  const auto& materials = declared_materials();
  if (is_probe(body)) return ObjectTable{{}, materials};
  return (body == ExploringBody::kLucs2 ? lucs2_objects(materials) : lucs3_objects(materials))
      .map([](std::vector<Object> objects) { return ObjectTable{std::move(objects), {}}; });
}

Result<void> check_effect(ExploringBody body, const Table& given) {
  for (const Table::Entry& entry : given.entries) {
    if (entry.name == "true_values") continue;
    if (is_probe(body) || (entry.name == "taxels" && body == ExploringBody::kLucs2)) {
      return fail(ErrorKind::kUsage, "has no effect on the body " + choice_name(body), entry.where,
                  "omit it");
    }
  }
  return {};
}

}  // namespace somato
