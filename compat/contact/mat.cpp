#include "compat/contact/mat.hpp"

#include "compat/contact/fortran.hpp"
#include "compat/contact/plastic_deformation.hpp"
#include "compat/contact/records.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

constexpr int format = 2410; ///< of the files

using Numbers = std::vector<double>;

Numbers operator+(Numbers a, const Numbers& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Data of module 1 about a patch.
struct PatchOfWheel {
  const Case& c;
  const WheelOutcome& wheel;
  std::size_t patch;
};

/// The axes of a profile in the track's: turned about the track's x, and then about their z [mm], [rad].
struct Marker {
  Vec3<double> origin;
  double roll = 0, yaw = 0;
};

Marker marker_of(const Frame<double>& frame) {
  return {per_m * frame.origin, roll_of(frame.axes), -std::asin(frame.axes.ey.x)};
}

/// The file's text; all its lines have the same number of columns.
class MatFile {
public:
  MatFile(const Case& c, const Outcome& outcome) : case_(c), outcome_(outcome) {
    yields_ = c.digits.mater == Bulk::layer && outcome.step.bodies.layer.yields();
    if (yields_) plastic_ = plastic_deformation(c, outcome);
    heats_ = c.digits.heat != Heat::none;
    columns_ = 11 + (yields_ ? 3 : 0) + (heats_ ? 2 : 0);
  }

  std::string text(const PatchOfWheel* of_wheel) {
    add_position(of_wheel);
    add_grid(of_wheel);
    add_material();
    add_friction();
    add_elements();
    return std::move(text_);
  }

private:
  void comment(const char* names) { text_ += std::string("%") + names + "\n"; }

  void line(Numbers values) {
    values.resize(columns_, 0);
    for (const double value : values) text_ += general(value, 14, 6);
    text_ += "\n";
  }

  void add_position(const PatchOfWheel* of_wheel) {
    comment(
        "  TIM           S_WS(FC)      TH_WS(FC)     Y_R(TR)       Z_R(TR)       ROLL_R(TR)    RNOM_ROL      ... FMT");
    Numbers rail(columns_, 0), wheel, contact;
    if (of_wheel) {
      const WheelRailData& d = *of_wheel->c.wheel_rail;
      const Placement& placed = of_wheel->wheel.placement;
      const Marker r = marker_of(placed.rail), w = marker_of(placed.wheel);
      const bool roller = d.digits.is_roller();
      const Numbers first = {
          0,      roller ? 0 : d.position.s * per_m,         d.position.pitch, r.origin.y, r.origin.z,
          r.roll, roller ? d.track.roller_radius * per_m : 0};
      std::copy(first.begin(), first.end(), rail.begin());
      wheel = {w.origin.x, w.origin.y, w.origin.z, w.roll, w.yaw, d.wheelset.nominal_radius * per_m};
      const PatchLocation& l = of_wheel->wheel.patches[of_wheel->patch].location;
      contact = {l.rail.x * per_m,
                 l.rail.y * per_m,
                 l.rail.z * per_m,
                 l.angle_on_rail,
                 l.wheel.x * per_m,
                 l.wheel.y * per_m,
                 l.wheel.z * per_m,
                 static_cast<double>(of_wheel->wheel.patches.size()),
                 static_cast<double>(of_wheel->patch + 1)};
    } else {
      contact.resize(9, 0);
    }
    rail.back() = format;
    line(rail);
    comment("  X_W(TR)       Y_W(TR)       Z_W(TR)       ROLL_W(TR)    YAW_W(TR)     RNOM_WHL");
    line(wheel);
    comment("  X_CP(R)       Y_CP(R)       Z_CP(R)       DELT_CP(R)    X_CP(W)       Y_CP(W)       Z_CP(W)       "
            "NPATCH        IPATCH        SPINXO        SPINYO");
    line(contact + Numbers{case_.spin_x * per_m, case_.spin_y * per_m});
  }

  void add_grid(const PatchOfWheel* of_wheel) {
    const ElementGrid& grid = outcome_.step.grid;
    const bool rolls = case_.digits.rolls();
    Numbers config = {1, 0, 0};
    if (of_wheel) {
      const WheelRailData& d = *of_wheel->c.wheel_rail;
      config = {double(number(d.digits.config)), double(number(d.search)),
                std::abs(of_wheel->wheel.placement.wheel_on_axle.origin.y * per_m)};
    }
    comment("   MX    MY     XL            YL            DX            DY            CHI           DQ            C1    "
            "        "
            "D             YNOM_WHL");
    line(Numbers{double(grid.mx), double(grid.my), (grid.x0 - grid.dx / 2) * per_m, (grid.y0 - grid.dy / 2) * per_m,
                 grid.dx * per_m, grid.dy * per_m, rolls ? case_.rolling->chi : 0,
                 rolls ? outcome_.step.motion.step * per_m : 1} +
         config);
  }

  void add_material() {
    const MaterialData& m = *case_.material;
    const Numbers digits = {double(number(case_.digits.tang)), double(number(case_.digits.mater))};
    const Numbers shear = {m.shear1 * per_pa, m.shear2 * per_pa};
    if (outcome_.springs) { // without POISS2: there are no more columns
      const auto& [l, slope] = *outcome_.springs;
      Numbers reduction = {1, 1, 1};
      if (m.model_data.size() >= 3) reduction.assign(m.model_data.end() - 3, m.model_data.end());
      comment("    T    M      GG1           GG2           POISS1        FLX1          FLX2          FLX3          "
              "K0_MF         "
              "ALFAMF        BETAMF");
      line(digits + shear + Numbers{m.poisson1, l[0], l[1], l[2]} + reduction);
      return;
    }
    comment("    T    M      GG1           GG2           POISS1        POISS2        (FG1 FG2 TC1 TC2 | GG3 LAYTHK "
            "TAU_C0 K_TAU)");
    const bool has_model = case_.digits.mater == Bulk::viscoelastic || case_.digits.mater == Bulk::layer;
    line(digits + shear + Numbers{m.poisson1, m.poisson2} +
         (has_model ? in_file(m.model_data, units_of_model(case_.digits.mater)) : Numbers()));
  }

  void add_friction() {
    comment("    L    H      VELOC         (FSTAT FKIN | FKIN F1 SABSH1 F2 SABSH2 | FREF TREF DFHEAT DTHEAT) MEMDST "
            "MEM_S0");
    line(Numbers{double(number(case_.friction.law)), double(number(case_.digits.heat)),
                 case_.digits.rolls() ? case_.rolling->veloc * per_m : 1} +
         in_file(case_.friction.sets.at(0), units_of_friction(case_.friction.law)));
  }

  /// The coefficient at rest of a row.
  double at_rest(std::size_t row) const {
    const auto& sets = case_.friction.sets;
    const auto& set = sets[std::min(row, sets.size() - 1)];
    const bool falls = set.size() == 7; // with MEMDST and MEM_S0
    return falls ? set[0] + set[1] + set[3] : set[0];
  }

  double coefficient(std::size_t k) const {
    const auto& friction = outcome_.solution.fields.friction;
    const bool in_contact = outcome_.solution.normal.pressure[k] > 0;
    if (in_contact && !outcome_.step.frictionless && !friction.empty()) return friction[k];
    return at_rest(k / static_cast<std::size_t>(outcome_.step.grid.mx));
  }

  void add_elements() {
    text_ += std::string("%    I IGS   H  MU  PN  PX  PY  UN  UX  UY  ") + (case_.digits.rolls() ? "SREL" : "SHFT") +
             (yields_ ? "  TAUCRT  UPLSX  UPLSY" : "") + (heats_ ? "  TEMP1  TEMP2\n" : "\n");
    for (std::size_t k = 0; k < outcome_.step.grid.count(); ++k) {
      const int state = element_state(outcome_, k);
      if (case_.digits.matfil == Stored::contact && state == 0) continue;
      text_ += fmt::format("{:7}{:5}  ", k + 1, state);
      Numbers values = fields(k, state);
      if (yields_) values = values + layer(k);
      const SurfaceFields& f = outcome_.solution.fields;
      if (heats_)
        values = values + (outcome_.has_temperatures() ? Numbers{f.temperature1[k], f.temperature2[k]} : Numbers{0, 0});
      for (const double value : values) text_ += general(value, 14, 6);
      text_ += "\n";
    }
  }

  Numbers fields(std::size_t k, int state) const {
    const SurfaceFields& f = outcome_.solution.fields;
    const bool shifts = !case_.digits.rolls();
    constexpr int slip = 2;
    return {outcome_.step.gap[k] * per_m,
            coefficient(k),
            f.pressure[k] * per_pa,
            f.traction.x[k] * per_pa,
            f.traction.y[k] * per_pa,
            case_.digits.takes_ellipse() ? 0 : outcome_.solution.normal.displacement[k] * per_m,
            f.displacement.x[k] * per_m,
            f.displacement.y[k] * per_m,
            state == slip ? std::hypot(f.slip.x[k], f.slip.y[k]) * (shifts ? per_m : 1) : 0};
  }

  /// What the layer bears now, and how far it has yielded: along the traction if no more is known.
  Numbers layer(std::size_t k) const {
    const auto& [px, py] = outcome_.solution.fields.traction;
    const auto& deformation = outcome_.solution.slip_friction.deformation;
    const double u = deformation.empty() ? 0 : deformation[k], p = std::hypot(px[k], py[k]);
    const double share = p > 0 ? u / p : 0;
    const double x = plastic_ ? plastic_->x[k] : share * px[k], y = plastic_ ? plastic_->y[k] : share * py[k];
    return {outcome_.step.bodies.layer.yield_stress_after(u) * per_pa, x * per_m, y * per_m};
  }

  const Case& case_;
  const Outcome& outcome_;
  bool yields_ = false, heats_ = false;
  std::optional<VectorField> plastic_; ///< of a layer that yields, where it is known
  std::size_t columns_ = 0;
  std::string text_;
};

} // namespace

std::string mat_text(const Case& c, const Outcome& outcome) {
  return MatFile(c, outcome).text(nullptr);
}

std::string mat_text(const Case& c, const WheelOutcome& wheel, std::size_t patch) {
  const WheelPatch& p = wheel.patches[patch];
  const PatchOfWheel of_wheel{c, wheel, patch};
  return MatFile(p.contact, *p.solution).text(&of_wheel);
}

} // namespace microslip::contact_program
