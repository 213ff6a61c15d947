#pragma once

namespace clapotis {

/// Principal branch W0 of Lambert's function: the w >= -1 with w exp(w) = x, for x >= -1/e. No unit.
/// Relative error of a unit or two in the last place for w > -0.9. The slope is infinite at the branch point
/// x = -1/e: towards it the error grows as 1e-16/(1 + w), no more than what the last digit of x decides;
/// within 1e-6 of it a series takes over. Throws std::invalid_argument for x < -1/e and NaN; W0(infinity) =
/// infinity. Corless, Gonnet, Hare, Jeffrey and Knuth 1996, Adv. Comput. Math. 5.
double lambert_w0(double x);

}  // namespace clapotis
