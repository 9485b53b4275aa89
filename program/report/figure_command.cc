#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "flags/commands.h"
#include "flags/result_output.h"
#include "report/figure_checks.h"
#include "report/figure_page.h"
#include "report/figure_width.h"
#include "report/made_report.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

constexpr const char* kUsualWidth = "85mm";  // a column of most journals

Result<FigurePage> open_page(const Arguments& arguments) {
  const std::string width = arguments.has("width") ? arguments.text("width") : kUsualWidth;
  SOMATO_TRY(const auto millimetres, figure_width(width));
  SOMATO_TRY(const auto made, made_report(arguments, {arguments.text("RESULTS")}));
  for (const std::string& sentence : made.report.missing) {
    if (!arguments.has("json")) print_summary(sentence + "\n");
  }
  return FigurePage::open(made.page, millimetres);
}

Result<void> print_names(const Arguments& arguments) {
  SOMATO_TRY(auto page, open_page(arguments));
  SOMATO_TRY(const auto figures, page.list());
  std::size_t width = 0;
  for (const ListedFigure& one : figures) width = std::max(width, one.name.size());
  std::string text;
  for (const ListedFigure& one : figures) {
    text += fmt::format("{:<{}}  {} (.{})\n", one.name, width, printable(one.title),
                        fmt::join(one.endings, ", ."));
  }
  const auto of_figure = [](const ListedFigure& one) {
    return Table{
        {}, {entry("name", one.name), entry("title", one.title), entry("endings", one.endings)}};
  };
  print_result(arguments, text, Table{{}, {entry("figures", figures, of_figure)}});
  return {};
}

Result<void> save_figure(const Arguments& arguments) {
  const std::string path = arguments.text("output");
  const FigureRequest request{arguments.text("NAME"), ending_of(path), arguments.has("caption"),
                              arguments.has("selection") ? arguments.text("selection") : ""};
  SOMATO_TRY(auto page, open_page(arguments));
  SOMATO_TRY(const auto figures, page.list());
  SOMATO_TRY_VOID(check_known(figures, request));
  SOMATO_TRY(const auto bytes, page.file(request));
  if (stop_requested()) return fail(ErrorKind::kInterrupted, "the figure was not saved", path);
  SOMATO_TRY_VOID(save_whole(path, bytes));
  print_summary(fmt::format("{}: {}\n", path, request.name));
  return {};
}

Result<void> run_figure(const Arguments& arguments) {
  const bool saves = arguments.has("NAME");
  SOMATO_TRY_VOID(saves ? check_saving(arguments) : check_listing(arguments));
  catch_stop_requests();
  return saves ? save_figure(arguments) : print_names(arguments);
}

}  // namespace

Command figure_command() {
  std::vector<Flag> flags{
      output_flag("-o,--output",
                  "File for the figure: .svg, .pdf or .png; .tex or .csv for a table, .tex or .txt "
                  "for the methods, .bib for the references"),
      {"--width", "Width of the picture, such as 85mm, 8.5cm or 3.3in. Default: 85mm"},
      {"--caption", "Whether the picture contains its title and its caption", false, false},
      {"--selection",
       "What is shown of a system, as in an address of the report, such as label=shape&run=2"},
      json_flag()};
  for (Flag& flag : report_source_flags()) flags.push_back(std::move(flag));
  return {
      "figure",
      "Save a figure or a table of the report, or the methods, for a paper; requires the "
      "program chromium",
      {{"RESULTS",
        "results.json of a study or a reproduction, inference.json of an inference, or the folder"},
       {"NAME", "Name of the figure; without it, all names are listed", false, false,
        Role::kValue}},
      std::move(flags),
      {},
      run_figure};
}

}  // namespace somato::program
