// What a call of cntc_calculate costs beside the same case in C++, and what setters and getters cost: the right wheel
// of the example's profiles, elements of 0.2 mm, ten states. Both take turns; each figure is the shortest of many
// rounds [processor time].

#include "compat/contact/input.hpp"
#include "compat/contact/run.hpp"
#include "contact_addon.h"
#include "validation/clock.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace microslip::contact_program;
using microslip::validation::thread_time;

constexpr int states = 10, rounds = 20;
const std::string folder = MICROSLIP_EXAMPLES "/profiles/";

double y_of(int state) {
  return 0.7 * state;
}

/// The cases of a file with the same states.
std::vector<Case> cases() {
  std::ostringstream text;
  text.precision(17);
  for (int k = 0; k < states; ++k)
    text << " 1 MODULE\n 1203100\n 0022033\n 0000321\n 999 20 25 1 1e-5\n .3 .3\n .28 .28 82000. 82000.\n"
         << " .2 .2 1. 90d 8. 4.\n 14. 0 1435. 0.\n '" << folder << "60e1.prr' 0 1. 0.\n 0 0 0 0 0 0\n"
         << " 1360. -70. 460.\n '" << folder << "s1002.prw' 0 1. 0.\n 0 " << y_of(k) << " 10000. 0 0 0\n"
         << " 2000. 0 0 0 0 -4.34\n";
  std::istringstream stream(text.str());
  InputReader reader(stream, "bench.inp");
  std::vector<Case> all;
  while (const Case* c = reader.next()) all.push_back(*c);
  return all;
}

void require(int code) {
  if (code < 0) throw std::runtime_error("code " + std::to_string(code) + ", see contact_addon.out");
}

/// The wheel as result element 1.
void set_up() {
  int ire = 1, module = 1, version = 0, error = 0, icp = -1, count = 5, method = 0;
  int flags[] = {CNTC_ic_config, CNTC_ic_tang, CNTC_ic_pvtime, CNTC_ic_norm, CNTC_ic_discns},
      values[] = {1, 3, 2, 1, 2};
  double material[] = {0.28, 0.28, 82000, 82000}, friction[] = {0.3, 0.3}, force = 10e3;
  double rules[] = {0.2, 0.2, 1.5707963267948966, 8, 4}, track[] = {14, 0, 1435, 0, 0, 0, 0, 0, 0, 0, 0};
  double wheelset[] = {1360, -70, 460}, numbers[] = {1, 0};
  const std::string log_folder = std::filesystem::temp_directory_path().string();
  int length_of_folder = static_cast<int>(log_folder.size());
  require(cntc_initialize(&ire, &module, &version, &error, log_folder.c_str(), &length_of_folder));
  require(cntc_setflags(&ire, &icp, &count, flags, values));
  count = 4;
  require(cntc_setmaterialparameters(&ire, &icp, &method, &count, material));
  count = 2;
  require(cntc_setfrictionmethod(&ire, &icp, &method, &count, friction));
  require(cntc_setverticalforce(&ire, &force));
  method = -1, count = 5;
  require(cntc_setpotcontact(&ire, &icp, &method, &count, rules));
  method = 3, count = 11;
  require(cntc_settrackdimensions(&ire, &method, &count, track));
  count = 3;
  require(cntc_setwheelsetdimensions(&ire, &method, &count, wheelset));
  for (int type = 0; type < 2; ++type) {
    const std::string file = folder + (type == 0 ? "60e1.prr" : "s1002.prw");
    int length = static_cast<int>(file.size()), one = 1, two = 2;
    require(cntc_setprofileinputfname(&ire, file.c_str(), &length, &one, &type, &two, numbers));
  }
}

void set_state(int state) {
  int ire = 1, method = 2, six = 6;
  double position[] = {0, y_of(state), 0, 0, 0, 0}, velocity[] = {2000, 0, 0, 0, 0, -4.34};
  require(cntc_setwheelsetposition(&ire, &method, &six, position));
  require(cntc_setwheelsetvelocity(&ire, &method, &six, velocity));
}

double solve_by_library() {
  int ire = 1, icp = -1, error = 0, count = 3;
  double forces[3], sum = 0;
  for (int k = 0; k < states; ++k) {
    set_state(k);
    require(cntc_calculate(&ire, &icp, &error));
    require(cntc_getglobalforces(&ire, &icp, &count, forces));
    sum += forces[0] + forces[1];
  }
  return sum;
}

/// One of what takes turns.
struct Turn {
  const char* name;
  int calls;
  std::function<double()> run;
  double shortest = HUGE_VAL; ///< [us] for a call
};

} // namespace

int main() try {
  const std::vector<Case> all = cases();
  set_up();
  Run runs;
  const auto solve_in_cpp = [&] {
    double sum = 0;
    for (const Case& c : all) {
      const Outcome o = runs.run(c);
      sum += o.wheel->track.force.x + o.wheel->track.force.y;
    }
    return sum;
  };
  if (solve_in_cpp() != solve_by_library()) throw std::runtime_error("the library has other numbers");
  constexpr int many = 10000;
  const auto set_many = [] {
    for (int k = 0; k < many / 2; ++k) set_state(0);
    return 0.0;
  };
  const auto get_many = [] {
    int ire = 1, icp = -1, count = 24;
    double forces[24];
    for (int k = 0; k < many; ++k) cntc_getglobalforces(&ire, &icp, &count, forces);
    return forces[0];
  };
  Turn turns[] = {{"C++", states, solve_in_cpp},
                  {"cntc_calculate", states, solve_by_library},
                  {"a setter", many, set_many},
                  {"cntc_getglobalforces", many, get_many}};
  for (int k = 0; k < rounds; ++k)
    for (Turn& turn : turns) {
      const double begin = thread_time();
      turn.run();
      turn.shortest = std::min(turn.shortest, 1e6 * (thread_time() - begin) / turn.calls);
    }
  std::printf("%-24s %12s %12s\n", "", "us per call", "over C++");
  for (const Turn& turn : turns)
    std::printf("%-24s %12.4g %12.4g\n", turn.name, turn.shortest, turn.shortest / turns[0].shortest);
  cntc_finalizelast();
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
