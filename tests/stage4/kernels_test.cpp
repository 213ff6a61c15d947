#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "common/kernels/cubic_spline.hpp"
#include "common/kernels/lattice.hpp"
#include "common/kernels/wendland_c2.hpp"
#include "tests/catch.hpp"
#include "tests/common/runs.hpp"

using namespace clapotis;
using namespace clapotis::tests;

namespace {

const std::vector<double> lengths{0.03, 1.0, 1.7, 250.0};

/// Integral over [a, b] by Gauss and Legendre with five points: exact for polynomials up to degree 9.
template <class F>
double integral(double a, double b, const F& f) {
  const double s = std::sqrt(10.0 / 7), near = std::sqrt(5 - 2 * s) / 3, far = std::sqrt(5 + 2 * s) / 3;
  const double r = std::sqrt(70.0), heavy = (322 + 13 * r) / 900, light = (322 - 13 * r) / 900;
  const double middle = (a + b) / 2, half = (b - a) / 2;
  const auto at = [&](double x) { return f(middle + half * x); };
  return half * (128.0 / 225 * at(0) + heavy * (at(near) + at(-near)) + light * (at(far) + at(-far)));
}

/// A number as a table prints it: right to half a unit of its last digit.
Approx printed(const std::string& digits) {
  const auto decimals = static_cast<double>(digits.size() - digits.find('.') - 1);
  return Approx(std::stod(digits)).epsilon(0).margin(0.5 * std::pow(10, -decimals) * (1 + 1e-9));
}

}  // namespace

TEMPLATE_TEST_CASE("a kernel's integral over the plane is 1", "[stage4]", CubicSpline, WendlandC2) {
  for (const double h : lengths) {
    const TestType kernel(h);
    const auto ring = [&](double r) { return 2 * std::numbers::pi * r * kernel.value(r); };
    CAPTURE(h);
    // W r is a polynomial of degree 4 or 6 on [0, h] and on [h, 2h]: the rule is exact, and 30 roundings stay
    CHECK(integral(0, h, ring) + integral(h, 2 * h, ring) == Approx(1).epsilon(30 * epsilon));
  }
}

TEMPLATE_TEST_CASE("the slope of a kernel is what its values differ by", "[stage4]", CubicSpline,
                   WendlandC2) {
  for (const double h : lengths) {
    const TestType kernel(h);
    const double e = 1e-4 * h;
    // a central difference is off by e^2/6 of the third derivative, which is below 45 W(0)/h^3, and by the
    // round-off of values over 2e
    const double tolerance = kernel.value(0.0) / h * (45e-8 / 6 + 4 * epsilon / 1e-4);
    for (double q = 0.001; q < 2.2; q += 0.0137) {
      const double r = q * h, difference = (kernel.value(r + e) - kernel.value(r - e)) / (2 * e);
      CAPTURE(h, q);
      CHECK(std::abs(kernel.slope_over_r(r, 1 / r) * r - difference) < tolerance);
    }
  }
}

TEMPLATE_TEST_CASE("a kernel falls all the way, and is zero at and beyond twice its smoothing length",
                   "[stage4]", CubicSpline, WendlandC2) {
  for (const double h : lengths) {
    const TestType kernel(h);
    CAPTURE(h);
    REQUIRE(kernel.support() == 2 * h);
    for (double q = 0.01; q < 1.99; q += 0.01) {
      CHECK(kernel.value(q * h) < kernel.value((q - 0.01) * h));
      CHECK(kernel.slope_over_r(q * h, 1 / (q * h)) < 0);
    }
    // at 2h itself 2 - q may be one rounding, of which the value has the cube and the slope the square
    CHECK(kernel.value(2 * h) <= kernel.value(0.0) * std::pow(4 * epsilon, 3));
    CHECK(-kernel.slope_over_r(2 * h, 0.5 / h) <= kernel.value(0.0) / (h * h) * std::pow(4 * epsilon, 2));
    for (const double r : {2 * h * (1 + 4 * epsilon), 2.5 * h, 4 * h, 1e9 * h}) {
      CHECK(kernel.value(r) == 0);
      CHECK(kernel.slope_over_r(r, 1 / r) == 0);
    }
  }
}

TEMPLATE_TEST_CASE("a kernel is the same for one number and for a pack", "[stage4]", CubicSpline,
                   WendlandC2) {
  const TestType kernel(0.7);
  // the same operations, of which the compiler may join a product and a sum into one rounding
  const double value = 8 * epsilon * kernel.value(0.0), slope = 8 * epsilon * kernel.value(0.0) / 0.7;
  for (double first = 1e-3; first < 1.6; first += 0.0371) {
    const Pack r = first + 0.0113 * lanes, inverse = 1.0 / r;
    const Pack values = kernel.value(r), slopes = kernel.slope_over_r(r, inverse);
    for (std::size_t lane = 0; lane < Pack::size(); ++lane) {
      CAPTURE(first, lane);
      CHECK(std::abs(values[lane] - kernel.value(double{r[lane]})) <= value);
      CHECK(std::abs(slopes[lane] - kernel.slope_over_r(double{r[lane]}, double{inverse[lane]})) * r[lane] <=
            slope);
    }
  }
}

TEMPLATE_TEST_CASE("two particles at one point have a kernel's peak between them, and no gradient",
                   "[stage4]", CubicSpline, WendlandC2) {
  const TestType kernel(0.7);
  const double peak = TestType::name == "cubic_spline" ? 10 / (7 * std::numbers::pi * 0.49)
                                                       : 7 / (4 * std::numbers::pi * 0.49);
  CHECK(kernel.value(0.0) == Approx(peak).epsilon(4 * epsilon));
  for (const double r : {1e-140, 1e-100, 1e-20}) {
    const double slope = kernel.slope_over_r(r, 1 / r);
    CHECK(std::isfinite(slope));
    CHECK(std::abs(slope * r) <= 10 * peak / 0.7 * std::max(r, epsilon));
    CHECK(slope * 0.0 == 0);
  }
}

TEST_CASE("on the square lattice kernels sum up to what the table says", "[stage4]") {
  // Sums over the lattice with support 2h, computed once in another language, as printed there.
  struct Line {
    double h;  ///< over dx
    int neighbours;
    std::string cubic_value, cubic_gradient, wendland_value, wendland_gradient;
  };
  const std::vector<Line> table{
      {0.6, 4, "1.3099", "0.351", "1.5680", "0.199"},     {1.0, 8, "1.00086", "1.0131", "1.0376", "0.976"},
      {1.2, 20, "0.99976", "0.9908", "1.01795", "0.964"}, {1.3, 20, "0.99995", "1.0105", "1.01047", "0.974"},
      {1.5, 24, "1.00344", "1.0067", "1.00514", "0.997"}, {2.0, 44, "0.99996", "0.9991", "1.00121", "0.999"}};
  const double dx = GENERATE(1.0, 0.03125, 250.0);
  for (const auto& line : table) {
    const auto cubic = lattice_sums(CubicSpline(line.h * dx), dx);
    const auto wendland = lattice_sums(WendlandC2(line.h * dx), dx);
    CAPTURE(dx, line.h);
    CHECK(cubic.neighbours == line.neighbours);
    CHECK(wendland.neighbours == line.neighbours);
    CHECK(cubic.value == printed(line.cubic_value));
    CHECK(cubic.gradient == printed(line.cubic_gradient));
    CHECK(wendland.value == printed(line.wendland_value));
    CHECK(wendland.gradient == printed(line.wendland_gradient));
  }
}
