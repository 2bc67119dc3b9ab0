#include "io/unit_system.hpp"

#include <mutex>

#include <udunits2.h>

namespace microslip::io {
namespace {

/// UDUNITS for one thread, and silent.
class Silence {
public:
  Silence() : lock_(one_at_a_time()), before_(ut_set_error_message_handler(ut_ignore)) {}
  ~Silence() { ut_set_error_message_handler(before_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

private:
  static std::mutex& one_at_a_time() {
    static std::mutex mutex;
    return mutex;
  }

  std::scoped_lock<std::mutex> lock_;
  ut_error_message_handler before_;
};

struct Free {
  void operator()(ut_system* system) const { ut_free_system(system); }
  void operator()(ut_unit* unit) const { ut_free(unit); }
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
template <class Object> using Owned = std::unique_ptr<Object, Free>;

/// Of the same dimensions: UDUNITS itself converts to the reciprocal, too.
bool are_alike(const ut_unit* given, const ut_unit* wanted) {
  const Owned<ut_unit> ratio(ut_divide(given, wanted));
  return ratio && ut_is_dimensionless(ratio.get()) != 0;
}

} // namespace

/// UDUNITS' database would be a file to be found at run time.
struct UnitSystem::Kept {
  Kept() : system(ut_new_system()) {
    for (const auto& [symbol, factor] : unit_prefixes()) ut_add_symbol_prefix(system.get(), symbol, factor);
    for (const auto& [symbol, value] : unit_definitions()) {
      const Owned<ut_unit> unit = value == nullptr ? Owned<ut_unit>(ut_new_base_unit(system.get())) : parse(value);
      ut_map_symbol_to_unit(symbol, UT_ASCII, unit.get());
    }
  }
  Owned<ut_unit> parse(const std::string& unit) const {
    return Owned<ut_unit>(ut_parse(system.get(), unit.c_str(), UT_ASCII));
  }

  Owned<ut_system> system;
};

UnitSystem::UnitSystem() {
  const Silence silence;
  kept_ = std::make_unique<Kept>();
}

UnitSystem::~UnitSystem() {
  const Silence silence;
  kept_.reset();
}

bool UnitSystem::knows(const std::string& symbol) const {
  const Silence silence;
  return kept_->parse(symbol) != nullptr;
}

std::optional<UnitSystem::Conversion> UnitSystem::conversion(const std::string& from, const std::string& to) const {
  const Silence silence;
  const auto given = kept_->parse(from), wanted = kept_->parse(to);
  if (!given || !are_alike(given.get(), wanted.get())) return {};
  const std::shared_ptr<cv_converter> converter(ut_get_converter(given.get(), wanted.get()), Free());
  if (!converter) return {};
  return [converter](double value) { return cv_convert_double(converter.get(), value); };
}

} // namespace microslip::io
