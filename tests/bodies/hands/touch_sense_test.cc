#include "bodies/hands/touch_sense.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace somato::detail {
namespace {

constexpr double kGravity = 9.81;

// A plate that lies on its back, with the eight domes of a distal segment, and something above.
std::string pad(const std::string& above) {
  std::string taxels;
  const std::array<std::array<double, 2>, 8> places{
      {{-15, 18}, {0, 18}, {15, 18}, {-8, 0}, {8, 0}, {-15, -18}, {0, -18}, {15, -18}}};
  for (std::size_t i = 0; i < places.size(); ++i)
    taxels += fmt::format(R"(<geom name="taxel_{}" type="sphere" size="0.005" pos="{} {} 0"/>)",
                          i + 1, places[i][0] / 1000, places[i][1] / 1000);
  return fmt::format(R"(<mujoco><option timestep="0.001" cone="elliptic" impratio="10"/>
    <default><geom solref="0.01 1" solimp="0.5 0.95 0.002 0.5 2" friction="0.5 0 0"/></default>
    <worldbody><body><geom name="plate" type="box" size="0.018 0.019 0.002"/>{}</body>
    <body pos="0 0 0.03"><freejoint/>{}</body></worldbody></mujoco>)",
                     taxels, above);
}

std::vector<double> forces_after(const std::string& mjcf, double seconds) {
  const auto model = compile_model(mjcf, "pad");
  EXPECT_TRUE(model) << model.error().what;
  const auto data = make_data(*model);
  while ((*data)->time < seconds) mj_step(model->get(), data->get());
  const Taxels taxels = find_taxels(**model);
  std::vector<double> forces(taxels.names.size());
  read_forces(**model, **data, taxels, forces);
  return forces;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(TouchSense, AKnownWeightOnAFlatPadReadsItsForce) {
  for (const double mass : {0.1, 0.5, 2.0}) {
    const auto forces = forces_after(
        pad(fmt::format(R"(<geom type="box" size="0.03 0.03 0.01" mass="{}"/>)", mass)), 2.0);
    ASSERT_EQ(forces.size(), 8U);
    EXPECT_NEAR(sum(forces), mass * kGravity, 0.02 * mass * kGravity);
    for (const double force : forces) EXPECT_GT(force, 0.0);
  }
}

TEST(TouchSense, AWeightOnOneCornerIsFeltThereMost) {
  const auto forces = forces_after(pad(R"(<geom type="box" size="0.03 0.03 0.004" mass="0.05"/>
             <geom type="box" size="0.004 0.004 0.004" pos="0.014 0.017 0.008" mass="0.5"/>)"),
                                   2.0);
  EXPECT_NEAR(sum(forces), 0.55 * kGravity, 0.02 * 0.55 * kGravity);
  EXPECT_EQ(std::max_element(forces.begin(), forces.end()) - forces.begin(), 2);
}

TEST(TouchSense, ContactsOfTheBarePlateReachNoTaxel) {
  // A narrow ridge of the thing rests on the plate between the domes, which it does not touch.
  const std::string ridge = R"(<geom type="box" size="0.0005 0.0008 0.02" mass="0.3"/>)";
  const std::string mjcf = pad(ridge);
  const auto model = compile_model(mjcf, "pad");
  ASSERT_TRUE(model);
  const auto data = make_data(*model);
  bool touched = false;
  for (int step = 0; step < 300; ++step) {
    mj_step(model->get(), data->get());
    const Taxels taxels = find_taxels(**model);
    std::vector<double> forces(taxels.names.size());
    read_forces(**model, **data, taxels, forces);
    std::vector<bool> has_contact(forces.size(), false);
    for (int i = 0; i < (*data)->ncon; ++i) {
      for (const int geom : contact_geoms((*data)->contact[i])) {
        const int taxel = taxels.taxel_of_geom[static_cast<std::size_t>(geom)];
        if (taxel >= 0) has_contact[static_cast<std::size_t>(taxel)] = true;
      }
      touched = true;
    }
    for (std::size_t i = 0; i < forces.size(); ++i) {
      if (!has_contact[i]) {
        ASSERT_EQ(forces[i], 0.0);
      }
    }
    if (step == 250) {
      EXPECT_GT((*data)->ncon, 0);
      EXPECT_EQ(sum(forces), 0.0);
    }
  }
  EXPECT_TRUE(touched);
}

TEST(TouchSense, TaxelsComeInTheModelsOrderUnderTheirNames) {
  const auto model = compile_model(pad(R"(<geom type="sphere" size="0.01"/>)"), "pad");
  ASSERT_TRUE(model);
  const Taxels taxels = find_taxels(**model);
  EXPECT_EQ(taxels.names, (std::vector<std::string>{"1", "2", "3", "4", "5", "6", "7", "8"}));
  EXPECT_EQ(taxels.taxel_of_geom[0], -1);  // the plate
  EXPECT_EQ(taxels.taxel_of_geom[8], 7);
}

}  // namespace
}  // namespace somato::detail
