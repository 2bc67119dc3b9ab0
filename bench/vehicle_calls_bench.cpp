// Processor time of a wheel in a vehicle program through the doors that it has: C, the header of the adapters, the unit
// of eight wheels. S1002 on 60E1, heights given, a wheelset that runs sideways by 10 um a step. Prints a Markdown
// table.

#include "examples/adapters/wheel.h"
#include "fmi/fmi2.h"
#include "microslip.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <functional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <dlfcn.h>

namespace {

constexpr int steps = 200;

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The shortest time of a wheel [us] among some runs of all steps, or one run of every tenth.
double shortest(int runs, int wheels, const std::function<void(int step)>& call) {
  const int stride = runs > 1 ? 1 : 10;
  double best = 1e300;
  for (int run = 0; run < runs; ++run) {
    const double before = processor_time();
    for (int k = 0; k < steps; k += stride) call(k);
    best = std::min(best, 1e6 * (processor_time() - before) * stride / (steps * wheels));
  }
  return best;
}

void row(const char* call, double time) {
  std::printf("| %s | %.0f |\n", call, time);
}

double lateral_of(int step) {
  constexpr int middle = steps / 2;
  return 1e-5 * (step - middle);
}

wheel_motion motion_of(int step) {
  return {{0, lateral_of(step), 0.46 - 4e-4}, {0, 1, 0}, {20, 0, 0}, {0, 20 / 0.46, 0}, 0};
}

std::string case_text(const std::string& theory) {
  return "[track]\ngauge = 1.435\ncant = 0.025\n[rail]\nprofile = \"60e1.prr\"\n[wheelset]\nprofile = \"s1002.prw\"\n"
         "nominal_radius = 0.46\nflange_back_distance = 1.36\n[wheel]\nside = \"left\"\nvertical = -4e-4\n"
         "forward_velocity = 20.0\n[material]\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n[friction]\n"
         "coefficient = 0.3\n[solution]\n" +
         theory;
}

/// Through C and the header of the adapters.
void time_theory(const char* name, const std::string& theory, int runs) {
  const std::string file = std::string(MICROSLIP_PROFILES) + "/case.toml";
  microslip_error error = {0, ""};
  microslip_problem* problem = nullptr;
  rail_wheel w = {};
  if (microslip_problem_read(case_text(theory).c_str(), file.c_str(), &problem, &error) != MICROSLIP_OK ||
      microslip_wheel_rail_create(problem, &w.contact, &error) != MICROSLIP_OK) {
    std::printf("%s: %s\n", name, error.text);
    std::exit(1);
  }
  microslip_problem_destroy(problem);
  w.radius = 0.46, w.half_base = 0.75;
  double state[wheel_state_width], result[6], load_by[6][12];
  std::vector<double> by_state(std::size_t{7} * wheel_state_width);
  int status = 0;
  wheel_load load;
  const auto place = [&](int step) {
    const wheel_motion motion = motion_of(step);
    wheel_state(&w, &motion, state);
  };
  const auto titled = [&](const char* call) { return std::string(name) + ", " + call; };
  row(titled("`microslip_wheel_rail_solve`").c_str(), shortest(runs, 1, [&](int k) {
        place(k);
        microslip_wheel_rail_solve(w.contact, 1, wheel_state_width, state, 6, result, &status);
      }));
  row(titled("`microslip_wheel_rail_continue`").c_str(), shortest(runs, 1, [&](int k) {
        place(k);
        microslip_wheel_rail_continue(w.contact, 1, wheel_state_width, state, 6, result, &status);
      }));
  row(titled("`microslip_wheel_rail_differentiate`").c_str(), shortest(runs, 1, [&](int k) {
        place(k);
        microslip_wheel_rail_differentiate(w.contact, 1, wheel_state_width, state, 6, result, &status, 7,
                                           wheel_state_width, by_state.data());
      }));
  if (std::string(name) == "fastsim2") {
    row("fastsim2, an adapter: `wheel_solve`", shortest(runs, 1, [&](int k) {
          const wheel_motion motion = motion_of(k);
          wheel_solve(&w, &motion, &load);
        }));
    row("fastsim2, an adapter: `wheel_differentiate`", shortest(runs, 1, [&](int k) {
          const wheel_motion motion = motion_of(k);
          wheel_differentiate(&w, &motion, &load, load_by);
        }));
  }
  wheel_destroy(&w);
}

/// The unit of eight wheels, by FMI 2.0.
class VehicleUnit {
public:
  VehicleUnit() : library_(dlopen(MICROSLIP_VEHICLE_UNIT "/binaries/linux64/microslip_vehicle_wheels.so", RTLD_NOW)) {
    std::ifstream file(MICROSLIP_VEHICLE_UNIT "/modelDescription.xml");
    std::stringstream contents;
    contents << file.rdbuf();
    text_ = contents.str();
    std::smatch guid;
    std::regex_search(text_, guid, std::regex("guid=\"([^\"]*)\""));
    static const fmi2CallbackFunctions functions{nullptr, nullptr, nullptr, nullptr, nullptr};
    unit_ = find<decltype(fmi2Instantiate)>("fmi2Instantiate")("bench", fmi2CoSimulation, guid[1].str().c_str(),
                                                               "file://" MICROSLIP_VEHICLE_UNIT "/resources",
                                                               &functions, fmi2False, fmi2False);
    for (int k = 0; k < 8; ++k) {
      const std::string name = "wheel[" + std::to_string(k + 1) + "].";
      lateral_.push_back(reference(name + "state.lateral"));
      forces_.push_back(reference(name + "force_y"));
      set(reference(name + "state.vertical_force"), 0);
      set(reference(name + "state.vertical"), -4e-4);
      set(reference(name + "state.forward_velocity"), 20);
      set(reference(name + "state.pitch_velocity"), 20 / 0.46);
    }
    set(reference("track.cant"), 0.025);
    find<decltype(fmi2EnterInitializationMode)>("fmi2EnterInitializationMode")(unit_);
    find<decltype(fmi2ExitInitializationMode)>("fmi2ExitInitializationMode")(unit_);
    step_ = find<decltype(fmi2DoStep)>("fmi2DoStep");
    derivative_ = find<decltype(fmi2GetDirectionalDerivative)>("fmi2GetDirectionalDerivative");
  }
  void step(int step, int moved) {
    for (int k = 0; k < moved; ++k) set(lateral_[k], lateral_of(step));
    step_(unit_, 0, 1e-3, fmi2True);
  }
  void differentiate() {
    double changes[8], seeds[8] = {1};
    derivative_(unit_, forces_.data(), 8, lateral_.data(), 8, seeds, changes);
  }

private:
  template <class Function> Function* find(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(library_, name));
  }
  fmi2ValueReference reference(const std::string& name) const {
    const std::size_t at = text_.find("name=\"" + name + "\" valueReference=\"");
    return static_cast<fmi2ValueReference>(std::stoul(text_.substr(text_.find("Reference=\"", at) + 11, 8)));
  }
  void set(fmi2ValueReference reference, double value) {
    if (!set_) set_ = find<decltype(fmi2SetReal)>("fmi2SetReal");
    set_(unit_, &reference, 1, &value);
  }

  void* library_;
  std::string text_;
  fmi2Component unit_ = nullptr;
  std::vector<fmi2ValueReference> lateral_, forces_;
  decltype(&fmi2SetReal) set_ = nullptr;
  decltype(&fmi2DoStep) step_ = nullptr;
  decltype(&fmi2GetDirectionalDerivative) derivative_ = nullptr;
};

} // namespace

int main() {
  std::printf("| call, for one wheel | time [us] |\n|---|---|\n");
  time_theory("fastsim2", "theory = \"fastsim2\"\n", 20);
  time_theory("table", "theory = \"table\"\ntable = \"" MICROSLIP_TABLE "\"\n", 20);
  time_theory("exact, 12 elements across", "theory = \"exact\"\ngrid = 12\n", 1);
  VehicleUnit unit;
  row("unit of eight wheels, a step", shortest(20, 8, [&](int k) { unit.step(k, 8); }));
  row("unit of eight wheels, a step after which one has moved", shortest(20, 1, [&](int k) { unit.step(k, 1); }));
  row("unit of eight wheels, a step with all derivatives", shortest(20, 8, [&](int k) {
        unit.step(k, 8);
        unit.differentiate();
      }));
  return 0;
}
