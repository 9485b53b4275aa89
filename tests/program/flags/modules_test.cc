#include "program/support/program_test.h"
#include "somato/graph/module.h"

namespace somato {
namespace {

class Modules : public ProgramTest {};

TEST_F(Modules, ListsEveryTypeWithItsPortsAndParameters) {
  const std::string all = output_of({"modules"});
  const std::string page = output_of({"modules", "--markdown"});
  for (const ModuleType& type : module_types()) {
    const std::string one = output_of({"modules", type.name});
    EXPECT_TRUE(one.starts_with(type.name + (type.learns ? " (learns)\n" : "\n"))) << one;
    EXPECT_NE(all.find(one), std::string::npos) << type.name;
    EXPECT_NE(page.find("## `" + type.name + "`\n"), std::string::npos) << type.name;
    for (const InputPort& port : type.ports) {
      EXPECT_NE(one.find("  <- " + port.name + ": "), std::string::npos) << type.name;
    }
    for (const ParameterInfo& info : type.parameters) {
      EXPECT_NE(one.find("  " + info.name + " = " + info.default_text + "  "), std::string::npos)
          << type.name << " " << info.name;
      EXPECT_NE(page.find("| `" + info.name + "` | "), std::string::npos) << info.name;
    }
  }
  EXPECT_GT(module_types().size(), 10u);
}

TEST_F(Modules, RefusesWhatItDoesNotKnow) {
  expect_refused(2, {{{"modules", "smo"}, {"unknown type of module 'smo'"}},
                     {{"modules", "one_hat"},
                      {"modules: unknown type of module 'one_hat'", "did you mean 'one_hot'?"}},
                     {{"modules", "som", "more"}, {"unexpected argument 'more'"}},
                     {{"modules", "som", "--markdown"},
                      {"--markdown: the page contains all types", "omit TYPE"}}});
}

}  // namespace
}  // namespace somato
