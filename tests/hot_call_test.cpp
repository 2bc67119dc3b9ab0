// The calls that a vehicle simulation makes millions of times take no memory and no lock, write nothing and throw
// nothing. This program replaces the functions by which they could, counts, and passes on to the real ones.

#include "microslip/simplified/row_solver.hpp"
#include "tests/test_cases.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>
#include <span>
#include <utility>
#include <vector>

#include <dlfcn.h>
#include <pthread.h>
#include <unistd.h>

#include <gtest/gtest.h>

// The sanitizers replace the C functions themselves; with them only the C++ ones are counted.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MICROSLIP_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MICROSLIP_SANITIZED
#endif
#endif

namespace {

struct Counts {
  std::atomic<int> allocations = 0, locks = 0, writes = 0, throws = 0;
};
Counts counts;
std::atomic<bool> counting = false;

void count(std::atomic<int>& what) {
  if (counting) ++what;
}

/// The function of this name that this program hides.
template <class Function> Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

} // namespace

void* operator new(std::size_t size) {
  count(counts.allocations);
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  count(counts.allocations);
  const auto step = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(step, (size + step - 1) / step * step)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  count(counts.allocations);
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  operator delete(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  operator delete(memory);
}

extern "C" {

/// Every exception begins with this.
void* __cxa_allocate_exception(std::size_t size) noexcept {
  count(counts.throws);
  return real<void*(std::size_t)>("__cxa_allocate_exception")(size);
}

#ifndef MICROSLIP_SANITIZED
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t number, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_malloc(size);
}
void* calloc(std::size_t number, std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_calloc(number, size);
}
void* realloc(void* memory, std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_realloc(memory, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  count(counts.allocations);
  return __libc_memalign(alignment, size);
}
void free(void* memory) noexcept {
  count(counts.allocations);
  __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  count(counts.locks);
  static auto* const lock = real<int(pthread_mutex_t*)>("pthread_mutex_lock");
  return lock(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  count(counts.locks);
  static auto* const lock = real<int(pthread_mutex_t*)>("pthread_mutex_trylock");
  return lock(mutex);
}
ssize_t write(int file, const void* bytes, std::size_t size) {
  count(counts.writes);
  static auto* const real_write = real<ssize_t(int, const void*, std::size_t)>("write");
  return real_write(file, bytes, size);
}
std::FILE* fopen(const char* path, const char* mode) {
  count(counts.writes);
  static auto* const open_file = real<std::FILE*(const char*, const char*)>("fopen");
  return open_file(path, mode);
}
#endif
}

namespace microslip {
namespace {

/// Whether something was written to standard output or error meanwhile, through any function.
class Silence {
public:
  Silence() {
    std::fflush(nullptr);
    for (int k = 0; k < 2; ++k) {
      saved_[k] = dup(k + 1);
      catch_[k] = std::tmpfile();
      dup2(fileno(catch_[k]), k + 1);
    }
  }
  ~Silence() { end(); }
  long end() {
    if (ended_) return bytes_;
    std::fflush(nullptr);
    for (int k = 0; k < 2; ++k) {
      bytes_ += lseek(fileno(catch_[k]), 0, SEEK_END);
      dup2(saved_[k], k + 1);
      close(saved_[k]);
      std::fclose(catch_[k]);
    }
    ended_ = true;
    return bytes_;
  }

private:
  int saved_[2];
  std::FILE* catch_[2];
  long bytes_ = 0;
  bool ended_ = false;
};

template <class Call> void expect_silent(Call call) {
  for (auto* number : {&counts.allocations, &counts.locks, &counts.writes, &counts.throws}) *number = 0;
  Silence silence;
  counting = true;
  call();
  counting = false;
  EXPECT_EQ(silence.end(), 0);
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.locks, 0);
  EXPECT_EQ(counts.writes, 0);
  EXPECT_EQ(counts.throws, 0);
}

using Contacts = std::span<const EllipticContact>;
static_assert(noexcept(std::declval<RowSolver&>().solve(std::declval<const EllipticContact&>())));
static_assert(noexcept(std::declval<RowSolver&>().solve(Contacts{}, std::span<ContactForces>{})));
static_assert(noexcept(std::declval<RowSolver&>().differentiate(std::declval<const EllipticContact&>())));
static_assert(noexcept(std::declval<RowSolver&>().differentiate(Contacts{}, std::span<ContactDerivatives>{})));

/// Of all friction laws, with invalid ones and extreme ones among them.
std::vector<EllipticContact> contacts() {
  std::vector<EllipticContact> contacts = every_nth_case(31);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EllipticContact& contact = contacts[k];
    const FrictionTerm term{.drop = 0.2, .half_velocity = 1e-3};
    if (k % 7 == 1) contact.friction = FrictionLaw::linear(0.1, term);
    if (k % 7 == 2) contact.friction = FrictionLaw::rational(0.1, term);
    if (k % 7 == 3) contact.friction = FrictionLaw::exponential(0.1, term);
    if (k % 11 == 4) contact.a = std::numeric_limits<double>::quiet_NaN();
    if (k % 11 == 5) contact.normal_force = -1;
    if (k % 11 == 6) contact.creepage.spin = 1e300;
    if (k % 11 == 7) contact.b = 1e-9;
  }
  return contacts;
}

TEST(HotCall, CountersCount) {
  counting = true;
  delete new int(1);
  try {
    throw 1;
  } catch (int) {
  }
  counting = false;
  EXPECT_GE(counts.allocations, 2);
  EXPECT_EQ(counts.throws, 1);
#ifndef MICROSLIP_SANITIZED
  pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
  counting = true;
  pthread_mutex_lock(&mutex);
  pthread_mutex_unlock(&mutex);
  [[maybe_unused]] const auto written = write(STDOUT_FILENO, "", 0);
  counting = false;
  EXPECT_EQ(counts.locks, 1);
  EXPECT_EQ(counts.writes, 1);
#endif
  Silence silence;
  std::printf("heard");
  EXPECT_EQ(silence.end(), 5);
}

TEST(HotCall, TakesNoMemoryNorLockWritesNothingAndThrowsNothing) {
  const auto all = contacts();
  std::vector<ContactForces> forces(all.size());
  std::vector<ContactDerivatives> derivatives(all.size());
  for (RowSolver& solver : all_solvers(10, 10)) {
    SCOPED_TRACE(describe(solver));
    expect_silent([&] {
      for (std::size_t k = 0; k < all.size(); ++k) forces[k] = solver.solve(all[k]);
    });
    expect_silent([&] { solver.solve(all, forces); });
    expect_silent([&] {
      for (std::size_t k = 0; k < all.size(); ++k) derivatives[k] = solver.differentiate(all[k]);
    });
    expect_silent([&] { solver.differentiate(all, derivatives); });
  }
}

} // namespace
} // namespace microslip
