#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "common/references/capillarity.hpp"
#include "tests/catch.hpp"

using namespace clapotis;
using std::numbers::pi;

TEST_CASE("the pressure in a drop is higher by the energy that its surface gains per area", "[references]") {
  // dA = 2 pi R dR of area costs sigma 2 pi dR of surface.
  const double sigma = 0.072, radius = 1e-3, dr = 1e-9;
  const auto surface = [&](double r) { return sigma * 2 * pi * r; };
  const auto area = [](double r) { return pi * r * r; };
  const double slope =
      (surface(radius + dr) - surface(radius - dr)) / (area(radius + dr) - area(radius - dr));
  CHECK(laplace_jump(sigma, radius) == Approx(slope).epsilon(1e-6));  // of differences of 1e-6
  CHECK_THROWS_AS(laplace_jump(sigma, 0), std::invalid_argument);
  CHECK_THROWS_AS(laplace_jump(std::numeric_limits<double>::quiet_NaN(), 1), std::invalid_argument);
}

TEST_CASE("a drop of water of a millimetre swings 105 times a second, and faster in finer modes",
          "[references]") {
  DropMode mode{.radius = 1e-3, .density = 1000, .sigma = 0.072, .viscosity = 1e-6};
  CHECK(mode.frequency() == Approx(std::sqrt(6 * 0.072 / 1e-6)));
  CHECK(mode.frequency() / (2 * pi) == Approx(104.6).epsilon(1e-3));
  CHECK(mode.decay() == Approx(4.0));  // 4 nu/R^2
  CHECK(mode.at(0) == 1);
  CHECK(mode.at(pi / mode.frequency()) == Approx(-std::exp(-4 * pi / mode.frequency())));
  mode.n = 3;
  CHECK(mode.frequency() == Approx(std::sqrt(24 * 0.072 / 1e-6)));
  CHECK(mode.decay() == Approx(12.0));
  mode.n = 1;  // it moves as a whole, and nothing drives it back
  CHECK_THROWS_AS(mode.frequency(), std::invalid_argument);
  CHECK_THROWS_AS((DropMode{.radius = 1e-3, .density = 0, .sigma = 1, .viscosity = 0}.frequency()), std::invalid_argument);
}

TEST_CASE("a cap of 90 degrees is half a disc, and one of any angle has its area and its angle",
          "[references]") {
  const CircularCap half{.area = pi / 2, .angle = pi / 2};
  CHECK(half.radius() == Approx(1));
  CHECK(half.height() == Approx(1));
  CHECK(half.width() == Approx(2));
  CHECK(half.centre_of_mass() == Approx(4 / (3 * pi)));
  for (const double degrees : {20.0, 60.0, 90.0, 120.0, 160.0}) {
    CAPTURE(degrees);
    const double angle = degrees * pi / 180;
    const CircularCap cap{.area = 2.5, .angle = angle};
    // Area and its first moment by strips parallel to the plate.
    const double a = cap.radius();
    double area = 0, moment = 0;
    constexpr int strips = 20000;
    for (int k = 0; k < strips; ++k) {
      const double y = (k + 0.5) / strips * cap.height(), up = y + a * std::cos(angle);
      const double strip = 2 * std::sqrt(a * a - up * up) * cap.height() / strips;
      area += strip;
      moment += strip * y;
    }
    CHECK(area == Approx(2.5).epsilon(1e-5));  // the strips' error where the circle is vertical to them
    CHECK(cap.centre_of_mass() == Approx(moment / area).epsilon(1e-5));
    CHECK(angle_of_cap(2.5, cap.centre_of_mass()) == Approx(angle).epsilon(1e-9));
  }
  CHECK_THROWS_AS((CircularCap{.area = 1, .angle = pi}.radius()), std::invalid_argument);
  CHECK_THROWS_AS((CircularCap{.area = -1, .angle = 1}.radius()), std::invalid_argument);
}
