// What result elements and contact problems have until it is set, and that they come to be by themselves.

#include "compat/libcontact/defaults.hpp"
#include "compat/libcontact/tests/calls.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <sstream>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

/// The library as a program uses it that begins with a setter. The log is in the current folder then.
class UninitializedLibrary {
public:
  UninitializedLibrary() { std::filesystem::current_path(folder_.path()); }
  ~UninitializedLibrary() {
    cntc_finalizelast();
    std::filesystem::current_path(before_);
  }
  UninitializedLibrary(const UninitializedLibrary&) = delete;
  UninitializedLibrary& operator=(const UninitializedLibrary&) = delete;

  const std::filesystem::path& folder() const { return folder_.path(); }

private:
  std::filesystem::path before_ = std::filesystem::current_path();
  TemporaryFolder folder_;
};

int flag_of(int ire, int icp, int code) {
  int one = 1, value = -12345;
  EXPECT_EQ(cntc_getflags(&ire, &icp, &one, &code, &value), 0) << code;
  return value;
}

TEST(Defaults, AreTheFlagsOfNewElements) {
  const UninitializedLibrary library;
  ASSERT_EQ(initialize(1, 1), 0);
  ASSERT_EQ(initialize(3, 3), 0);
  for (const Default& row : defaults) {
    if (row.flag == 0) continue;
    if (row.of != DefaultOf::contact) {
      EXPECT_EQ(flag_of(1, whole, row.flag), row.value) << row.name;
    }
    if (row.of != DefaultOf::wheel) {
      EXPECT_EQ(flag_of(3, 1, row.flag), row.value) << row.name;
    }
  }
}

TEST(Defaults, AreTheNumbersOfNewWheels) {
  const UninitializedLibrary library;
  int ire = 1, icp = whole, count = 6;
  double dx = 0, ds = 0, force = 80e3;
  ASSERT_EQ(cntc_getgriddiscretization(&ire, &icp, &dx, &ds), 0);
  EXPECT_EQ(dx, default_in_file("DX", DefaultOf::wheel));
  EXPECT_EQ(ds, default_in_file("DS", DefaultOf::wheel));
  Values velocity(6);
  ASSERT_EQ(cntc_getwheelsetvelocity(&ire, &count, velocity.data()), 0);
  EXPECT_EQ(velocity, (Values{default_in_file("VS", DefaultOf::wheel), 0, 0, 0, 0, 0}));
  // Those of the track and the wheelset are the ones of the example, so that profiles alone make a contact.
  const auto forces = [&](int element, bool is_set) {
    if (is_set) {
      EXPECT_EQ(set(cntc_settrackdimensions, element, 1, {14, 0, 1435, 0, 0}), 0);
      EXPECT_EQ(set(cntc_setwheelsetdimensions, element, 3, {1360, -70, 460, 1000}), 0);
      EXPECT_EQ(set(cntc_setpotcontact, element, whole, -1, {.5, .5, std::numbers::pi, 8, 4, 12, -1}), 0);
      EXPECT_EQ(set(cntc_setfrictionmethod, element, whole, 0, {.3, .3}), 0);
      EXPECT_EQ(set(cntc_setwheelsetvelocity, element, 2, {30e3, 0, 0, 0, 0, 0}), 0);
    }
    EXPECT_EQ(set_profile(element, profiles + "60e1.prr", 0), 0);
    EXPECT_EQ(set_profile(element, profiles + "s1002.prw", 1), 0);
    EXPECT_EQ(set(cntc_setmaterialparameters, element, whole, 0, {.28, .28, 82000, 82000}), 0);
    EXPECT_EQ(cntc_setverticalforce(&element, &force), 0);
    EXPECT_GE(calculate(element), 0);
    return list(cntc_getglobalforces, element, whole, 24);
  };
  const Values found = forces(1, false);
  ASSERT_EQ(found.size(), 24u);
  EXPECT_NEAR(found[2], 80e3, 1);
  EXPECT_GT(std::abs(found[0]), 1e3) << "a wheel that slides";
  EXPECT_EQ(found, forces(2, true));
}

TEST(Defaults, AreTheNumbersOfNewContactProblems) {
  const UninitializedLibrary library;
  ASSERT_EQ(set(cntc_setpotcontact, 3, 1, 1, {5, 5, -.25, -.25, .1, .1}), 0);
  const double approach = 0.05;
  ASSERT_EQ(set(cntc_setpenetration, 3, 1, approach), 0);
  ASSERT_GE(calculate(3, 1), 0);
  EXPECT_EQ(parameters(3, 1, 1, 3),
            (Values{default_in_file("VELOC", DefaultOf::contact), 0, default_in_file("DQ", DefaultOf::contact)}));
  EXPECT_EQ(
      parameters(3, 1, 2, 18),
      (Values{default_in_file("GG1"), default_in_file("GG2"), 1, default_in_file("POISS1"), default_in_file("POISS2"),
              default_in_file("POISS1"), 0, default_in_file("FLX"), default_in_file("FLX"), 0, default_in_file("K0_MF"),
              default_in_file("ALFAMF"), default_in_file("BETAMF"), 0, default_in_file("GG3"), 0, 0, 0}));
  EXPECT_EQ(parameters(3, 1, 3, 7),
            (Values{default_in_file("L"), 1, 0, 0, 0, default_in_file("FSTAT"), default_in_file("FKIN")}));
  EXPECT_EQ(scalars(cntc_getcreepages, 3, 1), (Values{0, 0, 0}));
  const Values h = field(3, 1, CNTC_fld_h, 25);
  EXPECT_NEAR(h[0], 2 * 0.2 * 0.2 - approach, 1e-15) << "h = x2 + y2";
}

/// Of a contact that rolls steadily, with all else as it is by default.
const std::vector<Setting> setters_of_a_contact = {
    by(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000}), by(cntc_setfrictionmethod, 0, {.3, .3}),
    by(cntc_sethertzcontact, -3, {21, 21, 4, 4, 21. / 17}), by(cntc_setnormalforce, {1e4}),
    by(cntc_setcreepages, {0.001, 0, 0})};

/// The number is CONTACT's, of the same calls.
TEST(Defaults, AreThoseOfContactsOwnPrograms) {
  for (const bool is_initialized : {false, true}) {
    const UninitializedLibrary library;
    if (is_initialized) {
      ASSERT_EQ(initialize(1, 3), 0);
    }
    for (const auto& setter : setters_of_a_contact) ASSERT_EQ(setter(1, 1), 0);
    EXPECT_EQ(calculate(1, 1), 0);
    const Values forces = scalars(cntc_getcontactforces, 1, 1);
    ASSERT_EQ(forces.size(), 4u);
    EXPECT_NEAR(forces[0], 1e4, 1e-6);
    EXPECT_NEAR(forces[1], -2932.51, 0.005);
    EXPECT_NEAR(forces[2], 0, 1e-6);
  }
}

TEST(Setters, OfAContactMayComeInAnyOrder) {
  const UninitializedLibrary library;
  std::vector<std::size_t> order = {0, 1, 2, 3, 4};
  Values wanted;
  do {
    for (const std::size_t k : order) ASSERT_EQ(setters_of_a_contact[k](1, 1), 0);
    ASSERT_EQ(calculate(1, 1), 0);
    const Values found = scalars(cntc_getcontactforces, 1, 1);
    ASSERT_EQ(found.size(), 4u);
    if (wanted.empty()) wanted = found;
    ASSERT_EQ(found, wanted) << order[0] << order[1] << order[2] << order[3] << order[4];
    ASSERT_EQ(finalize(1), 0);
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_NEAR(wanted[1], -2932.51, 0.005);
}

TEST(Setters, OfAWheelMayComeInAnyOrder) {
  const UninitializedLibrary library;
  const std::vector<Setting> setters = {
      by_flag(CNTC_ic_config, 0),
      by(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000}),
      by(cntc_setfrictionmethod, 0, {.25, .25}),
      by_force(60e3),
      by(cntc_setpotcontact, -1, {.5, .5, 1.57, 8, 4}),
      by(cntc_settrackdimensions, 3, {14, 0, 1435, .05, 0, 0, 0, 0, 0, 0, 0}),
      by_profile(profiles + "60e1.prr", 0),
      by(cntc_setwheelsetdimensions, 3, {1360, -70, 460}),
      by_profile(profiles + "s1002.prw", 1),
      by(cntc_setwheelsetposition, 2, {0, 3, 0, -3e-4, 6e-3, 0}),
      by(cntc_setwheelsetvelocity, 2, {30e3, 0, 0, 0, 0, -30e3 / 460.3}),
  };
  std::vector<std::size_t> order(setters.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::mt19937 chance(1);
  Values wanted;
  for (int round = 0; round < 12; ++round) {
    for (const std::size_t k : order) ASSERT_EQ(setters[k](1, whole), 0) << k;
    ASSERT_GE(calculate(1), 0);
    const Values found = list(cntc_getglobalforces, 1, whole, 24);
    if (wanted.empty()) wanted = found;
    ASSERT_EQ(found, wanted) << round;
    ASSERT_EQ(finalize(1), 0);
    if (round == 0)
      std::reverse(order.begin(), order.end());
    else
      std::shuffle(order.begin(), order.end(), chance);
  }
  EXPECT_NEAR(wanted[2], 60e3, 1);
}

TEST(Elements, ComeToBeByTheFirstCallThatTakesThem) {
  const UninitializedLibrary library;
  EXPECT_EQ(set(cntc_setfrictionmethod, 1, whole, 0, {.3, .3}), 0) << "icp = -1: module 1";
  EXPECT_EQ(initialize(1, 3), CNTC_err_icp);
  EXPECT_EQ(initialize(1, 1), 0);
  EXPECT_EQ(set(cntc_setfrictionmethod, 2, 1, 0, {.3, .3}), 0) << "icp = 1: module 3";
  EXPECT_EQ(initialize(2, 1), CNTC_err_icp);
  int wheel = 4, contact = 5, one = 1, patches = -1;
  double force = 1;
  EXPECT_EQ(cntc_setverticalforce(&wheel, &force), 0) << "no icp: module 1";
  EXPECT_EQ(initialize(4, 1), 0);
  EXPECT_EQ(scalars(cntc_getpenetration, 5, 1), Values()) << "a function that gets results does as well";
  EXPECT_EQ(cntc_getnumcontactpatches(&contact, &patches), CNTC_err_icp);
  EXPECT_EQ(initialize(5, 3), 0);
  EXPECT_TRUE(std::filesystem::exists(library.folder() / "contact_addon.out"));
  // Calls that have no problem, whatever the element were.
  double fn = 1;
  for (int icp : {0, -2, 10}) EXPECT_EQ(set_flag(7, icp, CNTC_ic_tang, 3), CNTC_err_icp) << icp;
  int icp = whole;
  wheel = 7;
  EXPECT_EQ(cntc_setnormalforce(&wheel, &icp, &fn), CNTC_err_icp);
  EXPECT_EQ(list(cntc_getcontactlocation, 7, one, 38), Values());
  EXPECT_EQ(finalize(7), CNTC_err_icp) << "they have made none";
  for (const int number : {0, -1, 1000}) EXPECT_EQ(set_flag(number, 1, CNTC_ic_tang, 3), CNTC_err_icp);
}

/// The rows of the page's table by module and name: value and unit.
using Rows = std::map<std::pair<std::string, std::string>, std::pair<double, std::string>>;

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> found;
  std::stringstream stream(line.substr(1));
  for (std::string cell; std::getline(stream, cell, '|');) {
    const auto first = cell.find_first_not_of(' ');
    found.push_back(first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
  }
  return found;
}

double number_of(const std::string& text, const std::string& unit) {
  std::string plain = text;
  std::erase(plain, ',');
  const auto slash = plain.find('/');
  const double value = slash == std::string::npos
                           ? std::stod(plain)
                           : std::stod(plain.substr(0, slash)) / std::stod(plain.substr(slash + 1));
  return unit == "°" ? value * std::numbers::pi / 180 : value;
}

Rows rows_of_the_page() {
  std::ifstream page(MICROSLIP_SOURCE_DIR "/docs/libcontact.md");
  std::string line;
  while (std::getline(page, line) && line != "## Defaults") continue;
  Rows rows;
  while (std::getline(page, line) && !line.starts_with("## ")) {
    if (!line.starts_with("| `")) continue;
    const auto row = cells(line);
    std::stringstream names(row.at(0));
    for (std::string name; std::getline(names, name, ',');) {
      const auto first = name.find('`') + 1;
      rows[{row.at(3), name.substr(first, name.find('`', first) - first)}] = {number_of(row.at(1), row.at(2)),
                                                                              row.at(2)};
    }
  }
  return rows;
}

TEST(Defaults, AreTheTableOfThePage) {
  Rows rows = rows_of_the_page();
  const std::map<DefaultOf, std::string> modules = {
      {DefaultOf::both, "1, 3"}, {DefaultOf::wheel, "1"}, {DefaultOf::contact, "3"}};
  const std::map<std::string_view, std::string> units = {{"rad", "°"}, {"N/mm2", "N/mm²"}, {"mm3/N", "mm³/N"}};
  for (const Default& row : defaults) {
    const auto found = rows.find({modules.at(row.of), std::string(row.name)});
    ASSERT_NE(found, rows.end()) << row.name << " of module " << modules.at(row.of) << " is not on the page";
    EXPECT_NEAR(found->second.first, row.value, 1e-12 * std::abs(row.value)) << row.name;
    const auto written = units.find(row.unit);
    EXPECT_EQ(found->second.second, written == units.end() ? std::string(row.unit) : written->second) << row.name;
    rows.erase(found);
  }
  for (const auto& [name, value] : rows) ADD_FAILURE() << name.second << " of the page is not in the table";
}

} // namespace
} // namespace microslip::libcontact
