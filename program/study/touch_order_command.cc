#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "som/data.h"
#include "studies/lifelong/touch_order.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

std::string figure(const Metric& values, int digits) {
  return fmt::format("{:.{}f} +- {:.{}f}", values.mean(), digits, values.standard_deviation(),
                     digits);
}

std::string row(const std::string& name, const std::vector<std::string>& cells) {
  std::string text = fmt::format("{:<10}", name);
  for (const std::string& cell : cells) text += fmt::format("{:<18}", cell);
  text.erase(text.find_last_not_of(' ') + 1);
  return text + "\n";
}

// A column for each order.
template <typename Cell>
std::string rows_of(const TouchOrders& orders, const std::string& name, const Cell& cell) {
  std::vector<std::string> cells;
  cells.reserve(orders.orders.size());
  for (const TouchOrderResult& order : orders.orders) cells.push_back(cell(order));
  return row(name, cells);
}

std::string text_of(const TouchOrders& orders, const TouchOrderParameters& parameters) {
  using Order = const TouchOrderResult&;
  std::string text =
      fmt::format("{} explorations of {} grasps, {} classes, {} seeds: accuracy\n",
                  orders.explorations, orders.grasps, orders.classes, parameters.seeds);
  text += rows_of(orders, "grasps", [](Order order) { return order.order; });
  for (std::size_t taken = 0; taken < orders.grasps; ++taken) {
    text += rows_of(orders, std::to_string(taken + 1),
                    [&](Order order) { return figure(order.accuracy[taken], 3); });
  }
  text += fmt::format("until a name has the probability {}\n", parameters.certainty);
  text += rows_of(orders, "grasps", [](Order order) { return figure(order.stopped_grasps, 2); });
  text +=
      rows_of(orders, "accuracy", [](Order order) { return figure(order.stopped_accuracy, 3); });
  return text;
}

Table table_of(const Metric& accuracy, const Metric& certainty, std::size_t grasps) {
  return {
      {},
      {entry("grasps", std::uint64_t{grasps}), entry("accuracy", accuracy.mean()),
       entry("accuracy_sd", accuracy.standard_deviation()), entry("certainty", certainty.mean())}};
}

Table table_of(const TouchOrderResult& order) {
  std::vector<Table> curve;
  curve.reserve(order.accuracy.size());
  for (std::size_t taken = 0; taken < order.accuracy.size(); ++taken) {
    curve.push_back(table_of(order.accuracy[taken], order.certainty[taken], taken + 1));
  }
  return {{},
          {entry("order", order.order), entry("curve", std::move(curve)),
           entry("stopped_grasps", order.stopped_grasps.mean()),
           entry("stopped_accuracy", order.stopped_accuracy.mean())}};
}

Table table_of(const TouchOrders& orders) {
  std::vector<Table> tables;
  tables.reserve(orders.orders.size());
  for (const TouchOrderResult& order : orders.orders) tables.push_back(table_of(order));
  return {{},
          {entry("explorations", std::uint64_t{orders.explorations}),
           entry("classes", std::uint64_t{orders.classes}),
           entry("grasps", std::uint64_t{orders.grasps}), entry("orders", std::move(tables))}};
}

Result<void> run_touch_order(const Arguments& arguments) {
  SOMATO_TRY(const auto parameters, read_flags<TouchOrderParameters>(arguments));
  SOMATO_TRY(const auto threads, read_threads(arguments));
  const std::string path = arguments.text("DATA");
  SOMATO_TRY(const auto recording, read_study_data({}, path));
  auto orders = compare_touch_orders(recording, parameters, terminal_progress("reading"), threads);
  if (!orders) return fail(with_place(std::move(orders.error()), path));
  print_result(arguments, text_of(*orders, parameters), table_of(*orders));
  return {};
}

std::vector<KeySection> key_sections_of_touch_orders() {
  return {{"Orders of grasps",
           "Flags of `somato touch-order`; they are not keys of a file. "
           "[continual.md](../continual.md#the-next-grasp) describes the comparison; none of these "
           "numbers is in the papers.",
           {key_table<TouchOrderParameters>("touch_order")}}};
}

}  // namespace

Command touch_order_command() {
  return {"touch-order",
          "Compare orders of the grasps of recorded explorations: chosen, fixed and random",
          {{"DATA", "Recording: its file, or a folder of original files"}},
          {threads_flag(), json_flag()},
          TouchOrderParameters::declarations().infos(),
          run_touch_order,
          {"touch_order"},
          key_sections_of_touch_orders};
}

}  // namespace somato::program
