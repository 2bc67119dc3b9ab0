#include "compat/contact/input_text.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <span>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

/// The number of millimetres that is read as this length [m] again.
double millimetres(double length) {
  constexpr double per_m = 1e3, mm = 1e-3;
  const double near = length * per_m, infinity = std::numeric_limits<double>::infinity();
  for (const double one : {near, std::nextafter(near, -infinity), std::nextafter(near, infinity)})
    if (one * mm == length) return one;
  return near;
}

double number_of(const Vertical& vertical) {
  const auto* force = std::get_if<VerticalForce>(&vertical);
  return force ? force->fz : std::get<VerticalPosition>(vertical).z;
}

double number_of(const PitchDrive& drive) {
  if (const auto* force = std::get_if<LongitudinalForce>(&drive)) return force->fx;
  if (const auto* moment = std::get_if<PitchMoment>(&drive)) return moment->my;
  return std::get<PitchVelocity>(drive).rate;
}

bool is_used(const WheelDeflection& d) {
  for (const double value : {d.dx, d.dy, d.dz, d.droll, d.dyaw, d.dpitch, d.vx, d.vy, d.vz, d.vroll, d.vyaw, d.vpitch})
    if (value != 0) return true;
  return false;
}

/// Writes the records of a case in their order.
class CaseText {
public:
  explicit CaseText(const Case& c) : case_(c) {}

  std::string text() {
    const auto& [element, problem] = case_.sequence;
    text_ = fmt::format("{:2} {} {}  MODULE, RE, CP  % case {}\n", case_.wheel_rail ? 1 : 3, element, problem,
                        case_.number_in_element);
    if (case_.wheel_rail)
      add_wheel(*case_.wheel_rail);
    else
      add_contact();
    return std::move(text_);
  }

private:
  void add_contact() {
    const Digits& d = case_.digits;
    add_control({number(d.pvtime), number(d.bound), number(d.tang), number(d.norm), number(d.force), points_digit()},
                "P-B-T-N-F-S");
    const int sets = number(case_.friction.by_row ? FrictionSets::by_row : FrictionSets::one);
    add_control({sets, number(case_.friction.law), number(GridSource::read), coefficients(), number(d.mater),
                 number(DistanceSource::read), number(case_.extra)},
                "V-L-D-C-M-Z-E", damping_digit());
    add_third_control();
    add_solver();
    const bool of_force = d.norm == Normal::force;
    add({of_force ? case_.load.value : millimetres(case_.load.value), contact_program::number_of(case_.x),
         contact_program::number_of(case_.y), case_.phi, case_.spin_x, case_.spin_y},
        of_force ? "FN, KSI, ETA, PHI, SPINXO, SPINYO" : "PEN, KSI, ETA, PHI, SPINXO, SPINYO");
    if (!case_.friction.by_row) add_friction_set(case_.friction.sets.at(0));
    if (d.rolls()) {
      const RollingData& r = *case_.rolling;
      add({r.chi, r.dq, r.veloc, r.facphi}, "CHI, DQ, VELOC, FACPHI");
    }
    add_correction();
    add_material();
    add_potential();
    if (!case_.potential->is_hertzian()) add_geometry();
    if (case_.friction.by_row)
      for (const auto& set : case_.friction.sets) add_friction_set(set);
    if (case_.extra == ExtraSlip::by_element) add_list(case_.extra_slip);
    add_points();
  }

  void add_wheel(const WheelRailData& w) {
    const Digits& d = case_.digits;
    const WheelRailDigits& own = w.digits;
    const bool bends = own.reads_flexibility() || is_used(w.deflection);
    add_control({number(own.config), number(d.pvtime), number(d.bound), number(d.tang), number(d.norm),
                 number(own.force), points_digit()},
                "C-P-B-T-N-F-S");
    add_control({number(friction_stations()), number(case_.friction.law), number(w.search), coefficients(),
                 number(d.mater), number(TrackSource::all),
                 number(bends ? WheelsetSource::all_flexible : WheelsetSource::all)},
                "V-L-D-C-M-Z-E", damping_digit());
    add_third_control();
    add_solver();
    add_friction();
    add_correction();
    add_material();
    const PatchRules& g = w.grid;
    add({g.dx, g.ds, g.dqrel, g.a_sep, g.d_sep, g.d_comb, g.d_turn, g.g_miss},
        "DX, DS, DQREL, A_SEP, D_SEP, D_COMB, D_TURN, G_MISS");
    add_track(w);
    add_wheelset(w, bends);
    add_points();
  }

  void add(std::initializer_list<double> values, const char* names) {
    for (const double value : values) add_number(value);
    text_ += fmt::format("  % {}\n", names);
  }
  /// Many numbers on several lines.
  void add_list(std::span<const double> values) {
    constexpr std::size_t on_a_line = 8;
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (k > 0 && k % on_a_line == 0) text_ += "\n";
      add_number(values[k]);
    }
    text_ += "\n";
  }
  void add_number(double value) {
    if (!std::isfinite(value)) throw Error("an input file cannot have a number that is not finite");
    text_ += fmt::format(" {}", value);
  }
  void add_integers(std::initializer_list<int> values, const char* names) {
    for (const int value : values) text_ += fmt::format(" {}", value);
    text_ += fmt::format("  % {}\n", names);
  }
  void add_control(std::initializer_list<int> digits, const char* names, const char* more = "") {
    text_ += " ";
    for (const int digit : digits) text_ += fmt::format("{}", digit);
    text_ += fmt::format("{}  % {}\n", more, names);
  }

  void add_third_control() {
    const Digits& d = case_.digits;
    const Heat heat = d.heat == Heat::none ? Heat::none : Heat::read;
    const Treatment solve = d.is_skipped() ? Treatment::skip : Treatment::solve;
    add_control({number(Trace::none), number(heat), number(solver()), number(d.iestim), number(d.matfil),
                 number(d.output), number(d.flow), number(solve)},
                "X-H-G-I-A-O-W-R");
  }

  SolverChoice solver() const {
    const SolverChoice method = case_.solver.method;
    return method == SolverChoice::gd_steady ? SolverChoice::standard : method;
  }
  int coefficients() const {
    const Coefficients c = case_.material->coefficients;
    if (c == Coefficients::from_file) throw Error("C = 9: the name of the file of coefficients is not kept");
    return number(c);
  }
  int points_digit() const {
    const bool has_points = case_.digits.stress != InteriorPoints::none && !case_.points.empty();
    return number(has_points ? InteriorPoints::read : InteriorPoints::none);
  }
  const char* damping_digit() const { return case_.damping ? " 2" : ""; }
  FrictionStations friction_stations() const {
    return case_.friction.stations.empty() ? FrictionStations::one : case_.wheel_rail->digits.varfrc;
  }

  void add_solver() {
    const SolverData& s = case_.solver;
    text_ += fmt::format(" {} {} {} {}", s.maxgs, s.maxin, s.maxnr, s.maxout);
    add_number(s.eps);
    text_ += fmt::format(" {}  % MAXGS, MAXIN, MAXNR, MAXOUT, EPS, NPOT_MAX\n", s.npot_max);
    if (!s.starts_from_slip()) return;
    if (s.method == SolverChoice::slip_iteration) return add({s.inislp, s.omgslp}, "INISLP, OMGSLP");
    add({s.omegah, s.omegas, s.inislp, s.omgslp}, "OMEGAH, OMEGAS, INISLP, OMGSLP");
  }

  /// The numbers of a law but for its memory, which are the last two of all laws but Coulomb's.
  std::span<const double> without_memory(const std::vector<double>& set) const {
    return std::span(set).first(set.size() - (case_.friction.law == Law::coulomb ? 0 : 2));
  }
  void add_memory(const std::vector<double>& set) {
    if (case_.friction.law != Law::coulomb) add_list(std::span(set).last(2));
  }
  void add_friction_set(const std::vector<double>& set) {
    add_list(without_memory(set));
    add_memory(set);
  }
  /// Of module 1: one set, or several with one memory.
  void add_friction() {
    const FrictionData& f = case_.friction;
    if (friction_stations() == FrictionStations::one) {
      add_friction_set(f.sets.at(0));
      return;
    }
    add_integers({static_cast<int>(f.sets.size())}, "NVF");
    for (std::size_t k = 0; k < f.sets.size(); ++k) {
      add_number(f.stations[k]);
      add_list(without_memory(f.sets[k]));
    }
    add_memory(f.sets.at(0));
  }

  /// C = 4; module 1 knows the angles from its profiles.
  void add_correction() {
    const MaterialData& m = *case_.material;
    if (m.coefficients != Coefficients::angle_corrected) return;
    const AngleCorrection& a = m.correction;
    if (case_.wheel_rail) return add_integers({a.method, a.variant}, "IF_METH, VARIANT");
    add_integers({a.method, a.variant, static_cast<int>(a.angles.size())}, "IF_METH, VARIANT, NN");
    for (const auto& [y, angle] : a.angles) add({y, angle}, "Y, ALPHA");
  }

  /// Elasticity, what B and M add to it, damping and heat.
  void add_material() {
    const MaterialData& m = *case_.material;
    add({m.poisson1, m.poisson2, m.shear1, m.shear2}, "POISS 1, 2, GG 1, 2");
    if (case_.digits.bound == PressureModel::thin_sheet) add({m.sheet_flexibility}, "FLXZ");
    if (case_.digits.mater != Bulk::elastic && !m.model_data.empty()) add_list(m.model_data);
    if (const auto& d = case_.damping)
      add({d->normal, d->tangential, d->normal_limit, d->tangential_limit}, "CDAMPN, CDAMPT, DFNMAX, DFTMAX");
    if (case_.digits.heat != Heat::none) add_heat(*case_.heat);
  }
  void add_heat(const HeatData& h) {
    for (const auto& body : {h.body1, h.body2}) add_list(body);
    if (case_.digits.mater == Bulk::layer) add({h.plastic_share}, "BETAPL");
  }

  void add_potential() {
    const PotentialContact& p = *case_.potential;
    if (p.is_hertzian() && (case_.formed.given != case_.load.given || case_.formed.value != case_.load.value))
      throw Error("an input file cannot have Hertz's grid of one case and the force of another in one case");
    add_integers({number(p.kind)}, "IPOTCN");
    text_ += fmt::format(" {} {}", p.mx, p.my);
    const std::size_t count = !p.is_hertzian() ? 4 : p.kind == Potential::half_ellipses ? 3 : 2;
    for (std::size_t k = 0; k < count; ++k) add_number(p.values[k]);
    if (p.is_hertzian()) add_number(p.scale);
    text_ += "  % MX, MY, ...\n";
  }

  void add_geometry() {
    const Geometry& g = case_.geometry;
    add_integers({number(g.base), number(g.planform)}, "IBASE, IPLAN");
    const std::span<const double> values = g.values;
    if (g.base == Base::circle) {
      constexpr std::size_t of_circle = 4;
      text_ += fmt::format(" {}", values.size() - of_circle);
      add_list(values.first(of_circle));
      add_list(values.subspan(of_circle));
    } else {
      add_list(values);
    }
    if (g.planform == Planform::all) return;
    const std::span<const double> plan = g.plan_values;
    if (g.planform != Planform::sub_patches) return add_list(plan);
    add_list(plan.first(1));
    if (plan.size() > 1) add_list(plan.subspan(1));
  }

  void add_profile(const ProfileRecord& p) {
    const std::string file = std::filesystem::absolute(p.file).string();
    if (file.find('\'') != std::string::npos) throw Error(file + ": an input file cannot have quotes in names");
    text_ += fmt::format(" '{}' {}", file, p.mirror_y);
    add_number(p.scale);
    add_number(p.smooth);
    text_ += fmt::format(" {} 2  % NAME, MIRRORY, SCALE, SMOOTH, MIRRORZ, PRFOPT\n {}", p.mirror_z, p.smoothing);
    add({p.zigzag, p.kink_high, p.kink_low, p.kink_width}, "ISMOOTH, ZIGTHRS, KINKHIGH, KINKLOW, KINKWID");
    text_ += fmt::format(" {}", p.error_handling);
    add({p.most_omitted}, "ERRHND, MAXOMIT");
  }

  void add_track(const WheelRailData& w) {
    const TrackDimensions& t = w.track;
    add_number(t.gauge_height);
    add_number(t.by_gauge() ? 0 : t.rail_y0);
    add_number(t.by_gauge() ? t.gauge_width : t.rail_z0);
    if (w.digits.is_roller())
      add({t.roller_radius}, "GAUGHT, ..., NOMRADR");
    else
      add({t.cant, t.curvature}, "GAUGHT, ..., CANT, CURV");
    add_profile(w.rail);
    const RailPosition& p = w.rail_position;
    add({p.dy, p.dz, p.roll, p.vy, p.vz, p.vroll}, "DYRAIL, DZRAIL, DROLLR, VYRAIL, VZRAIL, VROLLR");
    const RailSupport& s = w.support;
    if (w.digits.force == TotalForce::rail_deflection)
      add({s.ky, s.fy, s.kz, s.fz, s.first_step}, "KYRAIL, FYRAIL, KZRAIL, FZRAIL, DYSTEP0");
  }

  void add_wheelset(const WheelRailData& w, bool bends) {
    const WheelsetDimensions& s = w.wheelset;
    add({s.flange_back_distance, s.flange_back_position, s.nominal_radius, s.tape_circle},
        "FBDIST, FBPOS, NOMRADW, YTAPE");
    add_profile(w.wheel);
    const WheelsetPosition& p = w.position;
    add({p.s, p.y, number_of(p.vertical), p.roll, p.yaw, p.pitch},
        case_.digits.norm == Normal::force ? "S, Y, FZ, ROLL, YAW, PITCH" : "S, Y, Z, ROLL, YAW, PITCH");
    const WheelsetVelocity& v = w.velocity;
    add({v.vs, v.vy, v.vz, v.vroll, v.vyaw, number_of(v.pitch)},
        w.digits.force == TotalForce::force_x    ? "VS, VY, VZ, VROLL, VYAW, FX"
        : w.digits.force == TotalForce::moment_y ? "VS, VY, VZ, VROLL, VYAW, MY"
                                                 : "VS, VY, VZ, VROLL, VYAW, VPITCH");
    if (!bends) return;
    const WheelDeflection& d = w.deflection;
    add({d.dx, d.dy, d.dz, d.droll, d.dyaw, d.dpitch}, "DXWHL, DYWHL, DZWHL, DROLLW, DYAWW, DPITCHW");
    add({d.vx, d.vy, d.vz, d.vroll, d.vyaw, d.vpitch}, "VXWHL, VYWHL, VZWHL, VROLLW, VYAWW, VPITCHW");
  }

  void add_points() {
    if (points_digit() == number(InteriorPoints::none)) return;
    add_integers({number(case_.subs_file), case_.interior_level}, "A_s, O_s");
    for (const PointBlock& block : case_.points) add_block(block);
    add_integers({number(Points::end)}, "ISUBS");
  }
  void add_block(const PointBlock& b) {
    const auto counts = [this](std::initializer_list<std::size_t> sizes) {
      for (const std::size_t size : sizes) text_ += fmt::format(" {}", size);
      text_ += "\n";
    };
    add_integers({number(b.kind)}, "ISUBS");
    for (std::size_t k = 0; k < b.range.size(); ++k) text_ += fmt::format(" {}{}", b.range[k], k % 3 == 2 ? "\n" : "");
    if (b.kind == Points::anywhere)
      counts({b.x.size(), b.y.size(), b.z.size()});
    else if (!b.x.empty())
      counts({b.x.size(), b.y.size()});
    for (const auto* places : {&b.x, &b.y})
      if (!places->empty()) add_list(*places);
    if (b.kind != Points::anywhere && !b.has_equal_depths()) counts({b.z.size()});
    add_list(b.z);
  }

  const Case& case_;
  std::string text_;
};

} // namespace

std::string input_text(const Case& c) {
  return CaseText(c).text();
}

std::string input_end() {
  return " 0  MODULE\n";
}

} // namespace microslip::contact_program
