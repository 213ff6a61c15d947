#pragma once

namespace clapotis {

/// A plane jet of width d and speed U, without weight, that meets a plate squarely and flows off along it to
/// either side (free-streamline theory; Milne-Thomson, Theoretical Hydrodynamics, section 11.42; Batchelor
/// 1967, section 6.2). Along the plate the speed s U grows from 0 in the middle, where
///   x/d = (2/pi) (atan s + artanh s),   p = rho U^2/2 (1 - s^2);
/// the force on the plate is rho U^2 d, and the sheet thins to d/2 on either side. On the free surface the
/// velocity is U exp(i theta), and z/d = (2/pi) (atan + artanh) of its conjugate over U, so that
///   sinh(pi (x/d - 1/2)) sinh(pi (y/d - 1/2)) = 1.
struct ImpingingJet {
  double width;    ///< d [m], > 0
  double speed;    ///< U [m/s], > 0
  double density;  ///< rho [kg/m^3], > 0

  /// At a distance x from the middle of the plate [Pa]. Throws std::invalid_argument if a parameter is out of
  /// the range given here.
  [[nodiscard]] double pressure(double x) const;
  /// y of the free surface at a distance x > d/2 from the middle [m]; the same for x at y.
  [[nodiscard]] double surface(double x) const;
  /// Per unit of depth [N/m].
  [[nodiscard]] double force() const { return density * speed * speed * width; }
};

}  // namespace clapotis
