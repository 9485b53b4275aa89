#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace somato::program {

/// Formats --help to the width of the terminal; 100 columns without a terminal.
class HelpFormat : public CLI::Formatter {
 public:
  HelpFormat();

  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;

 private:
  /// A name with its description beside it, wrapped.
  std::string entry(const std::string& name, const std::string& text) const;

  std::size_t width_;
};

}  // namespace somato::program
