#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/contact.hpp"
#include "binding/contact_batch.hpp"
#include "binding/exact_solver.hpp"
#include "binding/long_work.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"
#include "microslip/error.hpp"

namespace microslip::python {

RollingProblem CommonProblem::of(const EllipticContact& contact, Motion motion) const {
  motion.direction = problem.motion.direction;
  RollingProblem out = rolling_problem(contact, motion);
  out.friction.memory = problem.friction.memory;
  out.friction.temperature_effect = problem.friction.temperature_effect;
  out.thermal = problem.thermal;
  if (!bodies) return out;
  const double dissimilarity = bodies->material.dissimilarity;
  if (contact.dissimilarity != 0 && contact.dissimilarity != dissimilarity)
    throw Error("dissimilarity", contact.dissimilarity, "-",
                "that of the solver's bodies, " + std::to_string(dissimilarity) + ", or 0");
  out.bodies = *bodies;
  return out;
}

ExactSolver::ExactSolver(const CommonProblem& common, const Method& method) : common_(common), solver_(method) {
  require_compatible(common.of({}), method);
  if (common.problem.thermal) check(*common.problem.thermal);
  if (common.problem.friction.temperature_effect) check(*common.problem.friction.temperature_effect);
}

ContactSolution ExactSolver::solve(const EllipticContact& contact, const Motion& motion, const Progress& progress) {
  try {
    return solver_.solve(common_.of(contact, motion), progress);
  } catch (const Error& refusal) {
    return solution_without_result(Status::invalid_input, refusal.what());
  }
}

ExactDerivatives ExactSolver::differentiate(const EllipticContact& contact, const Progress& progress) {
  try {
    return solver_.differentiate(common_.of(contact), progress);
  } catch (const Error& refusal) {
    return {.solution = solution_without_result(Status::invalid_input, refusal.what())};
  }
}

GapValues ExactSolver::deformed_gap(const EllipticContact& contact, const Motion& motion, const Progress& progress) {
  return solver_.deformed_gap(common_.of(contact, motion), progress);
}

namespace {

namespace py = pybind11;
using namespace py::literals;
using Exact = OneAtATime<ExactSolver>;
using Accurate = OneAtATime<AccurateSolver>;
using Force = std::optional<double>;
using Heat = std::optional<std::pair<ThermalBody, ThermalBody>>;

ContactSolution solve(Exact& self, const EllipticContact& contact, ContactMotion motion, Force force_x, Force force_y,
                      double step, int steps) {
  return self.run([&, contact](ExactSolver& solver, const Progress& progress) {
    return solver.solve(contact, {.kind = motion, .force_x = force_x, .force_y = force_y, .step = step, .steps = steps},
                        progress);
  });
}

py::array deformed_gap(Exact& self, const EllipticContact& contact, ContactMotion motion) {
  const auto found = self.run([&, contact](ExactSolver& solver, const Progress& progress) {
    return solver.deformed_gap(contact, {.kind = motion}, progress);
  });
  py::array_t<double> out({found.grid.my, found.grid.mx});
  std::copy(found.gap.begin(), found.gap.end(), out.mutable_data());
  return out;
}

ExactForceArrays solve_batch(const Exact& self, const ContactBatch& batch, int threads) {
  ExactForceArrays out(batch);
  if (self.object.has_bodies() && batch.gives({"shear_modulus", "poisson_ratio", "dissimilarity"}))
    throw Error(
        "shear_modulus, poisson_ratio, dissimilarity: the solver's bodies have their own; make a solver for each "
        "pair of bodies");
  run_batch(batch.count(), 1, threads, [&]() -> BatchWorker {
    return [&, solver = std::make_shared<ExactSolver>(self.object.copy())](std::size_t i, std::size_t,
                                                                           const Progress& progress) {
      const ContactSolution solved = solver->solve(batch[i], {}, progress);
      out.forces.put(i, solved.forces());
      out.residual[i] = solved.report.residual;
      out.newton_steps[i] = solved.report.newton_steps;
    };
  });
  return out;
}

void bind_results(py::module_& module) {
  py::class_<ExactDerivatives> derivatives(module, "ExactDerivatives",
                                           "Forces in steady rolling and their derivatives.");
  derivatives.def_readonly("solution", &ExactDerivatives::solution, "The solution, as ContactSolution.")
      .def_property_readonly(
          "jacobian",
          [](const py::object& self) {
            return view(&self.cast<const ExactDerivatives&>().jacobian[0][0], {3, 3}, self);
          },
          "Derivatives of fx [N], fy [N], mz [N m] with respect to xi [-], eta [-] and phi [1/m], shape (3, 3).")
      .def_readonly("products", &ExactDerivatives::products, "Products that the derivatives took [-].");
  add_value(derivatives, {"solution", "jacobian"});

  py::class_<AccurateContact> accurate(module, "AccurateContact", "Steady rolling on two nested grids and its limit.");
  add_members(accurate, Shown<&AccurateContact::forces>{"The limit, extrapolated; areas and status of the finer grid."},
              Shown<&AccurateContact::creepage>{"The limit, where a force is prescribed [-], [-], [1/m]."},
              Shown<&AccurateContact::error>{
                  "Estimated error of the limit, in mu Fn for forces and mu Fn sqrt(a b) for the moment [-]."},
              Shown<&AccurateContact::elements>{"Elements across the ellipse, of the finer grid [-]."},
              Shown<&AccurateContact::finest>{"The solution on the finer grid, as ContactSolution."},
              Shown<&AccurateContact::coarser>{"The totals on half the elements, as ContactForces."},
              Shown<&AccurateContact::products>{"Products on all grids [-]."});
  add_value(accurate, {"forces", "creepage", "error", "elements"});
}

/// The constructor of a solver from its arguments and the options that both solvers have; `make` makes it from
/// the options and those arguments. The texts are what stands before and after that of these options.
template <class... Own, class Class, class Make, class... Arguments>
void def_options(Class& solver, Make make, const std::string& before, const std::string& after, Arguments... own) {
  const auto none = py::none();
  solver.def(
      py::init([make](Own... own_values, RollingDirection direction, double tolerance, std::optional<Bodies> bodies,
                      Coupling coupling, double memory_distance, double memory_speed, SlipStart slip_start,
                      const Heat& thermal, std::optional<TemperatureEffect> temperature_effect) {
        CommonProblem common{.bodies = std::move(bodies)};
        common.problem.motion.direction = direction;
        common.problem.friction.memory = {memory_distance, memory_speed};
        common.problem.friction.temperature_effect = temperature_effect;
        if (thermal) common.problem.thermal = {thermal->first, thermal->second};
        return make(common, Method{.tolerance = tolerance, .coupling = coupling, .slip_start = slip_start},
                    own_values...);
      }),
      own..., "direction"_a = RollingDirection::forward, "tolerance"_a = 1e-6, "bodies"_a = none,
      "coupling"_a = Coupling::newton, "memory_distance"_a = 0.0, "memory_speed"_a = 0.0,
      "slip_start"_a = SlipStart::below, "thermal"_a = none, "temperature_effect"_a = none,
      (before +
       "direction 'forward' (along +x) or 'backward'; tolerance of the relative residual [-]. bodies:\n"
       "CombinedMaterial or Bodies, with a layer or viscoelastic ones, classical, coupling 'newton' or\n"
       "'alternating'; None: elastic ones with the contact's G, nu and K. Friction that falls with the\n"
       "slip (classical) follows it over memory_distance [m] or at least with memory_speed [m/s]; of\n"
       "several solutions slip_start picks that from 'below' or 'above'. thermal: two ThermalBody,\n"
       "whose surfaces have temperatures in steady rolling (classical); temperature_effect: what these\n"
       "add to the friction.\n" +
       after)
          .c_str());
}

void bind_solver(py::module_& module) {
  const auto none = py::none();
  py::class_<Exact> elliptic(
      module, "EllipticContactSolver",
      "Hertzian contacts by the exact theory of half-spaces: normal and tangential problem on mx x my\n"
      "elements across the ellipse. Influence coefficients are kept for the next contact with the same\n"
      "ellipse and material. Calls from several Python threads wait for each other; Ctrl-C ends them.");
  def_options<int, int, Discretisation, ElementShape>(
      elliptic,
      [](const CommonProblem& common, Method method, int mx, int my, Discretisation discretisation,
         ElementShape elements) {
        method.mx = mx;
        method.my = my;
        if (discretisation == Discretisation::classical) method.discretisation = discretisation;
        method.elements = elements;
        return std::make_unique<Exact>(common, method);
      },
      "mx, my: elements across the ellipse [-], 1 to 4,000; discretisation of rolling\n"
      "'second_order' or 'classical' (Kalker's, first order; shifts and steps that are given always);\n"
      "elements 'constant' or, classical, 'bilinear';\n",
      "Error if an option is out of range or the grid needs more memory than the machine has.", "mx"_a = 24,
      "my"_a = 24, py::kw_only(), "discretisation"_a = Discretisation::second_order,
      "elements"_a = ElementShape::constant);
  elliptic
      .def("solve", &solve, "contact"_a, py::kw_only(), "motion"_a = ContactMotion::steady, "force_x"_a = none,
           "force_y"_a = none, "step"_a = 0.0, "steps"_a = 1,
           "Solves a contact. motion: 'steady' rolling; 'transient' rolling, `steps` steps of `step` [m]\n"
           "(0: the elements' length) from zero tractions on; 'shift', a rigid shift with creepages\n"
           "in [m], [m], [rad]. force_x, force_y [N] on body 1 replace the creepage in that\n"
           "direction. Returns ContactSolution; input out of range gives Status.invalid_input and NaN. Cost\n"
           "O(N log N) in the number of elements, 2 ms at 24 x 24.")
      .def(
          "differentiate",
          [](Exact& self, const EllipticContact& contact) {
            return self.run([contact](ExactSolver& solver, const Progress& progress) {
              return solver.differentiate(contact, progress);
            });
          },
          "contact"_a,
          "Steady rolling at second order: forces [N], [N m] and their derivatives with respect to xi [-],\n"
          "eta [-] and phi [1/m], as ExactDerivatives, by the implicit function theorem, accurate to 1e-5\n"
          "away from kinks.")
      .def("__repr__",
           [](const Exact& self) {
             const Method& method = self.object.method();
             return "EllipticContactSolver(" + std::to_string(method.mx) + ", " + std::to_string(method.my) + ")";
           })
      .def("deformed_gap", &deformed_gap, "contact"_a, py::kw_only(), "motion"_a = ContactMotion::steady,
           "Deformed distance of the bodies h - delta + u_n at the cells of the results, shape (my, mx) [m]; zero in "
           "contact.");
  def_batch(elliptic, "solve_batch", solve_batch,
            "Many contacts in steady rolling in one call, on all processors (threads = 0) or as many threads\n"
            "as given. Arguments as in Fastsim2.solve_batch: longitudinal, lateral [-], spin [1/m], a, b [m],\n"
            "shear_modulus [Pa], poisson_ratio [-], normal_force [N], friction [-], rolling_speed [m/s],\n"
            "dissimilarity [-], as numbers or arrays that broadcast to shape (...). Ctrl-C ends the call.\n"
            "Returns ExactForceArrays; no contact stops the others.");

  py::class_<Accurate> accurate(
      module, "AccurateContactSolver",
      "Hertzian contacts in steady rolling to an accuracy that is asked for: grids of 8 and 16, 16 and\n"
      "32, ... elements across, extrapolated, until the limit's error is estimated below it.");
  def_options<double>(
      accurate,
      [](const CommonProblem& common, Method method, double accuracy) {
        method.accuracy = accuracy;
        return std::make_unique<Accurate>(common, method);
      },
      "accuracy in mu Fn [-], in [1e-5, 0.1];\n",
      "Those that are solved classically take far more elements for the same accuracy.", "accuracy"_a, py::kw_only());
  accurate.def(
      "solve",
      [](Accurate& self, const EllipticContact& contact, Force force_x, Force force_y) {
        return self.run([&, contact](AccurateSolver& solver, const Progress& progress) {
          return solver.solve(contact, {.force_x = force_x, .force_y = force_y}, progress);
        });
      },
      "contact"_a, py::kw_only(), "force_x"_a = none, "force_y"_a = none,
      "Steady rolling with creepages, or force_x, force_y [N] on body 1 instead. Returns\n"
      "AccurateContact; its status is not_converged if not even 512 x 512 elements are good enough.");
}

} // namespace

void bind_exact(py::module_& module) {
  bind_results(module);
  bind_solver(module);
}

} // namespace microslip::python
