// All functions by chance, in any order, with elements that have been made and without, with null pointers, lengths
// that do not fit and numbers from 0 to NaN: no crash, no code that does not exist, and the library works afterwards.
//
//   libcontact_random_calls [--seed N] [--rounds N | --seconds S | --round K] [--calls N]
//
// A round is a separate process with N calls, whose calls depend on the seed and its number only. The first that fails
// ends the program, which prints how to make it again: --round K runs it in this process and prints each call before
// it is made, and which of its numbers are other than those that programs give. Rounds that are given up are named.

#include "compat/libcontact/tests/calls.hpp"
#include "tests/support/temporary_folder.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <limits>
#include <random>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace microslip::libcontact {
namespace {

using Limits = std::numeric_limits<double>;

class Chance {
public:
  Chance(unsigned seed, unsigned round) {
    std::seed_seq both{seed, round};
    engine_.seed(both);
  }

  std::size_t below(std::size_t count) { return engine_() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <class Value, std::size_t count> const Value& of(const Value (&values)[count]) {
    return values[below(count)];
  }

  /// For an angle, which is not that of a wheel on its side.
  double extreme_angle() {
    static constexpr double values[] = {0, -0.0, 1e-300, 1e-9, -1e-3, 0.1, Limits::infinity(), Limits::quiet_NaN()};
    return of(values);
  }

  double extreme() {
    static constexpr double values[] = {0,
                                        -0.0,
                                        1e-300,
                                        1e-30,
                                        1e-9,
                                        1e-3,
                                        -1,
                                        -1e-9,
                                        1e9,
                                        1e30,
                                        -1e30,
                                        1e300,
                                        Limits::denorm_min(),
                                        Limits::max(),
                                        -Limits::max(),
                                        Limits::infinity(),
                                        -Limits::infinity(),
                                        Limits::quiet_NaN()};
    return of(values);
  }

private:
  std::mt19937 engine_;
};

/// Arguments that need not have anything to do with the function: arrays that are longer than any length among them
/// asks for.
class Arguments {
public:
  explicit Arguments(Chance& chance) : chance_(chance) {}

  int* get(int*) {
    if (chance_.one_in(25)) return nullptr;
    auto& array = ints_[next_++ % ints_.size()];
    for (int& value : array) value = flag();
    array[0] = small();
    return array.data();
  }
  double* get(double*) {
    if (chance_.one_in(25)) return nullptr;
    auto& array = doubles_[next_++ % doubles_.size()];
    for (double& value : array) value = number();
    return array.data();
  }
  const char* get(const char*) { return chance_.one_in(25) ? nullptr : letters_.data(); }

private:
  /// What a length, a number of an element, a method or a count may be.
  int small() {
    static constexpr int values[] = {-1, 1, 1, 1, 2, 3, 3, 0, -2, 4, 5, 6, 9, 10, 11, 12, 21, 32, 60};
    return chance_.one_in(50) ? std::numeric_limits<int>::min() : chance_.of(values);
  }
  int flag() { return chance_.one_in(3) ? small() : 1960 + static_cast<int>(chance_.below(70)); }
  double number() {
    static constexpr double values[] = {0,  1,   -1,  0.3,  0.28, 5,    14, 460, 82000, 0.5, 20.,
                                        8., 1e3, 1e4, 1e-3, 2.5,  1435, 3,  -70, 1360,  6.,  1.5};
    return chance_.one_in(20) ? chance_.extreme() : chance_.of(values);
  }

  Chance& chance_;
  std::array<std::vector<int>, 8> ints_ = filled<int>();
  std::array<std::vector<double>, 8> doubles_ = filled<double>();
  std::string letters_ = std::string(200, 'x');
  std::size_t next_ = 0;

  template <class Value> static std::array<std::vector<Value>, 8> filled() {
    std::array<std::vector<Value>, 8> all;
    all.fill(std::vector<Value>(60 * 60 + 60));
    return all;
  }
};

struct Function {
  const char* name;
  std::function<int(Arguments&)> call;
};

template <class... Places> std::function<int(Arguments&)> with_arguments(int (*function)(Places...)) {
  return [function](Arguments& arguments) { return function(arguments.get(Places{})...); };
}

/// Those that the header declares, of which CMake makes the list.
const Function functions[] = {
#define LIBCONTACT_FUNCTION(name) {#name, with_arguments(name)},
#include "libcontact_functions.inc"
#undef LIBCONTACT_FUNCTION
};

/// A call by its name, whose numbers from the first to the last angle are angles.
struct NamedSetting {
  const char* name;
  Setting setting;
  std::size_t first_angle = 1, last_angle = 0;
};

const NamedSetting settings_of_both[] = {
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000})},
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 1, {.28, .28, 82000, 82000, 1, 1, .001, .001})},
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 2, {.28, .28, 82000, 82000, 1e-5, 1, 1, 1})},
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 3, {.28, .28, 82000, 82000, 1, 1, 1})},
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 4, {.28, .28, 82000, 82000, 8200, .02, 0, 0})},
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 5, {.28, .28, 82000, 82000, 1, 1, 1})},
    {"cntc_setmaterialparameters", by(cntc_setmaterialparameters, 12, {1e-4, 1e-4, 1e30, 1e30})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 0, {.3, .3})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 1, {})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 2, {.2, .1, 5000, 0, 1, .001, 10})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 3, {.2, .1, 5000, 0, 1, .001, 10})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 4, {.2, .1, 5000, 0, 1, .001, 10})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 5, {.3, .4, 1e-4})},
    {"cntc_setfrictionmethod", by(cntc_setfrictionmethod, 6, {.3, 20, -.1, 800, .001, 10})},
    {"cntc_settemperaturedata", by(cntc_settemperaturedata, 0, {20, 450, .05, 7.85e-6, 20, 450, .05, 7.85e-6, 1})},
    {"cntc_settemperaturedata", by(cntc_settemperaturedata, 3, {20, 450, .05, 7.85e-6, 20, 450, .05, 7.85e-6, 1})},
    {"cntc_setrollingstepsize", by(cntc_setrollingstepsize, {0, .2})},
    {"cntc_setrollingstepsize", by(cntc_setrollingstepsize, {0, 1})},
    {"cntc_settangentialforces", by(cntc_settangentialforces, {.3, -.2})},
    {"subs_addblock",
     {[](int ire, int icp, Values z) {
        z.resize(3);
        Values x = {1, 1, 3}, y = x;
        int block = 1, kind = z[0] > 2 ? 1 : 2, three = 3;
        return subs_addblock(&ire, &icp, &block, &kind, &three, &three, &three, x.data(), y.data(), z.data());
      },
      {3, 0, .2}}},
};

const NamedSetting settings_of_wheels[] = {
    {"cntc_setverticalforce", by_force(80e3)},
    {"cntc_setpotcontact", by(cntc_setpotcontact, -1, {.5, .5, 1.57, 8, 4})},
    {"cntc_settrackdimensions", by(cntc_settrackdimensions, 3, {14, 0, 1435, .05, 0, 0, 0, 0, 0, 0, 0}), 3, 7},
    {"cntc_setwheelsetdimensions", by(cntc_setwheelsetdimensions, 3, {1360, -70, 460})},
    {"cntc_setwheelsetposition", by(cntc_setwheelsetposition, 2, {0, 3, .2, -3e-4, 6e-3, 0}), 3, 5},
    {"cntc_setwheelsetvelocity", by(cntc_setwheelsetvelocity, 2, {30e3, 0, 0, 0, 0, -30e3 / 460.3})},
    {"cntc_setwheelsetflexibility", by(cntc_setwheelsetflexibility, 4, Values(12, 0)), 3, 5},
    {"cntc_setwheelsetflexibility", by(cntc_setwheelsetflexibility, 4, Values(12, 1e-3)), 3, 5},
    {"cntc_setprofileinputfname", by_profile(profiles + "60e1.prr", 0)},
    {"cntc_setprofileinputfname", by_profile(profiles + "s1002.prw", 1)},
};

const NamedSetting settings_of_contacts[] = {
    {"cntc_setnormalforce", by(cntc_setnormalforce, {1000})},
    {"cntc_setpenetration", by(cntc_setpenetration, {.01})},
    {"cntc_setcreepages", by(cntc_setcreepages, {1e-3, -5e-4, 1e-4})},
    {"cntc_setpotcontact", by(cntc_setpotcontact, 1, {21, 21, -1.05, -1.05, .1, .1})},
    {"cntc_sethertzcontact", by(cntc_sethertzcontact, -1, {21, 21, .005, .005, 1.2})},
    {"cntc_sethertzcontact", by(cntc_sethertzcontact, -2, {21, 21, .005, 1, 1.2})},
    {"cntc_sethertzcontact", by(cntc_sethertzcontact, -3, {21, 21, 1, 1, 1.2})},
    {"cntc_setundeformeddistc", by(cntc_setundeformeddistc, 1, {.005, 0, .005, 0, 0, 0})},
    {"cntc_setreferencevelocity", by(cntc_setreferencevelocity, {1000})},
    {"cntc_setextrarigidslip",
     {[](int ire, int icp, Values v) {
        int count = size_of(v);
        return cntc_setextrarigidslip(&ire, &icp, &count, v.data(), v.data());
      },
      Values(12, 1e-4)}},
};

/// What a function may return.
bool exists(int code, bool may_count) {
  static constexpr int codes[] = {0,
                                  CNTC_err_search,
                                  CNTC_err_ftot,
                                  CNTC_err_norm,
                                  CNTC_err_tang,
                                  CNTC_err_tol,
                                  CNTC_err_icp,
                                  CNTC_err_profil,
                                  CNTC_err_frclaw,
                                  CNTC_err_discr,
                                  CNTC_err_input,
                                  CNTC_err_other};
  return std::find(std::begin(codes), std::end(codes), code) != std::end(codes) || (may_count && code > 0);
}

class Round {
public:
  Round(unsigned seed, unsigned number, bool tells) : chance_(seed, number), arguments_(chance_), tells_(tells) {
    begin(number % 4);
  }

  void run(unsigned calls) {
    for (unsigned k = 0; k < calls; ++k)
      if (chance_.one_in(3))
        call_with_any_arguments();
      else
        call_as_programs_do();
    cntc_finalizelast();
    check_afterwards();
  }

private:
  void begin(unsigned kind) {
    if (kind == 0) return; // all elements are made by the calls
    initialize(wheel, 1);
    initialize(contact, 3);
    if (kind == 1) return;
    set_up_wheel(wheel, kind == 2);
    set_wheel_state(wheel, 3);
    set_up_sphere(contact, 1);
    calculate(wheel);
    calculate(contact, 1);
  }

  void call_with_any_arguments() {
    const auto& function = functions[chance_.below(std::size(functions))];
    tell(function.name);
    check(function.name, function.call(arguments_), std::string(function.name) == "cntc_calculate");
  }

  /// A call whose arguments are right but for some of its numbers, and sometimes its length.
  void call_as_programs_do() {
    const int ire = chance_.one_in(2) ? wheel : contact, icp = ire == wheel ? whole : chance_.one_in(8) ? 2 : 1;
    if (chance_.one_in(4)) return solve(ire, icp);
    if (chance_.one_in(100)) return give("cntc_finalize", [&] { return finalize(ire); });
    if (chance_.one_in(50)) return read_a_file();
    if (chance_.one_in(4)) return set_a_flag(ire, icp);
    const auto give_one = [&](const auto& settings) { give_setting(chance_.of(settings), ire, icp); };
    if (chance_.one_in(2)) return give_one(settings_of_both);
    if (ire == wheel) return give_one(settings_of_wheels);
    give_one(settings_of_contacts);
  }

  void give_setting(const NamedSetting& named, int ire, int icp) {
    const Values numbers = perhaps(named.setting.numbers, named.first_angle, named.last_angle);
    give(named.name, [&] { return named.setting.set(ire, icp, numbers); });
  }

  double perhaps(double number, bool is_angle = false) {
    if (!chance_.one_in(12)) return number;
    const double other = is_angle ? chance_.extreme_angle() : chance_.extreme();
    if (tells_) std::printf("  %g in place of %g\n", other, number);
    return other;
  }
  /// Angles are those from `first_angle` to `last_angle`.
  Values perhaps(Values numbers, std::size_t first_angle = 1, std::size_t last_angle = 0) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      numbers[k] = perhaps(numbers[k], k >= first_angle && k <= last_angle);
    if (chance_.one_in(30)) numbers.resize(chance_.below(numbers.size() + 3));
    return numbers;
  }

  /// An input file with the wheel's case, or that of Simpack's pair, in the current folder.
  void read_a_file() {
    const bool is_pair = chance_.one_in(2);
    std::ofstream("wheel.inp") << (is_pair ? " 11" : " 1")
                               << " MODULE\n 1203100\n 0022033\n 0000321\n 999 20 25 1 1e-5\n"
                               << " .3 .3\n .28 .28 82000. 82000.\n .5 .5 1. 90d 8. 4.\n 14. 0 1435. .05\n '"
                               << profiles << "60e1.prr' 0 1. 0.\n"
                               << (is_pair ? "" : " 0 0 0 0 0 0\n") << " 1360. -70. 460.\n '" << profiles
                               << "s1002.prw' 0 1. 0.\n 0 " << perhaps(3) << " " << perhaps(80000)
                               << " 0 0 0\n 30000. 0 0 0 0 " << perhaps(-65.2) << "\n";
    const std::string name = "wheel.inp";
    int ire = wheel, kind = is_pair ? CNTC_inp_spck : CNTC_inp_modul1, length = size_of(name), error = 0;
    give("cntc_readinpfile", [&] { return cntc_readinpfile(&ire, &kind, name.c_str(), &length, &error); });
  }

  void set_a_flag(int ire, int icp) {
    static constexpr int flags[] = {
        CNTC_ic_config, CNTC_ic_pvtime, CNTC_ic_bound,  CNTC_ic_tang,   CNTC_ic_norm,   CNTC_ic_force,  CNTC_ic_frclaw,
        CNTC_ic_discns, CNTC_ic_inflcf, CNTC_ic_mater,  CNTC_ic_exrhs,  CNTC_ic_xflow,  CNTC_ic_heat,   CNTC_ic_iestim,
        CNTC_ic_output, CNTC_ic_flow,   CNTC_ic_return, CNTC_ic_matfil, CNTC_ic_sens,   CNTC_ic_ifmeth, CNTC_ic_ifvari,
        CNTC_ic_sbsout, CNTC_ic_sbsfil, CNTC_ic_npomax, CNTC_if_idebug, CNTC_if_licdbg, CNTC_if_wrtinp, CNTC_if_openmp,
        CNTC_if_timers, CNTC_if_ncase,  CNTC_if_units};
    const int flag = chance_.of(flags);
    const int value = flag == CNTC_if_units ? CNTC_un_cntc + static_cast<int>(chance_.below(4))
                                            : static_cast<int>(chance_.below(7)) - 1;
    if (tells_) std::printf("flag %d = %d of %d\n", flag, value, ire);
    give("cntc_setflags", [&] { return set_flag(ire, icp, flag, value); });
  }

  /// A calculation that tells of no error has forces that are numbers.
  void solve(int ire, int icp) {
    tell(ire == wheel ? "cntc_calculate of a wheel" : "cntc_calculate of a contact");
    const int code = calculate(ire, icp);
    check("cntc_calculate", code, true);
    int error = 0;
    check("subs_calculate", subs_calculate(&ire, &icp, &error), false);
    const int count = ire == wheel ? patches(ire) : 1;
    for (int patch = 1; code >= 0 && patch <= count; ++patch)
      for (const double force : scalars(cntc_getcontactforces, ire, ire == wheel ? patch : icp))
        if (!std::isfinite(force)) throw std::runtime_error("a force is not a number after cntc_calculate");
  }

  template <class Call> void give(const char* name, Call call) {
    tell(name);
    check(name, call(), false);
  }

  void tell(const char* name) const {
    if (tells_) std::printf("%s\n", name);
  }

  static void check(const char* name, int code, bool may_count) {
    if (!exists(code, may_count)) throw std::runtime_error(std::string(name) + " has returned " + std::to_string(code));
  }

  /// A contact that is set up anew has the forces that it always has.
  static void check_afterwards() {
    const auto forces = [] {
      if (set_up_sphere(5, 1) != 0 || calculate(5, 1) != 0) throw std::runtime_error("the library works no longer");
      const Values found = scalars(cntc_getcontactforces, 5, 1);
      cntc_finalizelast();
      return found;
    };
    const Values found = forces();
    if (found.size() != 4 || std::abs(found[0] - 1000) > 1e-3 || !(found[1] < -50) || forces() != found)
      throw std::runtime_error("a contact has other forces than it should have");
  }

  static constexpr int wheel = 1, contact = 3;
  Chance chance_;
  Arguments arguments_;
  bool tells_;
};

/// What the options say.
struct Options {
  unsigned seed = 7, rounds = 20, round = 0, calls = 300;
  double seconds = 0;
  bool is_one = false;
};

int run_round(const Options& o, unsigned round) {
  try {
    const TemporaryFolder folder; // for the log
    std::filesystem::current_path(folder.path());
    Round(o.seed, round, o.is_one).run(o.calls);
    std::filesystem::current_path("/");
    return 0;
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s\n", fault.what());
    return 1;
  }
}

enum class End { well, given_up, failed };

/// In a separate process. One that takes long is given up: some wheels that lie far from how wheels lie on rails,
/// such as one turned on its side, keep the search for their contact busy for minutes.
End end_of(const Options& o, unsigned round) {
  constexpr rlimit most_seconds{20, 30}; // of the processor
  const pid_t child = fork();
  if (child == 0) {
    setrlimit(RLIMIT_CPU, &most_seconds);
    std::exit(run_round(o, round)); // with the search for leaks
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return End::failed;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return End::given_up;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? End::well : End::failed;
}

Options options_of(const std::vector<std::string>& words) {
  Options o;
  for (std::size_t k = 0; k < words.size(); k += 2) {
    const std::string& name = words[k];
    if (k + 1 == words.size()) throw std::invalid_argument(name + " needs a number");
    const double number = std::stod(words[k + 1]);
    if (!(number >= 0 && number <= 1e9)) throw std::invalid_argument(name + " must be in 0 to 1e9");
    const auto count = static_cast<unsigned>(number);
    if (name == "--seed")
      o.seed = count;
    else if (name == "--rounds")
      o.rounds = count;
    else if (name == "--seconds")
      o.seconds = number;
    else if (name == "--round")
      o.round = count, o.is_one = true;
    else if (name == "--calls")
      o.calls = count;
    else
      throw std::invalid_argument("unknown option " + name +
                                  "; --seed, --rounds, --seconds, --round and --calls are known");
  }
  return o;
}

int run(const Options& o) {
  if (o.is_one) return run_round(o, o.round);
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
  unsigned round = 0, given_up = 0;
  for (; o.seconds > 0 ? seconds() < o.seconds : round < o.rounds; ++round) {
    const End end = end_of(o, round);
    if (end == End::well) continue;
    std::printf("%s; the same calls again: libcontact_random_calls --seed %u --round %u --calls %u\n",
                end == End::failed ? "failed" : "given up", o.seed, round, o.calls);
    if (end == End::failed) return 1;
    ++given_up;
  }
  std::printf("%u rounds of calls of libcontact by chance, seed %u, %u given up: ok\n", round, o.seed, given_up);
  return 0;
}

} // namespace
} // namespace microslip::libcontact

int main(int count, char** words) {
  using namespace microslip::libcontact;
  std::setbuf(stdout, nullptr); // so that the last call is there when the process dies
  try {
    return run(options_of({words + 1, words + count}));
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "libcontact_random_calls: %s\n", fault.what());
    return 2;
  }
}
