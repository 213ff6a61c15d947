// What names of the code are called where a person reads them, each with its French on the same line.

#include <array>

#include "common/words.hpp"

namespace clapotis {
namespace {

/// With two words it is called in English as in the code; with fewer it does not compile.
struct Name {
  constexpr Name(std::string_view in_code, std::string_view french) : Name(in_code, in_code, french) {}
  constexpr Name(std::string_view in_code, std::string_view english, std::string_view french)
      : code(in_code), words{english, french} {}
  std::string_view code;
  std::array<std::string_view, 2> words;
};

constexpr std::array names_in_lists{
    // quantities that particles are coloured by
    Name{"speed", "vitesse"}, Name{"pressure", "pression"}, Name{"vorticity", "vorticité"},
    Name{"density_error", "density error", "écart de densité"}, Name{"density", "masse volumique"},
    Name{"force", "force"}, Name{"mass", "masse"}, Name{"across", "distance à l'axe"}, Name{"plain", "unie"},
    // what two sides may differ in
    Name{"neighbour_search", "neighbour search", "recherche des voisins"}, Name{"grid", "grille"},
    Name{"list", "liste"}, Name{"integrator", "schéma"},
    // references
    Name{"closed form", "solution analytique"}, Name{"Koshizuka & Oka 1996", "Koshizuka et Oka 1996"},
    Name{"hydrostatic pressure", "pression hydrostatique"}, Name{"exact ellipse", "ellipse exacte"},
    Name{"round drop at rest", "goutte ronde au repos"}, Name{"mode n = 2", "mode n = 2"},
    Name{"circular cap", "calotte circulaire"}, Name{"series solution", "solution en série"},
    Name{"free streamlines", "lignes de courant libres"}, Name{"film on a slope", "film sur un plan incliné"},
    Name{"Torricelli's law", "loi de Torricelli"}, Name{"linear wave", "onde linéaire"},
    Name{"linear sloshing", "ballottement linéaire"},
    // what their errors are of, where it has words in it
    Name{"|front - experiment|/a", "|front - expérience|/a"},
    Name{"|angle - contact angle|", "|angle - angle de contact|"},
    Name{"rms of u - u_exact over U, around the middle",
         "moyenne quadratique de u - u_exact sur U, vers le milieu"},
    // titles of the stages
    Name{"Stage 1 - bouncing", "Étape 1 - rebonds"}, Name{"Stage 2 - cloud", "Étape 2 - nuage"},
    Name{"Stage 3 - grid", "Étape 3 - grille"}, Name{"Stage 4 - SPH", "Étape 4 - SPH"},
    Name{"Stage 5 - extensions", "Étape 5 - extensions"},
    // keys
    Name{"Space", "Espace"}, Name{"PageUp", "PgPréc"}, Name{"PageDown", "PgSuiv"}, Name{"Home", "Début"},
    Name{"Esc", "Échap"},
    // what stands for a value in the help
    Name{"NAME", "NOM"}, Name{"NAME=VALUE", "NOM=VALEUR"}, Name{"FILE", "FICHIER"},
    Name{"FILE.json", "FICHIER.json"}, Name{"FILE.mp4", "FICHIER.mp4"}, Name{"DIR", "DOSSIER"},
    Name{"KIND", "SORTE"},
    // where values come from, and when a change takes effect
    Name{"default", "défaut"}, Name{"scene", "scène"}, Name{"file", "fichier"},
    Name{"environment", "environnement"}, Name{"flag", "option"}, Name{"window", "fenêtre"},
    Name{"derived", "déduit"}, Name{"live", "en marche"}, Name{"restart", "relance"},
    // why the system could not do something with a file
    Name{"No such file or directory", "aucun fichier ni dossier de ce nom"},
    Name{"Permission denied", "accès refusé"}, Name{"Is a directory", "c'est un dossier"},
    Name{"Not a directory", "ce n'est pas un dossier"}, Name{"File exists", "il existe déjà"},
    Name{"File too large", "le fichier est trop grand"},
    Name{"No space left on device", "le disque est plein"},
    Name{"Read-only file system", "le disque est en lecture seule"},
    Name{"Input/output error", "erreur d'entrée-sortie"},
    Name{"Broken pipe", "le destinataire a fermé le tube"}};

constexpr std::array names_of_laws{
    Name{"gravity", "gravity", "poids"},
    Name{"air_drag", "drag", "traînée"},
    Name{"contact_spring", "contact", "contact"},
    Name{"walls", "wall", "paroi"},
    Name{"pressure", "pressure", "pression"},
    Name{"viscosity", "viscosity", "viscosité"},
    Name{"artificial_viscosity", "artificial viscosity", "viscosité artificielle"},
    Name{"laminar_viscosity", "viscosity", "viscosité"},
    Name{"newtonian_viscosity", "viscosity", "viscosité"},
    Name{"implicit_viscosity", "viscosity", "viscosité"},
    Name{"surface_tension", "surface tension", "tension superficielle"},
    Name{"tensile_correction", "tensile correction", "correction de traction"},
    Name{"hand", "hand", "main"},
    Name{"driving_force", "driving force", "force motrice"},
    Name{"tank_motion", "motion of the tank", "mouvement de la cuve"}};

constexpr std::array names_of_limits{Name{"acoustic", "acoustique"},    Name{"contact", "de contact"},
                                     Name{"drag", "de traînée"},        Name{"force", "en force"},
                                     Name{"viscous", "visqueuse"},      Name{"capillary", "capillaire"},
                                     Name{"profile", "d'établissement"}};

constexpr std::array names_of_limits_alone{Name{"acoustic", "acoustique"},  Name{"contact", "contact"},
                                           Name{"drag", "traînée"},         Name{"force", "force"},
                                           Name{"viscous", "visqueuse"},    Name{"capillary", "capillaire"},
                                           Name{"profile", "établissement"}};

constexpr std::array names_of_kinds{Name{"scene", "de scène"},
                                    Name{"preset", "de variante"},
                                    Name{"stage", "d'étape"},
                                    Name{"study", "d'étude"},
                                    Name{"integrator", "de schéma"},
                                    Name{"quantity", "de grandeur"},
                                    Name{"list", "de liste"},
                                    Name{"parameter", "de paramètre"},
                                    Name{"theme", "de thème"},
                                    Name{"neighbour_search", "neighbour search", "de recherche des voisins"}};

template <class Table>
std::string_view look_up(const Table& table, std::string_view name) {
  for (const auto& line : table)
    if (line.code == name) return line.words[static_cast<std::size_t>(language())];
  return name;
}

}  // namespace

std::string_view called(std::string_view name, Naming where) {
  if (where == Naming::law) return look_up(names_of_laws, name);
  if (where == Naming::limit_alone) return look_up(names_of_limits_alone, name);
  if (where == Naming::limit) return look_up(names_of_limits, name);
  return where == Naming::kind ? look_up(names_of_kinds, name) : look_up(names_in_lists, name);
}

}  // namespace clapotis
