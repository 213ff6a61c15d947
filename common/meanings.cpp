#include <map>

#include "common/words.hpp"

namespace clapotis {
namespace {

const std::map<std::string_view, std::string_view>& meanings() {
  static const std::map<std::string_view, std::string_view> table{
      {"mass", "mass of a particle"},
      {"radius", "radius of a particle, or of a drop"},
      {"gravity", "weight per unit of mass"},
      {"drag", "friction of the air"},
      {"restitution", "share of the normal speed kept by a wall"},
      {"width", "width of the box"},
      {"height", "height of the box"},
      {"x0", "initial abscissa"},
      {"y0", "initial height"},
      {"vx0", "initial velocity along x"},
      {"vy0", "initial velocity along y"},
      {"dt", "time step"},
      {"cfl", "share of h/c that a step takes"},
      {"impacts", "impacts located inside the step, or clamped after it"},
      {"particles", "number of particles"},
      {"stiffness", "stiffness of a contact"},
      {"seed", "seed of the random placement"},
      {"mass_ratio", "mass of the second disc over that of the first"},
      {"tank_width", "width of the tank"},
      {"tank_height", "height of the tank's walls"},
      {"column_width", "width of the column of water"},
      {"column_height", "height of the column of water"},
      {"depth", "depth of the water at rest"},
      {"side", "side of the square"},
      {"strain_rate", "rate at which the drop is stretched at the start"},
      {"angular_speed", "rate at which the square turns at the start"},
      {"impact_speed", "speed of the drop at the start"},
      {"drop_height", "height of the drop above the water"},
      {"disturbance", "greatest random displacement, in spacings"},
      {"formulation", "the handout's equations, or consistent ones"},
      {"spacing", "distance between particles at the start"},
      {"h_over_dx", "smoothing length over spacing"},
      {"kernel", "smoothing kernel"},
      {"density", "density from continuity, or as a sum"},
      {"walls", "walls of particles, or planes that reflect"},
      {"reference_density", "density without pressure"},
      {"sound_speed", "speed of sound; 10 times the fastest flow unless given"},
      {"gamma", "exponent of the Cole equation"},
      {"tension", "whether negative pressure is kept"},
      {"smoothing_length", "smoothing length"},
      {"particle_mass", "mass of a particle"},
      {"alpha", "artificial viscosity"},
      {"tolerance", "error that a step of bogacki_shampine may make"},
      {"probe_x", "where the height of the water is measured"},
      {"probe_y", "heights at which the pressure on the walls is measured"},
      {"angle", "the tank rolls to twice this angle and back"},
      {"amplitude", "the wave's, or half of the way that the tank sways"},
      {"period", "of the tank's motion"},
      {"nu", "kinematic viscosity"},
      {"sigma", "surface tension"},
      {"contact_angle", "angle at which the surface meets the plate"},
      {"shape", "shape of the drop at the start"},
      {"deformation", "how much longer than round at the start, ln(a/R)"},
      {"slip", "whether the liquid slips along walls"},
      {"delta", "diffusion of density"},
      {"epsilon", "repulsion under tension"},
      {"hand_strength", "acceleration that the hand gives"},
      {"hand_reach", "how far the hand reaches"},
      {"jet_width", "width of the jet"},
      {"jet_speed", "speed of the jet"},
      {"jet_height", "height of the nozzle above the plate"},
      {"plate_width", "width of the plate"},
      {"slot_width", "width of the slot in the floor"},
      {"viscosity_form", "viscosity as printed, or Monaghan's"},
      {"signs", "sign of the pair's unit vector, as printed or consistent"},
      {"viscous_step", "friction with the velocities before the step, or after it"},
      {"viscous_tolerance", "residual of the implicit step, over the velocities"},
      {"thread_width", "width of the thread"},
      {"thread_length", "length of the thread, all in the nozzle at the start"},
      {"thread_speed", "speed of the thread in the nozzle"},
      {"fall_height", "height of the nozzle above the dish"},
      {"columns", "particles across the block"},
      {"lines", "particles up the block"},
  };
  return table;
}

}  // namespace

std::string_view meaning(std::string_view name) {
  const auto found = meanings().find(name);
  return found == meanings().end() ? name : found->second;
}

}  // namespace clapotis
