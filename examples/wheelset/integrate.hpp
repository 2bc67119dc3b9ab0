#pragma once

#include "history.hpp"
#include "radau.hpp"

#include <chrono>

/// Runs a model from a state. `each(time)` is called before every step and may change the model.
template <class Model, std::size_t N, class Each>
History<N> integrate(Model& model, Radau<N>& integrator, const Vector<N>& start, double duration, double step,
                     const Each& each) {
  Vector<N> z = start;
  History<N> out{.step = step, .states = {z}};
  const auto steps = std::lround(duration / step);
  out.states.reserve(static_cast<std::size_t>(steps) + 1);
  const double contact_before = model.contact_seconds();
  const long contacts_before = model.contacts(), iterations_before = integrator.iterations(),
             jacobians_before = integrator.jacobians(), halvings_before = integrator.halvings(),
             jumps_before = integrator.jumps();
  const auto before = std::chrono::steady_clock::now();
  for (long k = 0; k < steps; ++k) {
    each(static_cast<double>(k) * step);
    integrator.advance(z, step, [&](const auto& at, auto&... found) { model.rates(at, found...); });
    out.states.push_back(z);
  }
  out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
  out.contact_seconds = model.contact_seconds() - contact_before;
  out.contacts = model.contacts() - contacts_before;
  out.newton_iterations = integrator.iterations() - iterations_before;
  out.jacobians = integrator.jacobians() - jacobians_before;
  out.halvings = integrator.halvings() - halvings_before;
  out.jumps = integrator.jumps() - jumps_before;
  return out;
}
