#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "common/runner/canvas.hpp"
#include "common/runner/colour_map.hpp"
#include "common/runner/inside.hpp"
#include "common/simulation/shape.hpp"

namespace clapotis {

/// What the colours of the discs mean: `lo` has the map's first colour, `hi` its last.
struct ColourScale {
  std::string label;  ///< "|v|"
  std::string unit;   ///< "px/s"; empty for a pure number
  double lo = 0, hi = 1;
  ColourMap map = ColourMap::viridis;
};

/// Which sides of the domain are solid.
struct SolidSides {
  bool left = false, right = false, bottom = false, top = false;
};

/// What the reference solution has, over what the run has.
struct Ghosts {
  Eigen::ArrayXd x, y;  ///< [length unit]
  std::string label;    ///< "closed form"
  Shape shape = Shape::particles;
  std::vector<std::string> labels = {};             ///< of the marks, one for each point
  Eigen::ArrayXd measured_x = {}, measured_y = {};  ///< what the run has in place of its lines
  std::string measured_label = {};
};

/// What is to be seen, apart from how a simulation found it: plain data in the scene's unit of length, y up.
/// The words come from the caller, in the caller's language.
struct Picture {
  std::string title;                        ///< "Stage 2 - Cloud"
  std::string subtitle;                     ///< "t = 1.234 s   dt = 2.0e-4 s   N = 500"
  Eigen::Array2d lower{0, 0}, upper{1, 1};  ///< corners of the domain [length unit]
  std::string length_unit;                  ///< "px", "m"
  SolidSides walls;
  Eigen::ArrayXd x, y;  ///< one per particle [length unit]; a particle at NaN or infinity is not painted
  double radius = 0;    ///< of every particle and ghost [length unit]
  bool liquid = false;  ///< whether the particles are one liquid: drawn without gaps while they are small
  Eigen::ArrayXd solid_x, solid_y;  ///< particles of walls, as large as the others [length unit]
  Eigen::ArrayXd value;  ///< one per particle [colours.unit], or empty: one calm colour and no legend
  ColourScale colours;
  std::optional<Ghosts> ghosts;
  std::optional<double>
      cell;  ///< side of the square cells of the neighbour search, at multiples of it [length unit]
  std::optional<Chosen> chosen;
  std::string note;  ///< how far the run is from its reference: "|y - y_exact| = 1.2e-6 m"
  // of one of two that stand side by side
  bool legend = true;          ///< of its colours; otherwise one stands above both
  std::optional<Colour> mark;  ///< beside its title: the colour of its curves in the plots
  std::string alarm;           ///< over the scene: why the run stopped
};

/// From the world to the canvas: which piece of the world is seen where.
struct PictureView {
  Box area;          ///< the whole picture: title and legend, then the scene, then ruler and note [pixel]
  Box scene;         ///< its middle part, the only one that shows the world [pixel]
  double scale = 1;  ///< of texts and lines; 1 suits 1280 x 720
  Eigen::Vector2d centre{0, 0};  ///< the point of the world in the middle of the scene [length unit]
  double pixels_per_unit = 1;    ///< the same along x and y

  [[nodiscard]] Point to_pixel(double x, double y) const;
  [[nodiscard]] Eigen::Vector2d to_world(Point pixel) const;
  [[nodiscard]] bool shows(Point pixel) const;  ///< whether it is one of the scene
};

/// Where the domain of the picture is [pixel].
[[nodiscard]] Box domain(const Picture& picture, const PictureView& view);

/// The view that shows the whole domain and its walls, as large as `area` allows.
[[nodiscard]] PictureView fit(const Picture& picture, const Box& area, double scale = 1);

/// Paints pictures; keeps its lists from one to the next, so that a window allocates nothing per frame.
class Painter {
 public:
  /// Fills `view.area`. All particles are one call of `Canvas::discs`, the first of the picture.
  /// Throws std::invalid_argument when x, y, value, ghosts or chosen do not have matching sizes.
  void paint(Canvas& canvas, const Picture& picture, const PictureView& view);

 private:
  void paint_scene(Canvas& canvas, const Picture& picture, const PictureView& view);
  void paint_cells(Canvas& canvas, const Picture& picture, const PictureView& view);
  void paint_particles(Canvas& canvas, const Picture& picture, const PictureView& view);
  void paint_solids(Canvas& canvas, const Picture& picture, const PictureView& view);
  void paint_marks(Canvas& canvas, const Picture& picture, const PictureView& view);
  static void paint_alarm(Canvas& canvas, const Picture& picture, const PictureView& view);

  std::vector<Disc> discs_;
  std::vector<Point> points_;
};

}  // namespace clapotis
