#include "systems/model/model_parts.h"

#include "maps/som/map_parts.h"

namespace somato {

Result<void> check_kind(const Archive& archive, const std::string& kind, const std::string& where) {
  if (archive.kind() == kind) return {};
  return fail(ErrorKind::kData, "the file contains '" + archive.kind() + "', not '" + kind + "'",
              where, "use the file of another model");
}

Result<void> check_parts(const Archive& archive, const std::set<std::string>& known,
                         const std::string& where) {
  for (const Archive::Entry& entry : archive.entries()) {
    if (!known.contains(entry.name)) {
      return damaged_model("the model has an unknown part '" + entry.name + "'", where);
    }
  }
  return {};
}

}  // namespace somato
