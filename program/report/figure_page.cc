#include "report/figure_page.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/files/whole_file.h"
#include "report/pdf_box.h"
#include "terminal/base64.h"

namespace somato::program {
namespace {

using SortedJson = nlohmann::json;

// The window in which the parts of the page are drawn.
constexpr std::size_t kFigureWidth = 1280;
constexpr std::size_t kFigureHeight = 800;

ListedFigure listed(const SortedJson& one) {
  return {one.at("name"), one.at("title"), one.at("endings").get<std::vector<std::string>>()};
}

}  // namespace

Result<FigurePage> FigurePage::open(const std::string& page, double width) {
  SOMATO_TRY(auto folder, ScratchFolder::create());
  const std::string path = folder.path() + "/report.html";
  SOMATO_TRY_VOID(save_whole(path, page));
  const std::string address = fmt::format("{}#figures-only?width={}", file_address(path), width);
  SOMATO_TRY(auto browser, HeadlessBrowser::open(address, kFigureWidth, kFigureHeight));
  SOMATO_TRY_VOID(browser.wait_until(
      "location.protocol === \"file:\" && document.readyState === \"complete\""));
  return FigurePage(std::move(folder), std::move(browser));
}

Result<std::vector<ListedFigure>> FigurePage::list() {
  SOMATO_TRY(const auto all, browser_.value_of("somatoFigures.list()"));
  std::vector<ListedFigure> figures;
  for (const SortedJson& one : all) figures.push_back(listed(one));
  return figures;
}

Result<std::string> FigurePage::file(const FigureRequest& request) {
  const SortedJson wanted{{"name", request.name},
                          {"ending", request.ending},
                          {"caption", request.has_caption},
                          {"selection", request.selection}};
  SOMATO_TRY(const auto made,
             browser_.value_of(fmt::format("somatoFigures.file({})", wanted.dump())));
  if (made.contains("problem")) return fail(ErrorKind::kUsage, made["problem"], request.name);
  if (made.contains("text")) return made["text"].get<std::string>();
  if (made.contains("base64")) return from_base64(made["base64"].get_ref<const std::string&>());
  return printed(made["page"], made["width"], made["height"]);
}

// The page of the report permits no fonts, so that the picture has a page of its own.
Result<std::string> FigurePage::printed(const std::string& page, double width, double height) {
  const std::string path = folder_.path() + "/figure.html";
  SOMATO_TRY_VOID(save_whole(path, page));
  SOMATO_TRY_VOID(browser_.go_to(file_address(path)));
  SOMATO_TRY_VOID(browser_.wait_until(
      "document.documentElement?.dataset.picture !== undefined && "
      "document.readyState === \"complete\" && document.fonts.status === \"loaded\""));
  return browser_.printed(width + kAroundPicture, height + kAroundPicture)
      .map([&](std::string pdf) { return cut_page(std::move(pdf), width, height); });
}

}  // namespace somato::program
