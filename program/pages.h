#pragma once

#include <string_view>
#include <vector>

namespace somato::program {

/// A file of the web front end that the program carries with it.
struct Page {
  std::string_view name;  ///< "report.html", "view.html", "view.js" or "view.css".
  std::string_view text;
};

/// All of them, written by the build from the folder web; none where it was built without npm.
const std::vector<Page>& pages();

}  // namespace somato::program
