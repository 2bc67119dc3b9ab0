// Results by every function that gets some, of programs that make no initialisation, set no T and call in an unusual
// order: in C and in Fortran the same, and those of the same cases as an input file.

#include "compat/contact/plastic_deformation.hpp"
#include "compat/contact/records.hpp"
#include "compat/contact/run.hpp"
#include "compat/contact/sensitivities.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/libcontact/tests/calls.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/command_output.hpp"

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace microslip::libcontact {
namespace {

namespace fs = std::filesystem;
using namespace contact_program;

/// Numbers by the function, ire and icp.
using Lines = std::map<std::string, Values>;

std::string key_of(const std::string& getter, int ire, int icp) {
  return getter + " " + std::to_string(ire) + " " + std::to_string(icp);
}

Lines run(const std::string& program) {
  Lines lines;
  std::istringstream stream(command_output("'" EVERY_GETTER_FOLDER "/" + program + "' '" + profiles + "60e1.prr' '" +
                                           profiles + "s1002.prw'"));
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string getter;
    int ire = 0, icp = 0;
    words >> getter >> ire >> icp;
    Values& numbers = lines[key_of(getter, ire, icp)];
    for (std::string word; words >> word;) numbers.push_back(std::stod(word));
  }
  return lines;
}

const Lines& in_c() {
  static const Lines lines = run("libcontact_every_getter_c");
  return lines;
}

/// What the programs set, as an input file. Cases are in the order of the results below.
std::string input() {
  const auto wheel = [](int ire, const std::string& digits, const std::string& z, const std::string& points) {
    return " 1 " + std::to_string(ire) + " MODULE, RE\n " + digits +
           "\n 0022033\n 0000321\n 999 20 25 1 1e-5\n .3 .3\n .28 .28 82000. 82000.\n"
           " .5 .5 1. 1.5707963267948966 8. 4.\n 14. 0 1435. .05\n '" +
           profiles + "60e1.prr' 0 1. 0.\n 0 0 0 0 0 0\n 1360. -70. 460. 1000.\n '" + profiles +
           "s1002.prw' 0 1. 0.\n 0 3. " + z + " -3e-4 6e-3 0\n 30000. 0 0 0 0 -65.\n" + points;
  };
  const std::string points = " 0 0\n 9\n 2 1 2\n 0 .5\n .25\n .5 -1.\n 0\n", solver = " 999 20 25 1 1e-5\n",
                    steel = " .28 .28 82000. 82000.\n", heat = " 20. 450. .05 7.85e-6\n";
  return wheel(1, "1203103", "80000.", points) + wheel(2, "0203000", ".2", "") +
         " 3 3 1 MODULE, RE, CP\n 203100\n 0422020\n 3000331\n" + solver +
         " 1000. .001 -.0005 .0001\n .2 .1 50. 0 10000.\n .001 10.\n 0 .2 2000.\n" + steel + heat + heat +
         " 1\n 21 21 -1.05 -1.05 .1 .1\n 1 1\n .005 0 .005 0 0 0\n" + //
         " 3 3 2 MODULE, RE, CP\n 203113\n 0022020\n 0000331\n" + solver + " 2000. .4 .0005 0\n .3 .3\n 0 .2 2000.\n" +
         steel + " -3\n 16 16 1. .8 1.25\n" + points + //
         " 3 4 5 MODULE, RE, CP\n 203000\n 0022420\n 0000331\n" + solver + " .01 .004 .002 0\n .5 .5\n 0 .2 2000.\n" +
         steel + " 8200. .02 60. 500.\n -3\n 12 12 1. 1. 1.2\n";
}

Values scaled(const std::vector<double>& field, double factor, std::size_t count) {
  Values found(count);
  for (std::size_t k = 0; k < field.size(); ++k) found[k] = factor * field[k];
  return found;
}

/// What a contact's lines should be.
class Expected {
public:
  Expected(const Case& c, const Outcome& o, int ire, int icp) : case_(c), outcome_(o), ire_(ire), icp_(icp) {}

  Lines lines() {
    add_totals();
    add_parameters();
    add_fields();
    return std::move(lines_);
  }

private:
  void add(const std::string& getter, Values values) { lines_[key_of(getter, ire_, icp_)] = std::move(values); }

  void add_totals() {
    const ElementGrid& g = outcome_.step.grid;
    const PrintedTotals& t = outcome_.totals;
    const double dx = g.dx * 1e3, dy = g.dy * 1e3, element = g.element_area() * 1e6;
    const auto& [px, py] = outcome_.solution.fields.traction;
    double traction = 0;
    for (std::size_t k = 0; k < px.size(); ++k) traction = std::max(traction, std::hypot(px[k], py[k]) * 1e-6);
    add("cntc_getreferencevelocity", {case_.rolling->veloc * 1e3});
    add("cntc_getgriddiscretization", {dx, dy});
    add("cntc_getpotcontact", {double(g.mx), double(g.my), g.x0 * 1e3, g.y0 * 1e3, dx, dy});
    add("cntc_getnumelements", {double(g.mx), double(g.my)});
    add("cntc_getpenetration", {t.approach});
    add("cntc_getcreepages",
        {case_.digits.force == Prescribed::creepages ? slip_of(case_.x) : t.x, slip_of(case_.y), case_.phi * 1e-3});
    add("cntc_getcontactforces", {t.fn, t.fx, t.fy, t.mz});
    add("cntc_getcontactpatchareas", {t.contact * element, t.adhesion * element, t.slip * element});
    add("cntc_getmaximumpressure", {t.peak_pressure});
    add("cntc_getmaximumtraction", {traction});
    Values temperatures(2);
    const SurfaceFields& f = outcome_.solution.fields;
    if (outcome_.has_temperatures()) {
      temperatures[0] = *std::ranges::max_element(f.temperature1);
      temperatures[1] = *std::ranges::max_element(f.temperature2);
      EXPECT_DOUBLE_EQ(std::max(temperatures[0], temperatures[1]), *t.temperature);
    }
    add("cntc_getmaximumtemperature", temperatures);
    Values sensitivities(16);
    if (case_.digits.force == Prescribed::force_x) { // the program asks for those of this contact
      const Sensitivities table = find_sensitivities(case_, outcome_, {3, 1e-4}, {});
      for (std::size_t k = 0; k < 16; ++k) sensitivities[k] = table[k % 4][k / 4];
    }
    add("cntc_getsensitivities", sensitivities);
  }

  void add_parameters() {
    const MaterialData& m = *case_.material;
    const bool has_layer = case_.digits.mater == Bulk::layer;
    add("cntc_getparameters_1", {case_.rolling->veloc * 1e3, case_.rolling->chi, case_.rolling->dq * 1e3, 0, 0,
                                 has_layer ? m.model_data[2] * 1e-6 : 0});
    const double flx = has_layer ? m.model_data[1] / m.model_data[0] * 1e9 : 1e-5, shear = m.shear1 * 1e-6;
    Values of_material = {shear,      m.shear2 * 1e-6,
                          shear,      m.poisson1,
                          m.poisson2, m.poisson1,
                          0,          flx,
                          flx,        has_layer ? flx : 0,
                          1,          1,
                          1,          0,
                          1,          0,
                          0,          0,
                          0,          0,
                          0,          0};
    if (has_layer) std::ranges::copy(in_file(m.model_data, units_of_model(Bulk::layer)), of_material.begin() + 14);
    add("cntc_getparameters_2", of_material);
    const auto& set = case_.friction.sets.at(0);
    const bool falls = case_.friction.law == Law::exponential;
    add("cntc_getparameters_3",
        {double(number(case_.friction.law)), 1, falls ? set[5] * 1e3 : 0, falls ? set[6] * 1e3 : 0, 0,
         falls ? set[0] + set[1] + set[3] : set[0], falls ? set[0] : set[1]});
  }

  void add_field(int code, Values values) { add("cntc_getfielddata_" + std::to_string(code), std::move(values)); }

  void add_fields() {
    const auto& n = outcome_.solution.normal;
    const SurfaceFields& f = outcome_.solution.fields;
    const ElementGrid& g = outcome_.step.grid;
    const std::size_t count = g.count();
    Values gap = outcome_.step.gap, division(count), wx(count), wy(count), yield(count);
    const Creepage& creepage = outcome_.solution.creepage;
    const double ahead = outcome_.step.motion.spin_offset * outcome_.step.motion.step; // along the way, CHI = 0
    const bool has_layer = case_.digits.mater == Bulk::layer;
    for (std::size_t k = 0; k < count; ++k) {
      gap[k] = 1e3 * (gap[k] - n.approach);
      division[k] = element_state(outcome_, k);
      const double x = g.x(static_cast<int>(k) % g.mx), y = g.y(static_cast<int>(k) / g.mx);
      wx[k] = creepage.longitudinal - creepage.spin * y;
      wy[k] = creepage.lateral + creepage.spin * (x + ahead);
      if (has_layer) {
        const auto& v = case_.material->model_data;
        yield[k] = 1e-6 * (v[2] + v[3] * outcome_.solution.slip_friction.deformation.at(k));
      }
    }
    const Values px = scaled(f.traction.x, 1e-6, count), py = scaled(f.traction.y, 1e-6, count),
                 pn = scaled(n.pressure, 1e-6, count), ux = scaled(f.displacement.x, 1e3, count),
                 uy = scaled(f.displacement.y, 1e3, count), un = scaled(n.displacement, 1e3, count),
                 sx = scaled(f.slip.x, 1, count), sy = scaled(f.slip.y, 1, count);
    add_field(CNTC_fld_h, gap);
    add_field(CNTC_fld_mu, scaled(f.friction, 1, count));
    for (const auto& [code, values] : {std::pair{CNTC_fld_px, &px},
                                       {CNTC_fld_py, &py},
                                       {CNTC_fld_pn, &pn},
                                       {CNTC_fld_ux, &ux},
                                       {CNTC_fld_uy, &uy},
                                       {CNTC_fld_un, &un},
                                       {CNTC_fld_sx, &sx},
                                       {CNTC_fld_sy, &sy},
                                       {CNTC_fld_wx, &wx},
                                       {CNTC_fld_wy, &wy},
                                       {CNTC_fld_taucrt, &yield}})
      add_field(code, *values);
    const auto plastic = plastic_deformation(case_, outcome_);
    add_field(CNTC_fld_uplsx, scaled(plastic->x, 1e3, count));
    add_field(CNTC_fld_uplsy, scaled(plastic->y, 1e3, count));
    add_field(CNTC_fld_temp1, scaled(f.temperature1, 1, count));
    add_field(CNTC_fld_temp2, scaled(f.temperature2, 1, count));
    add("cntc_gettractions_pn", pn);
    add("cntc_gettractions_px", px);
    add("cntc_gettractions_py", py);
    add("cntc_getmicroslip_sx", sx);
    add("cntc_getmicroslip_sy", sy);
    add("cntc_getdisplacements_un", un);
    add("cntc_getdisplacements_ux", ux);
    add("cntc_getdisplacements_uy", uy);
    add("cntc_getelementdivision", division);
  }

  const Case& case_;
  const Outcome& outcome_;
  int ire_, icp_;
  Lines lines_;
};

Lines interior_lines(const Outcome& o, int ire, int icp) {
  const InteriorBlock& b = o.interior.at(0);
  const std::size_t count = b.states.size();
  Lines lines;
  lines[key_of("subs_getblocksize", ire, icp)] = {double(b.points.x.size()), double(b.points.y.size()),
                                                  double(b.points.z.size())};
  Values& table = lines[key_of("subs_getresults", ire, icp)];
  table.resize(21 * count);
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [ux, uy, uz, s] = b.states[k];
    const auto principal = principal_stresses(s);
    const double lengths[] = {b.points.x_of(k), b.points.y_of(k), b.points.z_of(k), ux, uy, uz};
    const double stresses[] = {hydrostatic(s), von_mises(s), tresca(s), principal[0], principal[1],
                               principal[2],   s.xx,         s.xy,      s.xz,         s.xy,
                               s.yy,           s.yz,         s.xz,      s.yz,         s.zz};
    for (std::size_t column = 0; column < 21; ++column)
      table[column * count + k] = column < 6 ? 1e3 * lengths[column] : 1e-6 * stresses[column - 6];
  }
  return lines;
}

/// Of a wheel as a whole, and the first numbers of the patches' places.
Lines wheel_lines(const Case& c, const Outcome& o, int ire) {
  const WheelOutcome& w = *o.wheel;
  const auto& at = c.wheel_rail->position;
  const auto& moves = c.wheel_rail->velocity;
  constexpr double mm = 1e3; // in a metre
  const auto forces = [](const Wrench& track, const Wrench& wheelset) {
    Values all;
    for (const auto& [force, moment] : {track, wheelset})
      all.insert(all.end(), {force.x, force.y, force.z, mm * moment.x, mm * moment.y, mm * moment.z});
    return all;
  };
  Lines lines;
  lines[key_of("cntc_getnumcontactpatches", ire, whole)] = {double(w.patches.size())};
  lines[key_of("cntc_getwheelsetposition", ire, whole)] = {mm * at.s, mm * at.y, mm * w.z, at.roll, at.yaw, at.pitch};
  lines[key_of("cntc_getwheelsetvelocity", ire, whole)] = {mm * moves.vs, mm * moves.vy, mm * moves.vz,
                                                           moves.vroll,   moves.vyaw,    w.vpitch};
  lines[key_of("cntc_getgriddiscretization", ire, whole)] = {mm * c.wheel_rail->grid.dx, mm * c.wheel_rail->grid.ds};
  lines[key_of("cntc_getglobalforces", ire, whole)] = forces(w.track, w.wheelset);
  for (std::size_t k = 0; k < w.patches.size(); ++k) {
    const WheelPatch& patch = w.patches[k];
    const PatchLocation& l = patch.location;
    const int icp = static_cast<int>(k) + 1;
    lines[key_of("cntc_getglobalforces", ire, icp)] = forces(patch.track, patch.wheelset);
    lines[key_of("cntc_getcontactlocation", ire, icp)] = {
        mm * l.track.x, mm * l.track.y,    mm * l.track.z,  l.angle,        mm * l.rail.x,  mm * l.rail.y,
        mm * l.rail.z,  mm * patch.s_rail, l.angle_on_rail, mm * l.wheel.x, mm * l.wheel.y, mm * l.wheel.z};
    lines.merge(Expected(patch.contact, *patch.solution, ire, icp).lines());
  }
  return lines;
}

/// Those of the input file. Lines may be longer: the rest of forces and places is the same in other axes.
Lines of_the_input_file() {
  const auto cases = run_cases(input());
  for (const auto& c : cases)
    for (const auto& reason : c.outcome.reasons) ADD_FAILURE() << reason;
  Lines lines = wheel_lines(cases.at(0).input, cases[0].outcome, 1);
  lines.merge(wheel_lines(cases.at(1).input, cases[1].outcome, 2));
  for (const auto& [k, ire, icp] : {std::tuple{2u, 3, 1}, {3u, 3, 2}, {4u, 4, 5}})
    lines.merge(Expected(cases.at(k).input, cases[k].outcome, ire, icp).lines());
  lines.merge(interior_lines(*cases[0].outcome.wheel->patches.at(0).solution, 1, 1));
  lines.merge(interior_lines(cases[3].outcome, 3, 2));
  return lines;
}

TEST(EveryGetter, HasTheNumbersOfTheInputFile) {
  const Lines& found = in_c();
  const Lines wanted = of_the_input_file();
  ASSERT_FALSE(found.empty());
  for (const auto& [key, numbers] : wanted) {
    const auto line = found.find(key);
    ASSERT_NE(line, found.end()) << key;
    ASSERT_GE(line->second.size(), numbers.size()) << key;
    for (std::size_t k = 0; k < numbers.size(); ++k)
      ASSERT_DOUBLE_EQ(line->second[k], numbers[k]) << key << ", number " << k;
  }
}

TEST(EveryGetter, IsTheSameInFortran) {
  if (!fs::exists(EVERY_GETTER_FOLDER "/libcontact_every_getter_fortran")) GTEST_SKIP() << "no Fortran compiler";
  const Lines found = run("libcontact_every_getter_fortran");
  ASSERT_EQ(found.size(), in_c().size());
  for (const auto& [key, numbers] : in_c()) EXPECT_EQ(found.at(key), numbers) << key;
}

/// The numbers of calculations last, before them L, M and H where they are not 0, and the default T.
TEST(EveryGetter, TellsTheFlags) {
  EXPECT_EQ(in_c().at("cntc_getflags 3 1"), (Values{2, 0, 3, 1, 0, 4, 2, 0, 3, 0, 0, 1, CNTC_un_cntc, 1}));
  EXPECT_EQ(in_c().at("cntc_getflags 3 2"), (Values{2, 0, 3, 1, 1, 0, 2, 0, 0, 0, 0, 1, CNTC_un_cntc, 1}));
  EXPECT_EQ(in_c().at("cntc_getflags 4 5"), (Values{2, 0, 3, 0, 0, 0, 2, 4, 0, 0, 0, 1, CNTC_un_cntc, 1}));
  EXPECT_EQ(in_c().at("cntc_getflags 1 -1"), (Values{2, 0, 3, 1, 0, 0, 2, 0, 0, 0, 0, 1, CNTC_un_cntc, 1}));
}

/// The ellipse of the setter, and of its force the curvatures: 1 mm by 0.8 mm.
TEST(EveryGetter, TellsHertzsNumbers) {
  const Values h = in_c().at("cntc_gethertzcontact 3 2");
  EXPECT_NEAR(h.at(2), 1, 1e-12);
  EXPECT_NEAR(h.at(3), 0.8, 1e-12);
  EXPECT_NEAR(h.at(4) * (h.at(0) + h.at(1)), 2, 1e-12);
  EXPECT_NEAR(h.at(6), 1.25, 1e-12);
}

/// From element to element the layer deforms against the slip, which is plastic where it yields, by as much as its
/// yield stress tells.
TEST(EveryGetter, TellsThePlasticDeformation) {
  const auto field = [](int code) -> const Values& {
    return in_c().at("cntc_getfielddata_" + std::to_string(code) + " 4 5");
  };
  const Values &x = field(CNTC_fld_uplsx), &y = field(CNTC_fld_uplsy), &yield = field(CNTC_fld_taucrt),
               &sx = field(CNTC_fld_sx), &sy = field(CNTC_fld_sy), &division = in_c().at("cntc_getelementdivision 4 5");
  const double dx = in_c().at("cntc_getgriddiscretization 4 5").at(0), hardening = 500;
  constexpr std::size_t mx = 12;
  int yielding = 0;
  for (std::size_t k = 0; k + 1 < x.size(); ++k) {
    if (k % mx == mx - 1) continue; // particles come in there
    const double by_x = x[k] - x[k + 1], by_y = y[k] - y[k + 1], length = std::hypot(by_x, by_y);
    EXPECT_NEAR(length, (yield[k] - yield[k + 1]) / hardening, 1e-12) << k;
    EXPECT_NEAR(by_x * sy[k] - by_y * sx[k], 0, 1e-14) << k;
    if (division[k] != 3) continue;
    ++yielding;
    EXPECT_NEAR(by_x, -sx[k] * dx, 1e-12) << k;
    EXPECT_NEAR(by_y, -sy[k] * dx, 1e-12) << k;
  }
  EXPECT_GT(yielding, 50);
}

/// No function that gets something is left out.
TEST(EveryGetter, IsInTheProgram) {
  std::set<std::string> called;
  for (const auto& [key, numbers] : in_c()) called.insert(key.substr(0, key.find(' ')));
  std::ifstream header(MICROSLIP_SOURCE_DIR "/compat/libcontact/include/contact_addon.h");
  int count = 0;
  for (std::string line; std::getline(header, line);) {
    const std::string name = line.substr(0, line.find('(')).substr(std::min<std::size_t>(4, line.size()));
    if (!line.starts_with("int ") || name.find("_get") == std::string::npos) continue;
    ++count;
    const bool has_own_check = name == "cntc_getmaxnumthreads" || name == "cntc_getcalculationtime" ||
                               name == "cntc_getprofilevalues_new"; // times differ; the points are gotten by it
    const auto found = called.lower_bound(name);
    EXPECT_TRUE(has_own_check || (found != called.end() && found->starts_with(name))) << name;
  }
  EXPECT_GE(count, 30);
}

} // namespace
} // namespace microslip::libcontact
