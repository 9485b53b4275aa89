#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/files/scratch_folder.h"
#include "somato/core/result.h"
#include "terminal/headless_browser.h"

namespace somato::program {

/// A figure, a table or a text of a report.
struct ListedFigure {
  std::string name;
  std::string title;
  std::vector<std::string> endings;  ///< The endings of its files, such as "pdf".
};

struct FigureRequest {
  std::string name;
  std::string ending;
  bool has_caption = false;  ///< Whether a picture contains its title and its caption.
  std::string selection;     ///< As in an address of the page, such as "label=shape&run=2".
};

/// The page of a report in a browser without a window, which draws figures for files. The page has
/// the object somatoFigures (web/src/report/paper/figure_files.ts) for this.
class FigurePage {
 public:
  /// Draws the figures of the page for a width in mm. Errors: those of HeadlessBrowser.
  static Result<FigurePage> open(const std::string& page, double width);

  /// All figures, in the order of the page. Errors: kSystem.
  Result<std::vector<ListedFigure>> list();

  /// The bytes of the file. Errors: kUsage if the figure has no such file or selection; kSystem.
  Result<std::string> file(const FigureRequest& request);

 private:
  FigurePage(ScratchFolder folder, HeadlessBrowser browser)
      : folder_(std::move(folder)), browser_(std::move(browser)) {}

  Result<std::string> printed(const std::string& page, double width, double height);

  ScratchFolder folder_;
  HeadlessBrowser browser_;
};

}  // namespace somato::program
