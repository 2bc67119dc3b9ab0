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

class Chance {
public:
  Chance(unsigned seed, unsigned round) {
    std::seed_seq both{seed, round};
    engine_.seed(both);
  }

  std::size_t below(std::size_t count) { return engine_() % count; }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <class Value, std::size_t count> Value of(const Value (&values)[count]) { return values[below(count)]; }

  /// For an angle, which is not that of a wheel on its side.
  double extreme_angle() {
    static constexpr double values[] = {0,
                                        -0.0,
                                        1e-300,
                                        1e-9,
                                        -1e-3,
                                        0.1,
                                        std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::quiet_NaN()};
    return of(values);
  }

  double extreme() {
    using Limits = std::numeric_limits<double>;
    static constexpr double values[] = {0,
                                        -0.0,
                                        Limits::denorm_min(),
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

#define LIBCONTACT_FUNCTION(name)                                                                                      \
  { #name, with_arguments(name) }
const Function functions[] = {
    LIBCONTACT_FUNCTION(cntc_initializefirst),
    LIBCONTACT_FUNCTION(cntc_initializefirst_new),
    LIBCONTACT_FUNCTION(cntc_initialize),
    LIBCONTACT_FUNCTION(cntc_setfileunits),
    LIBCONTACT_FUNCTION(cntc_setglobalflags),
    LIBCONTACT_FUNCTION(cntc_getmaxnumthreads),
    LIBCONTACT_FUNCTION(cntc_readinpfile),
    LIBCONTACT_FUNCTION(cntc_finalize),
    LIBCONTACT_FUNCTION(cntc_finalizelast),
    LIBCONTACT_FUNCTION(cntc_setflags),
    LIBCONTACT_FUNCTION(cntc_getflags),
    LIBCONTACT_FUNCTION(cntc_setmetadata),
    LIBCONTACT_FUNCTION(cntc_setsolverflags),
    LIBCONTACT_FUNCTION(cntc_setmaterialparameters),
    LIBCONTACT_FUNCTION(cntc_setmaterialproperties),
    LIBCONTACT_FUNCTION(cntc_settemperaturedata),
    LIBCONTACT_FUNCTION(cntc_settimestep),
    LIBCONTACT_FUNCTION(cntc_setrollingstepsize),
    LIBCONTACT_FUNCTION(cntc_setfrictionmethod),
    LIBCONTACT_FUNCTION(cntc_setpotcontact),
    LIBCONTACT_FUNCTION(cntc_settangentialforces),
    LIBCONTACT_FUNCTION(cntc_setreferencevelocity),
    LIBCONTACT_FUNCTION(cntc_sethertzcontact),
    LIBCONTACT_FUNCTION(cntc_setpenetration),
    LIBCONTACT_FUNCTION(cntc_setnormalforce),
    LIBCONTACT_FUNCTION(cntc_setundeformeddistc),
    LIBCONTACT_FUNCTION(cntc_setcreepages),
    LIBCONTACT_FUNCTION(cntc_setextrarigidslip),
    LIBCONTACT_FUNCTION(cntc_setverticalforce),
    LIBCONTACT_FUNCTION(cntc_setprofileinputfname),
    LIBCONTACT_FUNCTION(cntc_setprofileinputvalues),
    LIBCONTACT_FUNCTION(cntc_settrackdimensions),
    LIBCONTACT_FUNCTION(cntc_setwheelsetdimensions),
    LIBCONTACT_FUNCTION(cntc_setwheelsetposition),
    LIBCONTACT_FUNCTION(cntc_setwheelsetvelocity),
    LIBCONTACT_FUNCTION(cntc_setwheelsetflexibility),
    LIBCONTACT_FUNCTION(cntc_calculate),
    LIBCONTACT_FUNCTION(cntc_getcalculationtime),
    LIBCONTACT_FUNCTION(cntc_resetcalculationtime),
    LIBCONTACT_FUNCTION(cntc_getprofilevalues),
    LIBCONTACT_FUNCTION(cntc_getprofilevalues_new),
    LIBCONTACT_FUNCTION(cntc_getwheelsetposition),
    LIBCONTACT_FUNCTION(cntc_getwheelsetvelocity),
    LIBCONTACT_FUNCTION(cntc_getnumcontactpatches),
    LIBCONTACT_FUNCTION(cntc_getcontactlocation),
    LIBCONTACT_FUNCTION(cntc_getglobalforces),
    LIBCONTACT_FUNCTION(cntc_getparameters),
    LIBCONTACT_FUNCTION(cntc_getreferencevelocity),
    LIBCONTACT_FUNCTION(cntc_gethertzcontact),
    LIBCONTACT_FUNCTION(cntc_getnumelements),
    LIBCONTACT_FUNCTION(cntc_getgriddiscretization),
    LIBCONTACT_FUNCTION(cntc_getpotcontact),
    LIBCONTACT_FUNCTION(cntc_getpenetration),
    LIBCONTACT_FUNCTION(cntc_getcreepages),
    LIBCONTACT_FUNCTION(cntc_getcontactforces),
    LIBCONTACT_FUNCTION(cntc_getcontactpatchareas),
    LIBCONTACT_FUNCTION(cntc_getelementdivision),
    LIBCONTACT_FUNCTION(cntc_getmaximumpressure),
    LIBCONTACT_FUNCTION(cntc_getmaximumtraction),
    LIBCONTACT_FUNCTION(cntc_getmaximumtemperature),
    LIBCONTACT_FUNCTION(cntc_getfielddata),
    LIBCONTACT_FUNCTION(cntc_gettractions),
    LIBCONTACT_FUNCTION(cntc_getmicroslip),
    LIBCONTACT_FUNCTION(cntc_getdisplacements),
    LIBCONTACT_FUNCTION(cntc_getsensitivities),
    LIBCONTACT_FUNCTION(subs_addblock),
    LIBCONTACT_FUNCTION(subs_calculate),
    LIBCONTACT_FUNCTION(subs_getblocksize),
    LIBCONTACT_FUNCTION(subs_getresults),
};
#undef LIBCONTACT_FUNCTION

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
    if (chance_.one_in(2)) return set_both(ire, icp);
    if (ire == wheel)
      set_the_wheel();
    else
      set_the_contact(icp);
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

  void set_both(int ire, int icp) {
    static constexpr int materials[] = {0, 0, 1, 2, 3, 4, 5, 12};
    static const Values extra[] = {{}, {1, 1, .001, .001}, {1e-5, 1, 1, 1}, {1, 1, 1}, {8200, .02, 0, 0}, {1, 1, 1}};
    switch (chance_.below(6)) {
    case 0: {
      const int method = chance_.of(materials);
      Values numbers = method == 12 ? Values{1e-4, 1e-4, 1e30, 1e30} : Values{.28, .28, 82000, 82000};
      if (method < 6) numbers.insert(numbers.end(), extra[method].begin(), extra[method].end());
      return give("cntc_setmaterialparameters",
                  [&] { return set(cntc_setmaterialparameters, ire, icp, method, perhaps(numbers)); });
    }
    case 1: {
      static const Values sets[] = {{.3, .3},
                                    {},
                                    {.2, .1, 5000, 0, 1, .001, 10},
                                    {.2, .1, 5000, 0, 1, .001, 10},
                                    {.2, .1, 5000, 0, 1, .001, 10},
                                    {.3, .4, 1e-4},
                                    {.3, 20, -.1, 800, .001, 10}};
      const std::size_t law = chance_.below(std::size(sets));
      return give("cntc_setfrictionmethod",
                  [&] { return set(cntc_setfrictionmethod, ire, icp, static_cast<int>(law), perhaps(sets[law])); });
    }
    case 2:
      return give("cntc_settemperaturedata", [&] {
        return set(cntc_settemperaturedata, ire, icp, chance_.one_in(3) ? 0 : 3,
                   perhaps({20, 450, .05, 7.85e-6, 20, 450, .05, 7.85e-6, 1}));
      });
    case 3: {
      double chi = perhaps(0), dq = perhaps(ire == wheel ? 1 : .2);
      return give("cntc_setrollingstepsize", [&] { return cntc_setrollingstepsize(&ire, &icp, &chi, &dq); });
    }
    case 4: {
      double fx = perhaps(.3), fy = perhaps(-.2);
      return give("cntc_settangentialforces", [&] { return cntc_settangentialforces(&ire, &icp, &fx, &fy); });
    }
    default: {
      Values x = {1, 1, 3}, y = x, z = perhaps({3, 0, .2});
      int block = 1, kind = chance_.one_in(2) ? 1 : 2, three = 3;
      return give("subs_addblock", [&] {
        return subs_addblock(&ire, &icp, &block, &kind, &three, &three, &three, x.data(), y.data(), z.data());
      });
    }
    }
  }

  void set_the_wheel() {
    double force = perhaps(80e3);
    int one = wheel;
    switch (chance_.below(8)) {
    case 0:
      return give("cntc_setverticalforce", [&] { return cntc_setverticalforce(&one, &force); });
    case 1:
      return give("cntc_setpotcontact", [&] {
        return set(cntc_setpotcontact, wheel, whole, -1, perhaps({.5, .5, 1.57, 8, 4}));
      });
    case 2:
      return give("cntc_settrackdimensions", [&] {
        return set(cntc_settrackdimensions, wheel, 3, perhaps({14, 0, 1435, .05, 0, 0, 0, 0, 0, 0, 0}, 3, 7));
      });
    case 3:
      return give("cntc_setwheelsetdimensions", [&] {
        return set(cntc_setwheelsetdimensions, wheel, 3, perhaps({1360, -70, 460}));
      });
    case 4:
      return give("cntc_setwheelsetposition", [&] {
        return set(cntc_setwheelsetposition, wheel, 2, perhaps({0, 3, .2, -3e-4, 6e-3, 0}, 3, 5));
      });
    case 5:
      return give("cntc_setwheelsetvelocity", [&] {
        return set(cntc_setwheelsetvelocity, wheel, 2, perhaps({30e3, 0, 0, 0, 0, -30e3 / 460.3}));
      });
    case 6:
      return give("cntc_setwheelsetflexibility", [&] {
        return set(cntc_setwheelsetflexibility, wheel, 4, perhaps(Values(12, chance_.one_in(2) ? 0 : 1e-3), 3, 5));
      });
    default:
      return give("cntc_setprofileinputfname", [&] {
        return chance_.one_in(2) ? set_profile(wheel, profiles + "60e1.prr", 0)
                                 : set_profile(wheel, profiles + "s1002.prw", 1);
      });
    }
  }

  void set_the_contact(int icp) {
    int ire = contact;
    double a = perhaps(1e-3), b = perhaps(-5e-4), c = perhaps(1e-4), force = perhaps(1000), approach = perhaps(.01);
    switch (chance_.below(8)) {
    case 0:
      return give("cntc_setnormalforce", [&] { return cntc_setnormalforce(&ire, &icp, &force); });
    case 1:
      return give("cntc_setpenetration", [&] { return cntc_setpenetration(&ire, &icp, &approach); });
    case 2:
      return give("cntc_setcreepages", [&] { return cntc_setcreepages(&ire, &icp, &a, &b, &c); });
    case 3:
      return give("cntc_setpotcontact", [&] {
        return set(cntc_setpotcontact, ire, icp, 1, perhaps({21, 21, -1.05, -1.05, .1, .1}));
      });
    case 4: {
      const int kind = -1 - static_cast<int>(chance_.below(3));
      const Values shape = kind == -3 ? Values{1, 1} : Values{.005, kind == -2 ? 1 : .005};
      return give("cntc_sethertzcontact", [&] {
        return set(cntc_sethertzcontact, ire, icp, kind, perhaps({21, 21, shape[0], shape[1], 1.2}));
      });
    }
    case 5:
      return give("cntc_setundeformeddistc", [&] {
        return set(cntc_setundeformeddistc, ire, icp, 1, perhaps({.005, 0, .005, 0, 0, 0}));
      });
    case 6: {
      double speed = perhaps(1000);
      return give("cntc_setreferencevelocity", [&] { return cntc_setreferencevelocity(&ire, &icp, &speed); });
    }
    default: {
      Values wx(441, perhaps(0)), wy(441, perhaps(1e-4));
      int count = static_cast<int>(chance_.one_in(2) ? wx.size() : chance_.below(wx.size()));
      return give("cntc_setextrarigidslip",
                  [&] { return cntc_setextrarigidslip(&ire, &icp, &count, wx.data(), wy.data()); });
    }
    }
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
  unsigned seed = 1, rounds = 20, round = 0, calls = 300;
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
