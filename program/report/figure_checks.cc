#include "report/figure_checks.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/core/contains.h"
#include "somato/core/parameter.h"
#include "somato/core/value.h"

namespace somato::program {
namespace {

const std::vector<std::string> kEndings{"svg", "pdf", "png", "tex", "csv", "txt", "bib"};
const std::vector<std::string> kOfPictures{"svg", "pdf", "png"};

// The figures of several systems begin with the name of their system.
Error unknown_figure(const std::string& name, const std::vector<std::string>& known) {
  std::vector<std::string> longer;
  for (const std::string& one : known) {
    if (one.ends_with("-" + name)) longer.push_back(one);
  }
  Error error = unknown_name("figure", name, "figure", known);
  if (!longer.empty()) error.advice = fmt::format("did you mean {}?", fmt::join(longer, " or "));
  return error;
}

}  // namespace

std::string ending_of(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending.empty() ? ending : ending.substr(1);
}

Result<void> check_listing(const Arguments& arguments) {
  for (const std::string flag : {"output", "width", "caption", "selection"}) {
    if (!arguments.has(flag)) continue;
    return fail(ErrorKind::kUsage, "has no effect without the NAME of a figure", "--" + flag,
                "'somato figure RESULTS' lists the names");
  }
  return {};
}

Result<void> check_saving(const Arguments& arguments) {
  if (arguments.has("json")) {
    return fail(ErrorKind::kUsage, "has no effect with the NAME of a figure", "--json", "omit it");
  }
  if (!arguments.has("output")) {
    return fail(ErrorKind::kUsage, "a file is missing", "figure",
                "name it with -o, such as -o figure.pdf");
  }
  const std::string path = arguments.text("output");
  const std::string ending = ending_of(path);
  if (!contains(kEndings, ending)) {
    return fail(ErrorKind::kUsage, "the format follows from the ending of the file", path,
                fmt::format("known are: .{}", fmt::join(kEndings, ", .")));
  }
  for (const std::string flag : {"width", "caption"}) {
    if (!arguments.has(flag) || contains(kOfPictures, ending)) continue;
    return fail(ErrorKind::kUsage, fmt::format("has no effect on a file .{}", ending), "--" + flag,
                "omit it, or save a picture");
  }
  return {};
}

Result<void> check_known(const std::vector<ListedFigure>& figures, const FigureRequest& request) {
  std::vector<std::string> names;
  for (const ListedFigure& one : figures) {
    names.push_back(one.name);
    if (one.name != request.name) continue;
    if (contains(one.endings, request.ending)) return {};
    return fail(ErrorKind::kUsage, fmt::format("it cannot be saved as .{}", request.ending),
                request.name, fmt::format("known are: .{}", fmt::join(one.endings, ", .")));
  }
  return tl::unexpected(unknown_figure(request.name, names));
}

}  // namespace somato::program
