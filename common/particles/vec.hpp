#pragma once

#include <cmath>

namespace clapotis {

/// A vector of the plane; T is one number, or a pack of numbers for as many particles.
template <class T>
struct Vec {
  T x, y;

  friend Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y}; }
  friend Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y}; }
  friend Vec operator-(const Vec& a) { return {-a.x, -a.y}; }
  friend Vec operator*(const T& s, const Vec& a) { return {s * a.x, s * a.y}; }
  Vec& operator+=(const Vec& b) { return *this = *this + b; }
  bool operator==(const Vec&) const = default;
};

template <class T>
Vec(T, T) -> Vec<T>;

using Vector = Vec<double>;

struct Corners {
  Vector low{0, 0}, high{0, 0};  ///< lower left, upper right
};

template <class T>
T dot(const Vec<T>& a, const Vec<T>& b) {
  return a.x * b.x + a.y * b.y;
}

inline double norm(const Vector& a) { return std::hypot(a.x, a.y); }

}  // namespace clapotis
