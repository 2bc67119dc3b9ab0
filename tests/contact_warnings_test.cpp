// What makes contacts of two bodies doubtful: units that look like others, pressures beyond elasticity; the table.

#include "microslip/rolling/contact_warnings.hpp"
#include "paths.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>

namespace microslip {
namespace {

const PrincipalRadii wheel_on_rail{0.46, infinity, infinity, 0.3};

ContactWarnings of(double young, double force, const PrincipalRadii& radii = wheel_on_rail) {
  const Material material = Material::from_young(young, 0.28);
  const CombinedMaterial pair = combine(material, material);
  return contact_warnings(hertz_from_load(gap_curvatures(radii), pair, force), radii, pair);
}

Warnings set_of(std::initializer_list<Warning> warnings) {
  Warnings set;
  for (const Warning warning : warnings) set.add(warning);
  return set;
}

TEST(ContactWarnings, PlausibleContactsHaveNone) {
  EXPECT_TRUE(of(210e9, 80e3).empty());
  EXPECT_TRUE(of(100e6, 80e3).empty()); // hard rubber: large, but not absurd
  EXPECT_TRUE(of(5e6, 500).empty());    // rubber
}

TEST(ContactWarnings, ModuliInMegapascals) {
  const ContactWarnings found = of(210e3, 80e3);
  EXPECT_EQ(found.all,
            set_of({Warning::extreme_pressure, Warning::soft_material, Warning::wide_contact, Warning::deep_approach}));
  ASSERT_EQ(found.texts.size(), 5u); // both semi-axes
  EXPECT_NE(found.texts[0].find("210000 Pa, is very small: is it in MPa?"), std::string::npos) << found.texts[0];
  EXPECT_NE(found.texts[1].find("far beyond linear elasticity"), std::string::npos) << found.texts[1];
  EXPECT_NE(found.texts[2].find("semi-axis a = 0.6"), std::string::npos) << found.texts[2];
  EXPECT_NE(found.texts[3].find("transverse radius of body 2, 0.3 m"), std::string::npos) << found.texts[3];
  EXPECT_NE(found.texts[4].find("approach "), std::string::npos) << found.texts[4];
  for (std::size_t k = 1; k < 5; ++k) EXPECT_NE(found.texts[k].find("moduli in Pa"), std::string::npos);
}

TEST(ContactWarnings, RadiiInMillimetres) {
  const ContactWarnings found = of(210e9, 80e3, {460, infinity, infinity, 0.3});
  EXPECT_EQ(found.all, set_of({Warning::large_radius}));
  EXPECT_EQ(found.texts.at(0), "rolling radius of body 1 = 460 m is implausible: is it in mm? Numbers are in m, a "
                               "straight line is inf");
}

/// Johnson 1985, section 4.2: the peak pressure goes like the cube root of the load.
TEST(ContactWarnings, PressuresBeyondYieldAndBeyondElasticity) {
  const double load = 80e3, pressure = 1139.19e6, young = 210e9;
  const auto load_of = [&](double wanted) { return load * std::pow(wanted / pressure, 3); };
  EXPECT_TRUE(of(young, load_of(0.0099 * young)).empty());
  EXPECT_EQ(of(young, load_of(0.0101 * young)).all, set_of({Warning::high_pressure}));
  EXPECT_TRUE(of(young, load_of(0.0501 * young)).all.has(Warning::extreme_pressure));
  EXPECT_FALSE(of(young, load_of(0.0499 * young)).all.has(Warning::extreme_pressure));
}

TEST(ContactWarnings, OfEllipsesAlone) {
  EllipticContact contact{};
  contact.a = 6e-3, contact.b = 5e-3, contact.shear_modulus = 82e9, contact.poisson_ratio = 0.28;
  contact.normal_force = 80e3;
  EXPECT_TRUE(contact_warnings(contact).empty());
  contact.a = 6, contact.b = 5; // in mm
  EXPECT_EQ(contact_warnings(contact).all, set_of({Warning::faint_pressure}));
  contact.a = 6e-5, contact.b = 5e-5;
  EXPECT_TRUE(contact_warnings(contact).all.has(Warning::extreme_pressure));
}

TEST(Warnings, HaveNamesAndTextsOfTheirOwnAndCodesThatComeBack) {
  std::set<std::string_view> names, texts;
  Warnings all;
  for (const WarningInfo& one : warning_table()) {
    names.insert(one.name), texts.insert(one.text);
    EXPECT_FALSE(all.has(one.warning));
    all.add(one.warning);
    EXPECT_EQ(info(one.warning).name, one.name);
  }
  EXPECT_EQ(names.size(), warning_count);
  EXPECT_EQ(texts.size(), warning_count);
  EXPECT_EQ(all.texts().size(), warning_count);
  EXPECT_EQ(all.code, (1u << warning_count) - 1);
  EXPECT_EQ(Warnings{all.code}, all);
  EXPECT_TRUE(all.is_decisive());
  EXPECT_FALSE(set_of({Warning::profile_end, Warning::high_pressure}).is_decisive());
}

/// A row of the documentation's table.
std::string row_of(const WarningInfo& one) {
  std::ostringstream row;
  row << "| `" << one.name << "` | ";
  if (one.limit != 0) row << one.limit;
  row << " | " << one.of << " | " << one.text << " | " << (one.is_decisive ? "`implausible`" : "") << " |";
  return row.str();
}

TEST(Warnings, TheDocumentationHasTheTable) {
  std::ifstream page(MICROSLIP_SOURCE_DIR "/docs/troubleshooting.md");
  std::string line;
  while (std::getline(page, line) && line != "## Warnings") continue;
  while (std::getline(page, line) && !line.starts_with("|---")) continue;
  for (const WarningInfo& one : warning_table()) {
    ASSERT_TRUE(std::getline(page, line));
    EXPECT_EQ(line, row_of(one));
  }
  ASSERT_TRUE(std::getline(page, line));
  EXPECT_EQ(line, "");
}

} // namespace
} // namespace microslip
