#include "compat/contact/wheel_rail/wheel_rail_solver.hpp"

#include "compat/contact/prescribed_forces.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/contact/support.hpp"
#include "compat/contact/units.hpp"
#include "compat/contact/wheel_rail/force_search.hpp"
#include "compat/contact/wheel_rail/left_wheel.hpp"
#include "compat/contact/wheel_rail/patch_case.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "compat/contact/wheel_rail/root_search.hpp"
#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/words.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace microslip::contact_program {
namespace {

using Vec = Vec3<double>;

GridOrigin origin_of(const Digits& digits) {
  if (digits.tang == Tangential::shift) return GridOrigin::fixed;
  return digits.tang == Tangential::transient ? GridOrigin::moving : GridOrigin::reference;
}

/// The force of a patch, and its moment about the origin of some axes that lie in the track's.
Wrench wrench(const Frame<double>& axes, const Vec& at, const Vec& force, const Vec& moment) {
  return {axes.axes.back(force), axes.axes.back(cross(at - axes.origin, force) + moment)};
}

void add(Wrench& sum, const Wrench& part) {
  sum.force = sum.force + part.force;
  sum.moment = sum.moment + part.moment;
}

/// What the tractions on a curved patch sum to in the reference's axes, force [N] and moment [N m] about its origin.
Wrench aggregate(const Outcome& o, const PatchFrame& frame) {
  const ElementGrid& grid = o.step.grid;
  const auto& [px, py] = o.solution.fields.traction;
  Wrench sum;
  for (int j = 0; j < frame.my; ++j) {
    const Rotation<double> row = rotation_about_x(frame.row_turn(j));
    Vec at = frame.reference.inner(frame.rows[static_cast<std::size_t>(j)].point);
    for (int i = 0; i < frame.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * frame.mx + i;
      const bool slides = !px.empty();
      const Vec traction{slides ? px[k] : 0, slides ? py[k] : 0, o.solution.normal.pressure[k]};
      const Vec force = grid.element_area() * (row * traction);
      at.x = frame.reference.inner(frame.grid.outer({frame.x0 + (i + 0.5) * frame.dx, 0, 0})).x;
      sum.force = sum.force + force;
      sum.moment = sum.moment + cross(at, force);
    }
  }
  return sum;
}

/// The totals of a curved patch are those in the reference's axes; the integrals over the surface stay beside them,
/// that of the pressure and, over it, that of the lateral traction. As CONTACT prints it, MN is about the line x = 0 of
/// the elements, where the reference lies at `reference_x` [m]: not 0 with T = 1 and 2.
void set_totals(Outcome& o, const Wrench& sum, double reference_x) {
  PrintedTotals& t = o.totals;
  const double integral_fs = t.fy;
  t.integral_fn = t.fn;
  t.fn = sum.force.z;
  t.fx = sum.force.x;
  t.fy = sum.force.y;
  t.mz = (sum.moment.z + reference_x * sum.force.y) * per_m;
  const double friction = o.step.friction.size() == 1 ? o.step.friction.front().static_coefficient() : 1;
  const double limit = friction * *t.integral_fn;
  t.x = limit > 0 ? t.fx / limit : 0;
  t.y = limit > 0 ? integral_fs / limit : 0;
}

/// In the patch's axes, without damping [N].
Vec force_of(const Outcome& o) {
  return {o.totals.fx, o.totals.fy, o.totals.fn};
}

/// The normal force on a row of elements [N].
double row_load(const Outcome& o, int row) {
  const ElementGrid& grid = o.step.grid;
  const auto first = o.solution.normal.pressure.begin() + static_cast<std::ptrdiff_t>(row) * grid.mx;
  return grid.element_area() * std::accumulate(first, first + grid.mx, 0.0);
}

/// Moments of the pressure about the axes of a patch's plane [N m].
Vec moments(const Outcome& o) {
  Vec m{0, 0, o.solution.totals.mz};
  const ElementGrid& grid = o.step.grid;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double force = o.solution.normal.pressure[static_cast<std::size_t>(j) * grid.mx + i] * grid.element_area();
      m.x += force * grid.y(j);
      m.y -= force * grid.x(i);
    }
  return m;
}

/// How deep a wheel sinks in under a force by Hertz's solution [m].
double hertzian_depth(const Case& c, const LeastGap& gap, double force) {
  const double a = 0.5 / c.wheel_rail->wheelset.nominal_radius;
  const double b = std::max(gap.curvature, SearchThresholds::least_curvature);
  const double depth = hertz_from_load({a, b}, combined_material(c), force).approach;
  return depth / std::max(0.5, std::cos(gap.angle));
}

/// Around the elements in contact [m].
std::optional<PatchBox> contact_box(const Outcome& o) {
  const ElementGrid& g = o.step.grid;
  int i0 = g.mx, i1 = -1, j0 = g.my, j1 = -1;
  for (int j = 0; j < g.my; ++j)
    for (int i = 0; i < g.mx; ++i) {
      if (!(o.solution.normal.pressure[static_cast<std::size_t>(j) * g.mx + i] > 0)) continue;
      i0 = std::min(i0, i), i1 = std::max(i1, i);
      j0 = std::min(j0, j), j1 = std::max(j1, j);
    }
  if (i1 < 0) return {};
  return PatchBox{g.x(i0) - g.dx / 2, g.x(i1) + g.dx / 2, g.y(j0) - g.dy / 2, g.y(j1) + g.dy / 2};
}

PatchMotion motion_of(const Case& right, const Placement& placement, const PatchFrame& frame,
                      const UndeformedDistance& distance) {
  const WheelRailData& data = *right.wheel_rail;
  const bool is_shift = right.digits.tang == Tangential::shift;
  if (data.search != ContactSearch::true_slip && data.search != ContactSearch::conformal)
    return patch_motion(data, placement, frame, distance.approach, is_shift);
  const MaterialData& m = *right.material;
  const double rail = (1 - m.poisson1) * m.shear2, wheel = (1 - m.poisson2) * m.shear1;
  return surface_motion(data, placement, frame, distance, rail / (rail + wheel), RollingData().facphi, is_shift);
}

constexpr double least_step = 1e-12; ///< of a rate of rotation, over it; of a deflection over 1 mm

/// Returns whether a search ends: what it looks for is there, or cannot be brought any nearer.
bool ends(const PrescribedForce& force, int step, std::optional<double> width, double least_width) {
  return force.is_reached() || step == SearchThresholds::most_solutions || (width && *width < least_width);
}

std::vector<std::string> notes_of(const std::vector<NearMiss>& misses) {
  std::vector<std::string> notes;
  notes.reserve(misses.size());
  for (const NearMiss& miss : misses)
    notes.push_back("G_MISS: near miss at x = " + short_number(miss.x / mm) + ", y = " + short_number(miss.y / mm) +
                    " mm, gap " + short_number(miss.gap / mm) + " mm; the patches do not reach for it");
  return notes;
}

void append_new(std::vector<std::string>& to, const std::vector<std::string>& from) {
  for (const auto& text : from)
    if (std::find(to.begin(), to.end(), text) == to.end()) to.push_back(text);
}

} // namespace

ProfileShape WheelRailSolver::profile(const ProfileRecord& record, ProfileRole role) {
  if (record.curve) return {record.curve};
  for (const auto& [known, shape] : profiles_)
    if (known == record) return shape;
  ProfileShape shape = read_profile_shape(record, role);
  profiles_.emplace_back(record, shape);
  return shape;
}

Outcome WheelRailSolver::run(const Case& c, const Progress& progress) {
  Outcome outcome = run_unless_refused(c, unsupported_of_wheel(c), lost_tractions(c, lost_), [&] {
    lost_ = c.number; // unless it is solved
    return solve(c, progress);
  });
  if (outcome.kind == Outcome::Kind::refused) lost_ = c.number;
  if (outcome.kind == Outcome::Kind::solved) lost_ = 0;
  return outcome;
}

Outcome WheelRailSolver::solve(const Case& c, const Progress& progress) {
  const Case right = right_hand(c);
  const WheelRailData& data = *right.wheel_rail;
  effort_ = {};
  if (c.digits.pvtime == Continuation::nothing) tracks_.clear();
  for (TrackedPatch& track : tracks_) track.is_new = true;
  if (c.digits.pvtime != Continuation::repeated) origins_ = std::exchange(tracks_, {});
  move_origins(origin_of(c.digits));
  Outcome outcome = data.digits.force == TotalForce::force_x           ? find_pitch_velocity(right, progress)
                    : data.digits.force == TotalForce::rail_deflection ? find_deflection(right, progress)
                                                                       : solve_placed(right, {}, progress);
  if (outcome.wheel) {
    check_prescribed_forces(right, outcome);
    last_z_ = outcome.wheel->z;
    remember(*outcome.wheel, frames_, place_on_track(data), origin_of(c.digits));
    finish(c, *outcome.wheel, progress);
  }
  if (outcome.wheel) append_new(outcome.notes, notes_of(outcome.wheel->near_misses));
  return outcome;
}

/// The wheel over its rail, deflected so far.
WheelGeometry WheelRailSolver::geometry_over(const Case& right, const RailDeflection& deflection) {
  const WheelRailData& data = *right.wheel_rail;
  // In this order, so that of two files that are missing always the same one is named.
  const auto rail = profile(data.rail, ProfileRole::rail), wheel = profile(data.wheel, ProfileRole::wheel);
  const PlacedRail placed = rail_placer_.place(data, rail.curve, deflection);
  WheelGeometry geometry(data, rail, placed, wheel, origin_of(right.digits), right.solver.npot_max);
  if (!geometry.overlaps()) throw Error("wheel and rail do not lie above one another");
  return geometry;
}

Outcome WheelRailSolver::solve_placed(const Case& right, const RailDeflection& deflection, const Progress& progress) {
  WheelGeometry geometry = geometry_over(right, deflection);
  const auto* position = std::get_if<VerticalPosition>(&right.wheel_rail->position.vertical);
  Outcome outcome =
      position ? solve_at(right, geometry, position->z, progress) : find_height(right, geometry, progress);
  if (!outcome.wheel) return outcome;
  outcome.wheel->dy_rail = deflection.dy;
  outcome.wheel->dz_rail = deflection.dz;
  return outcome;
}

/// F = 3: how far a rail on springs moves aside, so that the forces on it are in balance; at each position it has sunk
/// as far as its other spring lets it.
Outcome WheelRailSolver::find_deflection(const Case& right, const Progress& progress) {
  const RailSupport& support = right.wheel_rail->support;
  const auto under_force = [&](double fz) { return support.kz != 0 ? (fz + support.fz) / support.kz : 0; };
  std::optional<RootSearch> search;
  std::optional<double> depth;
  double dy = 0;
  const auto* force = std::get_if<VerticalForce>(&right.wheel_rail->position.vertical);
  for (int k = 0;; ++k) {
    Outcome outcome = force ? solve_placed(right, {dy, under_force(force->fz)}, progress)
                            : find_settlement(right, dy, depth, progress);
    if (!outcome.wheel) return outcome;
    const PrescribedForce on_spring = side_spring(right, *outcome.wheel);
    if (ends(on_spring, k, search ? search->width() : std::nullopt, least_step * mm)) return outcome;
    if (!search) search.emplace(std::copysign(support.first_step, on_spring.missing()));
    dy = search->next(dy, on_spring.missing());
  }
}

/// With the wheel's height and the rail's position across the track given: the deflection of the rail's spring below.
/// What grows with the wheel's depth over the unmoved rail is the contact's force and what the spring takes less of.
/// `depth` is that from the first touch on, of the last position and of this one.
Outcome WheelRailSolver::find_settlement(const Case& right, double dy, std::optional<double>& depth,
                                         const Progress& progress) {
  constexpr double share_of_tolerance = 0.1; // so that the search for dy sees a smooth force
  const double height = std::get<VerticalPosition>(right.wheel_rail->position.vertical).z;
  const RailSupport& support = right.wheel_rail->support;
  const LeastGap gap = geometry_over(right, {dy, 0}).least_gap_at_zero();
  ++effort_.geometry;
  const double wanted = support.kz * (height - gap.gap) - support.fz;
  if (!(wanted > 0)) return solve_placed(right, {dy, support.fz / support.kz}, progress); // the rail hangs free
  ForceSearch search(wanted, gap.gap);
  double z = gap.gap + depth.value_or(hertzian_depth(right, gap, wanted));
  for (int k = 0;; ++k) {
    Outcome outcome = solve_placed(right, {dy, height - z}, progress);
    if (!outcome.wheel) return outcome;
    depth = z - gap.gap;
    PrescribedForce force = bottom_spring(right, *outcome.wheel);
    force.tolerance *= share_of_tolerance;
    if (force.is_reached()) return outcome;
    search.add(z, force.found + support.kz * (z - gap.gap));
    const auto next = search.next();
    if (!next || k == SearchThresholds::most_solutions) return outcome;
    z = *next;
  }
}

/// F = 1: the rate of rotation at which the longitudinal force is the prescribed one.
Outcome WheelRailSolver::find_pitch_velocity(const Case& right, const Progress& progress) {
  Case now = right;
  WheelRailData& data = *now.wheel_rail;
  const double speed = data.digits.is_roller() ? data.velocity.vs * data.track.roller_radius : data.velocity.vs;
  double& vpitch = data.velocity.pitch.emplace<PitchVelocity>().rate;
  vpitch = -speed / data.wheelset.nominal_radius;
  RootSearch search(1e-4 * vpitch);
  for (int k = 0;; ++k) {
    Outcome outcome = solve_placed(now, {}, progress);
    if (!outcome.wheel) return outcome;
    const PrescribedForce force = pulling_force(right, *outcome.wheel);
    if (ends(force, k, search.width(), least_step * std::abs(vpitch))) return outcome;
    vpitch = search.next(vpitch, force.missing());
  }
}

/// What the next case may go on from.
void WheelRailSolver::remember(const WheelOutcome& wheel, const std::vector<PatchFrame>& frames, double place,
                               GridOrigin origin) {
  for (std::size_t k = 0; k < frames.size(); ++k) {
    TrackedPatch& track = tracks_[k];
    track.origin = origin;
    track.x = frames[k].reference.origin.x;
    track.place = place + track.x;
    track.s_rail = frames[k].s_rail;
    track.dx = frames[k].dx;
    track.ds = frames[k].ds;
    track.contact = contact_box(*wheel.patches[k].solution);
    track.carried = track.solver->carried();
    track.carries = false;
    track.force = force_of(*wheel.patches[k].solution);
    track.rows.clear();
    for (int j = 0; j < frames[k].my; ++j)
      track.rows.push_back({frames[k].row_in_track(j), row_load(*wheel.patches[k].solution, j)});
  }
}

/// Tractions of the case before as seen from where this case's elements count from, if it goes on from them.
void WheelRailSolver::move_origins(GridOrigin origin) {
  if (origin == GridOrigin::reference) return;
  for (TrackedPatch& track : origins_) {
    const auto along = [&](GridOrigin from) {
      return from == GridOrigin::fixed ? track.place : from == GridOrigin::moving ? track.x : 0.0;
    };
    const double dx = track.dx * std::round((along(origin) - along(track.origin)) / track.dx);
    const double ds = track.origin == GridOrigin::reference ? track.ds * std::round(track.s_rail / track.ds) : 0;
    track.origin = origin;
    move_origin(track.carried, dx, ds);
    if (track.contact)
      track.contact = {track.contact->x0 + dx, track.contact->x1 + dx, track.contact->s0 + ds, track.contact->s1 + ds};
  }
}

/// What was found of a left wheel's mirror image for the wheel, and fields inside the bodies at the final height.
void WheelRailSolver::finish(const Case& c, WheelOutcome& wheel, const Progress& progress) {
  wheel.effort = effort_;
  is_left_ = c.wheel_rail->digits.is_left();
  if (is_left_) mirror_back(wheel);
  for (WheelPatch& patch : wheel.patches) {
    patch.contact.digits.stress = c.digits.stress;
    Outcome& o = *patch.solution;
    InteriorSequence interior;
    o.interior = interior_blocks(patch.contact, o.step, o.solution, interior, progress);
  }
}

CarriedTractions WheelRailSolver::started_from(std::size_t patch) const {
  CarriedTractions start = tracks_[patch].solver->started_from();
  if (is_left_) mirror_back(start);
  return start;
}

/// Of each patch, what it goes on from.
std::vector<std::vector<WheelRailSolver::Part>> WheelRailSolver::parts_of(const std::vector<PatchFrame>& frames,
                                                                          bool has_history) const {
  std::vector<std::vector<Part>> parts(frames.size());
  for (std::size_t i = 0; i < origins_.size(); ++i) {
    std::vector<std::size_t> heirs; // from low s to high
    for (std::size_t k = frames.size(); k-- > 0;)
      if (std::min(origins_[i].y1, frames[k].y1) > std::max(origins_[i].y0, frames[k].y0)) heirs.push_back(k);
    Part part{.origin = i};
    for (std::size_t n = 0; n < heirs.size(); ++n) {
      const bool is_split = has_history && n + 1 < heirs.size();
      const Part whole{.origin = i};
      if (is_split) { // between two rows of elements
        const double middle = (frames[heirs[n]].s1() + frames[heirs[n + 1]].s0) / 2, ds = origins_[i].ds;
        part.high = (std::floor(middle / ds) + 0.5) * ds;
      } else {
        part.high = whole.high;
      }
      parts[heirs[n]].push_back(part);
      if (is_split) part.low = part.high;
    }
  }
  return parts;
}

/// What the patches bore that patch `k` goes on from. Of one that has split each row's share of the normal force counts
/// for the nearest of the new ones.
std::optional<Vec> WheelRailSolver::force_before(const std::vector<PatchFrame>& frames, std::size_t k,
                                                 Continuation from) const {
  std::optional<Vec> sum;
  const auto overlaps = [](const TrackedPatch& origin, const PatchFrame& frame) {
    return std::min(origin.y1, frame.y1) > std::max(origin.y0, frame.y0);
  };
  for (const TrackedPatch& origin : origins_) {
    if (!overlaps(origin, frames[k])) continue;
    double all = 0, own = 0;
    for (const auto& [y, load] : origin.rows) {
      std::size_t nearest = k;
      for (std::size_t i = 0; i < frames.size(); ++i)
        if (overlaps(origin, frames[i]) && frames[i].distance_across(y) < frames[nearest].distance_across(y))
          nearest = i;
      all += load;
      if (nearest == k) own += load;
    }
    const Vec share = (all > 0 ? own / all : 0) * origin.force;
    sum = sum ? *sum + share : share;
  }
  return carried_force(from, sum);
}

/// A patch that this case has not had yet.
WheelRailSolver::TrackedPatch WheelRailSolver::begin_track(const std::vector<Part>& parts, bool has_history) const {
  TrackedPatch track;
  track.parts = parts;
  const bool is_one = parts.size() == 1 && parts[0] == Part{.origin = parts[0].origin};
  track.solver = is_one ? origins_[parts[0].origin].solver : std::make_shared<CaseSolver>();
  if (!has_history || parts.empty()) return track;
  std::vector<CarriedTractions> carried;
  carried.reserve(parts.size());
  for (const Part& part : parts) carried.push_back(part_of(origins_[part.origin].carried, part.low, part.high));
  track.solver->carry(sum_of(carried));
  track.carries = true;
  return track;
}

/// Hands the solvers of patches on to those that lie where they did and go on from the same ones, and begins others.
void WheelRailSolver::follow(const std::vector<PatchFrame>& frames, const Digits& digits) {
  const bool has_history = digits.has_history();
  const auto parts = parts_of(frames, has_history);
  std::vector<TrackedPatch> now;
  for (TrackedPatch& track : tracks_) track.taken = false;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    TrackedPatch* best = nullptr;
    double most = 0;
    for (TrackedPatch& track : tracks_) {
      const double common = std::min(track.y1, frames[k].y1) - std::max(track.y0, frames[k].y0);
      if (!track.taken && track.parts == parts[k] && common > most) {
        best = &track;
        most = common;
      }
    }
    if (best) best->taken = true;
    now.push_back(best ? *best : begin_track(parts[k], has_history));
    if (!best) now.back().force_before = force_before(frames, k, digits.pvtime);
    now.back().y0 = frames[k].y0;
    now.back().y1 = frames[k].y1;
  }
  tracks_ = std::move(now);
}

WheelPatch WheelRailSolver::solve_patch(const Case& right, const PatchFrame& frame, const WheelGeometry& geometry,
                                        double z, TrackedPatch& track, const Progress& progress) {
  const Placement placement = geometry.placement(z);
  const UndeformedDistance distance = geometry.distance(frame, z);
  WheelPatch patch;
  patch.location = locate(frame, placement);
  patch.reference = frame.reference;
  patch.grid = frame.grid;
  patch.s_rail = frame.s_rail;
  if (const auto& curve = placement.wheel_profile.curve) patch.s_wheel = -curve->nearest_s_at_y(patch.location.wheel.y);
  PatchMotion motion;
  if (right.digits.has_friction()) motion = motion_of(right, placement, frame, distance);
  patch.contact = patch_case(right, frame, distance, motion, patch.location);
  Digits& digits = patch.contact.digits;
  for (const Part& part : track.parts) patch.previous.push_back(static_cast<int>(part.origin) + 1);
  if (track.is_new && track.carries && digits.pvtime == Continuation::repeated)
    digits.pvtime = Continuation::previous; // it has been given what the case goes on from
  if (!track.is_new) {                      // the same case once more, at another height
    if (digits.pvtime != Continuation::nothing) digits.pvtime = Continuation::repeated;
    digits.iestim = InitialGuess::previous;
  }
  track.is_new = false;
  patch.solution = std::make_shared<Outcome>(track.solver->run(patch.contact, progress));
  ++effort_.normal;
  effort_.tangential += digits.has_friction();
  return patch;
}

/// Elements reach back to where the patches that they go on from were in contact; notes on what is too far away.
std::vector<std::string> WheelRailSolver::reach_back(std::vector<PatchFrame>& frames, const Case& right) const {
  const double most = most_elements(origin_of(right.digits), right.solver.npot_max);
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < frames.size(); ++k)
    for (const Part& part : tracks_[k].parts) {
      const auto& contact = origins_[part.origin].contact;
      if (!contact) continue;
      const double low = std::max(contact->s0, part.low), high = std::min(contact->s1, part.high);
      if (!cover(frames[k], {contact->x0, contact->x1, low, high}, most))
        append_new(notes,
                   {"the last contact is so far away along the track that elements do not reach back to it: what "
                    "its tractions deform here is left out"});
    }
  return notes;
}

Outcome WheelRailSolver::solve_at(const Case& right, WheelGeometry& geometry, double z, const Progress& progress) {
  ++effort_.geometry;
  std::vector<PatchFrame> frames = geometry.patches(z);
  const Placement placement = geometry.placement(z);
  follow(frames, right.digits);
  Outcome outcome;
  append_new(outcome.notes, reach_back(frames, right));
  for (PatchFrame& frame : frames) geometry.bend(frame, z);
  WheelOutcome wheel;
  wheel.z = z;
  wheel.near_misses = geometry.near_misses(z);
  wheel.vpitch = right.wheel_rail->velocity.pitch_rate();
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const PatchFrame& frame = frames[k];
    wheel.patches.push_back(solve_patch(right, frame, geometry, z, tracks_[k], progress));
    const Outcome& o = *wheel.patches.back().solution;
    if (o.kind == Outcome::Kind::refused) return o;
    const Rotation<double>& axes = frame.reference.axes;
    WheelPatch& patch = wheel.patches.back();
    const Wrench sum = frame.rows.empty() ? Wrench{force_of(o), moments(o)} : aggregate(o, frame);
    if (!frame.rows.empty()) set_totals(*patch.solution, sum, patch.contact.spin_x);
    patch.solution->damping = damping_force(patch.contact, o.step.motion.step, sum.force, tracks_[k].force_before);
    const Vec force = axes * (sum.force + patch.solution->damping.value_or(Vec{})), moment = axes * sum.moment;
    patch.track = wrench({placement.rail.origin, {}}, frame.reference.origin, force, moment);
    patch.wheelset = wrench({placement.wheel.origin, placement.wheelset.axes}, frame.reference.origin, force, moment);
    add(wheel.track, patch.track);
    add(wheel.wheelset, patch.wheelset);
    append_new(outcome.notes, o.notes);
    if (outcome.solution.report.status == Status::ok) outcome.solution.report.status = o.solution.report.status;
  }
  wheel.placement = placement;
  outcome.wheel = std::move(wheel);
  frames_ = std::move(frames);
  return outcome;
}

Outcome WheelRailSolver::find_height(const Case& right, WheelGeometry& geometry, const Progress& progress) {
  const double target = std::get<VerticalForce>(right.wheel_rail->position.vertical).fz;
  const LeastGap gap = geometry.least_gap_at_zero();
  ++effort_.geometry;
  ForceSearch search(target, gap.gap);
  const bool goes_on_from_last = last_z_ && right.digits.iestim != InitialGuess::nothing;
  double z = goes_on_from_last ? *last_z_ : gap.gap + hertzian_depth(right, gap, target);
  for (int k = 0;; ++k) {
    Outcome outcome = solve_at(right, geometry, z, progress);
    if (!outcome.wheel) return outcome;
    const PrescribedForce force = vertical_force(right, *outcome.wheel);
    if (force.is_reached()) return outcome;
    search.add(z, force.found);
    const auto next = search.next();
    if (!next || k == SearchThresholds::most_solutions) return outcome;
    z = *next;
  }
}

} // namespace microslip::contact_program
