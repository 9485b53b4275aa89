#include "somato/graph/t_mpsom_model.h"

#include <utility>

#include "graph/model_parts.h"
#include "somato/maps/t_mpsom_archive.h"

namespace somato {
namespace {

const std::string kTMpsomKind = "t_mpsom";
const std::string kTMpsomPrefix = "t_mpsom.";

Archive archive_of(const TMpsom& map) {
  Archive archive(kTMpsomKind);
  add_t_mpsom(archive, kTMpsomPrefix, map);
  return archive;
}

std::set<std::string> parts_of(const TMpsom& map) {
  std::set<std::string> names;
  const Archive archive = archive_of(map);
  for (const Archive::Entry& entry : archive.entries()) names.insert(entry.name);
  return names;
}

}  // namespace

Result<void> save_t_mpsom(const std::string& path, const TMpsom& map) {
  return save_archive(path, archive_of(map));
}

Result<TMpsom> load_t_mpsom(const std::string& path) {
  auto archive = load_archive(path);
  if (!archive) return fail(std::move(archive.error()));
  if (auto right = check_kind(*archive, kTMpsomKind, path); !right) return fail(right.error());
  auto map = t_mpsom_from(*archive, kTMpsomPrefix, path);
  if (!map) return map;
  if (auto known = check_parts(*archive, parts_of(*map), path); !known) return fail(known.error());
  return map;
}

}  // namespace somato
