#include <cstdint>
#include <string>

#include "somato/core/check.h"
#include "views/report/report.h"
#include "views/report/results_file.h"

// An accepted document makes a report, or is refused by it, and nothing in the page ends its
// element.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  auto results = somato::parse_results(text, "input");
  if (!results) return 0;
  const auto report = somato::make_report({{"input", std::move(*results)}}, {});
  if (!report) return 0;
  const auto page = somato::report_page(
      R"(<script type="application/json" id="report-data">null</script>)", report->json);
  SOMATO_ASSERT(page && page->find("</script>") + 9 == page->size());
  return 0;
}
