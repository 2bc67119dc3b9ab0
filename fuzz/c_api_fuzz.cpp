// Calls the C interface with random arguments: zero, tiny, huge, infinite, NaN, null pointers, wrong sizes, mangled
// case texts.
//
//   microslip_c_api_fuzz [--seed S] [--seconds N | --calls N] [--call I]
//
// After every call its code is one of the header's, a text stands beside a refusal, what was refused changed nothing,
// and else all results are written: finite with MICROSLIP_OK, NaN where the header says so. Each call has a seed of its
// own: --call I makes that one again and nothing else. Calls run in a separate process, so that a crash is told as
// well.

#include "microslip.h"
#include "paths.hpp"
#include "tests/support/case_text.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <new>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace {

/// Random arguments. A share of them, drawn for each call, is of an unusual kind.
class Draw {
public:
  Draw(unsigned long seed, unsigned long call) {
    std::seed_seq seeds{seed, call};
    random_.seed(seeds);
    odd_ = pick({0.0, 0.02, 0.1, 0.5});
  }

  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  int count(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  bool is_odd() { return between(0, 1) < odd_; }
  template <class Value> Value pick(std::initializer_list<Value> values) {
    return values.begin()[count(0, static_cast<int>(values.size()) - 1)];
  }

  /// Usually near a number.
  double number(double usual) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!is_odd()) return usual * between(0.5, 1.5);
    if (count(0, 1) == 0) return pick({0.0, -usual, infinity, -infinity, std::nan(""), 1e-320, 1e-300, 1e300});
    return pick({-1.0, 1.0}) * std::pow(10, between(-320, 308));
  }
  int choice(int choices) { return is_odd() ? pick({-1, choices, 1000000, -2147483647 - 1}) : count(0, choices - 1); }
  int size(int low, int high) { return is_odd() ? pick({0, -1, 2147483647}) : count(low, high); }
  template <class Value> Value* pointer(Value* usual) { return is_odd() && count(0, 3) == 0 ? nullptr : usual; }

  std::string mangled(std::string text) {
    while (is_odd() && !text.empty()) {
      const auto at = static_cast<std::size_t>(count(0, static_cast<int>(text.size()) - 1));
      switch (count(0, 3)) {
      case 0:
        text[at] = static_cast<char>(count(1, 255));
        break;
      case 1:
        text.resize(at);
        break;
      case 2:
        text.erase(at, static_cast<std::size_t>(count(1, 40)));
        break;
      default:
        text.insert(at, pick<const char*>({"1e400", "nan", "-inf", "[", "\"", "\n\n", "[[a]]", "= 3", "\xff\xfe"}));
      }
    }
    return text;
  }

private:
  std::mt19937_64 random_;
  double odd_ = 0;
};

void require(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error(what);
}

bool is_refusal(int code) {
  return code >= MICROSLIP_NULL_POINTER;
}

/// Results that are not written yet, and whether they still are not.
template <class Result> class Results {
public:
  explicit Results(std::size_t count) : values_(count) {
    std::fill_n(reinterpret_cast<unsigned char*>(values_.data()), count * sizeof(Result), garbage);
  }
  Result* data() { return values_.data(); }
  const Result& operator[](std::size_t k) const { return values_[k]; }
  bool is_untouched() const {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values_.data());
    return std::all_of(bytes, bytes + values_.size() * sizeof(Result), [](unsigned char b) { return b == garbage; });
  }

private:
  static constexpr unsigned char garbage = 0xa5;
  std::vector<Result> values_;
};

struct Said {
  microslip_error error = {};
  microslip_error* pointer;

  explicit Said(Draw& draw) : pointer(draw.pointer(&error)) {}
  /// Looks at the code of a call, and returns it.
  int of(int code, const char* call) const {
    require(std::string_view(microslip_code_text(code)) != microslip_code_text(-1),
            std::string(call) + ": no such code");
    require(code != MICROSLIP_INTERNAL_ERROR && code != MICROSLIP_IN_USE, std::string(call) + ": " + error.text);
    if (pointer == nullptr) return code;
    require(error.code == code, std::string(call) + ": the error has another code");
    require(std::memchr(error.text, 0, sizeof error.text) != nullptr, std::string(call) + ": the text has no end");
    require((code == MICROSLIP_OK) == (error.text[0] == 0),
            std::string(call) + ": text of code " + std::to_string(code));
    return code;
  }
};

// What is passed on.

microslip_contact contact(Draw& draw) {
  microslip_contact c = {};
  c.a = draw.number(6e-3), c.b = draw.number(5e-3);
  c.shear_modulus = draw.number(82e9), c.poisson_ratio = draw.is_odd() ? draw.number(0.3) : draw.between(0, 0.5);
  c.normal_force = draw.number(80e3), c.rolling_speed = draw.number(30);
  c.creepage_longitudinal = draw.number(1e-3), c.creepage_lateral = draw.number(-1e-3), c.spin = draw.number(0.3);
  c.friction = draw.is_odd() ? draw.number(0.3) : draw.between(0, 1);
  c.friction_law = draw.count(0, 2) > 0 ? 0 : draw.choice(4);
  for (double& drop : c.friction_drop) drop = draw.count(0, 1) > 0 ? 0 : draw.number(0.1);
  for (double& velocity : c.friction_half_velocity) velocity = draw.number(1);
  return c;
}

std::vector<microslip_contact> contacts(Draw& draw) {
  std::vector<microslip_contact> all(static_cast<std::size_t>(draw.count(0, 70)));
  for (microslip_contact& c : all) c = contact(draw);
  return all;
}

bool all_are(bool (*property)(double), std::initializer_list<double> numbers) {
  return std::ranges::all_of(numbers, property);
}
bool is_finite(double x) {
  return std::isfinite(x);
}
bool is_nan(double x) {
  return std::isnan(x);
}

void look_at(const microslip_forces& f) {
  const std::initializer_list<double> numbers = {f.fx, f.fy, f.mz, f.adhesion_area, f.slip_area};
  if (f.status == MICROSLIP_OK || f.status == MICROSLIP_OUT_OF_RANGE)
    require(all_are(is_finite, numbers), "forces are not finite with status " + std::to_string(f.status));
  else if (f.status == MICROSLIP_INVALID_INPUT)
    require(all_are(is_nan, numbers), "an invalid contact has forces");
  else
    require(f.status > 0 && !is_refusal(f.status), "status " + std::to_string(f.status));
}
void look_at(const microslip_derivatives& d) {
  look_at(d.forces);
  for (const auto& row : d.jacobian)
    for (const double x : row)
      require(d.forces.status == MICROSLIP_INVALID_INPUT ? is_nan(x) : is_finite(x), "derivatives and status differ");
}
/// Makes a call on many items with results that are not written yet.
template <class Result, class Item, class Call>
void on_many(Draw& draw, const std::vector<Item>& items, const char* name, const Call& call) {
  Results<Result> results(items.size());
  const Item* const given = draw.pointer(items.data());
  Result* const wanted = draw.pointer(results.data());
  const int code = call(items.size(), given, wanted);
  if (is_refusal(code)) {
    require(code == MICROSLIP_NULL_POINTER, std::string(name) + ": refused with " + std::to_string(code));
    require(results.is_untouched(), std::string(name) + ": refused, and written");
    return;
  }
  for (std::size_t k = 0; k < items.size(); ++k) look_at(results[k]);
}

// What is called.

/// The numbers of a list: each is found again by its name.
void lists(Draw& draw, const Said& said) {
  const int list = draw.choice(MICROSLIP_WHEELSET_INPUT + 1);
  const std::size_t count = microslip_count(list);
  require((count > 0) == (list >= 0 && list <= MICROSLIP_WHEELSET_INPUT), "count of list " + std::to_string(list));
  microslip_quantity info = {};
  info.struct_size = draw.is_odd() ? draw.pick<std::size_t>({0, 8, 100000}) : sizeof info;
  const auto index = static_cast<std::size_t>(draw.is_odd() ? draw.size(0, 99) : draw.count(0, 40));
  const int code = said.of(microslip_describe(list, index, draw.pointer(&info), said.pointer), "describe");
  require(code != MICROSLIP_OK || index < count, "describe");
  if (code == MICROSLIP_OK)
    require(microslip_index(list, info.name, nullptr) == static_cast<int>(index), "index of a name");
  microslip_error error = {};
  const std::string name = draw.mangled("vertical_force");
  const int found = microslip_index(list, draw.pointer(name.c_str()), &error);
  require(found < 0 || static_cast<std::size_t>(found) < count, "index");
  require((found < 0) == (error.text[0] != 0), "index: text of the error");
}

void simple_calls(Draw& draw) {
  const Said said(draw);
  microslip_contact c = contact(draw);
  said.of(microslip_contact_check(draw.pointer(&c), said.pointer), "contact_check");
  said.of(
      microslip_polach_friction(draw.number(0.4), draw.number(0.4), draw.number(0.6), draw.pointer(&c), said.pointer),
      "polach_friction");
  microslip_bodies bodies = {};
  for (int k = 0; k < 2; ++k) {
    bodies.rolling_radius[k] = k == 1 && draw.count(0, 1) > 0 ? INFINITY : draw.number(0.46);
    bodies.transverse_radius[k] = draw.number(0.3);
    bodies.young_modulus[k] = draw.number(2.1e11), bodies.poisson_ratio[k] = draw.number(0.28);
  }
  microslip_hertz hertz = {};
  const int code =
      said.of(microslip_hertz_from_load(draw.pointer(&bodies), draw.number(8e4), draw.pointer(&hertz), said.pointer),
              "hertz_from_load");
  if (code == MICROSLIP_OK)
    require(all_are(is_finite, {hertz.a, hertz.b, hertz.approach, hertz.peak_pressure}), "hertz");
  char* text = nullptr;
  said.of(microslip_hertz_warnings(draw.pointer(&bodies), draw.pointer(&hertz), draw.pointer(&text), said.pointer),
          "hertz_warnings");
  microslip_free_text(text);
  lists(draw, said);
  require(microslip_code_text(draw.choice(30)) != nullptr, "code_text");
}

/// What can be got from a solved contact by name.
template <class Handle, class Quantity, class Field>
void get_results(Draw& draw, const Said& said, Handle* handle, std::size_t cells, Quantity quantity, Field field) {
  std::vector<double> values(cells + 1);
  const std::size_t count = draw.is_odd() ? cells + 1 : cells;
  const char* const name = draw.pick<const char*>({"fx", "frictional_power", "px", "gap", "state", "ux", "force_y",
                                                   "normal_force", "left.fx", "right.force_z", "", "no such"});
  said.of(field(draw.pointer(handle), draw.pointer(name), count, draw.pointer(values.data()), said.pointer), "field");
  double value = 0;
  said.of(quantity(draw.pointer(handle), draw.pointer(name), draw.pointer(&value), said.pointer), "quantity");
}

void fastsim2(Draw& draw) {
  const Said said(draw);
  microslip_fastsim2_options options;
  microslip_fastsim2_options_init(&options, sizeof options);
  options.mx = draw.is_odd() ? draw.size(1, 9) : draw.count(1, 9), options.my = draw.count(1, 9);
  options.bound = draw.choice(2), options.flexibility = draw.choice(3), options.coefficients = draw.choice(2);
  options.direction = draw.choice(2), options.precision = draw.choice(2);
  options.slope_initial = draw.is_odd() ? draw.number(1) : draw.between(0.1, 1);
  options.slope_decay = draw.is_odd() ? draw.number(1) : 0.5;
  if (draw.is_odd()) options.struct_size = draw.pick<std::size_t>({0, 7, sizeof options - 8, 100000});
  microslip_fastsim2* made = nullptr;
  const microslip_fastsim2_options* const chosen = draw.pointer(&options);
  if (chosen == nullptr) options.mx = options.my = 10; // the defaults
  said.of(microslip_fastsim2_create(chosen, &made, said.pointer), "fastsim2_create");
  const std::unique_ptr<microslip_fastsim2, decltype(&microslip_fastsim2_destroy)> own(made,
                                                                                       microslip_fastsim2_destroy);
  microslip_fastsim2* const solver = draw.pointer(made);
  const std::vector<microslip_contact> all = contacts(draw);
  on_many<microslip_forces>(draw, all, "fastsim2_solve", [&](auto count, auto given, auto results) {
    return microslip_fastsim2_solve(solver, count, given, results);
  });
  on_many<microslip_derivatives>(draw, all, "fastsim2_differentiate", [&](auto count, auto given, auto results) {
    return microslip_fastsim2_differentiate(solver, count, given, results);
  });
  if (made == nullptr || options.mx > 100) return;
  const microslip_contact c = contact(draw);
  Results<microslip_forces> forces(1);
  const int code = said.of(microslip_fastsim2_solve_fields(solver, draw.pointer(&c), forces.data(), said.pointer),
                           "fastsim2_solve_fields");
  if (code == MICROSLIP_OK) look_at(forces[0]);
  get_results(draw, said, made, static_cast<std::size_t>(options.mx) * options.my, microslip_fastsim2_quantity,
              microslip_fastsim2_field);
}

void creep_table(Draw& draw) {
  const Said said(draw);
  const std::string shipped = MICROSLIP_SOURCE_DIR "/python/microslip/hertz.creep";
  const std::string file = draw.is_odd() ? draw.pick<const char*>({"", "/", "/dev/null", "no such file"}) : shipped;
  microslip_creep_table* table = nullptr;
  said.of(microslip_creep_table_read(draw.pointer(file.c_str()), draw.choice(2), draw.pointer(&table), said.pointer),
          "creep_table_read");
  const std::vector<microslip_contact> all = contacts(draw);
  on_many<microslip_forces>(draw, all, "creep_table_solve", [&](auto count, auto given, auto results) {
    return microslip_creep_table_solve(table, count, given, results);
  });
  on_many<microslip_derivatives>(draw, all, "creep_table_differentiate", [&](auto count, auto given, auto results) {
    return microslip_creep_table_differentiate(table, count, given, results);
  });
  microslip_creep_table_destroy(table);
}

void force_element(Draw& draw) {
  const Said said(draw);
  static const std::string shipped = [] {
    std::ifstream file(MICROSLIP_SOURCE_DIR "/fmi/force_element.txt", std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(file), {}};
  }();
  const std::string text = draw.mangled(shipped);
  microslip_force_element* element = nullptr;
  const int made =
      said.of(microslip_force_element_create(draw.pointer(text.c_str()), draw.pointer(&element), said.pointer),
              "force_element_create");
  require((made == MICROSLIP_OK) == (element != nullptr), "force_element_create: an element without a code");
  const std::size_t size = microslip_force_element_state_size(element);
  std::vector<double> before(size), after(size);
  for (int step = draw.count(1, 4); step-- > 0;) {
    const double input[] = {draw.number(1e-3), draw.number(1e-3), draw.number(0.1), draw.number(80e3)};
    Results<double> forces(MICROSLIP_ELEMENT_FORCES);
    const int kept = microslip_force_element_get_state(element, size, before.data());
    require((kept == MICROSLIP_OK) == (element != nullptr), "force_element_get_state: no state");
    const int code = draw.count(0, 3) == 0 ? microslip_force_element_reset(element, draw.pointer(&input[0]))
                                           : microslip_force_element_step(element, draw.number(1e-3),
                                                                          draw.pointer(&input[0]), forces.data());
    if (code != MICROSLIP_OK) {
      require(forces.is_untouched(), "force_element_step: forces beside a refusal");
      microslip_force_element_get_state(element, size, after.data());
      require(before == after, "force_element_step: another state after a refusal");
    }
    if (draw.is_odd())
      microslip_force_element_set_state(element, draw.count(0, 1) == 0 ? size : size + 1, before.data());
  }
  microslip_force_element_destroy(element);
}

/// Ends solves that take long, at the same point in every run.
int end_after_many(double, void* calls) {
  return ++*static_cast<int*>(calls) > 300 ? 1 : 0;
}

const std::string& two_bodies() {
  static const std::string text =
      "[body1]\nrolling_radius = 0.46\ntransverse_radius = inf\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n"
      "[body2]\nrolling_radius = inf\ntransverse_radius = 0.3\nyoung_modulus = \"210 GPa\"\npoisson_ratio = 0.28\n"
      "[load]\nnormal_force = 80e3\n[friction]\ncoefficient = 0.3\n[motion]\nrolling_speed = 30\n"
      "creepage_longitudinal = 0.001\nspin = 0.2\n[solution]\ngrid = 6\n";
  return text;
}

/// The same bodies by the ellipse of their contact.
const std::string& an_ellipse() {
  static const std::string text =
      "[ellipse]\na = 6.7e-3\nb = 5e-3\n[body1]\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n"
      "[body2]\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n" +
      two_bodies().substr(two_bodies().find("[load]"));
  return text;
}

std::string text_of(const microslip_problem* problem) {
  char* text = nullptr;
  require(microslip_problem_text(problem, &text, nullptr) == MICROSLIP_OK, "problem_text");
  std::string copy = text;
  microslip_free_text(text);
  return copy;
}

/// A number that an input may be, usually.
double number_of(Draw& draw, const microslip_quantity& info) {
  if (info.kind == MICROSLIP_WHOLE || info.kind == MICROSLIP_WHOLES)
    return draw.is_odd() ? draw.number(4) : draw.count(1, 8);
  if (std::isfinite(info.missing) && info.missing != 0) return draw.number(info.missing);
  if (draw.is_odd() || !std::isfinite(info.least) || !std::isfinite(info.largest)) return draw.number(0.3);
  return draw.between(info.least, info.largest);
}

/// A word of a list such as "shift, transient or steady", or whatever.
std::string word_of(Draw& draw, const microslip_quantity& info) {
  std::vector<std::string> words = {"80 kN", "0.1 mm", ""};
  const std::string range = info.range;
  for (std::size_t at = 0; at < range.size();) {
    const std::size_t end = std::min(range.find_first_of(", ", at), range.size());
    if (end > at && !draw.is_odd()) words.insert(words.begin(), range.substr(at, end - at));
    at = end + 1;
  }
  const auto likely = std::max<std::size_t>(words.size() - 3, 1);
  return draw.mangled(words[static_cast<std::size_t>(draw.count(0, static_cast<int>(likely) - 1))]);
}

/// Sets an input, or something else; a refusal changes nothing.
void set_input(Draw& draw, const Said& said, microslip_problem* problem, int list) {
  microslip_quantity info = {};
  info.struct_size = sizeof info;
  const auto index = static_cast<std::size_t>(draw.count(0, static_cast<int>(microslip_count(list)) - 1));
  require(microslip_describe(list, index, &info, nullptr) == MICROSLIP_OK, "describe");
  if (std::string_view(info.name) == "solution.accuracy") return; // takes long
  const std::string path = draw.mangled(info.name), before = text_of(problem);
  const char* const named = draw.pointer(path.c_str());
  const int kind = draw.is_odd() ? draw.count(0, 5) : info.kind;
  const std::vector<double> values = {number_of(draw, info), number_of(draw, info), 1};
  int code;
  if (kind == MICROSLIP_NUMBER || kind == MICROSLIP_WHOLE)
    code = microslip_set(problem, named, values[0], said.pointer);
  else if (kind == MICROSLIP_TEXT || kind == MICROSLIP_WORD)
    code = microslip_set_text(problem, named, draw.pointer(word_of(draw, info).c_str()), said.pointer);
  else
    code = microslip_set_array(problem, named, draw.is_odd() ? draw.count(0, 3) : 2, draw.pointer(values.data()),
                               said.pointer);
  said.of(code, "set");
  if (is_refusal(code)) require(text_of(problem) == before, "set: refused, and changed");
  if (draw.is_odd()) said.of(microslip_unset(problem, named, said.pointer), "unset");
}

/// Reads an input in each form.
void get_input(Draw& draw, const Said& said, const microslip_problem* problem, int list) {
  microslip_quantity info = {};
  info.struct_size = sizeof info;
  microslip_describe(list, static_cast<std::size_t>(draw.count(0, 40)), &info, nullptr);
  const std::string path = draw.mangled(info.name ? info.name : "");
  double values[3] = {};
  std::size_t count = 0;
  char* text = nullptr;
  const char* const named = draw.pointer(path.c_str());
  said.of(microslip_get(problem, named, draw.pointer(values), said.pointer), "get");
  said.of(microslip_get_text(problem, named, draw.pointer(&text), said.pointer), "get_text");
  microslip_free_text(text);
  said.of(microslip_get_array(problem, named, 3, draw.pointer(values), draw.pointer(&count), said.pointer),
          "get_array");
}

void problem(Draw& draw) {
  const Said said(draw);
  int calls = 0;
  const int kind = draw.count(0, 2);
  microslip_problem* made = nullptr;
  if (draw.count(0, 3) == 0)
    said.of(microslip_problem_create(draw.choice(3), draw.pointer(&made), said.pointer), "problem_create");
  std::string text = kind == 0   ? (draw.is_odd() ? an_ellipse() : two_bodies()) + "theory = \"exact\"\n"
                     : kind == 1 ? microslip::wheel_rail_text
                                 : microslip::wheelset_text;
  if (made == nullptr)
    said.of(microslip_problem_read(draw.mangled(text).c_str(), "p.toml", draw.pointer(&made), said.pointer),
            "problem_read");
  const std::unique_ptr<microslip_problem, decltype(&microslip_problem_destroy)> own(made, microslip_problem_destroy);
  if (made == nullptr) return;
  const int list = MICROSLIP_BODIES_INPUT + kind;
  for (int k = draw.count(0, 4); k > 0; --k) set_input(draw, said, made, list);
  get_input(draw, said, made, list);
  said.of(microslip_set_progress(made, end_after_many, &calls, said.pointer), "set_progress");
  const int solved = said.of(microslip_solve(made, said.pointer), "solve");
  std::size_t columns = 0, rows = 0;
  said.of(microslip_field_size(made, kind == 0 ? "px" : "fx", &columns, &rows, said.pointer), "size");
  double fx = 0;
  const int told = microslip_number(made, kind == 0 ? "fx" : "force_x", &fx, nullptr);
  require(solved != MICROSLIP_OK || told != MICROSLIP_OK || std::isfinite(fx), "the force is no number");
  get_results(draw, said, made, columns * rows, microslip_number, microslip_field);
  std::vector<double> jacobian(9);
  calls = 0;
  const int code =
      said.of(microslip_differentiate(made, draw.is_odd() ? 8 : 9, draw.pointer(jacobian.data()), said.pointer),
              "differentiate");
  if (code == MICROSLIP_OK) require(std::ranges::all_of(jacobian, is_finite), "derivatives of the exact theory");
}

void solve_case(Draw& draw) {
  const Said said(draw);
  const std::string text = draw.mangled(draw.count(0, 1) > 0 ? two_bodies() : microslip::wheel_rail_text);
  char* json = nullptr;
  const int code = said.of(
      microslip_solve_case(draw.pointer(text.c_str()), draw.pointer("c.toml"), draw.pointer(&json), said.pointer),
      "solve_case");
  require(!is_refusal(code) || json == nullptr, "a refused case has a document");
  microslip_free_text(json);
}

std::size_t place(int list, const char* name) {
  const int index = microslip_index(list, name, nullptr);
  require(index >= 0, std::string("no number ") + name);
  return static_cast<std::size_t>(index);
}

/// How wide rows are: usually as their list.
std::size_t width(Draw& draw, int list) {
  const auto whole = static_cast<int>(microslip_count(list));
  return static_cast<std::size_t>(draw.is_odd() ? draw.count(0, whole + 1) : whole);
}

/// Rows of states near a usual one.
std::vector<double> states(Draw& draw, const std::vector<double>& usual, std::size_t count, std::size_t width) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> s = usual;
    s[place(MICROSLIP_WHEEL_STATE, "lateral")] = draw.is_odd() ? draw.number(0.006) : draw.between(-0.009, 0.009);
    s[place(MICROSLIP_WHEEL_STATE, "yaw")] = draw.is_odd() ? draw.number(0.01) : draw.between(-0.03, 0.03);
    s[place(MICROSLIP_WHEEL_STATE, "forward_velocity")] = draw.number(30);
    s[place(MICROSLIP_WHEEL_STATE, "vertical_force")] = draw.count(0, 4) > 0 ? draw.number(80e3) : 0;
    for (double& number : s)
      if (draw.count(0, 9) == 0 && draw.is_odd()) number = draw.number(1e-3);
    s.resize(width);
    rows.insert(rows.end(), s.begin(), s.end());
  }
  return rows;
}

/// The rows that a call on states writes.
struct WheelRows {
  WheelRows(Draw& draw, std::size_t states)
      : count(states), width(::width(draw, MICROSLIP_WHEEL_RESULT)), rows(::width(draw, MICROSLIP_WHEEL_DERIVATIVE)),
        columns(::width(draw, MICROSLIP_WHEEL_STATE)), results(count * width), jacobians(count * rows * columns),
        status(count) {}

  std::size_t count, width, rows, columns;
  Results<double> results, jacobians;
  Results<int> status;

  /// What a call has written that returned a code; `with_jacobians`: these as well.
  void look_at(int code, bool is_refusal_of_sizes, bool with_jacobians) const {
    if (is_refusal(code)) {
      require(code == MICROSLIP_NULL_POINTER || (is_refusal_of_sizes && code == MICROSLIP_WRONG_SIZE),
              "refused with " + std::to_string(code));
      require(results.is_untouched() && jacobians.is_untouched() && status.is_untouched(), "refused, and written");
      return;
    }
    require(!is_refusal_of_sizes, "rows are longer than their list");
    for (std::size_t k = 0; k < count; ++k) {
      require(status[k] >= 0 && !is_refusal(status[k]), "status " + std::to_string(status[k]));
      if (status[k] != MICROSLIP_OK && status[k] != MICROSLIP_IMPLAUSIBLE) continue;
      const std::size_t finite = place(MICROSLIP_WHEEL_RESULT, "iterations") + 1;
      for (std::size_t i = 0; i < std::min(width, finite); ++i)
        require(std::isfinite(results[k * width + i]), "a wheel's forces are not finite");
      for (std::size_t i = 0; with_jacobians && i < rows * columns; ++i)
        require(std::isfinite(jacobians[k * rows * columns + i]), "a wheel's derivatives are not finite");
    }
  }
};

/// The patches of the state last solved.
void look_at_patches(Draw& draw, const Said& said, const microslip_wheel_rail* handle) {
  const std::size_t wide = width(draw, MICROSLIP_WHEEL_PATCH), room = static_cast<std::size_t>(draw.count(0, 9));
  Results<double> values(room * wide);
  std::size_t count = 99;
  double* const to = draw.pointer(values.data());
  const int code = said.of(microslip_wheel_rail_patches(handle, wide, room, to, draw.pointer(&count), said.pointer),
                           "wheel_rail_patches");
  if (code == MICROSLIP_WRONG_SIZE)
    require(wide > microslip_count(MICROSLIP_WHEEL_PATCH) || (count > room && count < 99), "rows of patches");
  if (is_refusal(code)) require(values.is_untouched(), "wheel_rail_patches: refused, and written");
  if (code != MICROSLIP_OK || to == nullptr) return;
  require(count <= room, "more patches than room");
  for (std::size_t k = 0; k < count; ++k)
    for (const char* name : {"status", "normal_force", "fx", "fy", "mz", "contact_area", "peak_pressure"})
      if (const std::size_t i = place(MICROSLIP_WHEEL_PATCH, name); i < wide)
        require(std::isfinite(values[k * wide + i]), std::string("a patch's ") + name);
}

/// A handle's calls on states.
void solve_states(Draw& draw, const Said& said, microslip_wheel_rail* made) {
  std::vector<double> usual(microslip_count(MICROSLIP_WHEEL_STATE));
  microslip_wheel_rail_state(draw.pointer(made), width(draw, MICROSLIP_WHEEL_STATE), draw.pointer(usual.data()));
  microslip_wheel_rail* const handle = draw.pointer(made);
  const auto count = static_cast<std::size_t>(draw.count(0, 5));
  const std::size_t wide = width(draw, MICROSLIP_WHEEL_STATE);
  const std::vector<double> given = states(draw, usual, count, wide);
  const bool with_jacobians = draw.count(0, 2) == 0;
  WheelRows found(draw, count);
  const bool too_wide = wide > usual.size() || found.width > microslip_count(MICROSLIP_WHEEL_RESULT);
  const bool jacobian_too_wide =
      with_jacobians && (found.columns > usual.size() || found.rows > microslip_count(MICROSLIP_WHEEL_DERIVATIVE));
  const double* const from = draw.pointer(given.data());
  double* const results = draw.pointer(found.results.data());
  int* const status = found.status.data();
  const int code =
      with_jacobians
          ? microslip_wheel_rail_differentiate(handle, count, wide, from, found.width, results, status, found.rows,
                                               found.columns, draw.pointer(found.jacobians.data()))
          : (draw.count(0, 1) == 0 ? microslip_wheel_rail_solve : microslip_wheel_rail_continue)(
                handle, count, wide, from, found.width, results, status);
  found.look_at(code, too_wide || jacobian_too_wide, with_jacobians);
  look_at_patches(draw, said, handle);
}

void wheel_rail(Draw& draw) {
  const Said said(draw);
  std::string text = microslip::wheel_rail_text;
  const int theory = draw.count(0, 9);
  if (theory == 0) text = microslip::with(text, "\"fastsim2\"", "\"exact\"\ngrid = 8");
  if (theory > 6) text = microslip::with(text, "\"fastsim2\"", "\"table\"");
  if (draw.count(0, 3) == 0) text = microslip::with(text, "side = \"left\"", "side = \"right\"");
  microslip_wheel_rail* made = nullptr;
  microslip_problem* of = nullptr;
  said.of(microslip_problem_read(draw.count(0, 3) == 0 ? draw.mangled(text).c_str() : text.c_str(), "w.toml", &of,
                                 said.pointer),
          "problem_read");
  said.of(microslip_wheel_rail_create(of, draw.pointer(&made), said.pointer), "wheel_rail_create");
  microslip_problem_destroy(of);
  const std::unique_ptr<microslip_wheel_rail, decltype(&microslip_wheel_rail_destroy)> own(
      made, microslip_wheel_rail_destroy);
  solve_states(draw, said, made);
  microslip_wheel_rail* const handle = draw.pointer(made);
  std::vector<double> lateral(4), conicity(4);
  for (double& y : lateral) y = draw.number(0.004);
  const std::size_t wide = width(draw, MICROSLIP_WHEELSET_CONTACT);
  Results<double> contacts(lateral.size() * wide);
  Results<int> status(lateral.size());
  const int roll = draw.choice(2);
  const int code =
      said.of(microslip_wheelset_contacts(handle, roll, draw.number(1e-3), lateral.size(), draw.pointer(lateral.data()),
                                          wide, contacts.data(), status.data(), said.pointer),
              "wheelset_contacts");
  for (std::size_t k = 0; k < lateral.size() && !is_refusal(code); ++k) {
    require(status[k] >= 0 && !is_refusal(status[k]), "status of a wheelset's contact");
    for (std::size_t i = 0; i < wide && status[k] == MICROSLIP_OK; ++i)
      require(std::isfinite(contacts[k * wide + i]), "a wheelset's contact");
  }
  require(!is_refusal(code) || (contacts.is_untouched() && status.is_untouched()),
          "wheelset_contacts: refused, and written");
  said.of(microslip_equivalent_conicity(handle, roll, draw.number(1.5), lateral.size(), draw.pointer(lateral.data()),
                                        draw.pointer(conicity.data()), said.pointer),
          "equivalent_conicity");
}

struct Call {
  const char* name;
  void (*make)(Draw&);
};
constexpr Call calls[] = {{"simple_calls", simple_calls},   {"fastsim2", fastsim2}, {"creep_table", creep_table},
                          {"force_element", force_element}, {"problem", problem},   {"solve_case", solve_case},
                          {"wheel_rail", wheel_rail}};

void make_call(unsigned long seed, unsigned long k) {
  Draw draw(seed, k);
  const Call& call = calls[static_cast<std::size_t>(draw.count(0, static_cast<int>(std::size(calls)) - 1))];
  try {
    call.make(draw);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "%s: %s\n", call.name, fault.what());
    std::_Exit(1);
  }
}

struct Options {
  unsigned long seed = 1, calls = std::numeric_limits<unsigned long>::max();
  double seconds = std::numeric_limits<double>::infinity();
  long call = -1;
};

Options options_of(int count, char** words) {
  Options options;
  for (int k = 1; k < count; k += 2) {
    const std::string name = words[k];
    if (k + 1 == count) throw std::invalid_argument(name + ": needs a number");
    const std::string number = words[k + 1];
    if (name == "--seed")
      options.seed = std::stoul(number);
    else if (name == "--calls")
      options.calls = std::stoul(number);
    else if (name == "--seconds")
      options.seconds = std::stod(number);
    else if (name == "--call")
      options.call = std::stol(number);
    else
      throw std::invalid_argument(name + ": is not --seed, --calls, --seconds or --call");
  }
  if (std::isinf(options.seconds) && options.calls == std::numeric_limits<unsigned long>::max()) options.calls = 1000;
  return options;
}

} // namespace

int main(int count, char** words) try {
  const Options options = options_of(count, words);
  if (options.call >= 0) {
    make_call(options.seed, static_cast<unsigned long>(options.call));
    return 0;
  }
  // The number of the call is where both processes see it.
  using Count = std::atomic<unsigned long>;
  void* const shared = mmap(nullptr, sizeof(Count), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  Count& made = *new (shared) Count(0);
  const pid_t child = fork();
  if (child == 0) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    for (; made < options.calls; ++made) {
      if (std::chrono::duration<double>(Clock::now() - begin).count() > options.seconds) break;
      make_call(options.seed, made);
    }
    std::exit(0);
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) throw std::runtime_error("no process for the calls");
  if (status == 0) {
    std::printf("%lu calls with seed %lu: no fault found\n", made.load(), options.seed);
    return 0;
  }
  std::fprintf(stderr, "a fault in call %lu; again: microslip_c_api_fuzz --seed %lu --call %lu\n", made.load(),
               options.seed, made.load());
  return 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "microslip_c_api_fuzz: %s\n", error.what());
  return 2;
}
