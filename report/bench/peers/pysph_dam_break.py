#!/usr/bin/python3 -Es
"""PySPH's own example of the dam break, measured: what it costs and what it finds. `./lab bench --peer pysph` runs it.

pysph.examples.dam_break_2d as Debian ships it: WCSPH, Wendland C2 in the plane with h = 1.3 dx, alpha = 0.1,
c0 = 62.6 m/s, adaptive dt, double, one thread. Only the particles are made here. The example's --dx changes the spacing
but leaves h and the mass of its 0.03 m, and its column is a row and a column of particles larger than 1 m x 2 m; its
tank is 4 m high, here 3 m, which no water reaches while anything is measured.

An update is one particle of the fluid given its density rate, pressure and acceleration once. PySPH predicts with the
accelerations of the step before, evaluates, then corrects: one evaluation per step. Walls and the one evaluation before
the first step count as no update. The clock, CPU time of the process, starts after that evaluation, so neither start-up
nor PySPH's compiling counts. What PySPH compiles goes to a temporary folder, with the flags of Debian's Python (-O2)
unless the environment has CFLAGS.
"""
import argparse
import contextlib
import json
import math
import os
import signal
import sys
import tempfile
import time

WORDS = {
    "usage": "%(prog)s [--dx DX] [--until S | --steps N] [--json [FILE]]",
    "dx": "spacing of the particles in m, a whole fraction of 1 m (default: 0.01, 20,000 particles)",
    "until": "simulated seconds (default: 0.7; T = 3, where the energy is read, is 0.677 s)",
    "steps": "time steps instead, at least 1",
    "json": "write JSON to FILE as well; without FILE print it instead of the table",
    "bad_dx": "%s m is not a whole fraction, 1/4 to 1/1000, of the column's 1 m. The nearest is %.10g.",
    "bad_until": "%s is not a finite number of seconds above 0.",
    "bad_steps": "%s is not a whole number of at least 1.",
    "missing": "PySPH is not there (%s): ./lab bench --peer pysph installs it.",
    "compiling": "PySPH compiles its equations (about half a minute) ...",
    "progress": "t = %.4f s, step %d, %.0f s of CPU time",
    "diverged": "PySPH's run diverged: its energy is no number at t = %g s.",
    "unwritable": "Cannot write to %s: %s.",
    "seconds": "%.1f s",
    "of_the_start": "%.4f of the start",
    "kept": "  kept in               %s",
    "table": """\
PySPH {version}, dam break 1 m x 2 m, dx = {dx:g} m, one thread, double
  particles             {fluid_particles} of fluid, {boundary_particles} of wall, {neighbours:.1f} neighbours each
  steps                 {steps}, {force_evaluations} force evaluations, {simulated_seconds:.4g} s
  dt                    {dt[median]:.3g} s (from {dt[least]:.3g} to {dt[largest]:.3g})
  CPU time              {cpu_seconds:.1f} s
  updates               {updates_per_second:.3g} particles of fluid per second
  CPU per simulated s   {cost}
  energy at T = 3       {energy}
  front x/a at T =      {T}
    foremost particle   {foremost}
    end of the wet bed  {wet_bed}""",
}


def stop(status, words, *values):
    print(WORDS[words] % values, file=sys.stderr)
    sys.exit(status)


try:
    import numpy as np
    import pysph
    from cyarray.api import UIntArray
    from pysph.base.utils import get_particle_array
    from pysph.examples.dam_break_2d import DamBreak2D
except ImportError as missing:
    stop(69, "missing", missing)

A = 1.0              # width of the column [m]; it is 2 a high
TANK = (4.0, 3.0)    # [m]
WALL_LAYERS = 4      # as in the example
RHO = 1000.0         # [kg/m^3]
G = 9.81             # [m/s^2]
TIME_UNIT = math.sqrt(A / (2 * G))   # T = t/TIME_UNIT
FRONT_AT = (0.83, 1.45, 2.07, 2.69)  # T
ENERGY_AT = 3.0                      # T


def number(text):
    try:
        return float(text)
    except ValueError:
        return math.nan


def fraction_of_the_column(text):
    dx = number(text)
    across = min(max(round(A / dx), 4), 1000) if 0 < dx < math.inf else 4
    if not abs(across * dx - A) < 1e-6:
        raise argparse.ArgumentTypeError(WORDS["bad_dx"] % (text, A / across))
    return A / across


def seconds(text):
    if not 0 < number(text) < math.inf:
        raise argparse.ArgumentTypeError(WORDS["bad_until"] % text)
    return number(text)


def count(text):
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(WORDS["bad_steps"] % text)
    return int(text)


def read_options():
    parser = argparse.ArgumentParser(usage=WORDS["usage"], description=__doc__.splitlines()[0], allow_abbrev=False)
    parser.add_argument("--dx", type=fraction_of_the_column, default=0.01, help=WORDS["dx"])
    end = parser.add_mutually_exclusive_group()
    end.add_argument("--until", type=seconds, default=0.7, help=WORDS["until"])
    end.add_argument("--steps", type=count, help=WORDS["steps"])
    parser.add_argument("--json", nargs="?", const="-", metavar="FILE", help=WORDS["json"])
    return parser.parse_args()


def end_of_the_wet_bed(x, y, dx):
    """Where, along the particles less than 4 dx above the bed, the first gap of more than 3 dx begins: drops that fly
    ahead do not count. [m]"""
    wet = np.sort(x[y < 4 * dx])
    gaps = np.flatnonzero(np.diff(wet) > 3 * dx)
    return wet[gaps[0] if gaps.size else -1]


class DamBreak(DamBreak2D):
    """The example with particles that fit their spacing, and a look at them before each step."""

    def create_particles(self):
        across, width, height = (round(length / self.dx) for length in (A, *TANK))
        row, line = np.mgrid[-WALL_LAYERS:width + WALL_LAYERS, -WALL_LAYERS:height]
        wall = (row < 0) | (row >= width) | (line < 0)
        column = ~wall & (row < across) & (line < 2 * across)
        self.fluid, self.boundary = (
            get_particle_array(name=name, x=(row[where] + 0.5) * self.dx, y=(line[where] + 0.5) * self.dx,
                               h=self.h, m=RHO * self.dx**2, rho=RHO)
            for name, where in (("fluid", column), ("boundary", wall)))
        self.scheme.setup_properties([self.fluid, self.boundary])
        self.started, self.dts, self.fronts, self.energies = None, [], [], [self.energy(self.fluid.y)]
        return [self.fluid, self.boundary]

    def energy(self, y):
        """Kinetic and potential, zero on the bed. [J/m]"""
        return float(np.sum(self.fluid.m * ((self.fluid.u**2 + self.fluid.v**2) / 2 + G * y)))

    def pre_step(self, solver):
        now = time.process_time()
        if self.started is None:
            self.started = self.said = now
        self.look(solver.t)
        self.dts.append(solver.dt)
        if sys.stderr.isatty() and now > self.said + 1:
            self.said = now
            said = WORDS["progress"] % (solver.t, solver.count, now - self.started)
            print("\r\033[K" + said, end="", file=sys.stderr, flush=True)

    def look(self, t):
        """At an instant that the last step has passed, by moving the particles back along their velocities."""
        fluid = self.fluid
        if len(self.fronts) < len(FRONT_AT) and t >= FRONT_AT[len(self.fronts)] * TIME_UNIT:
            T = FRONT_AT[len(self.fronts)]
            x, y = (fluid.x - fluid.u * (t - T * TIME_UNIT), fluid.y - fluid.v * (t - T * TIME_UNIT))
            self.fronts.append({"T": T, "foremost": float(x.max()) / A,
                                "wet_bed": float(end_of_the_wet_bed(x, y, self.dx)) / A})
        if len(self.energies) == 1 and t >= ENERGY_AT * TIME_UNIT:
            self.energies.append(self.energy(fluid.y - fluid.v * (t - ENERGY_AT * TIME_UNIT)))

    def neighbours(self):
        """Mean of 1,000 particles of fluid or so, themselves not counted."""
        near, counts = UIntArray(), []
        self.nnps.update()
        for i in range(0, len(self.fluid.x), max(1, len(self.fluid.x) // 1000)):
            counts.append(-1)
            for source in (0, 1):
                self.nnps.get_nearest_particles(source, 0, i, near)
                counts[-1] += near.length
        return float(np.mean(counts))


def run(options):
    with tempfile.TemporaryDirectory(prefix="clapotis-pysph-") as folder, contextlib.redirect_stdout(sys.stderr):
        os.environ["HOME"] = folder  # PySPH keeps there what it compiles
        print(WORDS["compiling"], file=sys.stderr)
        app = DamBreak(fname="dam_break", output_dir=folder)
        app.setup(["--quiet", "--disable-output", "--loglevel", "none", "--no-openmp", "--dx", repr(options.dx)] +
                  (["--max-steps", str(options.steps)] if options.steps else ["--tf", repr(options.until)]))
        solver, fluid = app.solver, app.fluid
        solver.solve(show_progress=False)
        cpu = time.process_time() - app.started
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr)
        if not math.isfinite(app.energy(fluid.y)):
            stop(5, "diverged", solver.t)
        app.look(solver.t)
        neighbours = app.neighbours()
    usual = app.dts[solver.n_damp:-1] or app.dts  # but for the small ones of the start and the last, cut to fit the end
    return {
        "peer": "pysph",
        "version": pysph.__version__,
        "case": "dam break, column 1 m x 2 m, tank 4 m x 3 m",
        "compiler_flags": os.environ.get("CFLAGS", "as shipped"),
        "dx": options.dx,
        "fluid_particles": len(fluid.x),
        "boundary_particles": len(app.boundary.x),
        "neighbours": neighbours,
        "steps": solver.count,
        "force_evaluations": solver.count,
        "dt": {"median": float(np.median(usual)), "least": min(usual), "largest": max(usual)},
        "simulated_seconds": solver.t,
        "cpu_seconds": cpu,
        "updates_per_second": len(fluid.x) * solver.count / cpu,
        "cpu_seconds_per_simulated_second": None if options.steps else cpu / solver.t,  # the first 50 steps are small
        "front": app.fronts,
        "energy_at_T_3": app.energies[1] / app.energies[0] if len(app.energies) > 1 else None,
    }


def table(result):
    """The same for a reader; what was not reached is a dash."""
    def entry(key, words):
        return "-" if result[key] is None else WORDS[words] % result[key]

    def fronts(key):
        return "  ".join(f"{front[key]:.2f}" for front in result["front"]) or "-"
    return WORDS["table"].format(**result, cost=entry("cpu_seconds_per_simulated_second", "seconds"),
                                 energy=entry("energy_at_T_3", "of_the_start"),
                                 **{key: fronts(key) for key in ("T", "foremost", "wet_bed")})


def main():
    options = read_options()
    to_file = options.json not in (None, "-")
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the temporary folder goes as well
    try:
        if to_file:  # tried before the long run, not after it
            os.makedirs(os.path.dirname(options.json) or ".", exist_ok=True)
            open(options.json, "a").close()
        result = run(options)
        text = json.dumps(result, indent=2) + "\n"
        print(text if options.json == "-" else table(result) + "\n", end="")
        if to_file:
            with open(options.json, "w") as file:
                file.write(text)
            print(WORDS["kept"] % options.json)
    except OSError as error:
        stop(4, "unwritable", error.filename or "the output", error.strerror)
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
