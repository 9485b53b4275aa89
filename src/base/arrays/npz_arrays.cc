#include "base/arrays/npz_arrays.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/core/memory.h"

namespace somato {
namespace {

constexpr std::string_view kEnding = ".npy";

}  // namespace

Result<NpzArrays> NpzArrays::open(std::string_view bytes, const std::string& where) {
  SOMATO_TRY(ZipReader archive, ZipReader::open(bytes, where));
  return NpzArrays(std::move(archive), where);
}

std::vector<std::string> NpzArrays::names() const {
  std::vector<std::string> names;
  names.reserve(archive_.members().size());
  for (const ZipReader::Member& member : archive_.members()) {
    if (!member.name.ends_with(kEnding)) continue;
    names.push_back(member.name.substr(0, member.name.size() - kEnding.size()));
  }
  return names;
}

Result<std::string> NpzArrays::read(const std::string& name) const {
  const ZipReader::Member* member = find(name);
  if (member == nullptr) {
    return fail(ErrorKind::kData, fmt::format("the array '{}' is missing", name), where_,
                "save the file again");
  }
  return archive_.read(*member);
}

Result<std::vector<double>> NpzArrays::numbers(const std::string& name) const {
  SOMATO_TRY(const std::string bytes, read(name));
  SOMATO_TRY(const NpyLayout layout, npy_layout_of_any(bytes, bytes.size(), place_of(name)));
  SOMATO_TRY_VOID(check_free_memory(layout.rows * layout.columns, sizeof(double), place_of(name)));
  std::vector<double> numbers(layout.rows * layout.columns);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = layout.type->read(bytes.data() + layout.start + i * layout.type->size);
  }
  return numbers;
}

const ZipReader::Member* NpzArrays::find(const std::string& name) const {
  const auto found = std::find_if(
      archive_.members().begin(), archive_.members().end(),
      [&](const ZipReader::Member& member) { return member.name == name + std::string(kEnding); });
  return found == archive_.members().end() ? nullptr : &*found;
}

}  // namespace somato
