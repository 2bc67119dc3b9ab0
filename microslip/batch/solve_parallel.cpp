#include "microslip/batch/solve_parallel.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/error.hpp"

namespace microslip {

void solve_parallel(const RowSolver& solver, std::span<const EllipticContact> contacts, std::span<ContactForces> forces,
                    int threads) {
  if (forces.size() != contacts.size()) throw Error("forces: must be as many as contacts");
  run_batch(contacts.size(), {.chunk = 256, .threads = threads}, [&]() -> BatchWorker {
    return [&, own = RowSolver(solver)](std::size_t first, std::size_t n, const Progress&) mutable {
      own.solve(contacts.subspan(first, n), forces.subspan(first, n));
    };
  });
}

} // namespace microslip
