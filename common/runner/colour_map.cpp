#include "common/runner/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "common/runner/ink.hpp"

namespace clapotis {
namespace {

/// Every fifth of viridis' 256 colours; straight lines between them stay within 1/255 of the other ones.
/// Data: Stefan van der Walt and Nathaniel Smith, mpl-colormaps (2015), public domain (CC0 1.0).
constexpr std::array<Colour, 52> viridis{{
    {0.267004F, 0.004874F, 0.329415F}, {0.273809F, 0.031497F, 0.358853F}, {0.278791F, 0.062145F, 0.386592F},
    {0.281924F, 0.089666F, 0.412415F}, {0.283197F, 0.115680F, 0.436115F}, {0.282623F, 0.140926F, 0.457517F},
    {0.280255F, 0.165693F, 0.476498F}, {0.276194F, 0.190074F, 0.493001F}, {0.270595F, 0.214069F, 0.507052F},
    {0.263663F, 0.237631F, 0.518762F}, {0.255645F, 0.260703F, 0.528312F}, {0.246811F, 0.283237F, 0.535941F},
    {0.237441F, 0.305202F, 0.541921F}, {0.227802F, 0.326594F, 0.546532F}, {0.218130F, 0.347432F, 0.550038F},
    {0.208623F, 0.367752F, 0.552675F}, {0.199430F, 0.387607F, 0.554642F}, {0.190631F, 0.407061F, 0.556089F},
    {0.182256F, 0.426184F, 0.557120F}, {0.174274F, 0.445044F, 0.557792F}, {0.166617F, 0.463708F, 0.558119F},
    {0.159194F, 0.482237F, 0.558073F}, {0.151918F, 0.500685F, 0.557587F}, {0.144759F, 0.519093F, 0.556572F},
    {0.137770F, 0.537492F, 0.554906F}, {0.131172F, 0.555899F, 0.552459F}, {0.125394F, 0.574318F, 0.549086F},
    {0.121148F, 0.592739F, 0.544641F}, {0.119423F, 0.611141F, 0.538982F}, {0.121380F, 0.629492F, 0.531973F},
    {0.128087F, 0.647749F, 0.523491F}, {0.140210F, 0.665859F, 0.513427F}, {0.157851F, 0.683765F, 0.501686F},
    {0.180653F, 0.701402F, 0.488189F}, {0.208030F, 0.718701F, 0.472873F}, {0.239374F, 0.735588F, 0.455688F},
    {0.274149F, 0.751988F, 0.436601F}, {0.311925F, 0.767822F, 0.415586F}, {0.352360F, 0.783011F, 0.392636F},
    {0.395174F, 0.797475F, 0.367757F}, {0.440137F, 0.811138F, 0.340967F}, {0.487026F, 0.823929F, 0.312321F},
    {0.535621F, 0.835785F, 0.281908F}, {0.585678F, 0.846661F, 0.249897F}, {0.636902F, 0.856542F, 0.216620F},
    {0.688944F, 0.865448F, 0.182725F}, {0.741388F, 0.873449F, 0.149561F}, {0.793760F, 0.880678F, 0.120005F},
    {0.845561F, 0.887322F, 0.099702F}, {0.896320F, 0.893616F, 0.096335F}, {0.945636F, 0.899815F, 0.112838F},
    {0.993248F, 0.906157F, 0.143936F},
}};

/// From blue over a grey of lightness 82 to red, by the construction of K. Moreland, Diverging color maps for
/// scientific visualization (2009), with his two ends; his own grey, of lightness 88, is lost on white paper.
constexpr std::array<Colour, 17> cool_warm{{
    {0.230F, 0.299F, 0.754F},
    {0.338F, 0.396F, 0.830F},
    {0.434F, 0.489F, 0.889F},
    {0.521F, 0.573F, 0.927F},
    {0.599F, 0.647F, 0.945F},
    {0.667F, 0.709F, 0.940F},
    {0.724F, 0.755F, 0.914F},
    {0.769F, 0.786F, 0.867F},
    {0.800F, 0.800F, 0.800F},
    {0.872F, 0.767F, 0.736F},
    {0.918F, 0.717F, 0.663F},
    {0.939F, 0.650F, 0.582F},
    {0.936F, 0.568F, 0.497F},
    {0.909F, 0.472F, 0.408F},
    {0.861F, 0.362F, 0.319F},
    {0.792F, 0.233F, 0.232F},
    {0.706F, 0.016F, 0.150F},
}};

constexpr std::span<const Colour> table_of(ColourMap map) {
  return map == ColourMap::cool_warm ? std::span<const Colour>(cool_warm) : viridis;
}

Colour between(const Colour& a, const Colour& b, float share) {
  return {std::lerp(a.red, b.red, share), std::lerp(a.green, b.green, share),
          std::lerp(a.blue, b.blue, share)};
}

}  // namespace

Colour at(ColourMap map, double value01) {
  if (std::isnan(value01)) return not_a_number;
  const auto table = table_of(map);
  const double skipped = map == ColourMap::viridis ? double(ink::palette().darkest) : 0;
  const double place = (skipped + (1 - skipped) * std::clamp(value01, 0.0, 1.0)) * double(table.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), table.size() - 2);
  return between(table[below], table[below + 1], static_cast<float>(place - double(below)));
}

}  // namespace clapotis
