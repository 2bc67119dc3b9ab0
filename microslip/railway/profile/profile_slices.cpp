#include "microslip/railway/profile/profile_slices.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <string>

namespace microslip {
namespace {

constexpr double tiny = 1e-6; // in the unit of length, as in CONTACT

/// The features of a slice that it has, as s of its profile in ascending order, and the index of the first of them.
struct Features {
  std::size_t first = 0;
  std::vector<double> s;
};

[[noreturn]] void fail(std::size_t slice, const std::string& text) {
  throw Error("slice " + std::to_string(slice + 1) + ": " + text);
}

Features features_of(const ProfileSlice& slice, std::size_t index, std::size_t count) {
  const double length = slice.profile.length();
  if (slice.features.empty()) return {0, {0, length}};
  if (slice.features.size() != count) fail(index, "has other features than the first slice");
  const auto is_there = [](double s) { return s >= -tiny; };
  const auto begin = std::find_if(slice.features.begin(), slice.features.end(), is_there);
  const auto end = std::find_if(slice.features.rbegin(), slice.features.rend(), is_there).base();
  if (end - begin < 2) fail(index, "has fewer than two features");
  Features f{static_cast<std::size_t>(begin - slice.features.begin()), {begin, end}};
  f.s.back() = std::min(f.s.back(), length);
  for (std::size_t k = 1; k < f.s.size(); ++k)
    if (!(f.s[k] - f.s[k - 1] > tiny))
      fail(index, "feature " + std::to_string(f.first + k + 1) + " at " + std::to_string(f.s[k]) +
                      " does not lie behind the one before, at " + std::to_string(f.s[k - 1]) + "; the profile is " +
                      std::to_string(length) + " long");
  if (slice.profile.role() == ProfileRole::wheel) { // its file begins at the field side
    for (double& s : f.s) s = length - s;
    std::reverse(f.s.begin(), f.s.end());
    f.first = count - f.first - f.s.size();
  }
  return f;
}

} // namespace

ProfileSurface join_slices(const std::vector<ProfileSlice>& slices, const SliceOptions& options) {
  if (slices.empty()) throw Error("there are no slices");
  const std::size_t count = std::max<std::size_t>(2, slices.front().features.size());
  std::vector<Features> features;
  std::vector<double> longest(count - 1, -1);
  for (std::size_t k = 0; k < slices.size(); ++k) {
    features.push_back(features_of(slices[k], k, count));
    const Features& f = features.back();
    for (std::size_t i = 1; i < f.s.size(); ++i)
      longest[f.first + i - 1] = std::max(longest[f.first + i - 1], f.s[i] - f.s[i - 1]);
  }
  std::vector<std::size_t> v(count, 0); // of the features
  for (std::size_t i = 1; i < count; ++i)
    v[i] = v[i - 1] + 1 + static_cast<std::size_t>((std::max(0.0, longest[i - 1]) + tiny) / options.spacing);
  std::vector<SurfaceSlice> sampled;
  for (std::size_t k = 0; k < slices.size(); ++k) {
    const Features& f = features[k];
    SurfaceSlice slice{slices[k].u, v[f.first], {}};
    for (std::size_t i = 1; i < f.s.size(); ++i) {
      const std::size_t pieces = v[f.first + i] - v[f.first + i - 1];
      for (std::size_t j = i == 1 ? 0 : 1; j <= pieces; ++j) {
        const double s = f.s[i - 1] + (f.s[i] - f.s[i - 1]) * (double(j) / double(pieces));
        slice.points.push_back(slices[k].profile.at(s).value);
      }
    }
    sampled.push_back(std::move(slice));
  }
  SurfaceOptions surface{options.method, {}, options.waves, slices.front().profile.role() == ProfileRole::wheel};
  for (const int kink : options.kinks) {
    const auto feature = static_cast<std::size_t>(kink);
    surface.kinks.push_back(v[surface.is_wheel ? count - 1 - feature : feature]);
  }
  std::sort(surface.kinks.begin(), surface.kinks.end());
  return ProfileSurface(std::move(sampled), std::move(surface));
}

} // namespace microslip
