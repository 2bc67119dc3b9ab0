#include "validation/studies.hpp"

#include "compat/contact/run.hpp"
#include "compat/contact/set_up.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/accurate_contact.hpp"
#include "validation/contact_output.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

namespace fs = std::filesystem;
using contact_program::Case;
using contact_program::Outcome;

constexpr const char* printed_file = MICROSLIP_REFERENCE_DATA "/contact_results.csv";
constexpr const char* input_folder = MICROSLIP_REFERENCE_DATA "/../contact-cases";
constexpr double relative_difference = 0.005, of_friction_limit = 0.002; ///< that are allowed
constexpr const char* input_files[] = {"bentall",          "carter2d",    "catt_to_cart", "cattaneo", "conformal",
                                       "ertz_temperature", "fastsim",     "plastic_3bl",  "spence35", "subsurf",
                                       "tractcurv",        "veldep_fric", "visc_cylindr"};

/// What CONTACT printed for a case, by the names of the columns.
using Printed = std::map<std::string, PrintedNumber>;

/// Columns by the names that CONTACT's output has.
constexpr std::pair<const char*, const char*> columns[] = {{"fn", "FN"},
                                                           {"fx", "FX"},
                                                           {"fy_or_fs", "FY"},
                                                           {"mz", "MZ"},
                                                           {"elas_energy", "ELAST.EN."},
                                                           {"fric_power_or_work", "FRIC.POWER"},
                                                           {"fn_over_g", "FN/G"},
                                                           {"fx_rel_or_creep", "FX/FSTAT/FN"},
                                                           {"fy_rel_or_creep", "FY/FSTAT/FN"},
                                                           {"approach", "APPROACH"},
                                                           {"pmax", "PMAX"},
                                                           {"npot", "NPOT"},
                                                           {"ncon", "NCON"},
                                                           {"nadh", "NADH"},
                                                           {"nslip", "NSLIP"}};

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) result.push_back(cell);
  return result;
}

/// By file and number of the case.
std::map<std::string, std::map<int, Printed>> read_printed() {
  std::map<std::string, std::map<int, Printed>> files;
  std::ifstream in(printed_file);
  std::string line;
  std::getline(in, line);
  const auto names = cells(line);
  while (std::getline(in, line)) {
    const auto values = cells(line);
    Printed printed;
    for (std::size_t k = 2; k < std::min(names.size(), values.size()); ++k)
      if (const auto number = printed_number(values[k])) printed[names[k]] = *number;
    files[fs::path(values.at(0)).stem().string()][std::stoi(values.at(1))] = printed;
  }
  return files;
}

/// What is in the program's output and not among the columns.
std::map<int, Printed> read_output(const std::string& name) {
  std::map<int, Printed> cases;
  std::ifstream in(fs::path(input_folder) / (name + ".ref_out"));
  for (const PrintedCase& printed : read_contact_output(in))
    for (const auto& [column, printed_name] : columns) {
      const auto found = printed.totals.find(printed_name);
      if (found != printed.totals.end()) cases[printed.number][column] = found->second;
    }
  return cases;
}

/// Extremes of the stresses inside the bodies that CONTACT prints for a case, one block of points after the other, in
/// the order of interior_extremes.
std::map<int, std::vector<double>> read_extremes(const std::string& name) {
  std::map<int, std::vector<double>> extremes;
  std::ifstream in(fs::path(input_folder) / (name + ".ref_out"));
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string first, second, equals;
    double value = 0;
    words >> first >> second;
    if (first == "Case" && !second.empty()) number = std::stoi(second);
    if (first != "MAX" && first != "MIN" && first != "ABSMAX") continue;
    if (second.starts_with("SIG") && words >> equals >> value) extremes[number].push_back(value);
  }
  return extremes;
}

/// A quantity of a case, ours beside theirs.
struct Comparison {
  std::string name;
  double ours, theirs;
  double printed_to; ///< half a unit of the last digit of theirs
  double allowed;
  double share() const { return std::max(0.0, std::abs(ours - theirs) - printed_to) / allowed; }
};

/// A row of elements of the contact.
double row_of_elements(const Outcome& o) {
  const ElementGrid& grid = o.step.grid;
  int longest = 1;
  for (int j = 0; j < grid.my; ++j) {
    int row = 0;
    for (int i = 0; i < grid.mx; ++i) row += o.solution.normal.pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0;
    longest = std::max(longest, row);
  }
  return grid.my == 1 ? 1 : longest;
}

std::vector<Comparison> compare(const Outcome& o, const Printed& printed) {
  const contact_program::PrintedTotals& t = o.totals;
  std::vector<Comparison> all;
  const auto add = [&](const char* column, const std::string& name, double ours, double least) {
    const auto found = printed.find(column);
    if (found == printed.end()) return;
    const auto& [theirs, rounding] = found->second;
    all.push_back({name, ours, theirs, rounding, std::max(relative_difference * std::abs(theirs), least)});
  };
  const double limit = o.step.friction.empty() ? t.fn : o.step.friction[0].static_coefficient() * t.fn;
  const double length = std::sqrt(t.contact * o.step.grid.element_area() * 1e6 / std::numbers::pi);
  const double force = of_friction_limit * limit, row = row_of_elements(o);
  add("fn", "FN", t.fn, 0);
  add("fx", "FX", t.fx, force);
  add("fy_or_fs", "FY", t.fy, force);
  add("mz", "MZ", t.mz, force * length);
  add("elas_energy", "ELAST.EN.", t.elastic_energy, 0);
  add("fric_power_or_work", "FRIC", t.friction, 1e-9 * std::abs(t.elastic_energy));
  add("fn_over_g", "FN/G", t.fn_over_g, 0);
  add("fx_rel_or_creep", t.x_name, t.x, o.step.force_x ? 0 : of_friction_limit);
  const double least_creep = relative_difference * std::abs(t.x);
  add("fy_rel_or_creep", t.y_name, t.y, o.step.force_y ? least_creep : of_friction_limit);
  add("approach", "APPROACH", t.approach, 0);
  add("pmax", "PMAX", t.peak_pressure, 0);
  add("npot", "NPOT", t.potential, 0.5);
  add("ncon", "NCON", t.contact, row);
  add("nadh", "NADH", t.adhesion, row);
  add("nslip", "NSLIP", t.slip, row);
  return all;
}

/// A case of steady rolling that both discretisations can take, with part of the contact in adhesion: -Fx, -Fy over mu
/// Fn.
struct SteadyCase {
  std::string name;
  EllipticContact contact;
  RollingDirection direction;
  Method method; ///< second order, as many elements across as the case has
  double fx, fy; ///< classical
};

std::optional<SteadyCase> steady_case(const std::string& name, const Case& c, const Outcome& o) {
  using namespace contact_program; // its digits
  const ContactStep& step = o.step;
  const auto gap = gap_curvatures(c);
  const bool is_plain = c.digits.tang == Tangential::steady && c.digits.mater == Bulk::elastic &&
                        c.friction.law == Law::coulomb && !c.friction.by_row &&
                        c.digits.force == Prescribed::creepages && c.extra == ExtraSlip::none &&
                        !step.bodies.are_coupled() && !step.given;
  if (!is_plain || !gap || !(gap->y > 0) || o.solution.adhesion_elements == 0 || o.solution.slip_elements == 0)
    return {};
  const CombinedMaterial& material = step.bodies.material;
  const HertzContact hertz = hertz_from_load(*gap, material, o.totals.fn);
  const auto across = [](double axis, double element) { return static_cast<int>(std::lround(2 * axis / element)); };
  return SteadyCase{
      .name = fmt::format("{}, case {}", name, c.number),
      .contact = {.a = hertz.a,
                  .b = hertz.b,
                  .shear_modulus = material.shear_modulus,
                  .poisson_ratio = material.poisson_ratio,
                  .normal_force = hertz.normal_force,
                  .friction = step.friction[0],
                  .creepage = step.motion.creepage,
                  .rolling_speed = step.motion.rolling_speed},
      .direction = step.motion.direction,
      .method = {.mx = across(hertz.a, step.grid.dx), .my = across(hertz.b, step.grid.dy), .tolerance = 1e-7},
      .fx = o.totals.x,
      .fy = o.totals.y};
}

/// Which discretisation is nearer to the limit of nested grids, for the cases of rolling with adhesion and slip.
bool compare_discretisations(Report& report, const std::vector<SteadyCase>& cases, const Progress& progress) {
  constexpr double accuracy = 2e-4;
  report.heading(
      "Errors of Fx, Fy in mu Fn against the limit on nested grids: elements across, classical, second order");
  double sum_classical = 0, sum_second = 0;
  int nearer = 0;
  for (const SteadyCase& c : cases) {
    const double limit = c.contact.friction.static_coefficient() * c.contact.normal_force;
    const RollingProblem problem = rolling_problem(c.contact, {.direction = c.direction});
    Method to_accuracy = c.method;
    to_accuracy.accuracy = accuracy;
    const AccurateContact exact = AccurateContactSolver(to_accuracy).solve(problem);
    const ContactForces second = Solver(c.method).solve(problem).forces();
    const Vec2 to_classical = {c.fx - exact.forces.fx / limit, c.fy - exact.forces.fy / limit};
    const Vec2 to_second = {(second.fx - exact.forces.fx) / limit, (second.fy - exact.forces.fy) / limit};
    const double classical = std::hypot(to_classical.x, to_classical.y), own = std::hypot(to_second.x, to_second.y);
    report.line(fmt::format("{:<26} {:>3} x {:<3}  {:>8.5f} {:>8.5f}   {:>8.5f} {:>8.5f}", c.name, c.method.mx,
                            c.method.my, to_classical.x, to_classical.y, to_second.x, to_second.y));
    sum_classical += classical * classical;
    sum_second += own * own;
    nearer += own < classical && exact.forces.status == Status::ok;
    if (progress && !progress(double(&c - cases.data() + 1) / double(cases.size()))) return false;
  }
  const auto count = static_cast<double>(cases.size());
  report.line(fmt::format("rms: classical {:.5f}, second order {:.5f}", std::sqrt(sum_classical / count),
                          std::sqrt(sum_second / count)));
  report.figure("second order is nearer", fmt::format("{}", nearer), fmt::format("{}", cases.size()),
                nearer == static_cast<int>(cases.size()));
  return true;
}

/// The cases of a file, one after the other.
class FileComparison {
public:
  FileComparison(Report& report, std::string name, std::map<int, Printed> printed)
      : report_(report), name_(std::move(name)), printed_(std::move(printed)), extremes_(read_extremes(name_)) {}

  /// False if it was asked to stop.
  bool run(const Progress& progress) {
    const fs::path path = fs::path(input_folder) / (name_ + ".inp");
    std::ifstream in(path);
    if (!in) throw Error(path.string() + ": cannot be read");
    contact_program::InputReader reader(in, path.filename().string());
    contact_program::Run runs;
    report_.heading(name_ + ".inp");
    int last = printed_.empty() ? 1 : printed_.rbegin()->first;
    while (const Case* c = reader.next()) {
      take(*c, runs.run(*c));
      if (progress && !progress(std::min(1.0, static_cast<double>(c->number) / last))) return false;
    }
    finish();
    return true;
  }
  const std::vector<SteadyCase>& rolling_cases() const { return rolling_; }

private:
  void take(const Case& c, const Outcome& o) {
    ++cases_;
    if (o.kind == Outcome::Kind::refused) {
      for (const auto& reason : o.reasons) ++refused_[reason];
      return;
    }
    if (o.kind != Outcome::Kind::solved) return;
    ++solved_;
    converged_ += o.solution.report.status == Status::ok;
    note_extremes(c.number, o);
    if (auto rolling = steady_case(name_, c, o)) rolling_.push_back(std::move(*rolling));
    const auto found = printed_.find(c.number);
    if (found == printed_.end()) return;
    ++compared_;
    for (const Comparison& comparison : compare(o, found->second)) note(c.number, comparison);
  }

  /// Stresses are printed to three decimals [N/mm2].
  void note_extremes(int number, const Outcome& o) {
    const auto theirs = extremes_.find(number);
    if (theirs == extremes_.end()) return;
    std::vector<std::pair<std::string, double>> ours;
    for (const auto& [points, states] : o.interior)
      for (const auto& [name, value, point] : interior_extremes(states)) ours.emplace_back(name, value * 1e-6);
    for (std::size_t k = 0; k < std::min(ours.size(), theirs->second.size()); ++k) {
      ++stresses_;
      const auto& [name, value] = ours[k];
      const double printed = theirs->second[k];
      if (std::abs(value - printed) <= 0.501e-3)
        ++stresses_to_the_digit_;
      else
        report_.near(fmt::format("case {}, {}", number, name), "{:.4f}", value, "{:.3f}", printed,
                     relative_difference * std::abs(printed) + 0.5e-3);
    }
  }

  void note(int number, const Comparison& c) {
    ++quantities_;
    to_the_digit_ += std::abs(c.ours - c.theirs) <= 1.001 * c.printed_to;
    if (c.share() > 1)
      report_.figure(fmt::format("case {}, {}", number, c.name), fmt::format("{:.5g}", c.ours),
                     fmt::format("{:.4g}", c.theirs), false);
    const double scale = std::max(std::abs(c.theirs), c.allowed / relative_difference);
    const double difference = std::max(0.0, std::abs(c.ours - c.theirs) - c.printed_to) / scale;
    if (difference > largest_) {
      largest_ = difference;
      where_ = fmt::format("{} of case {}", c.name, number);
    }
  }

  void finish() {
    report_.count("cases solved that run", converged_, solved_);
    for (const auto& [reason, count] : refused_)
      report_.remark(fmt::format("not run: {} of {} cases", count, cases_), "", "", reason);
    if (quantities_ == 0) return;
    report_.line(fmt::format("printed by CONTACT: {} of the cases, {} quantities, {} equal to the digits printed",
                             compared_, quantities_, to_the_digit_));
    if (stresses_ > 0)
      report_.line(fmt::format("extremes of stresses inside the bodies: {}, {} equal to the three decimals printed",
                               stresses_, stresses_to_the_digit_));
    if (largest_ > 0)
      report_.line(fmt::format("largest difference beyond the digits printed: {:.2e}, {}", largest_, where_));
  }

  Report& report_;
  std::string name_;
  std::map<int, Printed> printed_;
  std::map<int, std::vector<double>> extremes_;
  std::vector<SteadyCase> rolling_;
  std::map<std::string, int> refused_;
  int cases_ = 0, solved_ = 0, converged_ = 0, compared_ = 0, quantities_ = 0, to_the_digit_ = 0, stresses_ = 0,
      stresses_to_the_digit_ = 0;
  double largest_ = 0;
  std::string where_;
};

} // namespace

bool run_contact_cases(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  if (!fs::exists(printed_file) || !fs::exists(input_folder)) {
    report.line("SKIPPED: contact_results.csv or the folder of CONTACT's cases is not beside MICROSLIP_REFERENCE_DATA");
    return true;
  }
  const auto printed = read_printed();
  report.line("Classical elements, CONTACT's grids; differences over the value, or over 0.4 of the friction limit");
  std::vector<SteadyCase> rolling;
  double done = 0;
  for (const char* name : input_files) {
    const auto found = printed.find(name);
    FileComparison file(report, name, found == printed.end() ? read_output(name) : found->second);
    const double end = done + 0.8 / std::size(input_files);
    if (!file.run(part_of(options.progress, done, end))) return false;
    rolling.insert(rolling.end(), file.rolling_cases().begin(), file.rolling_cases().end());
    done = end;
  }
  if (!compare_discretisations(report, rolling, part_of(options.progress, done, 1))) return false;
  return report.all_as_stated();
}

} // namespace microslip::validation
