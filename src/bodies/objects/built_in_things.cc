#include "bodies/objects/built_in_things.h"

#include <algorithm>
#include <iterator>

namespace somato {
namespace {

std::vector<Object> read_built_in_objects() {
  std::vector<Object> objects;
  for (const std::string& name : own_object_tables()) {
    auto table = own_object_table(name, declared_materials());
    if (!table) continue;  // not in an intact program
    std::move(table->objects.begin(), table->objects.end(), std::back_inserter(objects));
  }
  return objects;
}

template <typename Thing>
bool are_among(const std::vector<Thing>& things, const std::vector<Thing>& known) {
  return std::all_of(things.begin(), things.end(), [&](const Thing& thing) {
    return std::find(known.begin(), known.end(), thing) != known.end();
  });
}

}  // namespace

const std::vector<Object>& built_in_objects() {
  static const std::vector<Object> objects = read_built_in_objects();
  return objects;
}

bool are_built_in(const ObjectTable& table) {
  return are_among(table.objects, built_in_objects()) &&
         are_among(table.materials, declared_materials());
}

}  // namespace somato
