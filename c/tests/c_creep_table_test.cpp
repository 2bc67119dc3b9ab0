#include "c/tests/c_cases.hpp"
#include "io/creep_table_file.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "microslip/table/making/creep_table_maker.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

namespace microslip {
namespace {

/// A small table in a file, and what is in it.
struct TableFile {
  CreepTableNodes nodes = make_creep_table(
      {.axes = {.ratios = 4, .poisson_ratios = {0.28}, .levels = 4, .elevations = 4, .azimuths = 4}, .elements = 8});
  std::string path =
      (std::filesystem::temp_directory_path() / ("microslip_" + std::to_string(getpid()) + ".creep")).string();

  TableFile() { io::write_creep_table(nodes, path); }
  ~TableFile() { std::filesystem::remove(path); }
};

TEST(CCreepTable, HasTheForcesOfTheLibrary) {
  const TableFile file;
  const CreepForceTable expected(file.nodes);
  microslip_error error{};
  microslip_creep_table* table = nullptr;
  ASSERT_EQ(microslip_creep_table_read(file.path.c_str(), MICROSLIP_FORWARD, &table, &error), MICROSLIP_OK)
      << error.text;
  EllipticContact contact;
  contact.a = 6e-3, contact.b = 5e-3, contact.shear_modulus = 82e9, contact.poisson_ratio = 0.28;
  contact.normal_force = 80e3, contact.friction = FrictionLaw::coulomb(0.3), contact.rolling_speed = 30;
  contact.creepage = {0.0012, 0.0006, 0.4};
  const microslip_contact c = some_contact();
  microslip_forces forces{};
  ASSERT_EQ(microslip_creep_table_solve(table, 1, &c, &forces), MICROSLIP_OK);
  EXPECT_TRUE(same_bits(forces, expected.solve(contact)));
  microslip_derivatives derivatives{};
  ASSERT_EQ(microslip_creep_table_differentiate(table, 1, &c, &derivatives), MICROSLIP_OK);
  EXPECT_TRUE(same_bits(derivatives.jacobian[2][1], expected.differentiate(contact).jacobian[2][1]));

  std::vector<microslip_contact> some(3, c);
  some[1].a = 0.5; // beyond the table
  std::vector<microslip_forces> all(3);
  EXPECT_EQ(microslip_creep_table_solve(table, 3, some.data(), all.data()), MICROSLIP_OUT_OF_RANGE);
  some[2].b = -1;
  EXPECT_EQ(microslip_creep_table_solve(table, 3, some.data(), all.data()), MICROSLIP_INVALID_INPUT);
  EXPECT_TRUE(same_bits(all[0].fx, forces.fx));
  microslip_creep_table_destroy(table);
}

TEST(CCreepTable, RefusesFilesThatAreNoTables) {
  const TableFile file;
  microslip_error error{};
  microslip_creep_table* table = nullptr;
  std::filesystem::resize_file(file.path, 600);
  EXPECT_EQ(microslip_creep_table_read(file.path.c_str(), MICROSLIP_FORWARD, &table, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("cut short"), std::string::npos) << error.text;
  EXPECT_EQ(microslip_creep_table_read("none.creep", MICROSLIP_FORWARD, &table, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(microslip_creep_table_read(nullptr, MICROSLIP_FORWARD, &table, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_creep_table_solve(nullptr, 0, nullptr, nullptr), MICROSLIP_NULL_POINTER);
  microslip_creep_table_destroy(nullptr);
}

} // namespace
} // namespace microslip
