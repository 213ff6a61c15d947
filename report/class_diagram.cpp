// The diagram of the core's classes in the report. It cannot go stale: a box is a type, whose name the
// compiler gives, and an arrow is an expression that must compile. What is renamed is renamed here or does
// not compile; a relation that is gone does not compile either. Of calls it is seen only that they are
// possible.
//
//   class_diagram FILE.pdf

#include <cxxabi.h>

#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <typeindex>
#include <typeinfo>
#include <utility>
#include <vector>

#include "common/integrators/bogacki_shampine.hpp"
#include "common/integrators/explicit_euler.hpp"
#include "common/integrators/rk2.hpp"
#include "common/integrators/rk4.hpp"
#include "common/integrators/symplectic_euler.hpp"
#include "common/integrators/velocity_verlet.hpp"
#include "common/kernels/cubic_spline.hpp"
#include "common/kernels/wendland_c2.hpp"
#include "common/laws/surface_tension.hpp"
#include "common/runner/cairo_canvas.hpp"
#include "common/runner/compare.hpp"
#include "common/runner/comparison.hpp"
#include "common/runner/describe.hpp"
#include "common/runner/headless.hpp"
#include "common/runner/run_outputs.hpp"
#include "common/window/session.hpp"
#include "common/window/sfml_canvas.hpp"
#include "common/window/window.hpp"
#include "report/class_picture.hpp"
#include "stage2_cloud/cloud.hpp"
#include "stage4_sph/models.hpp"
#include "stage4_sph/scenes.hpp"

namespace clapotis {
namespace {

// ---- Types: the boxes ----

/// Stands for a free function.
template <auto function>
struct Function {};
using RunStage = Function<run_stage>;
using RunHeadless = Function<run_headless>;
using RunCompare = Function<run_compare>;

/// Stands for what is in the main.cpp of each stage.
struct main {};

using Discs = stage2::CloudModel<CellGrid>;
using DiscsByList = stage2::CloudModel<AllPairs>;
using Liquid = FluidModel<WendlandC2, Gravity, PressureForce, ArtificialViscosity, LaminarViscosity,
                          SurfaceTension, TankWalls, AcousticStep, ForceStep>;
using LiquidOfSplines = FluidModel<CubicSpline, Gravity, PressureForce, TankWalls>;

/// What a model is made of.
template <class Model>
struct PartsOf;
template <class S, class Mass, class... L>
struct PartsOf<FusedModel<S, Mass, L...>> {
  using Part = S;
  using Laws = std::tuple<L...>;
};
template <class K, class... L>
struct PartsOf<FluidModel<K, L...>> {
  using Part = K;
  using Laws = std::tuple<L...>;
};

/// "FusedModel" for clapotis::FusedModel<...>, "run_stage" for Function<run_stage>.
template <class T>
std::string name_of() {
  const std::unique_ptr<char, void (*)(void*)> text(
      abi::__cxa_demangle(typeid(T).name(), nullptr, nullptr, nullptr), std::free);
  std::string name = text.get();
  const std::string hidden = "(anonymous namespace)::", function = "Function<&";
  if (const auto at = name.find(hidden); at != std::string::npos) name.erase(at, hidden.size());
  if (const auto at = name.find(function); at != std::string::npos) {
    name.erase(0, name.find_first_not_of('(', at + function.size()));
    name = name.substr(0, name.find_first_of("(>")) + "()";
  }
  name.erase(std::min(name.find('<'), name.size()));
  return name.substr(name.rfind(':') + 1);
}

/// T without what it comes in: references, pointers, containers.
template <class T>
struct Bare {
  using Type = T;
};
template <class T>
using BareOf = typename Bare<std::remove_cvref_t<std::remove_pointer_t<std::remove_cvref_t<T>>>>::Type;
template <class T>
requires requires { typename T::element_type; }
struct Bare<T> : Bare<BareOf<typename T::element_type>> {};
template <class T>
requires requires { typename T::value_type; }
struct Bare<T> : Bare<BareOf<typename T::value_type>> {};

// ---- Expressions: the arrows ----

/// The expression says how one gets the result from the argument: a member, an accessor, a function.
template <class From, class To>
Arrow gives(To (*)(From)) {
  return {typeid(BareOf<From>), typeid(BareOf<To>), Kind::gives};
}
/// The expression hands the second argument to the first.
template <class To, class Given>
Arrow takes(void (*)(To, Given)) {
  return {typeid(BareOf<To>), typeid(BareOf<Given>), Kind::takes};
}
/// The expression calls, or builds, the callee with what the caller has.
template <class Caller, class Callee>
Arrow calls(auto /*expression*/) {
  return {typeid(Caller), typeid(Callee), Kind::gives};
}
template <class Derived, class Base>
requires std::derived_from<Derived, Base> Arrow derives() {
  return {typeid(Derived), typeid(Base), Kind::derives};
}
/// The part is one of the arguments of the model's template.
template <class Model, class Part>
requires std::same_as<Part, typename PartsOf<Model>::Part> Arrow made_of() {
  return {typeid(Model), typeid(Part), Kind::gives};
}

std::vector<Arrow> arrows_of_runner() {
  return {
      calls<main, RunStage>([](int argc, const char* const* argv) {
        return run_stage(stage4::stage(), argc, argv, window_door());
      }),
      calls<RunStage, RunHeadless>([](const Stage& stage, int argc, const char* const* argv) {
        return run_headless(stage, read_command_line(stage, argc, argv).options);
      }),
      calls<RunStage, Session>([](const Stage& stage, const Options& options) { Session(stage, options); }),
      calls<RunHeadless, RunOutputs>([](const Stage& stage, const Options& options, Simulation& simulation) {
        RunOutputs(stage, options, simulation, 1.0);
      }),
      calls<RunCompare, Comparison>([](Side& left, Side& right) { Comparison(left, right, 1.0, 0.1); }),
      takes(+[](RunStage, const Stage& stage) { run_stage(stage, 0, nullptr); }),
      takes(+[](RunHeadless, const Stage& stage) { run_headless(stage, Options{}); }),
      gives(+[](RunStage) { return read_command_line(Stage{}, 0, nullptr).options; }),
      takes(+[](Session& session, const Options& options) { session.begin(options); }),
      gives(+[](Session& session) { return session.sides(); }),
      gives(+[](Session & session) -> auto& { return session.simulation(); }),
      gives(+[](SideBySide & sides) -> auto& { return sides.comparison(); }),
      takes(+[](Comparison& comparison, Side& side) { comparison = Comparison(side, side, 1.0, 0.1); }),
      gives(+[](Side& side) { return side.simulation; }),
      takes(+[](RunOutputs& outputs, Simulation& simulation) {
        std::construct_at(&outputs, Stage{}, Options{}, simulation, 1.0);
      }),
      gives(+[](Simulation& simulation) { return describe("", simulation); }),
      takes(+[](Painter& painter, const Picture& picture) {
        CairoCanvas canvas({1, 1});
        painter.paint(canvas, picture, PictureView{});
      }),
      takes(+[](Painter& painter, Canvas& canvas) { painter.paint(canvas, Picture{}, PictureView{}); }),
      derives<CairoCanvas, Canvas>(),
      derives<SfmlCanvas, Canvas>(),
  };
}

std::vector<Arrow> arrows_of_simulation() {
  return {
      gives(+[](Stage & stage) -> auto& { return stage.scenes; }),
      takes(+[](Scene& scene, Parameters& parameters) { scene.build(parameters); }),
      takes(+[](Simulation& simulation, const Scene& scene) { std::construct_at(&simulation, scene); }),
      gives(+[](Simulation & simulation) -> auto& { return simulation.parameters(); }),
      gives(+[](Simulation & simulation) -> auto& { return simulation.setup(); }),
      gives(+[](Simulation & simulation) -> auto& { return simulation.system(); }),
      gives(+[](Simulation& simulation) { return simulation.energy(); }),
      gives(+[](Simulation& simulation) {
        return make_integrator(simulation.integrator(), simulation.setup().matter());
      }),
      gives(+[](Setup & setup) -> auto& { return setup.reference; }),
      gives(+[](Setup & setup) -> auto& { return setup.model; }),
      gives(+[](System & system) -> auto& { return system.model; }),
      gives(+[](System & system) -> auto& { return system.particles; }),
      takes(+[](Integrator& integrator, System& system) { integrator.step(system, 0.1); }),
      derives<ExplicitEuler, Integrator>(),
      derives<SymplecticEuler, Integrator>(),
      derives<VelocityVerlet, Integrator>(),
      derives<Rk2, Integrator>(),
      derives<Rk4, Integrator>(),
      derives<BogackiShampine, Integrator>(),
      derives<Discs, Model>(),
      derives<Liquid, Model>(),
      made_of<Discs, CellGrid>(),
      made_of<DiscsByList, AllPairs>(),
      made_of<Liquid, WendlandC2>(),
      made_of<LiquidOfSplines, CubicSpline>(),
      gives(+[](Liquid & liquid) -> auto& { return liquid.wall_particles()->grid; }),
  };
}

// ---- Laws: which hooks each has ----

template <Law L>
LawLine law_line() {
  std::string hooks;
  const auto add = [&](bool has, const char* hook) {
    if (has) hooks += (hooks.empty() ? "" : ", ") + std::string(hook);
  };
  add(ActsAsField<L>, "field");
  add(ActsOnBody<L>, "body");
  add(ActsOnPair<L>, "pair");
  add(ActsByStress<L>, "stress");
  add(ActsByFriction<L>, "friction");
  add(StressesWalls<L>, "wall_stress");
  add(RubsWalls<L>, "wall_friction");
  add(Settles<L>, "settle");
  add(StoresPotential<L>, "potential");
  add(StoresPairPotential<L>, "pair_potential");
  add(StoresBetweenParticles<L>, "pair_energy");
  add(Dissipates<L>, "dissipation");
  add(LimitsStep<L>, "limit");
  return {name_of<L>(), hooks};
}

template <class... L>
std::vector<LawLine> law_lines(std::type_identity<std::tuple<L...>>) {
  return {law_line<L>()...};
}
template <class Model>
std::vector<LawLine> laws_of() {
  return law_lines(std::type_identity<typename PartsOf<Model>::Laws>{});
}

// ---- Places ----

double column(double number) { return 2 + 76.8 * number; }
double line_of(double number) { return 3 + 27 * number; }

template <class... Types>
Place place(double at_column, double at_line, double width = place_width) {
  std::vector<std::string> names;
  for (auto& name : {name_of<Types>()...})
    if (names.empty() || names.back() != name) names.push_back(name);
  const double height = 6.5 + line_height * static_cast<double>(names.size());
  return {{{column(at_column), line_of(at_line)}, {width, height}}, std::move(names), {typeid(Types)...}};
}

/// Programs above, what they show and write at the right, below the simulation what it is made of.
std::vector<Place> places() {
  return {place<main>(0, 0),
          place<RunStage>(1, 0),
          place<Options>(2, 0),
          place<RunCompare>(4, 0),
          place<SfmlCanvas, CairoCanvas>(5, 0),
          place<Stage>(0, 1.1),
          place<RunHeadless>(1, 1.1),
          place<Session>(2, 1.1),
          place<SideBySide>(3, 1.1),
          place<Comparison>(4, 1.1),
          place<Canvas>(5, 1.45),
          place<Scene>(0, 2.2),
          place<RunOutputs>(1, 2.2),
          place<Side>(3, 2.2),
          place<Picture>(4, 2.55),
          place<Painter>(5, 2.55),
          place<Parameters>(0, 3.6),
          place<Simulation>(1, 3.6, column(4) - column(1) + place_width),
          place<Reference>(0, 4.8),
          place<Setup>(1, 4.8),
          place<System>(2, 4.8),
          place<Integrator>(3, 4.8),
          place<Energy>(5, 3.6),
          place<Model>(1, 6),
          place<Particles>(2, 6),
          place<ExplicitEuler, SymplecticEuler, VelocityVerlet, Rk2, Rk4, BogackiShampine>(3, 6),
          place<Discs, DiscsByList>(0, 7.2),
          place<Liquid, LiquidOfSplines>(1.65, 7.2),
          place<AllPairs>(0, 8.4),
          place<CellGrid>(1, 8.4),
          place<WendlandC2, CubicSpline>(2, 8.4)};
}

void paint_diagram(Canvas& canvas) {
  auto arrows = arrows_of_runner();
  const auto inner = arrows_of_simulation();
  arrows.insert(arrows.end(), inner.begin(), inner.end());
  paint_boxes(canvas, places(), arrows);
  const double end =
      paint_laws(canvas, {column(4), line_of(4.85)}, "Laws of a " + name_of<Discs>(), laws_of<Discs>());
  paint_laws(canvas, {column(4), end + 5}, "Laws of a " + name_of<Liquid>(), laws_of<Liquid>());
  paint_key(canvas, column(0));
}

}  // namespace

/// Returns the exit code.
static int draw_classes(const std::filesystem::path& file) {
  try {
    CairoCanvas canvas(file, sheet_size);
    paint_diagram(canvas);
    canvas.save();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "class_diagram: %s\n", error.what());
    return 4;
  }
  return 0;
}

}  // namespace clapotis

int main(int argc, char** argv) {
  if (argc == 2) return clapotis::draw_classes(argv[1]);
  std::fputs("usage: class_diagram FILE.pdf\n", stderr);
  return 2;
}
