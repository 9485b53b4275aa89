#include "view/planned_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "base/text/text.h"
#include "views/session/view_command.h"

namespace somato::program {
namespace {

tl::unexpected<Error> refuse(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what), "--names", "write cup,ball,sponge");
}

Result<std::vector<std::string>> read_names(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& name : split(text, ',')) {
    if (!is_name(name) || name == "unknown") return refuse(fmt::format("'{}' is no name", name));
    const bool is_repeated = std::find(names.begin(), names.end(), name) != names.end();
    if (is_repeated) return refuse(fmt::format("'{}' is there twice", name));
    names.push_back(name);
  }
  return names;
}

}  // namespace

std::vector<Flag> planned_name_flags() {
  return {
      {"--names",
       "Names for what is explored, separated by commas: the keys 1 to 9 of the page give the "
       "first nine"},
      {"--each",
       "Number of explorations of each name, 1 to 1000: the page proposes the next name. Default: "
       "no plan"}};
}

Result<void> plan_names(const Arguments& arguments, ViewSource& source) {
  if (arguments.has("names")) {
    SOMATO_TRY(source.names, read_names(arguments.text("names")));
  }
  SOMATO_TRY(const auto each, arguments.number("each", 1));
  source.each = each.value_or(0);
  if (source.each <= live::kMostPlanned) return {};
  return fail(ErrorKind::kUsage, "at most 1000 explorations of each name are planned", "--each");
}

}  // namespace somato::program
