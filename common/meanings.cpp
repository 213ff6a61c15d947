#include <array>

#include "common/words.hpp"

namespace clapotis {
namespace {

/// Made of all three, or not at all.
struct Meaning {
  constexpr Meaning(std::string_view of, std::string_view english, std::string_view french)
      : name(of), words{english, french} {}
  std::string_view name;
  std::array<std::string_view, 2> words;
};

constexpr std::array meanings{
    Meaning{"mass", "mass of a particle", "masse d'une particule"},
    Meaning{"radius", "radius of a particle, or of a drop", "rayon d'une particule, ou d'une goutte"},
    Meaning{"gravity", "weight per unit of mass", "poids par unité de masse"},
    Meaning{"drag", "friction of the air", "frottement de l'air"},
    Meaning{"restitution", "share of the normal speed kept by a wall",
            "part de la vitesse normale que rend une paroi"},
    Meaning{"width", "width of the box", "largeur de la boîte"},
    Meaning{"height", "height of the box", "hauteur de la boîte"},
    Meaning{"x0", "initial abscissa", "abscisse initiale"},
    Meaning{"y0", "initial height", "hauteur initiale"},
    Meaning{"vx0", "initial velocity along x", "vitesse initiale selon x"},
    Meaning{"vy0", "initial velocity along y", "vitesse initiale selon y"},
    Meaning{"dt", "time step", "pas de temps"},
    Meaning{"cfl", "share of h/c that a step takes", "part de h/c que prend un pas"},
    Meaning{"impacts", "impacts located inside the step, or clamped after it",
            "chocs situés à l'intérieur du pas, ou position rabattue après lui"},
    Meaning{"particles", "number of particles", "nombre de particules"},
    Meaning{"stiffness", "stiffness of a contact", "raideur d'un contact"},
    Meaning{"seed", "seed of the random placement", "graine du tirage au sort des positions"},
    Meaning{"mass_ratio", "mass of the second disc over that of the first",
            "masse du second disque sur celle du premier"},
    Meaning{"tank_width", "width of the tank", "largeur de la cuve"},
    Meaning{"tank_height", "height of the tank's walls", "hauteur des parois de la cuve"},
    Meaning{"column_width", "width of the column of water", "largeur de la colonne d'eau"},
    Meaning{"column_height", "height of the column of water", "hauteur de la colonne d'eau"},
    Meaning{"depth", "depth of the water at rest", "profondeur de l'eau au repos"},
    Meaning{"plate_speed", "speed of the upper plate", "vitesse de la plaque du haut"},
    Meaning{"length", "length of the channel, or of the slope", "longueur du canal, ou du plan incliné"},
    Meaning{"driving", "acceleration that drives the liquid", "accélération qui entraîne le liquide"},
    Meaning{"side", "side of the square", "côté du carré"},
    Meaning{"strain_rate", "rate at which the drop is stretched at the start",
            "taux d'étirement de la goutte au départ"},
    Meaning{"angular_speed", "rate at which the square turns at the start",
            "vitesse de rotation du carré au départ"},
    Meaning{"impact_speed", "speed of the drop at the start", "vitesse de la goutte au départ"},
    Meaning{"drop_height", "height of the drop above the water", "hauteur de la goutte au-dessus de l'eau"},
    Meaning{"disturbance", "greatest random displacement, in spacings",
            "plus grand déplacement aléatoire, en espacements"},
    Meaning{"formulation", "the handout's equations, or consistent ones",
            "les équations de l'énoncé, ou des équations cohérentes"},
    Meaning{"spacing", "distance between particles at the start", "distance entre particules au départ"},
    Meaning{"h_over_dx", "smoothing length over spacing", "longueur de lissage sur espacement"},
    Meaning{"kernel", "smoothing kernel", "noyau de lissage"},
    Meaning{"density", "density from continuity, or as a sum",
            "masse volumique par continuité, ou par somme"},
    Meaning{"walls", "walls of particles, or planes that reflect",
            "parois de particules, ou plans qui réfléchissent"},
    Meaning{"reference_density", "density without pressure", "masse volumique sans pression"},
    Meaning{"sound_speed", "speed of sound; 10 times the fastest flow unless given",
            "vitesse du son ; sauf indication, 10 fois la plus grande vitesse"},
    Meaning{"gamma", "exponent of the Cole equation", "exposant de l'équation de Cole"},
    Meaning{"tension", "whether negative pressure is kept", "si la pression négative est gardée"},
    Meaning{"smoothing_length", "smoothing length", "longueur de lissage"},
    Meaning{"particle_mass", "mass of a particle", "masse d'une particule"},
    Meaning{"alpha", "artificial viscosity", "viscosité artificielle"},
    Meaning{"tolerance", "error that a step of bogacki_shampine may make",
            "erreur permise à un pas de bogacki_shampine"},
    Meaning{"probe_x", "where the height of the water is measured", "où l'on mesure la hauteur de l'eau"},
    Meaning{"probe_y", "heights at which the pressure on the walls is measured",
            "hauteurs où l'on mesure la pression sur les parois"},
    Meaning{"angle", "the tank rolls to twice this angle and back",
            "la cuve roule jusqu'à deux fois cet angle, et revient"},
    Meaning{"amplitude", "the wave's, or half of the way that the tank sways",
            "celle de l'onde, ou la moitié du trajet de la cuve"},
    Meaning{"period", "of the tank's motion", "du mouvement de la cuve"},
    Meaning{"nu", "kinematic viscosity", "viscosité cinématique"},
    Meaning{"sigma", "surface tension", "tension superficielle"},
    Meaning{"contact_angle", "angle at which the surface meets the plate",
            "angle de la surface avec la plaque"},
    Meaning{"shape", "shape of the drop at the start", "forme de la goutte au départ"},
    Meaning{"deformation", "how much longer than round at the start, ln(a/R)",
            "allongement de la goutte au départ, ln(a/R)"},
    Meaning{"slip", "whether the liquid slips along walls", "si le liquide glisse le long des parois"},
    Meaning{"delta", "diffusion of density", "diffusion de la masse volumique"},
    Meaning{"epsilon", "repulsion under tension", "répulsion sous tension"},
    Meaning{"hand_strength", "acceleration that the hand gives", "accélération que donne la main"},
    Meaning{"hand_reach", "how far the hand reaches", "portée de la main"},
    Meaning{"jet_width", "width of the jet", "largeur du jet"},
    Meaning{"jet_speed", "speed of the jet", "vitesse du jet"},
    Meaning{"jet_height", "height of the nozzle above the plate",
            "hauteur de la buse au-dessus de la plaque"},
    Meaning{"plate_width", "width of the plate", "largeur de la plaque"},
    Meaning{"slot_width", "width of the slot in the floor", "largeur de la fente dans le fond"},
    Meaning{"viscosity_form", "viscosity as printed, or Monaghan's",
            "viscosité telle qu'imprimée, ou de Monaghan"},
    Meaning{"signs", "sign of the pair's unit vector, as printed or consistent",
            "sens du vecteur unitaire d'une paire, tel qu'imprimé ou cohérent"},
    Meaning{"viscous_step", "friction with the velocities before the step, or after it",
            "frottement d'après les vitesses d'avant le pas, ou d'après lui"},
    Meaning{"viscous_tolerance", "residual of the implicit step, over the velocities",
            "résidu du pas implicite, rapporté aux vitesses"},
    Meaning{"thread_width", "width of the thread", "largeur du filet"},
    Meaning{"thread_length", "length of the thread, all in the nozzle at the start",
            "longueur du filet, tout dans la buse au départ"},
    Meaning{"thread_speed", "speed of the thread in the nozzle", "vitesse du filet dans la buse"},
    Meaning{"fall_height", "height of the nozzle above the dish",
            "hauteur de la buse au-dessus de l'assiette"},
    Meaning{"columns", "particles across the block", "particules en largeur du bloc"},
    Meaning{"lines", "particles up the block", "particules en hauteur du bloc"}};

}  // namespace

std::string_view meaning(std::string_view name) {
  for (const auto& line : meanings)
    if (line.name == name) return line.words[static_cast<std::size_t>(language())];
  return name;
}

}  // namespace clapotis
