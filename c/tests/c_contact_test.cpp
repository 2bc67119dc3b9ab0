#include "c/tests/c_cases.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/version.hpp"
#include "paths.hpp"
#include "tests/support/files.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(CContact, CheckNamesTheFieldItsValueAndTheRange) {
  microslip_error error;
  microslip_contact good = some_contact();
  EXPECT_EQ(microslip_contact_check(&good, &error), MICROSLIP_OK);
  EXPECT_EQ(error.code, MICROSLIP_OK);
  EXPECT_STREQ(error.text, "");
  for (const auto& [name, field, value] : wrong_fields) {
    microslip_contact contact = good;
    contact.*field = value;
    EXPECT_EQ(microslip_contact_check(&contact, &error), MICROSLIP_INVALID_INPUT) << name;
    EXPECT_EQ(error.code, MICROSLIP_INVALID_INPUT);
    const std::string text = error.text;
    EXPECT_EQ(text.find(std::string(name) + " = "), 0U) << text;
    EXPECT_NE(text.find("must be"), std::string::npos) << text;
  }
  EXPECT_EQ(microslip_contact_check(nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_STREQ(error.text, "contact is NULL");
  EXPECT_EQ(microslip_contact_check(nullptr, nullptr), MICROSLIP_NULL_POINTER);
}

/// The header and the Fortran module number the laws as the library does.
TEST(CContact, FrictionLawsAreThoseOfTheLibrary) {
  const std::string header = contents(MICROSLIP_SOURCE_DIR "/c/include/microslip.h"),
                    fortran = contents(MICROSLIP_SOURCE_DIR "/c/fortran/microslip.f90");
  for (std::size_t k = 0; k < std::size_t{FrictionLaw::first_falling + FrictionLaw::falling}; ++k) {
    const std::string value = "microslip_" + std::string(FrictionLaw::names[k]) + " = " + std::to_string(k);
    EXPECT_NE(fortran.find(value), std::string::npos) << value;
    std::string capital = value;
    std::transform(value.begin(), value.end(), capital.begin(), [](unsigned char c) { return std::toupper(c); });
    EXPECT_NE(header.find(capital), std::string::npos) << capital;
  }
}

TEST(CContact, CheckNamesTheTermOfAFallingLaw) {
  microslip_error error;
  microslip_contact contact = some_contact();
  contact.friction_law = MICROSLIP_EXPONENTIAL;
  EXPECT_EQ(microslip_contact_check(&contact, &error), MICROSLIP_OK) << error.text; // terms without effect
  contact.friction_drop[1] = 0.2;
  EXPECT_EQ(microslip_contact_check(&contact, &error), MICROSLIP_INVALID_INPUT);
  EXPECT_NE(std::string(error.text).find("second.half_velocity = 0"), std::string::npos) << error.text;
  contact.friction_half_velocity[1] = 1;
  contact.friction_drop[1] = 9.9;
  EXPECT_EQ(microslip_contact_check(&contact, &error), MICROSLIP_INVALID_INPUT);
  contact.friction_law = 4;
  EXPECT_EQ(microslip_contact_check(&contact, &error), MICROSLIP_INVALID_INPUT);
  EXPECT_NE(std::string(error.text).find("friction_law = 4"), std::string::npos) << error.text;
}

TEST(CContact, HertzIsThatOfTheLibrary) {
  const microslip_bodies bodies = {{0.46, infinite}, {infinite, 0.3}, {210e9, 205e9}, {0.28, 0.3}};
  const CombinedMaterial pair = combine(Material::from_young(210e9, 0.28), Material::from_young(205e9, 0.3));
  const HertzContact wanted = hertz_from_load(gap_curvatures({0.46, infinite, infinite, 0.3}), pair, 80e3);
  microslip_hertz found;
  ASSERT_EQ(microslip_hertz_from_load(&bodies, 80e3, &found, nullptr), MICROSLIP_OK);
  EXPECT_TRUE(same_bits(found.a, wanted.a) && same_bits(found.b, wanted.b) &&
              same_bits(found.approach, wanted.approach));
  EXPECT_TRUE(same_bits(found.peak_pressure, wanted.peak_pressure) && same_bits(found.stiffness, wanted.stiffness));
  EXPECT_TRUE(same_bits(found.shear_modulus, pair.shear_modulus) && same_bits(found.poisson_ratio, pair.poisson_ratio));
  EXPECT_TRUE(same_bits(found.dissimilarity, pair.dissimilarity));
}

TEST(CContact, HertzRefusesWithWords) {
  microslip_bodies bodies = {{0.46, infinite}, {infinite, 0.3}, {210e9, 205e9}, {0.28, 0.7}};
  microslip_hertz hertz;
  microslip_error error;
  EXPECT_EQ(microslip_hertz_from_load(&bodies, 80e3, &hertz, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("poisson_ratio = 0.7"), std::string::npos) << error.text;
  bodies.poisson_ratio[1] = 0.3;
  EXPECT_EQ(microslip_hertz_from_load(&bodies, -1, &hertz, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(microslip_hertz_from_load(&bodies, 1, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_hertz_from_load(nullptr, 1, &hertz, &error), MICROSLIP_NULL_POINTER);
}

TEST(CContact, ImplausibleContactsAreWarnedOf) {
  microslip_bodies bodies = {{0.46, infinite}, {infinite, 0.3}, {210e9, 210e9}, {0.28, 0.28}};
  microslip_hertz hertz;
  microslip_error error;
  const auto warnings = [&] {
    char* text = nullptr;
    EXPECT_EQ(microslip_hertz_from_load(&bodies, 80e3, &hertz, &error), MICROSLIP_OK) << error.text;
    EXPECT_EQ(microslip_hertz_warnings(&bodies, &hertz, &text, &error), MICROSLIP_OK) << error.text;
    std::string copy = text ? text : "none";
    microslip_free_text(text);
    return copy;
  };
  EXPECT_EQ(warnings(), "");
  for (double& modulus : bodies.young_modulus) modulus = 210e3; // in MPa
  const std::string text = warnings();
  EXPECT_NE(text.find("\ncontact ellipse: semi-axis a = "), std::string::npos) << text;
  EXPECT_NE(text.find("moduli in Pa"), std::string::npos) << text;
  EXPECT_EQ(text.back(), '\n');
  EXPECT_EQ(microslip_hertz_warnings(&bodies, &hertz, nullptr, &error), MICROSLIP_NULL_POINTER);
  microslip_free_text(nullptr);
}

TEST(CContact, PolachsLawIsThatOfTheLibrary) {
  microslip_contact contact = some_contact();
  ASSERT_EQ(microslip_polach_friction(0.4, 0.4, 0.6, &contact, nullptr), MICROSLIP_OK);
  const FrictionLaw wanted = FrictionLaw::polach(0.4, 0.4, 0.6);
  EXPECT_EQ(contact.friction_law, MICROSLIP_EXPONENTIAL);
  EXPECT_EQ(contact.friction, wanted.kinetic_coefficient());
  EXPECT_EQ(contact.friction_drop[0], wanted.terms()[0].drop);
  EXPECT_EQ(contact.friction_half_velocity[0], wanted.terms()[0].half_velocity);
  microslip_error error;
  EXPECT_EQ(microslip_polach_friction(0.4, 1.4, 0.6, &contact, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("ratio = 1.4"), std::string::npos) << error.text;
  EXPECT_EQ(contact.friction, wanted.kinetic_coefficient()); // refused: nothing has changed
}

TEST(CContact, VersionsOfHeaderAndLibraryAgree) {
  const std::string header = std::to_string(MICROSLIP_VERSION_MAJOR) + "." + std::to_string(MICROSLIP_VERSION_MINOR) +
                             "." + std::to_string(MICROSLIP_VERSION_PATCH);
  EXPECT_EQ(std::string(MICROSLIP_VERSION).substr(0, header.size()), header);
  EXPECT_STREQ(microslip_version(), MICROSLIP_VERSION);
  EXPECT_EQ(microslip_abi(), MICROSLIP_ABI);
  const microslip_build build = microslip_build_info();
  const BuildInfo wanted = build_info();
  EXPECT_EQ(build.version, wanted.version);
  EXPECT_EQ(build.commit, wanted.commit);
  EXPECT_EQ(build.compiler, wanted.compiler);
  EXPECT_EQ(build.build_type, wanted.build_type);
}

TEST(CContact, EveryCodeHasATextOfItsOwn) {
  std::set<std::string> texts;
  for (const int code : {0, 1, 2, 3, 4, 5, 6, 16, 17, 18, 19, 20, 21, 22}) texts.insert(microslip_code_text(code));
  EXPECT_EQ(texts.size(), 14U);
  EXPECT_EQ(texts.count(microslip_code_text(-1)), 0U);
  EXPECT_STREQ(microslip_code_text(-1), microslip_code_text(1000));
}

} // namespace
} // namespace microslip
