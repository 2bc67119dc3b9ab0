#include "compat/libcontact/contact_problem.hpp"

#include "compat/contact/out_sections.hpp"
#include "compat/contact/rules.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "compat/libcontact/defaults.hpp"
#include "compat/libcontact/refusal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>

namespace microslip::libcontact {

using namespace contact_program;

namespace {

double cpu_time() {
  std::timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Adds what passes until its end.
class Stopwatch {
public:
  explicit Stopwatch(CalculationTime& sum) : sum_(sum) {}
  ~Stopwatch() {
    sum_.cpu += cpu_time() - cpu_;
    sum_.wall += std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  CalculationTime& sum_;
  double cpu_ = cpu_time();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

/// Elements in contact in the outer rows and columns, which count where there are three or more.
int elements_at_border(const Outcome& o) {
  const ElementGrid& g = o.step.grid;
  int count = 0;
  for (int j = 0; j < g.my; ++j)
    for (int i = 0; i < g.mx; ++i) {
      const bool outer_row = g.my >= 3 && (j == 0 || j == g.my - 1),
                 outer_column = g.mx >= 3 && (i == 0 || i == g.mx - 1);
      const auto k = static_cast<std::size_t>(j) * static_cast<std::size_t>(g.mx) + static_cast<std::size_t>(i);
      count += (outer_row || outer_column) && element_state(o, k) > 0;
    }
  return count;
}

/// Of a contact whose problems did not converge; 0 otherwise.
int code_of(const ContactStepSolution& s) {
  switch (s.report.status) {
  case Status::ok:
  case Status::no_contact:
    return 0;
  case Status::not_converged:
    return s.normal.status == Status::not_converged ? CNTC_err_norm : CNTC_err_tang;
  case Status::no_solution:
    return CNTC_err_tol;
  case Status::invalid_input:
  case Status::implausible:  // of wheels on rails by the library's solvers, and
  case Status::out_of_range: // of tables, which this library has not
    break;
  }
  return CNTC_err_other;
}

void set_wheel_defaults(WheelRailData& d) {
  constexpr DefaultOf of = DefaultOf::wheel;
  d.digits.config = default_choice<Config>("C", of);
  d.digits.force = default_choice<TotalForce>("F", of);
  d.search = d.digits.discns = default_choice<ContactSearch>("D", of);
  d.digits.ztrack = TrackSource::all; // the library's functions give what a file's digits would have read
  d.digits.ewheel = WheelsetSource::all;
  d.grid.dx = default_of("DX", of);
  d.grid.ds = default_of("DS", of);
  d.grid.dqrel = default_of("DQREL", of);
  d.grid.a_sep = default_of("A_SEP", of);
  d.grid.d_sep = default_of("D_SEP", of);
  d.grid.d_comb = default_of("D_COMB", of);
  d.grid.d_turn = default_of("D_TURN", of);
  d.grid.g_miss = default_of("G_MISS", of);
  d.track.gauge_height = default_of("GAUGHT", of);
  d.track.gauge_width = default_of("GAUGWD", of);
  d.support.ky = default_of("KYRAIL", of);
  d.support.kz = default_of("KZRAIL", of);
  d.support.first_step = default_of("DYSTEP0", of);
  d.wheelset.flange_back_distance = default_of("FBDIST", of);
  d.wheelset.flange_back_position = default_of("FBPOS", of);
  d.wheelset.nominal_radius = default_of("NOMRADW", of);
  d.wheelset.tape_circle = default_of("YTAPE", of);
  d.velocity.vs = default_of("VS", of);
}

void set_contact_defaults(Case& c) {
  constexpr DefaultOf of = DefaultOf::contact;
  c.digits.force = default_choice<Prescribed>("F", of);
  c.digits.discns = GridSource::read; // what the library's functions have given
  c.digits.rznorm = DistanceSource::read;
  c.extra = default_choice<ExtraSlip>("E", of);
  c.geometry.base = default_choice<Base>("IBASE", of);
  c.geometry.values = {default_of("B1", of), 0, default_of("B3", of), 0, 0, 0};
  c.rolling->dq = default_of("DQ", of);
  c.rolling->veloc = default_of("VELOC", of);
  c.rolling->facphi = default_of("FACPHI", of);
}

void set_digit_defaults(Digits& d) {
  d.pvtime = default_choice<Continuation>("P");
  d.bound = default_choice<PressureModel>("B");
  d.tang = default_choice<Tangential>("T");
  d.norm = default_choice<Normal>("N");
  d.frclaw = default_choice<Law>("L");
  d.inflcf = default_choice<Coefficients>("C3");
  d.mater = default_choice<Bulk>("M");
  d.heat = default_choice<Heat>("H");
  d.gausei = default_choice<SolverChoice>("G");
  d.iestim = default_choice<InitialGuess>("I");
  d.matfil = default_choice<Stored>("A");
  d.output = default_choice<PrintLevel>("O");
  d.flow = default_choice<FlowLevel>("W");
  d.solve = default_choice<Treatment>("R");
}

void set_solver_defaults(SolverData& s) {
  s.method = default_choice<SolverChoice>("G");
  s.maxgs = static_cast<int>(default_of("MAXGS"));
  s.maxin = static_cast<int>(default_of("MAXIN"));
  s.maxnr = static_cast<int>(default_of("MAXNR"));
  s.maxout = static_cast<int>(default_of("MAXOUT"));
  s.eps = default_of("EPS");
  s.omegah = default_of("OMEGAH");
  s.omegas = default_of("OMEGAS");
  s.omgslp = default_of("OMGSLP");
  s.npot_max = static_cast<int>(default_of("NPOT_MAX", DefaultOf::wheel));
}

MaterialData default_material() {
  MaterialData m;
  m.coefficients = default_choice<Coefficients>("C3");
  m.correction.method = static_cast<int>(default_of("IF_METH", DefaultOf::wheel));
  m.correction.variant = static_cast<int>(default_of("VARIANT", DefaultOf::wheel));
  m.poisson1 = default_of("POISS1");
  m.poisson2 = default_of("POISS2");
  m.shear1 = default_of("GG1");
  m.shear2 = default_of("GG2");
  m.model = default_choice<Bulk>("M");
  return m;
}

void set_defaults(Case& c) {
  set_digit_defaults(c.digits);
  set_solver_defaults(c.solver);
  c.friction.law = default_choice<Law>("L");
  c.friction.sets = {{default_of("FSTAT"), default_of("FKIN")}};
  c.rolling.emplace(); // of wheels each patch has one
  c.material = default_material();
}

bool is_missing(const ProfileRecord& profile) {
  return !profile.curve && !is_variable(profile);
}

/// Refuses elements so small that the search over the profiles would need more memory than a host has to spare.
void check_sizes(const WheelRailData& w) {
  constexpr double most_on_line = 1e6, most_on_surface = 2e7, other_width = 0.2; // points, [m]
  constexpr double part_of_ds = 0.3, part_of_radius = 0.5;                       // at the most
  const double width = w.rail.curve ? w.rail.curve->greatest_y() - w.rail.curve->least_y() : other_width;
  const double across = width / (part_of_ds * w.grid.ds);
  const double along = part_of_radius * std::max(w.wheelset.nominal_radius, mm) / w.grid.dx;
  const bool on_surface = w.search == ContactSearch::brute_force || w.search == ContactSearch::steep ||
                          is_variable(w.rail) || is_variable(w.wheel);
  if (across > most_on_line || (on_surface && across * along > most_on_surface))
    throw Refusal(CNTC_err_discr, "DX or DS is too small for the search over the profiles");
}

void check_wheel(const WheelRailData& w) {
  if (is_missing(w.rail)) throw Refusal(CNTC_err_profil, "there is no rail profile");
  if (is_missing(w.wheel)) throw Refusal(CNTC_err_profil, "there is no wheel profile");
  check_sizes(w);
}

int code_of(BrokenRule::Subject subject) {
  switch (subject) {
  case BrokenRule::Subject::discretisation:
    return CNTC_err_discr;
  case BrokenRule::Subject::force:
    return CNTC_err_ftot;
  case BrokenRule::Subject::digits:
    break;
  }
  return CNTC_err_other;
}

/// What a reader of input files would refuse.
void check(const Case& c) {
  if (c.wheel_rail) check_wheel(*c.wheel_rail);
  if (!c.wheel_rail && !c.potential) throw Refusal(CNTC_err_discr, "there is no potential contact");
  if (const auto broken = broken_rule(c)) throw Refusal(code_of(broken->subject), broken->text);
}

} // namespace

ContactProblem::ContactProblem(int element, int number) : element_(element), number_(number) {
  set_defaults(data);
  if (is_wheel())
    set_wheel_defaults(data.wheel_rail.emplace());
  else
    set_contact_defaults(data);
}

/// The case that the settings make.
Case ContactProblem::completed() const {
  Case c = data;
  const Digits& d = c.digits;
  c.number = c.number_in_element = calculations_ + 1;
  c.sequence = {element_, is_wheel() ? 1 : number_};
  if (!outcome_) {
    c.digits.pvtime = Continuation::nothing;
    c.digits.iestim = InitialGuess::nothing;
  }
  c.digits.exrhs = c.extra;
  const bool by_force = d.norm == Normal::force;
  if (is_wheel()) {
    WheelRailData& w = *c.wheel_rail;
    w.digits.discns = w.search;
    w.position.vertical = by_force ? Vertical(VerticalForce{vertical_force}) : VerticalPosition{z};
    w.velocity.pitch =
        w.digits.force == TotalForce::force_x ? PitchDrive(LongitudinalForce{force_x}) : PitchVelocity{vpitch};
    if (w.digits.is_roller()) w.track.cant = 0; // as CONTACT does
    return c;
  }
  c.load =
      by_force ? NormalLoad{NormalLoad::Given::force, normal_force} : NormalLoad{NormalLoad::Given::approach, approach};
  c.formed = c.load;
  const auto& [x, y, spin, length] = creepages;
  const bool shifts = d.tang == Tangential::shift;
  const double unit = shifts ? length : 1;
  c.x = d.force == Prescribed::creepages ? SlipOrForce(Slip{unit * x}) : ForceRatio{ratio_x};
  c.y = d.force == Prescribed::force_x_and_y ? SlipOrForce(ForceRatio{ratio_y}) : Slip{unit * y};
  c.phi = shifts ? spin : spin * (1 / length);
  return c;
}

int ContactProblem::code_of_refusal() const {
  return is_wheel() && !outcome_->is_unsupported ? CNTC_err_search : CNTC_err_other;
}

ProfileShape ContactProblem::profile(bool of_wheel) {
  const ProfileRecord& record = of_wheel ? wheel().wheel : wheel().rail;
  if (is_missing(record)) throw Refusal(CNTC_err_profil, "there is no such profile");
  try {
    return wheel_.profile(record, of_wheel ? ProfileRole::wheel : ProfileRole::rail);
  } catch (const Error& error) {
    throw Refusal(CNTC_err_profil, error.what());
  }
}

Calculation ContactProblem::calculate(const std::function<void(const Case&)>& begins) {
  Calculation calculation;
  Case next = completed();
  check(next);
  if (time_step != 1 && next.digits.tang == Tangential::shift && next.friction.law != Law::coulomb)
    throw Refusal(CNTC_err_other, "a time step other than 1 s with friction that depends on the slip is not supported");
  ++calculations_;
  begins(next);
  calculation.is_skipped = next.digits.is_skipped();
  if (calculation.is_skipped) return calculation;
  // What is thrown from here on leaves no solution, rather than one of another case.
  outcome_.reset();
  interior_.clear();
  sensitivities_.clear();
  solved_ = std::move(next);
  solve(calculation);
  return calculation;
}

void ContactProblem::solve(Calculation& calculation) {
  const Stopwatch stopwatch(time);
  outcome_ = is_wheel() ? wheel_.run(solved_) : contact_.run(solved_);
  calculation.messages = outcome_->kind == Outcome::Kind::refused ? outcome_->reasons : outcome_->notes;
  if (outcome_->kind == Outcome::Kind::refused) {
    calculation.code = code_of_refusal();
    outcome_->wheel.reset();
    return;
  }
  if (!is_finite()) {
    outcome_.reset();
    throw Refusal(CNTC_err_other, "settings so large or so small that the forces are no numbers");
  }
  calculation.code = code_of_solution();
  keep_what_was_found();
  find_sensitivities();
}

bool ContactProblem::is_finite() const {
  for (int k = 1; k <= contacts(); ++k) {
    const PrintedTotals& t = contact(k).outcome.totals;
    for (const double number : {t.fn, t.fx, t.fy, t.mz, t.approach})
      if (!std::isfinite(number)) return false;
  }
  return true;
}

int ContactProblem::code_of_solution() const {
  if (is_wheel() && outcome_->misses_force) return CNTC_err_ftot;
  int border = 0;
  for (int k = 1; k <= contacts(); ++k) {
    const Outcome& o = contact(k).outcome;
    if (const int code = code_of(o.solution)) return code;
    border += elements_at_border(o);
  }
  return border;
}

/// Inputs that were unknowns.
void ContactProblem::keep_what_was_found() {
  if (is_wheel()) {
    z = outcome_->wheel->z;
    vpitch = outcome_->wheel->vpitch;
    return;
  }
  if (solved_.digits.norm == Normal::force)
    approach = outcome_->solution.normal.approach;
  else
    normal_force = outcome_->totals.fn;
}

void ContactProblem::find_sensitivities() {
  sensitivities_.resize(static_cast<std::size_t>(contacts()));
  if (sensitivity.of == 1 && !is_wheel() && contact_program::prints(solved_, 2))
    outcome_->sensitivities = printed_sensitivities(solved_, *outcome_, contact_.started_from());
  if (sensitivity.of < 2) return;
  for (std::size_t k = 0; k < sensitivities_.size(); ++k) {
    const Contact c = contact(static_cast<int>(k) + 1);
    const auto start = is_wheel() ? wheel_.started_from(k) : contact_.started_from();
    sensitivities_[k] = contact_program::find_sensitivities(c.data, c.outcome, sensitivity, start);
  }
  if (!is_wheel()) outcome_->sensitivities = sensitivities_[0];
}

bool ContactProblem::writes_input() const {
  const auto found = other_flags.find(CNTC_if_wrtinp);
  return found != other_flags.end() && found->second > 0;
}

std::vector<int> ContactProblem::contacts_of(int icp) const {
  if (!is_wheel() || icp > 0) return {icp};
  std::vector<int> all(static_cast<std::size_t>(contacts()));
  std::iota(all.begin(), all.end(), 1);
  return all;
}

int ContactProblem::contacts() const {
  if (!outcome_ || outcome_->kind != Outcome::Kind::solved) return 0;
  return is_wheel() ? static_cast<int>(outcome_->wheel->patches.size()) : 1;
}

std::size_t ContactProblem::index(int patch) const {
  if (contacts() == 0) throw Refusal(CNTC_err_icp, "there is no solution yet");
  if (!is_wheel()) return 0;
  if (patch < 1 || patch > contacts())
    throw Refusal(CNTC_err_icp,
                  "icp = " + std::to_string(patch) + ": there are " + std::to_string(contacts()) + " contact patches");
  return static_cast<std::size_t>(patch) - 1;
}

const WheelPatch& ContactProblem::patch(int patch) const {
  return outcome_->wheel->patches[index(patch)];
}

Contact ContactProblem::contact(int number) const {
  index(number);
  if (!is_wheel()) return {solved_, *outcome_};
  const WheelPatch& p = patch(number);
  return {p.contact, *p.solution};
}

const WheelOutcome& ContactProblem::solved_wheel() const {
  if (!outcome_ || !outcome_->wheel) throw Refusal(CNTC_err_icp, "there is no solution yet");
  return *outcome_->wheel;
}

const Sensitivities& ContactProblem::sensitivities(int patch) const {
  return sensitivities_[index(patch)];
}

std::vector<PointBlock>& ContactProblem::points(int patch) {
  return is_wheel() && patch > 0 ? points_of_patch_[patch] : points_;
}

void ContactProblem::find_interior(int patch) {
  if (contacts() == 0) throw Refusal(CNTC_err_icp, "there is no solution yet");
  const Stopwatch stopwatch(time);
  for (const int k : contacts_of(patch)) {
    const Contact found = contact(k);
    Case c = found.data;
    const auto own = points_of_patch_.find(k);
    c.points = is_wheel() && own != points_of_patch_.end() && !own->second.empty() ? own->second : points_;
    c.digits.stress = InteriorPoints::read;
    InteriorSequence sequence;
    interior_[k] = interior_blocks(c, found.outcome.step, found.outcome.solution, sequence);
  }
}

const std::vector<InteriorBlock>& ContactProblem::interior(int patch) const {
  const auto found = interior_.find(patch);
  if (found == interior_.end()) throw Refusal(CNTC_err_icp, "fields inside the bodies have not been calculated yet");
  return found->second;
}

} // namespace microslip::libcontact
