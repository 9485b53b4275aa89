#include <fmt/format.h>

#include "base/support/places.h"
#include "program/support/program_test.h"

namespace somato {
namespace {

class Reference : public ProgramTest {};

TEST_F(Reference, PagesAreWhatTheProgramPrints) {
  const std::vector<std::pair<std::string, Words>> pages{{"flags-and-keys.md", {"reference"}},
                                                         {"modules.md", {"modules", "--markdown"}}};
  for (const auto& [name, words] : pages) {
    const std::string page = "docs/reference/" + name;
    EXPECT_TRUE(output_of(words) == bytes_of(source_path(page)))
        << fmt::format("{0} is not what the program prints. Make it anew: {1} {2} > {0}", page,
                       "build/dev/somato", fmt::join(words, " "));
  }
}

}  // namespace
}  // namespace somato
